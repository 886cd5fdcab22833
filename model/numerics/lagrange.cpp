#include "model/numerics/lagrange.h"

#include <stdexcept>
#include <vector>

namespace sbeh::model {

namespace {

void require_order(int order) {
  if (order < 1 || order > 3)
    throw std::invalid_argument("Lagrange element: order must be 1, 2 or 3");
}

// ℓ_m(x) = Π_{j<m} (k x − j)/(m − j), the factor of a principal-lattice basis function that
// vanishes on the first m lattice lines of a barycentric coordinate x, and its derivatives.
struct Factor {
  double value, slope, bend;
};
Factor lattice_factor(int order, int m, double x) {
  Factor f{1, 0, 0};
  for (int j = 0; j < m; ++j) {
    const double line = (order * x - j) / (m - j), rate = order / double(m - j);
    f.bend = f.bend * line + 2 * f.slope * rate;
    f.slope = f.slope * line + f.value * rate;
    f.value *= line;
  }
  return f;
}

// Lattice indices (along corner 1, along corner 2) of the nodes in the order of the header.
std::vector<std::array<int, 2>> triangle_lattice(int k) {
  std::vector<std::array<int, 2>> lattice{{0, 0}, {k, 0}, {0, k}};
  for (int i = 1; i < k; ++i) lattice.push_back({i, 0});
  for (int i = 1; i < k; ++i) lattice.push_back({k - i, i});
  for (int i = 1; i < k; ++i) lattice.push_back({0, k - i});
  if (k == 3) lattice.push_back({1, 1});
  return lattice;
}

}  // namespace

IntervalElement::IntervalElement(int order) : order_(order) { require_order(order); }

Eigen::VectorXd IntervalElement::nodes() const { return Eigen::VectorXd::LinSpaced(size(), 0, 1); }

Eigen::VectorXd IntervalElement::values(double x) const {
  Eigen::VectorXd phi(size());
  for (int i = 0; i < size(); ++i)
    phi[i] = lattice_factor(order_, i, x).value * lattice_factor(order_, order_ - i, 1 - x).value;
  return phi;
}

Eigen::VectorXd IntervalElement::derivatives(double x) const {
  Eigen::VectorXd dphi(size());
  for (int i = 0; i < size(); ++i) {
    const Factor right = lattice_factor(order_, i, x);
    const Factor left = lattice_factor(order_, order_ - i, 1 - x);
    dphi[i] = right.slope * left.value - right.value * left.slope;
  }
  return dphi;
}

TriangleElement::TriangleElement(int order) : order_(order) { require_order(order); }

Eigen::Matrix2Xd TriangleElement::nodes() const {
  const auto lattice = triangle_lattice(order_);
  Eigen::Matrix2Xd x(2, size());
  for (int i = 0; i < size(); ++i) x.col(i) << lattice[i][0], lattice[i][1];
  return x / order_;
}

Eigen::VectorXd TriangleElement::values(const Eigen::Vector2d& x) const {
  const auto lattice = triangle_lattice(order_);
  Eigen::VectorXd phi(size());
  for (int i = 0; i < size(); ++i) {
    const auto [m1, m2] = lattice[i];
    phi[i] = lattice_factor(order_, m1, x[0]).value * lattice_factor(order_, m2, x[1]).value
           * lattice_factor(order_, order_ - m1 - m2, 1 - x[0] - x[1]).value;
  }
  return phi;
}

Eigen::Matrix2Xd TriangleElement::derivatives(const Eigen::Vector2d& x) const {
  const auto lattice = triangle_lattice(order_);
  Eigen::Matrix2Xd dphi(2, size());
  for (int i = 0; i < size(); ++i) {
    const auto [m1, m2] = lattice[i];
    const Factor a = lattice_factor(order_, m1, x[0]);
    const Factor b = lattice_factor(order_, m2, x[1]);
    const Factor c = lattice_factor(order_, order_ - m1 - m2, 1 - x[0] - x[1]);
    dphi(0, i) = (a.slope * c.value - a.value * c.slope) * b.value;
    dphi(1, i) = (b.slope * c.value - b.value * c.slope) * a.value;
  }
  return dphi;
}

Eigen::Matrix3Xd TriangleElement::second_derivatives(const Eigen::Vector2d& x) const {
  const auto lattice = triangle_lattice(order_);
  Eigen::Matrix3Xd ddphi(3, size());
  for (int i = 0; i < size(); ++i) {
    const auto [m1, m2] = lattice[i];
    const Factor a = lattice_factor(order_, m1, x[0]);
    const Factor b = lattice_factor(order_, m2, x[1]);
    const Factor c = lattice_factor(order_, order_ - m1 - m2, 1 - x[0] - x[1]);
    const double both = a.value * b.value * c.bend;
    ddphi(0, i) = both + (a.bend * c.value - 2 * a.slope * c.slope) * b.value;
    ddphi(1, i) =
        both + a.slope * b.slope * c.value - (a.slope * b.value + a.value * b.slope) * c.slope;
    ddphi(2, i) = both + (b.bend * c.value - 2 * b.slope * c.slope) * a.value;
  }
  return ddphi;
}

}  // namespace sbeh::model
