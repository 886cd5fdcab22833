// The tables of the classical diagram.
#pragma once

#include "studies/io/columns.h"
#include "studies/seifert/seifert.h"

namespace sbeh::studies {

/// branches.csv: a shape of a witness.
struct BranchRow {
  std::string witness;
  axisym::ClassicalShape shape;  ///< without its profile
};
const Columns<BranchRow>& branch_columns();

/// points.csv, and points_by_witness.csv, which begins with the witness.
struct PointRow {
  std::string witness, name;
  axisym::SpecialPoint point;
};
const Columns<PointRow>& point_columns();
const Columns<PointRow>& witness_point_columns();

/// differences.csv
const Columns<Disagreement>& disagreement_columns();

}  // namespace sbeh::studies
