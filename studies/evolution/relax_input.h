// What one axisymmetric evolution is asked for: model, start, material, numerics and times.
#pragma once

#include "axisym/options.h"
#include "model/material.h"
#include "studies/scan/scan_row.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// Ellipsoid of revolution, scaled to the area 4π, of constant order. Exactly one of the optionals
/// is there.
struct Ellipsoid {
  std::optional<double> reduced_volume;       ///< V_r, 0 < V_r <= 1
  std::optional<std::array<double, 2>> axes;  ///< semi-axes > 0: equatorial, polar; up to 1 : 1000
  bool prolate = false;                       ///< which ellipsoid of that reduced volume
};

/// Sphere with modes of rotationally symmetric harmonics, degrees 1 … 32, none twice.
struct Harmonics {
  std::vector<std::pair<int, double>> shape;        ///< (l, u_l)
  std::optional<double> order;                      ///< β₀ in 0 … 1; without it the rest state
  std::vector<std::pair<int, double>> order_modes;  ///< (l, b_l)
};

/// Top-level key `model`; tables [start] and [time], optional [material] and [numerics].
struct RelaxInput {
  model::Model model = model::Model::SBEH;
  std::variant<Ellipsoid, Harmonics, ScanRow> start;
  double initial_order = model::full_order;  ///< β of the ellipsoid, 0 … 1
  model::Material material;  ///< from a ScanRow: L is that of the row unless [material] gives it
  axisym::Numerics numerics;
  double end_time = 0;                ///< > 0
  std::vector<double> output_times;   ///< of the energy history; 0 … end_time, ascending
  std::vector<double> profile_times;  ///< at which the profile is written; likewise
  bool every_step = false;            ///< rows of the history after each step too
  bool stop_at_rest = true;           ///< end before end_time when nothing moves any more
};

/// Throws InputError (toml_reader.h).
RelaxInput read_relax(const std::filesystem::path& path);

}  // namespace sbeh::studies
