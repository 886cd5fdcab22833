#include "studies/scan/beyond_fold_table.h"

#include "studies/io/interrupt.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace sbeh::studies {

using axisym::RimRecord;

std::vector<RimRecord> find_beyond_fold(const ScanInput& input, const std::vector<FoldRow>& folds) {
  std::vector<double> volumes;
  constexpr double reach =
      2;  // sharp rims are lower than smooth ones from about half the fold's L on
  for (const FoldRow& fold : folds)
    if (fold.branch == axisym::Branch::oblate && fold.L <= reach * input.L.back()
        && fold.reduced_volume > 0.51)
      volumes.push_back(fold.reduced_volume);
  std::vector<std::vector<RimRecord>> found(volumes.size());
  tbb::parallel_for(std::size_t(0), volumes.size(), [&](std::size_t k) {
    if (!interrupt_signal()) found[k] = axisym::beyond_fold(input.material, volumes[k], input.L);
  });
  std::vector<RimRecord> rows;
  for (auto& some : found) rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

std::string table_of(const std::vector<RimRecord>& rows) {
  std::string text =
      "reduced_volume,L,kind,energy,order_rim,H_rim,H_abs_max,resolution,status,jump,pressure,"
      "negative_directions\n";
  for (const RimRecord& r : rows)
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", r.reduced_volume, r.L,
                    axisym::name(r.kind), r.energy, r.order_rim, r.H_rim, r.H_abs_max, r.resolution,
                    r.resolution > axisym::resolution_limit ? "unresolved" : "stationary", r.jump,
                    r.pressure, r.negative_directions);
  return text;
}

std::string stem(const RimRecord& row) {
  return fmt::format("{}_v{}_L{}", axisym::name(row.kind), row.reduced_volume, row.L);
}

std::string profile_text(const axisym::State& state) {
  std::string text = "arc_length,r,z,order\n";
  double s = 0;
  for (Eigen::Index i = 0; i < state.beta.size(); ++i) {
    if (i > 0) s += (state.X.col(i) - state.X.col(i - 1)).norm();
    text += fmt::format("{},{},{},{}\n", s, state.X(0, i), state.X(1, i), state.beta[i]);
  }
  return text;
}

}  // namespace sbeh::studies
