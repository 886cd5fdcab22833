// What one 3D run is asked for: model, surface, material, numerics and times.
#pragma once

#include "meshing/spherical_harmonics.h"
#include "model/material.h"
#include "studies/evolution/relax_input.h"
#include "surface3d/options.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// Ellipsoid, scaled to the area 4π. Exactly one of the optionals is there.
struct Ellipsoid3d {
  std::optional<double> reduced_volume;  ///< V_r, 0 < V_r <= 1: of revolution about z
  std::optional<Eigen::Vector3d> axes;   ///< semi-axes > 0 along x, y, z
  bool prolate = false;                  ///< which ellipsoid of revolution of that reduced volume
};

/// r = 1 + Σ a_lm Y_lm, real orthonormal, then scaled to the area 4π.
struct HarmonicSphere {
  std::vector<meshing::Harmonic> modes;  ///< degrees 0 … 32, none twice
};

/// A mesh in a file, scaled to the area 4π.
struct MeshFileStart {
  std::string file;
};

/// A frame of an earlier run: surface and order.
struct FrameStart {
  std::string file;
};

/// Top-level key `model`; tables [surface] and [time], optional [material] and [numerics].
struct RunInput {
  model::Model model = model::Model::SBEH;
  std::variant<Ellipsoid3d, HarmonicSphere, MeshFileStart, ScanRow, FrameStart> start;
  int triangles = 320;                          ///< about so many; files bring their own
  double initial_order = model::full_order;     ///< where the start brings none, 0 … 1
  std::vector<meshing::Harmonic> perturbation;  ///< displaces along the normal by Σ a_lm Y_lm
  model::Material material;  ///< from a ScanRow: L is that of the row unless [material] gives it
  surface3d::Numerics numerics;
  double end_time = 0;               ///< > 0
  std::vector<double> output_times;  ///< of the rows of series.csv; 0 … end_time, ascending
  std::vector<double> frame_times;   ///< of the frames; likewise
  bool every_step = false;           ///< rows of series.csv after each step too
  bool stop_at_rest = true;          ///< end before end_time when nothing moves any more
  double checkpoint_minutes = 10;    ///< of wall time between checkpoints, > 0
};

/// Throws InputError (toml_reader.h).
RunInput read_run(const std::filesystem::path& path);

}  // namespace sbeh::studies
