// The classical diagram by three witnesses: finite elements, shooting, and minimisation.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/modes/stability_3d.h"
#include "studies/io/columns.h"

namespace sbeh::studies {

/// branches.csv: a shape of a witness.
struct BranchRow {
  std::string witness;
  axisym::ClassicalShape shape;  ///< without its profile
  axisym::Stability3d modes{};   ///< among shapes without an axis; of the finite elements only
};

/// stability_lines.csv: where the lowest eigenvalue of an m and a parity changes its sign along a branch.
struct ClassicalThreshold {
  axisym::Branch branch;
  int m;
  axisym::Parity parity;
  axisym::SpecialPoint point;  ///< of infinite error where it is not located
};

/// What one witness found.
struct WitnessReport {
  std::string witness;  ///< "elements", "shooting" or "minimiser"
  std::vector<axisym::ClassicalShape> shapes;
  axisym::SpecialPoints points;
  double seconds = 0;
  std::vector<axisym::Stability3d> modes{};  ///< of the shapes; none of witnesses that do not tell
  std::vector<ClassicalThreshold> thresholds{};
};

/// Largest disagreement of two witnesses over the shapes that both have.
struct Disagreement {
  std::string first, second;
  axisym::Branch branch;
  double energy, H_pole, pressure, tension;
};

struct SeifertSummary {
  std::vector<WitnessReport> witnesses;
  std::vector<Disagreement> disagreements;
  /// The special points: the value of the witness with the smallest error; the error covers its own
  /// and the disagreement with the others.
  axisym::SpecialPoints points;
};

/// The five members of SpecialPoints with their names in tables.
struct NamedPoint {
  const char* name;
  axisym::SpecialPoint axisym::SpecialPoints::*member;
};
const std::vector<NamedPoint>& special_point_names();

const Columns<BranchRow>& branch_columns();
const Columns<ClassicalThreshold>& classical_threshold_columns();

/// points.csv, and points_by_witness.csv, which begins with the witness.
struct PointRow {
  std::string witness, name;
  axisym::SpecialPoint point;
};
const Columns<PointRow>& point_columns();
const Columns<PointRow>& witness_point_columns();

/// differences.csv
const Columns<Disagreement>& disagreement_columns();

/// Runs the three witnesses side by side and leaves branches.csv, points.csv, points_by_witness.csv,
/// stability_lines.csv and differences.csv in the folder. A folder that holds results already is refused.
/// `elements` is that of the finite elements. Throws OutputError.
SeifertSummary run_seifert(const std::filesystem::path& folder, int elements);

/// The summary as a table for people.
std::string table_of(const SeifertSummary& summary);

}  // namespace sbeh::studies
