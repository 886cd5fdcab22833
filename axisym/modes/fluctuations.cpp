#include "axisym/modes/fluctuations.h"

#include "axisym/circles.h"
#include "axisym/modes/rigid_motions.h"
#include "axisym/stationary/newton_system.h"

#include <Eigen/QR>

#include <numbers>

namespace sbeh::axisym {

namespace {

// The outward displacement of the widest circle, as a row that multiplies the unknowns.
Eigen::VectorXd widening(const Nodes& X) {
  const CurvePlace at = widest_place(X);
  const ShapeValues s = shape_values(at.x);
  const CurvePoint p = curve_point(X, at.element, s);
  const Nodes n = node_normals(X);
  Eigen::VectorXd row = Eigen::VectorXd::Zero(node_unknowns * X.cols());
  for (int a = 0; a < 4; ++a) {
    const Eigen::Index node = 3 * at.element + a;
    row[index(node, node_d)] = s.phi[std::size_t(a)] * p.nu.dot(n.col(node));
  }
  return row;
}

// What the response to a load must be orthogonal to; of a sphere area and volume are one.
Eigen::MatrixXd borders(const SecondVariation& second, int m) {
  const model::BandMatrix mass = second.mass_of(m);
  const std::vector<RigidMotion> rigid = rigid_motions(second.state, m, mass);
  const Eigen::Index kept = m == 0 ? second.constraints.cols() : 0;
  Eigen::MatrixXd columns(second.constraints.rows(), kept + Eigen::Index(rigid.size()));
  if (kept > 0) columns.leftCols(kept) = second.constraints;
  for (std::size_t k = 0; k < rigid.size(); ++k)
    columns.col(kept + Eigen::Index(k)) = mass.times(unknowns_of(rigid[k]));
  if (columns.cols() == 0) return columns;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> independent(columns.colwise().normalized());
  independent.setThreshold(1e-6);
  return (columns * independent.colsPermutation()).leftCols(independent.rank());
}

}  // namespace

std::optional<double> contour_variance(const SecondVariation& second, int m) {
  const Eigen::VectorXd load = widening(second.state.X);
  const Eigen::MatrixXd B = borders(second, m);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(B.cols(), B.cols());
  // A itself is singular along rigid motions, and that of a sphere without tension along its size.
  constexpr double shift = -1e-6;  // stiffnesses
  const model::BandMatrix A = second.shifted(m, 0);
  model::BandMatrix regular = second.shifted(m, shift * second.stiffness);
  if (!regular.factor()) return {};
  Eigen::VectorXd x = Eigen::VectorXd::Zero(load.size()), y = Eigen::VectorXd::Zero(B.cols());
  for (int pass = 0; pass < 4; ++pass) {  // each leaves |shift|/λ of the error
    const auto change =
        model::solve_bordered(regular, B, B, none, load - A.times(x) - B * y, -B.transpose() * x);
    if (change.x.size() == 0) return {};
    x += change.x;
    y += change.y;
  }
  const double of_angle = m == 0 ? 2 * std::numbers::pi : std::numbers::pi;  // ∫cos² mφ dφ
  return load.dot(x) / of_angle;
}

}  // namespace sbeh::axisym
