#include "surface3d/element_system.h"

#include "model/numerics/contraction.h"
#include "surface3d/curvature.h"

#include <ceres/jet.h>

#include <algorithm>

namespace sbeh::surface3d {

namespace {

// Four derivatives more than there are numbers: a multiple of eight, for whole vector registers.
using Jet = ceres::Jet<double, int(unknowns_size) + 4>;

// Columns V, H, and rows W and W_n, as long as V, of the sums of outer products.
constexpr int H_column = 30, normal_row = 30;

// In the order of Unknowns.
std::array<model::DataRow<10>, unknowns_size> unknown_rows(const ShapeValues& s,
                                                           const SurfacePoint& x) {
  std::array<model::DataRow<10>, unknowns_size> rows{};
  auto* row = rows.data();
  for (int k = 0; k < 3; ++k) *row++ = {10 * k, s.phi.data()};
  for (int k = 0; k < 3; ++k)
    for (const auto& grad : x.grad) *row++ = {10 * k, grad.data()};
  *row++ = {H_column, s.phi.data()};
  for (const auto& grad : x.grad) *row++ = {H_column, grad.data()};
  return rows;
}

// In the order of Tested, from those of the unknowns.
std::array<model::DataRow<10>, tested_size> test_rows(
    const std::array<model::DataRow<10>, unknowns_size>& unknowns) {
  std::array<model::DataRow<10>, tested_size> rows{};
  std::copy_n(unknowns.begin(), 9, rows.begin());
  for (std::size_t k = 3; k < 9; ++k)
    rows[6 + k] = {normal_row + unknowns[k].first, unknowns[k].shape};
  return rows;
}

template <class Vector, class Visit>
void for_each_component(Vector& V, Visit&& visit) {
  for (int k = 0; k < int(V.rows()); ++k)
    for (int i = 0; i < int(V.cols()); ++i) visit(V(k, i));
}

// The unknowns as independent variables at zero: the flow is linear, so that the value of the pointwise
// function there is its constant part and the derivative its matrix.
Unknowns<Jet> independent_unknowns() {
  Unknowns<Jet> u;
  int k = 0;
  const auto set = [&k](Jet& number) { number = Jet(0., k++); };
  for_each_component(u.V, set);
  for_each_component(u.dV, set);
  set(u.H);
  for_each_component(u.dH, set);
  return u;
}

// C with C y = x × y.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& x) {
  Eigen::Matrix3d C;
  C << 0, -x[2], x[1], x[2], 0, -x[0], -x[1], x[0], 0;
  return C;
}

// The friction of a velocity, in parts of the larger coefficient; the velocity itself where there is none. A
// body of revolution turns without normal friction but for what the mesh adds, of some 1e-6, and where
// friction is to find what is left of a turn it finds nothing but errors. So a share along the surface always counts.
Eigen::Matrix3d relative_friction(const model::Material& m, const Eigen::Vector3d& nu) {
  if (m.frictionless()) return Eigen::Matrix3d::Identity();
  constexpr double least_share = 1e-4;
  const double larger = std::max(m.friction_tangential, m.friction_normal);
  const double along = std::max(m.friction_tangential / larger, least_share);
  return along * Eigen::Matrix3d::Identity()
       + (m.friction_normal / larger - along) * nu * nu.transpose();
}

void add_constraints(const model::Material& m, const SurfacePoint& x, const Shapes& phi,
                     ElementSystem& out) {
  Eigen::Matrix<double, 3, 7> directions;  // ν, e_k, e_k × x
  directions << x.nu(), Eigen::Matrix3d::Identity(), -cross_matrix(x.x);
  directions.rightCols<6>() = (relative_friction(m, x.nu()) * directions.rightCols<6>()).eval();
  for (int k = 0; k < 3; ++k)
    out.constraints.middleRows<10>(10 * k) += phi * (x.dS * directions.row(k));  // (V4), (P2)
}

// The P2 functions by the P3 functions of the same triangle.
const Eigen::Matrix<double, 10, 6>& quadratic_by_cubic() {
  static const Eigen::Matrix<double, 10, 6> table = [] {
    Eigen::Matrix<double, 10, 6> values;
    for (int a = 0; a < 10; ++a)
      values.row(a) = Shapes(node_points()[std::size_t(a)].quadratic.data()).head<6>();
    return values;
  }();
  return table;
}

// (p, Div_C W) and (∇p, W) by the components of W.
struct Pressure {
  using Block = Eigen::Matrix<double, 30, 6>;
  Block divergence = Block::Zero(), gradient = Block::Zero();

  void add(const SurfacePoint& x, const ShapeValues& s) {
    Eigen::Matrix<double, 2, 10> cubic;
    for (int i = 0; i < 2; ++i) cubic.row(i) = Shapes(x.grad[std::size_t(i)].data());
    const Eigen::Matrix<double, 3, 6> grad_p =
        x.frame.leftCols<2>() * (cubic * quadratic_by_cubic());
    const Eigen::Matrix<double, 3, 10> div = x.frame.leftCols<2>() * cubic;
    const Shapes phi(s.phi.data());
    const auto p = Shapes(s.quadratic.data()).head<6>();
    for (int k = 0; k < 3; ++k) {
      divergence.middleRows<10>(10 * k) += x.dS * div.row(k).transpose() * p.transpose();
      gradient.middleRows<10>(10 * k) += x.dS * phi * grad_p.row(k);
    }
  }
};

// Rows of test functions W by components: those of its part along the node normals.
template <class Rows>
Rows along(const ElementNodes& n, const Rows& rows) {
  const Eigen::Index columns = rows.cols();
  Eigen::Matrix<double, 10, Rows::ColsAtCompileTime> normal = decltype(normal)::Zero(10, columns);
  for (int k = 0; k < 3; ++k)
    normal += n.row(k).transpose().asDiagonal() * rows.template middleRows<10>(10 * k);
  Rows part = rows;
  for (int k = 0; k < 3; ++k)
    part.template middleRows<10>(10 * k) = n.row(k).transpose().asDiagonal() * normal;
  return part;
}

}  // namespace

void assemble_element(const model::Material& material, const ElementState& old, double area_rate,
                      ElementSystem& out) {
  constexpr int p = FlowPiece::p, q = FlowPiece::q, H = FlowPiece::H;
  static const Unknowns<Jet> independent = independent_unknowns();
  static thread_local model::BlockMatrix<10, 6, 4> products;
  products.set_zero();
  Eigen::Matrix<double, 60, 1> constants = decltype(constants)::Zero();
  Eigen::Matrix<double, 30, 1> order = decltype(order)::Zero();
  Eigen::Matrix<double, 6, 1> rate = decltype(rate)::Zero();
  Pressure pressure;
  out.constraints.setZero();
  out.mesh.set_zero();
  for (const ShapeValues& s : assembly_points()) {
    const SurfacePoint x = surface_point(old.X, s);
    const OldPoint point{.geometry = x,
                         .beta = value_at(old.beta, s),
                         .grad_beta = gradient_at(old.beta, x),
                         .B = shape_operator(x, old.projected_normals, value_at(old.H, s))};
    const Tested<Jet> test = flow_point(material, point, independent);
    Eigen::Matrix<double, int(tested_size), Jet::DIMENSION, Eigen::RowMajor> D;
    Eigen::Matrix<double, int(tested_size), 1> constant;
    int i = 0;
    const auto set = [&](const Jet& factor) {
      D.row(i) = factor.v.transpose();
      constant[i++] = -factor.a;
    };
    for_each_component(test.W, set);
    for_each_component(test.dW, set);
    for_each_component(test.dW_n, set);
    const auto unknowns = unknown_rows(s, x);
    const auto tests = test_rows(unknowns);
    model::add_matrix(tests, unknowns, D, x.dS, products);
    model::add_vector(tests, constant, x.dS, constants);

    const Shapes phi(s.phi.data());
    const double h = value_at(old.order_force, s);
    const Eigen::Vector3d traction =
        x.frame.leftCols<2>() * model::order_traction(h, point.grad_beta);  // (V12)
    for (int k = 0; k < 3; ++k) order.segment<10>(10 * k) += x.dS * traction[k] * phi;
    rate += x.dS * area_rate * Shapes(s.quadratic.data()).head<6>();  // (P1)
    pressure.add(x, s);
    add_constraints(material, x, phi, out);
    out.mesh.add(x, phi);
  }

  const ElementNodes& n = old.node_normals;
  const Eigen::Matrix<double, 60, 40> sum = products.dense();
  const Eigen::Matrix<double, 30, 10> force = sum.block<30, 10>(normal_row, H_column);
  const Eigen::Matrix<double, 30, 1> constant_force = constants.tail<30>();
  const Pressure::Block p_force =
      pressure.gradient - along(n, Pressure::Block(pressure.divergence + pressure.gradient));
  out.flow.setZero();
  out.flow.topLeftCorner<30, 30>() = sum.topLeftCorner<30, 30>();
  out.flow.block<30, 6>(0, p) = p_force;  // (V3)
  out.flow.block<30, 10>(0, H) = along(n, force);
  out.flow.block<6, 30>(q, 0) = -p_force.transpose();  // (P1)
  out.rhs << along(n, constant_force) + order - along(n, order), rate;
  out.constraints.col(0) = along(n, Eigen::Matrix<double, 30, 1>(out.constraints.col(0)));
}

}  // namespace sbeh::surface3d
