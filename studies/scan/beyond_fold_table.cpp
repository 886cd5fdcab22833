#include "studies/scan/beyond_fold_table.h"

#include "studies/io/interrupt.h"
#include "studies/states/profile_file.h"

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

const Columns<RimRecord>& rim_columns() {
  using axisym::RimKind;
  static const Columns<RimRecord> columns{
      column("reduced_volume", &RimRecord::reduced_volume),
      column("L", &RimRecord::L),
      column("kind", &RimRecord::kind),
      column("energy", &RimRecord::energy),
      column("order_rim", &RimRecord::order_rim),
      column("H_rim", &RimRecord::H_rim),
      column("H_abs_max", &RimRecord::H_abs_max),
      column("resolution", &RimRecord::resolution),
      derived_column<RimRecord>("status",
                                [](const RimRecord& row) {
                                  return name(row.resolution > axisym::resolution_limit
                                                  ? PointStatus::unresolved
                                                  : PointStatus::stationary);
                                }),
      column("jump", &RimRecord::jump),
      column("pressure", &RimRecord::pressure),
      column("negative_directions", &RimRecord::negative_directions),
  };
  return columns;
}

std::string stem(const RimRecord& row) {
  return fmt::format("{}_v{}_L{}", sbeh::name(row.kind), row.reduced_volume, row.L);
}

std::string profile_text(const axisym::State& state) {
  const Columns<ProfileRow>& all = profile_columns();
  std::vector<ProfileRow> rows;
  double s = 0;
  for (Eigen::Index i = 0; i < state.beta.size(); ++i) {
    if (i > 0) s += (state.X.col(i) - state.X.col(i - 1)).norm();
    rows.push_back({s, state.X(0, i), state.X(1, i), state.beta[i], not_known});
  }
  return table_text(Columns<ProfileRow>(all.begin(), all.end() - 1), rows);
}

}  // namespace sbeh::studies
