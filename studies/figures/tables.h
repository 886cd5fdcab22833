// The numbers of the figures, from the runs that are there.
#pragma once

#include "model/names.h"
#include "studies/figures/runs.h"
#include "studies/io/columns.h"

namespace sbeh::studies::figures {

/// The folder with what the figures are made from.
struct Sources {
  std::filesystem::path folder;
  const Inputs& inputs;
  std::optional<int> triangles;  ///< see find_run

  std::optional<FoundRun> find(const PlannedRun& plan) const {
    return find_run(folder, plan, triangles);
  }
};

enum class Solver { axisymmetric, in_3d };
constexpr auto names(Solver) { return std::array{"axisymmetric", "3D"}; }

/// energy.csv: the energies of the oblates over time.
struct EnergyRow {
  Solver solver;
  model::Model model;
  double reduced_volume, L;
  std::optional<int> triangles;  ///< in 3D
  std::optional<bool> at_rest;   ///< whether the run ends so; empty while it has not ended
  double time = 0, energy = 0;
};
const Columns<EnergyRow>& energy_columns();

/// What a 3D run has come to, of shapes.csv.
struct ShapeIn3d {
  int triangles;
  double time;
  std::string ending;
  double energy, order_min, H_abs_max;
  double distance;    ///< of its nodes from the axisymmetric profile
  std::string frame;  ///< relative to the folder
};
/// shapes.csv: a stationary oblate of the axisymmetric solver.
struct ShapeRow {
  double reduced_volume, L;
  double energy, energy_SSH, order_min, order_max, H_abs_max;
  double order_min_radius;   ///< where the order is least, in parts of the equator's radius
  double distance_from_SSH;  ///< of the two profiles
  double SSH_distance;       ///< of SSH's profile from that of the smallest L
  std::optional<ShapeIn3d> in_3d;
  std::string
      lacks{};  ///< why there is no shape in 3D: "not begun", "not finished, its last frame at t = 3"
};
const Columns<ShapeRow>& shape_columns();

/// cuts.csv: points of closed curves.
struct CutRow {
  model::Model model;
  Solver solver;
  double reduced_volume, L;
  double x = 0, z = 0, order = 0;
};
const Columns<CutRow>& cut_columns();

/// The state of a frame, of evolution.csv.
struct EvolutionState {
  double time, energy;
  double
      energy_oblate;  ///< of the stationary oblate of the same reduced volume, by Newton's method
  double energy_oblate_k0_0;  ///< the same without residual stiffness
  double reduced_volume, order_min, order_max, H_abs_max;
  std::array<double, 3>
      moments;        ///< principal ones of the surface, ascending; of the sphere 1/3 each
  std::string frame;  ///< relative to the folder
};
/// evolution.csv: a model at an instant.
struct EvolutionRow {
  model::Model model;
  double residual_stiffness, instant;
  std::optional<EvolutionState>
      nearest;  ///< empty where it is farther away than a tenth of the instant
};
const Columns<EvolutionRow>& evolution_columns();

/// measures.csv: an evolution at a time.
struct MeasureRow {
  model::Model model;
  double residual_stiffness;
  std::optional<double> unresolved_from;  ///< a time; empty when the mesh was always fine enough
  double time, energy, W2, order_std, order_variance, reduced_volume;
  bool ended = true;  ///< the run will not go on; tables of older versions do not say
};
const Columns<MeasureRow>& measure_columns();

/// Writes the tables of a figure, which its picture is drawn from, into the folder; nothing when there is
/// nothing to draw it from. Returns what is missing, a phrase for each. Throws InputError and OutputError.
std::vector<std::string> write_tables(Figure figure, const Sources& sources);
/// energy.csv
std::vector<std::string> write_energy(const Sources& sources);
/// shapes.csv and cuts.csv
std::vector<std::string> write_shapes(const Sources& sources);
/// evolution.csv: a row per model and instant.
std::vector<std::string> write_evolution(const Sources& sources);
/// measures.csv
std::vector<std::string> write_measures(const Sources& sources);

}  // namespace sbeh::studies::figures
