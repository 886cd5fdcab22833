// What one axisymmetric evolution is asked for: model, start, material, numerics and times.
#pragma once

#include "axisym/options.h"
#include "axisym/start_shapes.h"
#include "model/material.h"
#include "studies/evolution/start_shape.h"
#include "studies/evolution/times.h"
#include "studies/parameters/units.h"
#include "studies/scan/scan_row.h"
#include "studies/states/initial_order.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// Sphere with modes of rotationally symmetric harmonics, degrees 1 … 32, none twice.
struct Harmonics {
  std::vector<axisym::Mode> shape;        ///< (l, u_l)
  std::optional<double> reduced_volume;   ///< all u_l times one factor
  std::optional<double> order;            ///< β₀ in 0 … 1; without it the rest state
  std::vector<axisym::Mode> order_modes;  ///< (l, b_l)

  bool operator==(const Harmonics&) const = default;
};

/// Top-level key `model`; tables [start] and [time], optional [material] and [numerics]. What the row of a scan
/// was computed with stands for what the file does not say of model and material.
struct RelaxInput : Physics {
  std::variant<Ellipsoid, Harmonics, ScanRow> start;
  double initial_order = model::full_order;  ///< β of the ellipsoid, 0 … 1
  OrderPattern order_pattern;  ///< domains around the poles, where the start brings no order
  std::vector<axisym::Mode> perturbation;  ///< displaces along the normal by Σ a_l Y_l
  axisym::Numerics numerics;
  Times times;                   ///< states: profiles
  std::optional<Units> units{};  ///< for people: no number depends on them

  bool operator==(const RelaxInput&) const = default;
};

/// Throws InputError.
RelaxInput read_relax(const std::filesystem::path& path);
/// The same of a file that was read already.
RelaxInput relax_in(const TomlTable& file);

/// The whole input, defaults included, as TOML under a comment with the program's version: reading the text
/// gives the same input, bit for bit.
std::string describe(const RelaxInput& input, std::string_view version);

}  // namespace sbeh::studies
