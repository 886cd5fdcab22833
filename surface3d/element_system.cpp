#include "surface3d/element_system.h"

#include "model/numerics/contraction.h"

#include <ceres/jet.h>

namespace sbeh::surface3d {

namespace {

// Three derivatives more than there are numbers: a multiple of eight, for whole vector registers.
using Jet = ceres::Jet<double, int(flow_data_size) + 3>;

// The numbers of the data in the order of data_rows.
template <class T, class Visit>
void for_each_number(FlowData<T>& d, Visit&& visit) {
  for (int k = 0; k < 3; ++k) visit(d.V[k]);
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 2; ++i) visit(d.dV(k, i));
  visit(d.p);
  visit(d.H);
  for (int i = 0; i < 2; ++i) visit(d.dH[i]);
}

std::array<model::DataRow<10>, flow_data_size> data_rows(const ShapeValues& s,
                                                         const SurfacePoint& x) {
  std::array<model::DataRow<10>, flow_data_size> rows{};
  auto* row = rows.data();
  const auto values = [&](int first) { *row++ = {first, s.phi.data()}; };
  const auto gradients = [&](int first) {
    for (const auto& grad : x.grad) *row++ = {first, grad.data()};
  };
  for (int k = 0; k < 3; ++k) values(local::V + 10 * k);
  for (int k = 0; k < 3; ++k) gradients(local::V + 10 * k);
  *row++ = {local::p, s.quadratic.data()};
  values(local::H);
  gradients(local::H);
  return rows;
}

// The data as independent variables at zero: the flow is linear, so that the value of the pointwise
// function there is its constant part and the derivative its matrix.
FlowData<Jet> independent_data() {
  FlowData<Jet> d;
  int k = 0;
  for_each_number(d, [&k](Jet& number) { number = Jet(0., k++); });
  return d;
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
    out.constraints.middleRows<10>(10 * k) += phi * (x.dS * directions.row(k));
}

void add_mesh(const SurfacePoint& x, const Shapes& phi, ElementSystem& out) {
  for (int k = 0; k < 3; ++k)
    out.normal_mass[std::size_t(k)].noalias() += phi * (x.dS * x.nu()[k] * phi).transpose();
  for (const auto& slope : x.grad) {
    const Shapes along(slope.data());
    out.stiffness.noalias() += along * (x.dS * along).transpose();
  }
}

}  // namespace

void assemble_element(const model::Material& material, const ElementState& old,
                      const StepParameters& step, ElementSystem& out) {
  static const FlowData<Jet> independent = independent_data();
  static thread_local model::BlockMatrix<10, local::size / 10> flow;
  flow.set_zero();
  out.rhs.setZero();
  out.constraints.setZero();
  out.normal_mass.fill(ElementSystem::Scalar::Zero());
  out.stiffness.setZero();
  for (const ShapeValues& s : assembly_points()) {
    const SurfacePoint x = surface_point(old.X, s);
    const OldPoint point{.geometry = x,
                         .beta = value_at(old.beta, s),
                         .grad_beta = gradient_at(old.beta, x),
                         .B = shape_operator(x, old.normals, value_at(old.H, s))};
    FlowData<Jet> g = flow_point(material, point, step, independent);
    Eigen::Matrix<double, int(flow_data_size), Jet::DIMENSION, Eigen::RowMajor> D;
    Eigen::Matrix<double, int(flow_data_size), 1> constant;
    int i = 0;
    for_each_number(g, [&](const Jet& number) {
      D.row(i) = number.v.transpose();
      constant[i++] = -number.a;
    });
    const auto rows = data_rows(s, x);
    model::add_matrix(rows, D, x.dS, flow);
    model::add_vector(rows, constant, x.dS, out.rhs);
    const Shapes phi(s.phi.data());
    add_constraints(x, phi, out);
    add_mesh(x, phi, out);
  }
  out.flow = flow.dense();
}

}  // namespace sbeh::surface3d
