#include "studies/states/initial_order.h"

#include "studies/states/order_formula.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

namespace sbeh::studies {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

OrderCap read_cap(const TomlTable& table, bool of_revolution) {
  OrderCap cap{.fraction = table.number("fraction", {.low = 0, .high = 1, .low_open = true}),
               .order = table.number("order", orders)};
  if (table.has("axis")) {
    const std::vector<double> axis = table.numbers("axis");
    if (axis.size() != 3) table.fail("axis", "must be three numbers");
    cap.axis = {axis[0], axis[1], axis[2]};
    if (!(cap.axis.norm() > 0)) table.fail("axis", "must not vanish");
    if (of_revolution && (axis[0] != 0 || axis[1] != 0))
      table.fail("axis", "must be [0, 0, 1] or [0, 0, -1] on a surface of revolution");
  }
  table.reject_unknown_keys();
  return cap;
}

// Angles from an axis, of points seen from a centre.
VectorXd angles(const Matrix3Xd& points, const Vector3d& centre, const Vector3d& axis) {
  VectorXd angle(points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Vector3d x = points.col(i) - centre;
    angle[i] = std::atan2(axis.cross(x).norm(), axis.dot(x));
  }
  return angle;
}

// Within which a fraction of the area lies.
double angle_around(const AreaSamples& surface, const VectorXd& angle, double fraction) {
  std::vector<Eigen::Index> by_angle(std::size_t(angle.size()));
  std::iota(by_angle.begin(), by_angle.end(), 0);
  std::ranges::sort(by_angle, {}, [&](Eigen::Index i) { return angle[i]; });
  const double wanted = fraction * surface.areas.sum();
  double before = 0, at_angle = 0;  // half of a sample lies within its angle
  for (const Eigen::Index i : by_angle) {
    const double half = surface.areas[i] / 2;
    if (before + half >= wanted)
      return at_angle + (angle[i] - at_angle) * std::max(0., wanted - before + half) / (2 * half);
    before += 2 * half;
    at_angle = angle[i];
  }
  return std::numbers::pi;
}

// Normally distributed, and the same with any library: Box and Muller's.
std::vector<meshing::Harmonic> random_modes(const OrderNoise& noise) {
  constexpr int degree = 12;
  std::mt19937_64 generator(std::uint64_t(noise.seed));
  const auto uniform = [&] { return (double(generator() >> 11) + 0.5) / 9007199254740992.; };
  std::vector<meshing::Harmonic> modes;
  double squares = 0;
  for (int l = 1; l <= degree; ++l)
    for (int m = -l; m <= l; ++m) {
      const double radius = std::sqrt(-2 * std::log(uniform()));
      modes.push_back({l, m, radius * std::cos(2 * std::numbers::pi * uniform())});
      squares += modes.back().amplitude * modes.back().amplitude;
    }
  const double factor = noise.amplitude * std::sqrt(4 * std::numbers::pi / squares);
  for (meshing::Harmonic& mode : modes) mode.amplitude *= factor;
  return modes;
}

void add(const std::vector<meshing::Harmonic>& modes, const Matrix3Xd& nodes,
         const Vector3d& centre, VectorXd& beta) {
  if (modes.empty()) return;
  for (Eigen::Index i = 0; i < nodes.cols(); ++i)
    beta[i] += meshing::harmonic_sum(modes, (nodes.col(i) - centre).normalized());
}

// Tried at one place; of the range something is known on the surface alone.
std::string read_formula(const TomlTable& start, bool of_revolution) {
  if (!start.has("order_formula")) return {};
  start.refuse("order", "must not be given together with order_formula, which says it everywhere");
  if (of_revolution)
    start.refuse("order_modes",
                 "must not be given together with order_formula, which may have them");
  std::string formula = start.text("order_formula");
  try {
    values_of_formula(formula, of_revolution, Vector3d(0.6, 0, 0.8));
  } catch (const std::invalid_argument& error) {
    start.fail("order_formula", error.what());
  }
  return formula;
}

}  // namespace

OrderPattern read_order_pattern(const TomlTable& start, bool of_revolution) {
  OrderPattern pattern{.formula = read_formula(start, of_revolution),
                       .of_revolution = of_revolution,
                       .caps = {},
                       .modes = {},
                       .noise = {}};
  if (start.has("domains"))
    for (const TomlTable& domain : start.tables("domains"))
      pattern.caps.push_back(read_cap(domain, of_revolution));
  if (pattern.caps.empty()) {
    if (start.has("domain_width")) start.refuse_misspelt({"domains"});
    start.refuse("domain_width", "needs domains");
  } else {
    pattern.width = start.number("domain_width", above(0), pattern.width);
  }
  if (of_revolution) return pattern;
  if (start.has("order_modes")) pattern.modes = start.harmonics("order_modes", largest_degree);
  if (start.has("order_noise")) {
    const TomlTable noise = start.table("order_noise");
    pattern.noise = OrderNoise{.amplitude = noise.number("amplitude", above(0)),
                               .seed = noise.integer("seed", 0, 1 << 30, 1)};
    noise.reject_unknown_keys();
  }
  return pattern;
}

void write_order_pattern(TomlText& toml, const OrderPattern& pattern) {
  if (!pattern.formula.empty()) toml.value("order_formula", pattern.formula);
  std::vector<std::string> caps;
  for (const OrderCap& cap : pattern.caps)
    caps.push_back(fmt::format("{{ axis = [{}, {}, {}], fraction = {}, order = {} }}", cap.axis[0],
                               cap.axis[1], cap.axis[2], cap.fraction, cap.order));
  if (!caps.empty()) {
    toml.value("domains", AsIs{list_as_toml(caps)});
    toml.value("domain_width", pattern.width);
  }
  if (!pattern.modes.empty()) toml.value("order_modes", pattern.modes);
  if (pattern.noise)
    toml.value("order_noise", AsIs{fmt::format("{{ amplitude = {}, seed = {} }}",
                                               pattern.noise->amplitude, pattern.noise->seed)});
}

VectorXd with_pattern(VectorXd beta, const OrderPattern& pattern, const Matrix3Xd& nodes,
                      const AreaSamples& surface) {
  if (!pattern.is_there()) return beta;
  const Vector3d centre = surface.points * surface.areas / surface.areas.sum();
  if (!pattern.formula.empty())
    beta = values_of_formula(pattern.formula, pattern.of_revolution, nodes.colwise() - centre);
  for (const OrderCap& cap : pattern.caps) {
    const double rim =
        angle_around(surface, angles(surface.points, centre, cap.axis), cap.fraction);
    const VectorXd angle = angles(nodes, centre, cap.axis);
    for (Eigen::Index i = 0; i < beta.size(); ++i) {
      const double share = (1 - std::tanh((angle[i] - rim) / pattern.width)) / 2;
      beta[i] += share * (cap.order - beta[i]);
    }
  }
  add(pattern.modes, nodes, centre, beta);
  if (pattern.noise) add(random_modes(*pattern.noise), nodes, centre, beta);
  for (const double one : beta)
    if (!(std::abs(one) <= 1))
      throw std::invalid_argument(
          fmt::format("the order is {:.3g} somewhere: must be in -1 ... 1", one));
  return beta;
}

double outside_of(const model::Material& material, const OrderPattern& pattern) {
  double inside = 0, share = 0;
  for (const OrderCap& cap : pattern.caps) {
    inside += cap.fraction * cap.order;
    share += cap.fraction;
  }
  if (!pattern.caps.empty() && share >= 1 - 1e-12)
    throw std::invalid_argument(
        fmt::format("have fractions whose sum is {:.6g}: must be < 1, since what is outside of "
                    "them brings the mean to mean_order; with order given it need not",
                    share));
  const double order = (*material.mean_order - inside) / (1 - share);
  if (!(std::abs(order) <= 1))
    throw std::invalid_argument(
        fmt::format("mean_order = {} leaves the order {:.3g} outside of them: must be in -1 ... 1",
                    *material.mean_order, order));
  return order;
}

double outside_of(const TomlTable& start, const model::Material& material,
                  const OrderPattern& pattern) {
  try {
    return outside_of(material, pattern);
  } catch (const std::invalid_argument& error) {
    start.fail("domains", error.what());
  }
}

double shift_to_mean(const model::Material& material, double mean) {
  constexpr double little = 0.1;
  const double shift = *material.mean_order - mean;
  if (!(std::abs(shift) < little))
    throw std::invalid_argument(fmt::format(
        "order: its mean is {:.4g}, far from mean_order = {}: leave order out, and it follows",
        mean, *material.mean_order));
  return shift;
}

}  // namespace sbeh::studies
