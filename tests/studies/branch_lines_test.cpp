// The lines of the diagram: folds and equal energies, as a scan leaves them.

#include "axisym/seifert_shooting.h"
#include "studies/csv_line.h"
#include "studies/output.h"
#include "studies/scan.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

namespace sbeh::studies {
namespace {

namespace fs = std::filesystem;

// A folder that goes with the test.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "sbeh_lines_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~ScratchFolder() { fs::remove_all(path_); }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

using Rows = std::vector<std::vector<std::string>>;

Rows rows_of(const fs::path& file, const std::string& header) {
  std::istringstream text(read_file(file));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, header);
  Rows rows;
  while (std::getline(text, line)) rows.push_back(split_csv(line));
  return rows;
}

struct Lines {
  Rows folds, meetings;
};
Lines lines_of(ScanInput input, int elements) {
  input.numerics.elements = elements;
  const ScratchFolder folder;
  const ScanSummary summary = run_scan(input, folder.path() / "scan", "test");
  EXPECT_EQ(summary.failed, 0);
  return {rows_of(folder.path() / "scan/folds.csv",
                  "reduced_volume,L,energy,order_min,H_abs_max,branch"),
          input.branches.size() > 1 ? rows_of(folder.path() / "scan/equal_energy.csv",
                                              "first,second,L,reduced_volume,energy")
                                    : Rows{}};
}

TEST(FoldLine, of_the_oblates_is_found_to_four_digits_and_does_not_move_under_refinement) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.65, 0.7, 0.75, 0.8};
  input.L = {0.05};
  input.models = {model::Model::SBEH};
  const Rows coarse = lines_of(input, 48).folds, fine = lines_of(input, 72).folds;
  ASSERT_EQ(coarse.size(), 5u);
  ASSERT_EQ(fine.size(), 5u);
  double before = 0;
  for (std::size_t k = 0; k < 5; ++k) {
    const double L = std::stod(coarse[k][1]), refined = std::stod(fine[k][1]);
    std::printf("  V_r = %s: L* = %.9f, with 72 elements %.9f\n", coarse[k][0].c_str(), L, refined);
    EXPECT_NEAR(L / refined, 1, 1e-6);
    EXPECT_GT(L, before);  // rounder shapes hold out longer
    before = L;
  }
  EXPECT_NEAR(std::stod(fine[0][1]), 0.070637, 1e-6);  // one percent above the paper's largest L
}

TEST(EqualEnergies, of_oblate_and_prolate_start_at_the_classical_point_and_are_exact) {
  ScanInput input;
  input.reduced_volume = {0.6, 0.65, 0.7, 0.75};
  input.L = {1e-6, 0.01, 0.05, 0.09};
  input.models = {model::Model::SBEH};
  input.branches = {"oblate", "prolate"};
  const Rows coarse = lines_of(input, 48).meetings, fine = lines_of(input, 72).meetings;
  ASSERT_EQ(coarse.size(), 4u);
  ASSERT_EQ(fine.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(coarse[k][0], "oblate");
    EXPECT_EQ(coarse[k][1], "prolate");
    EXPECT_NEAR(std::stod(coarse[k][3]), std::stod(fine[k][3]), 1e-6) << "L = " << coarse[k][2];
    std::printf("  L = %s: V_r = %s\n", fine[k][2].c_str(), fine[k][3].c_str());
  }
  // As L → 0 the order is full and the shapes are the classical ones; the distance is linear in L.
  const double classical = axisym::shoot_special_points().prolate_oblate.reduced_volume;
  EXPECT_NEAR(std::stod(fine[0][3]), classical, 1e-6);
}

}  // namespace
}  // namespace sbeh::studies
