#include "axisym/modes/fluctuations.h"

#include "axisym/circles.h"
#include "axisym/modes/constrained_inverse.h"
#include "axisym/modes/rigid_motions.h"

#include <cmath>
#include <numbers>

namespace sbeh::axisym {

namespace {

// The outward displacement of the widest circle, or of its mirror image, as a row that multiplies the unknowns.
Eigen::VectorXd widening(const Nodes& X, const Sector& sector, Parity parity) {
  CurvePlace at = widest_place(X);
  if (at.element >= sector.elements()) at = {sector.state_elements - 1 - at.element, 1 - at.x};
  const ShapeValues s = shape_values(at.x);
  const CurvePoint p = curve_point(X, at.element, s);
  const Nodes n = node_normals(X);
  Eigen::VectorXd row =
      Eigen::VectorXd::Zero(node_unknowns * (3 * Eigen::Index(sector.elements()) + 1));
  for (int a = 0; a < 4; ++a) {
    const Eigen::Index node = 3 * at.element + a;
    row[index(node, node_d)] = s.phi[std::size_t(a)] * p.nu.dot(n.col(node));
  }
  fold<node_unknowns>(sector, parity, node_mirror(), row);
  for_each_mirrored<node_unknowns>(sector, parity, node_mirror(), [&](int i) { row[i] = 0; });
  return row;
}

// What the response to a load must be orthogonal to.
Eigen::MatrixXd borders(const SecondVariation& second, int m, Parity parity) {
  const NodeChain mass = second.mass_of(m, parity);
  const Eigen::MatrixXd kept = second.constraints_of(m, parity),
                        rigid = unknowns_of(rigid_motions(second, m, parity, mass));
  Eigen::MatrixXd columns(mass.size(), kept.cols() + rigid.cols());
  if (kept.cols() > 0) columns.leftCols(kept.cols()) = kept;
  for (Eigen::Index k = 0; k < rigid.cols(); ++k)
    columns.col(kept.cols() + k) = mass.times(rigid.col(k));
  return columns;
}

// load · (the form's inverse · load), among what is orthogonal to the borders; empty where that is not found.
std::optional<double> response(const SecondVariation& second, int m, Parity parity) {
  const Eigen::VectorXd load = widening(second.state.X, second.sector, parity);
  // A itself is singular along rigid motions, and that of a sphere without tension along its size.
  constexpr double shift = -1e-4;  // stiffnesses
  constexpr int most_passes = 200;
  constexpr double tolerance = 1e-10;
  const NodeChain A = second.form(m, parity);
  NodeChain regular = A;
  regular.add(-shift * second.stiffness, second.mass_of(m, parity));
  const model::ChainInverse<node_unknowns> inverse(regular);
  if (!inverse.usable()) return {};
  const auto solve = [&](Eigen::VectorXd x) {
    inverse.solve(x);
    return x;
  };
  const SoftConstraint moment = second.moment_of(m, parity);
  const SoftInverse soft(solve, moment);
  const ConstrainedInverse constrained(soft, borders(second, m, parity));
  const auto form_times = [&](const Eigen::VectorXd& y) {
    Eigen::VectorXd product = A.times(y);
    if (moment.softness > 0) product += moment.b * (moment.b.dot(y) / moment.softness);
    return product;
  };
  Eigen::VectorXd x = Eigen::VectorXd::Zero(load.size());
  for (int pass = 0; pass < most_passes; ++pass) {  // each leaves |shift|/(λ − shift) of the error
    const Eigen::VectorXd change = constrained(load - form_times(x));
    x += change;
    if (std::abs(load.dot(change)) <= tolerance * std::abs(load.dot(x))) return load.dot(x);
  }
  return {};
}

}  // namespace

std::optional<double> contour_variance(const SecondVariation& second, int m) {
  double sum = 0;
  for (const Parity parity : second.sector.parities()) {
    const auto part = response(second, m, parity);
    if (!part) return {};
    sum += *part;
  }
  const double of_angle = m == 0 ? 2 * std::numbers::pi : std::numbers::pi;  // ∫cos² mφ dφ
  return sum / of_angle;
}

}  // namespace sbeh::axisym
