#include "surface3d/element_system.h"

#include "model/numerics/contraction.h"
#include "surface3d/curvature.h"

#include <ceres/jet.h>

#include <algorithm>

namespace sbeh::surface3d {

namespace {

using Rows = std::array<model::DataRow<10>, 3>;
// A value and its gradient along (e1, e2), of ten numbers.
Rows scalar_rows(const ShapeValues& s, const SurfacePoint& x) {
  return {{{0, s.phi.data()}, {0, x.grad[0].data()}, {0, x.grad[1].data()}}};
}
// The numbers of V or W, three times ten, in the order of Velocity and Tested.
std::array<model::DataRow<10>, 9> vector_rows(const ShapeValues& s, const SurfacePoint& x) {
  std::array<model::DataRow<10>, 9> rows{};
  auto* row = rows.data();
  for (int k = 0; k < 3; ++k) *row++ = {10 * k, s.phi.data()};
  for (int k = 0; k < 3; ++k)
    for (const auto& grad : x.grad) *row++ = {10 * k, grad.data()};
  return rows;
}

template <class Vector, class Visit>
void for_each_component(Vector& V, Visit&& visit) {
  for (int k = 0; k < int(V.rows()); ++k)
    for (int i = 0; i < int(V.cols()); ++i) visit(V(k, i));
}

// The unknowns as independent variables at zero: the forms are linear, so that the value of a pointwise
// function there is its constant part and the derivative its matrix. The numbers of derivatives are filled up to
// whole vector registers.
using VelocityJet = ceres::Jet<double, 16>;
Velocity<VelocityJet> independent_velocity() {
  Velocity<VelocityJet> u;
  int k = 0;
  const auto set = [&k](VelocityJet& number) { number = VelocityJet(0., k++); };
  for_each_component(u.V, set);
  for_each_component(u.dV, set);
  return u;
}
using CurvatureJet = ceres::Jet<double, 4>;
NextCurvature<CurvatureJet> independent_curvature() {
  return {CurvatureJet(0., 0), {CurvatureJet(0., 1), CurvatureJet(0., 2)}};
}

// (V1), (V2): rows W, columns V. Symmetric: what is below the diagonal blocks is not added up.
struct Resistance {
  model::BlockMatrix<10, 3, 3> sum;

  void add(const model::Material& material, const OldPoint& point, const ShapeValues& s) {
    static const Velocity<VelocityJet> V = independent_velocity();
    const Tested<VelocityJet> resistance = resistance_at(material, point, V);
    Eigen::Matrix<double, 9, VelocityJet::DIMENSION, Eigen::RowMajor> D;
    int i = 0;
    const auto set = [&](const VelocityJet& factor) { D.row(i++) = factor.v.transpose(); };
    for_each_component(resistance.W, set);
    for_each_component(resistance.dW, set);
    const auto rows = vector_rows(s, point.geometry);
    for (std::size_t test = 0; test < 9; ++test)
      for (std::size_t trial = 0; trial < 9; ++trial)
        if (rows[trial].first < rows[test].first) D(Eigen::Index(test), Eigen::Index(trial)) = 0;
    model::add_matrix(rows, rows, D, point.geometry.dS, sum);
  }
  Eigen::Matrix<double, 30, 30> matrix() const {
    Eigen::Matrix<double, 30, 30> all = sum.dense();
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < i; ++j)
        all.block<10, 10>(10 * i, 10 * j) = all.block<10, 10>(10 * j, 10 * i).transpose();
    return all;
  }
};

// (V5)–(V11): rows W_n, columns H, and what is known.
struct ElasticForce {
  model::BlockMatrix<10, 3, 1> sum;
  Eigen::Matrix<double, 30, 1> rhs = decltype(rhs)::Zero();

  void add(const model::Material& material, const OldPoint& point, const ShapeValues& s) {
    static const NextCurvature<CurvatureJet> H = independent_curvature();
    const CartesianGradient<CurvatureJet> test = elastic_force_at(material, point, H);
    Eigen::Matrix<double, 6, CurvatureJet::DIMENSION, Eigen::RowMajor> D;
    Eigen::Matrix<double, 6, 1> constant;
    int i = 0;
    for_each_component(test, [&](const CurvatureJet& factor) {
      D.row(i) = factor.v.transpose();
      constant[i++] = -factor.a;
    });
    const SurfacePoint& x = point.geometry;
    std::array<model::DataRow<10>, 6> gradients{};
    const auto rows = vector_rows(s, x);
    std::copy(rows.begin() + 3, rows.end(), gradients.begin());
    model::add_matrix(gradients, scalar_rows(s, x), D, x.dS, sum);
    model::add_vector(gradients, constant, x.dS, rhs);
  }
};

// (V13)
struct Moment {
  Eigen::Matrix<double, 30, 1> force = decltype(force)::Zero();

  void add(const OldPoint& point) {
    const SurfacePoint& x = point.geometry;
    const CartesianGradient<double> test = x.frame * model::moment_stress(point.B);  // (V13)
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 2; ++i)
        force.segment<10>(10 * k) += x.dS * test(k, i) * Shapes(x.grad[std::size_t(i)].data());
  }
};

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

// What the multipliers meet, before (ν, W) is taken along the node normals.
struct ConstraintSums {
  model::BlockMatrix<10, 3, 1> sum;

  void add(const model::Material& m, const SurfacePoint& x, const ShapeValues& s) {
    Eigen::Matrix<double, 3, 7> directions;  // ν, e_k, e_k × x
    directions << x.nu(), Eigen::Matrix3d::Identity(), -cross_matrix(x.x);
    directions.rightCols<6>() = (relative_friction(m, x.nu()) * directions.rightCols<6>()).eval();
    const auto test = decltype(sum)::column(s.phi.data(), x.dS);
    for (int k = 0; k < 3; ++k)  // (V4), (P2)
      sum.add_outer(10 * k, 0, test, Eigen::Matrix<double, 7, 1>(directions.row(k)));
  }
};

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

// (p, Div_C W) and (∇p, W) by the components of W; p is n/n(2/3) times its unknown.
struct Pressure {
  using Block = Eigen::Matrix<double, 30, 6>;
  model::BlockMatrix<10, 3, 2> sum;

  void add(const model::Material& m, const OldPoint& point, const ShapeValues& s) {
    const SurfacePoint& x = point.geometry;
    Eigen::Matrix<double, 10, 2> cubic;
    for (int i = 0; i < 2; ++i) cubic.col(i) = Shapes(x.grad[std::size_t(i)].data());
    const auto tangents = x.frame.leftCols<2>().transpose();
    Eigen::Matrix<double, 6, 3> grad_p = (quadratic_by_cubic().transpose() * cubic) * tangents;
    const Eigen::Matrix<double, 10, 3> div = cubic * tangents;
    Eigen::Matrix<double, 6, 1> p = Shapes(s.quadratic.data()).head<6>();
    if (m.has_lipid_density()) {
      grad_p = m.packing(point.beta) * grad_p
             + m.packing_slope(point.beta) * p * point.grad_beta.transpose() * tangents;
      p *= m.packing(point.beta);
    }
    const auto W = decltype(sum)::column(s.phi.data(), x.dS);
    for (int k = 0; k < 3; ++k) {
      sum.add_outer(10 * k, 0, decltype(sum)::column(div.col(k).data(), x.dS), p);
      sum.add_outer(10 * k, 10, W, grad_p.col(k));
    }
  }
  /// (p, Div_C W_n) − (∇p, W_t) with the node normals n, times −1.
  Block force(const ElementNodes& n) const;
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

Pressure::Block Pressure::force(const ElementNodes& n) const {
  const Eigen::Matrix<double, 30, 20> sums = sum.dense();
  const Block divergence = sums.leftCols<6>(), gradient = sums.middleCols<6>(10);
  return gradient - along(n, Block(divergence + gradient));
}

}  // namespace

void assemble_element(const model::Material& material, const ElementState& old, double area_rate,
                      ElementSystem& out) {
  constexpr int p = FlowPiece::p, q = FlowPiece::q, H = FlowPiece::H;
  Resistance resistance;
  ElasticForce force;
  Pressure pressure;
  ConstraintSums constraints;
  MeshSums mesh;
  Moment moment;
  const bool has_moment = material.area_difference.is_there();
  Eigen::Matrix<double, 30, 1> order = decltype(order)::Zero();
  Eigen::Matrix<double, 6, 1> rate = decltype(rate)::Zero();
  for (const ShapeValues& s : assembly_points()) {
    const SurfacePoint x = surface_point(old.X, s);
    const OldPoint point{.geometry = x,
                         .beta = value_at(old.beta, s),
                         .grad_beta = gradient_at(old.beta, x),
                         .B = shape_operator(x, old.projected_normals, value_at(old.H, s))};
    resistance.add(material, point, s);
    force.add(material, point, s);
    pressure.add(material, point, s);
    constraints.add(material, x, s);
    if (has_moment) moment.add(point);

    const Shapes phi(s.phi.data());
    mesh.add(x, phi);
    const double h = value_at(old.order_force, s);
    const Eigen::Vector3d traction =
        x.frame.leftCols<2>() * model::order_traction(h, point.grad_beta);  // (V12)
    for (int k = 0; k < 3; ++k) order.segment<10>(10 * k) += x.dS * traction[k] * phi;
    rate += x.dS * area_rate * Shapes(s.quadratic.data()).head<6>();  // (P1)
  }

  const ElementNodes& n = old.node_normals;
  const Pressure::Block p_force = pressure.force(n);
  out.flow.setZero();
  out.flow.topLeftCorner<30, 30>() = resistance.matrix();
  out.flow.block<30, 6>(0, p) = p_force;  // (V3)
  out.flow.block<30, 10>(0, H) = along(n, force.sum.dense());
  out.flow.block<6, 30>(q, 0) = -p_force.transpose();  // (P1)
  out.rhs << along(n, force.rhs) + order - along(n, order), rate;
  out.constraints = constraints.sum.dense().leftCols<7>();
  out.constraints.col(0) = along(n, Eigen::Matrix<double, 30, 1>(out.constraints.col(0)));
  if (has_moment) out.moment = along(n, moment.force);
  out.mesh = mesh.equation();
}

}  // namespace sbeh::surface3d
