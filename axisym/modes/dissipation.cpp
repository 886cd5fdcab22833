#include "axisym/modes/dissipation.h"

#include "axisym/stationary/normal_shapes.h"
#include "model/numerics/contraction.h"

namespace sbeh::axisym {

namespace {

// What a motion is at a point: ḋ along the node normals with its derivative by ξ, ḃ, v_t, v_φ and p.
enum Motion {
  of_d_r,
  of_d_z,
  of_d_r_xi,
  of_d_z_xi,
  of_beta,
  of_v_t,
  of_v_t_xi,
  of_v_phi,
  of_v_phi_xi,
  of_p,
  motions
};
using Linear = Eigen::Matrix<double, motions, 1>;
using Form = Eigen::Matrix<double, motions, motions>;

// The velocity at a point and its gradient, each as a linear form of the motion.
struct Velocity {
  Linear t = Linear::Zero(), phi = Linear::Zero(), normal = Linear::Zero();
  Linear e_tt = Linear::Zero(), e_phi_phi = Linear::Zero();
  Linear shear = Linear::Zero();  // 2 e_tφ, with sin mφ
  Velocity(const CurvePoint& p, int m) {
    const double r = p.x[0];
    for (const int k : {0, 1}) {
      t[of_d_r + k] = p.t[k];
      normal[of_d_r + k] = p.nu[k];
      e_tt[of_d_r_xi + k] = p.t[k] / p.stretch;
    }
    t[of_v_t] = 1;
    phi[of_v_phi] = 1;
    e_tt[of_v_t_xi] = 1 / p.stretch;
    e_phi_phi[of_d_r] = 1 / r;
    e_phi_phi[of_v_t] = p.t[0] / r;
    e_phi_phi[of_v_phi] = m / r;
    shear = (-m * t - p.t[0] * phi) / r;
    shear[of_v_phi_xi] = 1 / p.stretch;
  }
};

Form square(const Linear& a) { return a * a.transpose(); }

Form form_at(const model::Material& material, const CurvePoint& p, double beta, double beta_s,
             bool has_order, int m) {
  const Velocity V(p, m);
  Form form = material.friction_tangential * (square(V.t) + square(V.phi))
            + material.friction_normal * square(V.normal)
            + material.eta(beta) * (2 * square(V.e_tt) + 2 * square(V.e_phi_phi) + square(V.shear));
  if (has_order) {
    Linear order_rate = Linear::Zero();
    order_rate[of_beta] = 1;
    order_rate[of_v_t] = beta_s;
    form += material.order_drag() * square(order_rate);
  }
  const Linear divergence = V.e_tt + V.e_phi_phi;
  // 0 for the solution; without viscosity it is what keeps the discrete one near it.
  form += (material.friction_tangential + material.friction_normal) * square(divergence);
  form.row(of_p) += divergence.transpose();
  form.col(of_p) += divergence;
  return form;
}

std::array<model::DataRow<4>, motions> rows_of(const NormalShapes& n, const ShapeValues& s) {
  return {{{4 * flow_d, n.r.data()},
           {4 * flow_d, n.z.data()},
           {4 * flow_d, n.dr.data()},
           {4 * flow_d, n.dz.data()},
           {4 * flow_beta, s.phi.data()},
           {4 * flow_v_t, s.phi.data()},
           {4 * flow_v_t, s.dphi.data()},
           {4 * flow_v_phi, s.phi.data()},
           {4 * flow_v_phi, s.dphi.data()},
           {4 * flow_p, s.phi2.data()}}};
}

// p has a value at the nodes 3e, 3e + 1 (where that of the middle stands) and 3e + 3.
int global(int e, int k) {
  const int a = k % 4, c = k / 4;
  constexpr std::array pressure_node{0, 1, 3, 3};
  return flow_index(3 * e + (c == flow_p ? pressure_node[std::size_t(a)] : a), FlowUnknown(c));
}

// Of an unknown of SecondVariation among those of the flow.
int place(int i) { return flow_index(i / node_unknowns, FlowUnknown(i % node_unknowns)); }

// At a pole only motions have a value that look the same from every side: for m = 1 v_φ = ∓v_t.
void tie_at_poles(const std::array<int, 2>& nodes, model::BandMatrix& R) {
  for (const int pole : nodes) {
    const int v_t = flow_index(pole, flow_v_t), v_phi = flow_index(pole, flow_v_phi);
    const double sign = pole == 0 ? -1 : 1;
    const int first = std::max(0, v_phi - R.half_width() + 1),
              last = std::min(R.size() - 1, v_phi + R.half_width() - 1);
    for (int k = first; k <= last; ++k) R(v_t, k) += sign * R(v_phi, k);
    for (int k = first; k <= last; ++k) R(k, v_t) += sign * R(k, v_phi);
  }
}

}  // namespace

model::BandMatrix among_flow_unknowns(const model::BandMatrix& matrix) {
  const int nodes = matrix.size() / node_unknowns;
  model::BandMatrix among(flow_unknowns * nodes, 4 * flow_unknowns - 1);
  for (int j = 0; j < matrix.size(); ++j) {
    const int first = std::max(0, j - matrix.half_width()),
              last = std::min(matrix.size() - 1, j + matrix.half_width());
    for (int i = first; i <= last; ++i) among(place(i), place(j)) = matrix(i, j);
  }
  return among;
}

Eigen::VectorXd among_flow_unknowns(const Eigen::VectorXd& x) {
  Eigen::VectorXd among = Eigen::VectorXd::Zero(flow_unknowns * (x.size() / node_unknowns));
  for (int i = 0; i < x.size(); ++i) among[place(i)] = x[i];
  return among;
}

model::BandMatrix dissipation(const model::Material& material, model::Model model,
                              const StationaryState& state, int m) {
  const int nodes = int(state.beta.size());
  model::BandMatrix R(flow_unknowns * nodes, 4 * flow_unknowns - 1);
  const Nodes n = node_normals(state.X);
  for (int e = 0; e < element_count(state.X); ++e) {
    Eigen::Matrix<double, 4 * flow_unknowns, 4 * flow_unknowns> element;
    element.setZero();
    for (const ShapeValues& s : assembly_points()) {
      const NormalShapes shapes(n, e, s);
      const CurvePoint p = curve_point(state.X, e, s);
      const Form form = form_at(material, p, value_at(state.beta, e, s),
                                slope_at(state.beta, e, s) / p.stretch, has_free_order(model), m);
      const auto rows = rows_of(shapes, s);
      model::add_matrix(rows, rows, form, s.weight * p.x[0] * p.stretch, element);
    }
    for (int j = 0; j < element.cols(); ++j)
      for (int i = 0; i < element.rows(); ++i) R(global(e, i), global(e, j)) += element(i, j);
  }
  if (m == 1) tie_at_poles({0, nodes - 1}, R);
  hold_flow(nodes, m, 0, R);
  if (!has_free_order(model))
    for (int i = 0; i < nodes; ++i) R.pin(flow_index(i, flow_beta), 0);
  if (m > 0)
    for (const int pole : {0, nodes - 1})
      for (const FlowUnknown c : {flow_d, flow_beta}) R.pin(flow_index(pole, c), 0);
  return R;
}

void hold_flow(int nodes, int m, double diagonal, model::BandMatrix& matrix) {
  const auto hold = [&](int node, FlowUnknown c) { matrix.pin(flow_index(node, c), diagonal); };
  for (int i = 0; i < nodes; ++i) {
    if (i % 3 == 2) hold(i, flow_p);
    if (m == 0) hold(i, flow_v_phi);
  }
  for (const int pole : {0, nodes - 1}) {
    if (m > 0) hold(pole, flow_v_phi);
    if (m != 1) hold(pole, flow_v_t);
    if (m == 1 || m > 2) hold(pole, flow_p);
  }
}

}  // namespace sbeh::axisym
