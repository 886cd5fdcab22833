#include "surface3d/element_system.h"

#include "model/numerics/contraction.h"
#include "surface3d/curvature.h"

#include <ceres/jet.h>

#include <algorithm>

namespace sbeh::surface3d {

namespace {

// Three derivatives more than there are numbers: a multiple of eight, for whole vector registers.
using Jet = ceres::Jet<double, int(unknowns_size) + 3>;

// In the order of Unknowns; the first ones are in that of Tested.
std::array<model::DataRow<10>, unknowns_size> data_rows(const ShapeValues& s,
                                                        const SurfacePoint& x) {
  std::array<model::DataRow<10>, unknowns_size> rows{};
  auto* row = rows.data();
  const auto values = [&](int first) { *row++ = {first, s.phi.data()}; };
  const auto gradients = [&](int first) {
    for (const auto& grad : x.grad) *row++ = {first, grad.data()};
  };
  for (int k = 0; k < 3; ++k) values(padded::V + 10 * k);
  for (int k = 0; k < 3; ++k) gradients(padded::V + 10 * k);
  *row++ = {padded::p, s.quadratic.data()};
  values(padded::H);
  gradients(padded::H);
  return rows;
}

// The numbers of V or W with its gradient, and of p or q, in the order of the rows.
template <class Vector, class Gradient, class T, class Visit>
void for_each_number(Vector& V, Gradient& dV, T& p, Visit&& visit) {
  for (int k = 0; k < 3; ++k) visit(V[k]);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 2; ++i) visit(dV(k, i));
  visit(p);
}

// The unknowns as independent variables at zero: the flow is linear, so that the value of the pointwise
// function there is its constant part and the derivative its matrix.
Unknowns<Jet> independent_unknowns() {
  Unknowns<Jet> u;
  int k = 0;
  const auto set = [&k](Jet& number) { number = Jet(0., k++); };
  for_each_number(u.V, u.dV, u.p, set);
  set(u.H);
  for (int i = 0; i < 2; ++i) set(u.dH[i]);
  return u;
}

// C with C y = x × y.
Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& x) {
  Eigen::Matrix3d C;
  C << 0, -x[2], x[1], x[2], 0, -x[0], -x[1], x[0], 0;
  return C;
}

void add_constraints(const SurfacePoint& x, const Shapes& phi, ElementSystem& out) {
  Eigen::Matrix<double, 3, 7> directions;  // ν, e_k, e_k × x
  directions << x.nu(), Eigen::Matrix3d::Identity(), -cross_matrix(x.x);
  for (int k = 0; k < 3; ++k)
    out.constraints.middleRows<10>(10 * k) += phi * (x.dS * directions.row(k));  // (V4), (P2)
}

}  // namespace

void assemble_element(const model::Material& material, const ElementState& old,
                      const StepParameters& step, ElementSystem& out) {
  static const Unknowns<Jet> independent = independent_unknowns();
  static thread_local model::BlockMatrix<10, padded::tests / 10, padded::size / 10> flow;
  flow.set_zero();
  out.rhs.setZero();
  out.constraints.setZero();
  out.mesh.set_zero();
  for (const ShapeValues& s : assembly_points()) {
    const SurfacePoint x = surface_point(old.X, s);
    const OldPoint point{.geometry = x,
                         .beta = value_at(old.beta, s),
                         .grad_beta = gradient_at(old.beta, x),
                         .B = shape_operator(x, old.normals, value_at(old.H, s))};
    const Tested<Jet> test = flow_point(material, point, step, independent);
    Eigen::Matrix<double, int(tested_size), Jet::DIMENSION, Eigen::RowMajor> D;
    Eigen::Matrix<double, int(tested_size), 1> constant;
    int i = 0;
    for_each_number(test.W, test.dW, test.q, [&](const Jet& factor) {
      D.row(i) = factor.v.transpose();
      constant[i++] = -factor.a;
    });
    const auto rows = data_rows(s, x);
    std::array<model::DataRow<10>, tested_size> tests{};
    std::copy_n(rows.begin(), tested_size, tests.begin());
    model::add_matrix(tests, rows, D, x.dS, flow);
    model::add_vector(tests, constant, x.dS, out.rhs);
    const Shapes phi(s.phi.data());
    add_constraints(x, phi, out);
    out.mesh.add(x, phi);
  }
  out.flow = flow.dense();
}

}  // namespace sbeh::surface3d
