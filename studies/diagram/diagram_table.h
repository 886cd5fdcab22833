// The tables of a diagram.
#pragma once

#include "studies/diagram/diagram_branches.h"
#include "studies/io/columns.h"

#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// What bifurcations.csv tells of.
enum class BifurcationKind {
  symmetry_loss,  ///< a branch leaves that is not symmetric top to bottom
  fold,           ///< V_r turns back
  limit,          ///< the necks close: the shape of spheres that touch
  equal_energy,   ///< of two minima within axisymmetry
  mode            ///< the sign of a mode's eigenvalue changes: mode_1, mode_2 …
};

/// Where a shape stands in all three diagrams, and its energy.
struct DiagramPlace {
  double value;           ///< of the diagram's second axis
  double H0;              ///< with which it is stationary without an area difference
  double W2;              ///< ∫H dS
  double reduced_volume;  ///< V_r
  double
      energy;  ///< F/κ: ½∫(H − H₀)² dS, and what the area difference adds; Gaussian energies left out
};

/// A row of bifurcations.csv.
struct Bifurcation {
  std::string kind;    ///< as BifurcationKind, modes with their m
  std::string branch;  ///< that it is on; of a symmetry loss the one that leaves
  std::string from;    ///< that the branch leaves; of equal energies the other branch
  DiagramPlace at;
  double error;  ///< estimated, of V_r; 0 of limits whose spheres are known, empty where it is not
  int leg;       ///< of the branch
  bool self_contact;  ///< the surface passes through itself there
};

/// A row of branches.csv.
struct DiagramRow {
  std::string branch, from;
  int leg;  ///< how many folds lie before it
  DiagramPlace at;
  double pressure, tension;  ///< in κ
  double neck;               ///< the least radius between the poles; empty without a neck
  int negative_directions;
  std::optional<int> negative_directions_3d;
  bool self_contact;
};

/// A point of the profile of a shape, for pictures: shapes.csv.
struct DiagramShapeRow {
  int number;  ///< of the shape
  std::string branch;
  double value, reduced_volume;
  double r, z;
};
const Columns<DiagramShapeRow>& diagram_shape_columns();

/// The minima of least energy, within axisymmetry, near a few reduced volumes.
std::vector<DiagramShapeRow> lowest_shapes(const DiagramInput& input, double value,
                                           const std::vector<DiagramBranch>& branches);

const Columns<Bifurcation>& bifurcation_columns();
const Columns<DiagramRow>& diagram_columns();

/// The states of a branch, in their order.
std::vector<DiagramRow> rows_of(double value, const DiagramBranch& branch);

/// What is special on the branches of one value, and between them.
std::vector<Bifurcation> bifurcations_of(const DiagramInput& input, double value,
                                         const std::vector<DiagramBranch>& branches);

}  // namespace sbeh::studies
