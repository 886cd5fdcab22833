// The order with which an evolution begins where its start brings none, and a branch of a scan.
#pragma once

#include "meshing/spherical_harmonics.h"
#include "model/material.h"
#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

inline constexpr Interval orders = between(0, 1);
inline constexpr int largest_degree = 32;  ///< of harmonics

/// The part of a surface around where it meets an axis through its centre.
struct OrderCap {
  Eigen::Vector3d axis{0, 0, 1};
  double fraction = 0;  ///< of the area
  double order = 0;

  bool operator==(const OrderCap&) const = default;
};

/// Σ a_lm Y_lm with random a_lm of degrees 1 … 12: the same for the same seed.
struct OrderNoise {
  double amplitude = 0;  ///< the root of the mean square over a sphere
  int seed = 1;

  bool operator==(const OrderNoise&) const = default;
};

/// What is added to a uniform order.
struct OrderPattern {
  std::string formula;                   ///< in its place, see order_formula.h; empty: none
  bool of_revolution = false;            ///< its variables are those of a surface of revolution
  std::vector<OrderCap> caps;            ///< later ones over earlier ones
  double width = 0.1;                    ///< tanh(angle/width) at their rims
  std::vector<meshing::Harmonic> modes;  ///< of the direction from the centre
  std::optional<OrderNoise> noise;

  bool is_there() const { return !formula.empty() || !caps.empty() || !modes.empty() || noise; }
  bool operator==(const OrderPattern&) const = default;
};

/// Keys `order_formula`, `domains`, `domain_width`, `order_modes`, `order_noise`. Of a surface of revolution the domains lie around the poles, and
/// `order_modes` and `order_noise` are not read. Throws InputError.
OrderPattern read_order_pattern(const TomlTable& start, bool of_revolution);
void write_order_pattern(TomlText& toml, const OrderPattern& pattern);

/// A surface as points with areas.
struct AreaSamples {
  Eigen::Matrix3Xd points;
  Eigen::VectorXd areas;
};

/// β at the nodes (3 x nodes) of a surface with the pattern on it. Throws std::invalid_argument where the order leaves −1 … 1.
Eigen::VectorXd with_pattern(Eigen::VectorXd beta, const OrderPattern& pattern,
                             const Eigen::Matrix3Xd& nodes, const AreaSamples& surface);

/// The order outside of the domains that makes the mean of a conserved order, but for the width of their rims. Throws std::invalid_argument
/// where there is none.
double outside_of(const model::Material& material, const OrderPattern& pattern);
/// The same of what is read from a table. Throws InputError.
double outside_of(const TomlTable& start, const model::Material& material,
                  const OrderPattern& pattern);

/// What is added to an order with this mean, that of a conserved one to come out: little. Throws std::invalid_argument where it is not.
double shift_to_mean(const model::Material& material, double mean);

}  // namespace sbeh::studies
