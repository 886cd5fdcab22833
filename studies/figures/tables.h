// The numbers of the figures, from the runs that are there.
#pragma once

#include "studies/figures/runs.h"

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

/// Writes the tables of a figure, which its picture is drawn from, into the folder; nothing when there is
/// nothing to draw it from. Files in them are named relative to the folder. Returns what is missing, a
/// phrase for each. Throws InputError and OutputError.
///
/// energy.csv: solver (axisymmetric, 3D), model, reduced_volume, L, triangles, at_rest (whether the run
/// ends so: yes, no, or nothing while it has not ended), time, energy
std::vector<std::string> write_energy(const Sources& sources);

/// shapes.csv: a row per reduced volume and L. Of the axisymmetric solver: energy, order_min, order_max,
/// H_abs_max, order_min_radius (where the order is least, in parts of the equator's radius),
/// distance_from_SSH (of the two profiles), SSH_distance (of SSH's profile from that of the smallest L); of
/// the 3D run, empty where there is none: triangles, time, ending, energy_3d, order_min_3d, H_abs_max_3d,
/// distance_3d (of its nodes from the axisymmetric profile), frame.
/// cuts.csv: model, solver, reduced_volume, L, x, z, order; the points of closed curves
std::vector<std::string> write_shapes(const Sources& sources);

/// evolution.csv: a row per model and instant, with the frame nearest to it, empty from `time` on where that
/// is farther away than a tenth of the instant: model, residual_stiffness, instant, time, energy,
/// energy_oblate (of the stationary oblate of the same reduced volume, by Newton's method),
/// energy_oblate_k0_0 (the same without residual stiffness), reduced_volume, order_min, order_max,
/// H_abs_max, moment_1 … moment_3 (principal moments of the surface, ascending, of the sphere 1/3 each),
/// frame
std::vector<std::string> write_evolution(const Sources& sources);

/// measures.csv: model, residual_stiffness, unresolved_from (a time, empty when the mesh was always fine
/// enough), time, energy, W2, order_std, order_variance, reduced_volume
std::vector<std::string> write_measures(const Sources& sources);

/// That of the figure.
std::vector<std::string> write_tables(Figure figure, const Sources& sources);

}  // namespace sbeh::studies::figures
