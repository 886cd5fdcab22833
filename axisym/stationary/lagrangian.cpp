#include "axisym/stationary/lagrangian.h"

#include "axisym/stationary/normal_shapes.h"
#include "model/numerics/contraction.h"
#include "model/numerics/second_order.h"

#include <ceres/jet.h>

namespace sbeh::axisym {

namespace {

constexpr int data = lagrangian_data;
constexpr int element_unknowns = 4 * node_unknowns;
using First = ceres::Jet<double, nonlinear_data>;
using Second = model::SecondOrder<nonlinear_data>;

// Rows of B in the order of LagrangianData; element unknowns component-wise.
std::array<model::DataRow<4>, data> data_rows(const NormalShapes& n, const ShapeValues& s) {
  constexpr int d = 4 * node_d, Lambda = 4 * node_Lambda, H = 4 * node_H, beta = 4 * node_beta;
  return {{{d, n.r.data()},
           {d, n.dr.data()},
           {d, n.dz.data()},
           {H, s.phi.data()},
           {beta, s.phi.data()},
           {beta, s.dphi.data()},
           {Lambda, n.r.data()},
           {Lambda, n.z.data()},
           {Lambda, n.dr.data()},
           {Lambda, n.dz.data()}}};
}

std::array<double, data> point_data(const StationaryState& state, const NormalShapes& n, int e,
                                    const ShapeValues& s) {
  std::array<double, data> q{};
  for (int a = 0; a < 4; ++a) {
    const int i = 3 * e + a;
    q[at_r] += s.phi[a] * state.X(0, i);
    q[at_dr] += s.dphi[a] * state.X(0, i);
    q[at_dz] += s.dphi[a] * state.X(1, i);
    q[at_Lambda_r] += n.r[a] * state.Lambda[i];
    q[at_Lambda_z] += n.z[a] * state.Lambda[i];
    q[at_dLambda_r] += n.dr[a] * state.Lambda[i];
    q[at_dLambda_z] += n.dz[a] * state.Lambda[i];
  }
  q[at_H] = value_at(state.H, e, s);
  q[at_beta] = value_at(state.beta, e, s);
  q[at_dbeta] = slope_at(state.beta, e, s);
  return q;
}

template <class T>
PointFields<T> independent(const std::array<double, data>& q) {
  PointFields<T> x;
  for (int i = 0; i < nonlinear_data; ++i) x[i] = T(q[i], i);
  return x;
}

// Gradient and Hessian of the density by all data.
struct PointDerivatives {
  Eigen::Matrix<double, data, 1> gradient;
  Eigen::Matrix<double, data, data> hessian;
};
PointDerivatives differentiate(const model::Material& material, double tension, double pressure,
                               const std::array<double, data>& q) {
  const auto density = lagrangian_density(material, tension, pressure, independent<Second>(q));
  PointDerivatives d;
  d.hessian.setZero();
  auto gradient = d.gradient.head<nonlinear_data>();
  auto hessian = d.hessian.topLeftCorner<nonlinear_data, nonlinear_data>();
  gradient = density.energy.gradient();
  hessian = density.energy.hessian();
  for (int k = 0; k < 4; ++k) {
    const Second& c = density.curvature[k];
    const int i = nonlinear_data + k;
    gradient += q[i] * c.gradient();
    hessian += q[i] * c.hessian();
    d.gradient[i] = c.a;
    d.hessian.col(i).head<nonlinear_data>() = c.gradient();
    d.hessian.row(i).head<nonlinear_data>() = c.gradient().transpose();
  }
  return d;
}

// Of unknown k of element e, component by component.
int global_index(const Sector& sector, int e, int k) {
  return node_unknowns * sector.folded(3 * e + k % 4) + k / 4;
}

// ∂(density) by all data for a density that does not know the multiplier.
Eigen::Matrix<double, data, 1> padded(const First& density) {
  Eigen::Matrix<double, data, 1> g = Eigen::Matrix<double, data, 1>::Zero();
  g.head<nonlinear_data>() = density.v;
  return g;
}

// From ∂W₂ to what the moment's equation has: less c/(π k_ad) ∂A; and from −∂∫β dS to that of the chemical potential.
template <class Derivatives>
void finish(const model::Material& material, double moment, Derivatives& out) {
  if (!material.area_difference.is_there())
    out.of_W2.setZero();
  else
    out.of_W2 -= moment * material.area_difference.compliance() * out.constraints.col(0);
  if (material.conserves_order())
    out.of_order += *material.mean_order * out.constraints.col(0);
  else
    out.of_order.setZero();
}

}  // namespace

LagrangianDerivatives::LagrangianDerivatives(const Sector& of)
    : sector(of),
      hessian(node_unknowns * of.nodes(), 4 * node_unknowns - 1),
      gradient(node_unknowns * of.nodes()),
      constraints(node_unknowns * of.nodes(), 2),
      of_W2(node_unknowns * of.nodes()),
      of_order(node_unknowns * of.nodes()) {}

void assemble(const model::Material& whole, const StationaryState& state, const Nodes& normals,
              LagrangianDerivatives& out) {
  const model::Material material = held_material(whole, state);
  const double tension = felt_tension(whole, state);
  out.hessian.set_zero();
  out.gradient.setZero();
  out.constraints.setZero();
  out.of_W2.setZero();
  out.of_order.setZero();
  out.area = out.volume = out.W2 = out.order = 0;
  Eigen::Matrix<double, element_unknowns, element_unknowns> matrix;
  Eigen::Matrix<double, element_unknowns, 1> vector, dA, dV, dW2, dOrder;
  for (int e = 0; e < out.sector.elements(); ++e) {
    matrix.setZero();
    vector.setZero();
    dA.setZero();
    dV.setZero();
    dW2.setZero();
    dOrder.setZero();
    for (const ShapeValues& s : assembly_points()) {
      const NormalShapes shapes(normals, e, s);
      const auto rows = data_rows(shapes, s);
      const auto q = point_data(state, shapes, e, s);
      const PointDerivatives density = differentiate(material, tension, state.pressure, q);
      const auto x = independent<First>(q);
      const First A = area_density(material, x), V = volume_density(x), W2 = A * x[at_H],
                  order = A * x[at_beta];
      const double weight = out.sector.copies(e) * s.weight;
      model::add_matrix(rows, rows, density.hessian, weight, matrix);
      model::add_vector(rows, density.gradient, weight, vector);
      model::add_vector(rows, padded(A), weight, dA);
      model::add_vector(rows, padded(V), weight, dV);
      model::add_vector(rows, padded(W2), weight, dW2);
      model::add_vector(rows, padded(order), weight, dOrder);
      out.area += weight * A.a;
      out.volume += weight * V.a;
      out.W2 += weight * W2.a;
      out.order += weight * order.a;
    }
    const auto global = [&](int k) { return global_index(out.sector, e, k); };
    for (int j = 0; j < element_unknowns; ++j) {
      out.gradient[global(j)] += vector[j];
      out.constraints(global(j), 0) += dA[j];
      out.constraints(global(j), 1) -= dV[j];
      out.of_W2[global(j)] += dW2[j];
      out.of_order[global(j)] -= dOrder[j];
      for (int i = 0; i < element_unknowns; ++i) out.hessian(global(i), global(j)) += matrix(i, j);
    }
  }
  finish(whole, state.moment, out);
}

LagrangianGradient gradient_at(const model::Material& whole, const StationaryState& state,
                               const Nodes& normals, const Sector& sector) {
  const model::Material material = held_material(whole, state);
  const double tension = felt_tension(whole, state);
  const Eigen::Index unknowns = node_unknowns * sector.nodes();
  LagrangianGradient out{Eigen::VectorXd::Zero(unknowns), Eigen::MatrixXd::Zero(unknowns, 2),
                         Eigen::VectorXd::Zero(unknowns), Eigen::VectorXd::Zero(unknowns)};
  Eigen::Matrix<double, element_unknowns, 1> vector, dA, dV, dW2, dOrder;
  for (int e = 0; e < sector.elements(); ++e) {
    vector.setZero();
    dA.setZero();
    dV.setZero();
    dW2.setZero();
    dOrder.setZero();
    for (const ShapeValues& s : assembly_points()) {
      const NormalShapes shapes(normals, e, s);
      const auto rows = data_rows(shapes, s);
      const auto q = point_data(state, shapes, e, s);
      const auto x = independent<First>(q);
      const auto density = lagrangian_density(material, tension, state.pressure, x);
      Eigen::Matrix<double, data, 1> gradient = padded(density.energy);
      for (int k = 0; k < 4; ++k) {
        const First& c = density.curvature[k];
        gradient += padded(q[nonlinear_data + k] * c);
        gradient[nonlinear_data + k] = c.a;
      }
      const First A = area_density(material, x), V = volume_density(x), W2 = A * x[at_H],
                  order = A * x[at_beta];
      const double weight = sector.copies(e) * s.weight;
      model::add_vector(rows, gradient, weight, vector);
      model::add_vector(rows, padded(A), weight, dA);
      model::add_vector(rows, padded(V), weight, dV);
      model::add_vector(rows, padded(W2), weight, dW2);
      model::add_vector(rows, padded(order), weight, dOrder);
      out.area += weight * A.a;
      out.volume += weight * V.a;
      out.W2 += weight * W2.a;
      out.order += weight * order.a;
    }
    for (int k = 0; k < element_unknowns; ++k) {
      const int i = global_index(sector, e, k);
      out.gradient[i] += vector[k];
      out.constraints(i, 0) += dA[k];
      out.constraints(i, 1) -= dV[k];
      out.of_W2[i] += dW2[k];
      out.of_order[i] -= dOrder[k];
    }
  }
  finish(whole, state.moment, out);
  return out;
}

LagrangianDerivatives lagrangian_at(const model::Material& material, model::Model model,
                                    const StationaryState& state) {
  LagrangianDerivatives lagrangian(Sector{element_count(state.X), false});
  assemble(felt_material(material, model), state, node_normals(state.X), lagrangian);
  return lagrangian;
}

Eigen::VectorXd gradient_difference(const model::Material& a, const model::Material& b,
                                    const StationaryState& state, const Nodes& normals) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(node_unknowns * state.beta.size());
  Eigen::Matrix<double, element_unknowns, 1> vector;
  for (int e = 0; e < element_count(state.X); ++e) {
    vector.setZero();
    for (const ShapeValues& s : assembly_points()) {
      const NormalShapes shapes(normals, e, s);
      const auto q = independent<First>(point_data(state, shapes, e, s));
      const First difference =
          lagrangian_density(a, 0, 0, q).energy - lagrangian_density(b, 0, 0, q).energy;
      model::add_vector(data_rows(shapes, s), padded(difference), s.weight, vector);
    }
    for (int k = 0; k < element_unknowns; ++k)
      sum[node_unknowns * (3 * e + k % 4) + k / 4] += vector[k];
  }
  return sum;
}

}  // namespace sbeh::axisym
