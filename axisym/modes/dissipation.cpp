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

// The velocity at a point and its gradient, each as a linear form of the motion; that with a factor m apart.
struct Velocity {
  Linear t = Linear::Zero(), phi = Linear::Zero(), normal = Linear::Zero();
  Linear e_tt = Linear::Zero(), e_phi_phi = Linear::Zero(), m_e_phi_phi = Linear::Zero();
  Linear shear = Linear::Zero(), m_shear = Linear::Zero();  // 2 e_tφ, with sin mφ
  explicit Velocity(const CurvePoint& p) {
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
    m_e_phi_phi[of_v_phi] = 1 / r;
    shear[of_v_phi] = -p.t[0] / r;
    shear[of_v_phi_xi] = 1 / p.stretch;
    m_shear = -t / r;
  }
};

Form square(const Linear& a) { return a * a.transpose(); }
Form twice(const Linear& a, const Linear& b) { return a * b.transpose() + b * a.transpose(); }

// β̇ = ḃ + v_t ∂_sβ
Linear rate_of_order(double beta_s) {
  Linear rate = Linear::Unit(of_beta);
  rate[of_v_t] = beta_s;
  return rate;
}

// Those of the powers of m.
std::array<Form, 3> forms_at(const model::Material& material, const CurvePoint& p, double beta,
                             double beta_s, bool has_order) {
  const Velocity V(p);
  const double eta = material.eta(beta);
  // Times (Div V)², 0 for the solution; without viscosity it is what keeps the discrete one near it.
  const double spread = material.friction_tangential + material.friction_normal;
  const Linear order_rate = has_order ? rate_of_order(beta_s) : Linear(Linear::Zero());
  const Linear &m_divergence = V.m_e_phi_phi,
               divergence = V.e_tt + V.e_phi_phi - material.expansion(beta) * order_rate;  // (P1)
  std::array<Form, 3> form{
      material.friction_tangential * (square(V.t) + square(V.phi))
          + material.friction_normal * square(V.normal) + spread * square(divergence)
          + eta * (2 * square(V.e_tt) + 2 * square(V.e_phi_phi) + square(V.shear)),
      spread * twice(divergence, m_divergence)
          + eta * (2 * twice(V.e_phi_phi, V.m_e_phi_phi) + twice(V.shear, V.m_shear)),
      spread * square(m_divergence) + eta * (2 * square(V.m_e_phi_phi) + square(V.m_shear))};
  form[0] += material.order_drag(beta) * square(order_rate);
  const Linear pressure = material.packing(beta) * Linear::Unit(of_p);
  form[0] += twice(pressure, divergence);
  form[1] += twice(pressure, m_divergence);
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

constexpr int element_unknowns = 4 * flow_unknowns;
using ElementMatrix = Eigen::Matrix<double, element_unknowns, element_unknowns>;
using ElementVector = Eigen::Matrix<double, element_unknowns, 1>;

// From component by component to node by node; p has a value at the first two nodes and at the last.
constexpr int place(int k) {
  constexpr std::array pressure_node{0, 1, 3, 3};
  const int a = k % 4, c = k / 4;
  return flow_unknowns * (c == flow_p ? pressure_node[std::size_t(a)] : a) + c;
}

Mirror<flow_unknowns> flow_mirror() {
  Mirror<flow_unknowns> even = Mirror<flow_unknowns>::Ones();
  even[flow_v_t] = -1;  // along the meridian
  return even;
}

template <class Visit>
void for_each_held(const Sector& sector, int m, Parity parity, Visit&& visit) {
  const int last = 3 * sector.elements();
  for (int i = 0; i <= last; ++i) {
    if (i % 3 == 2) visit(flow_index(i, flow_p));
    if (m == 0) visit(flow_index(i, flow_v_phi));
  }
  for (const int node : {0, last}) {
    if (node == last && sector.is_half) continue;
    if (m > 0) visit(flow_index(node, flow_v_phi));
    if (m != 1) visit(flow_index(node, flow_v_t));
    if (m == 1 || m > 2) visit(flow_index(node, flow_p));
  }
  for_each_mirrored<flow_unknowns>(sector, parity, flow_mirror(), visit);
  // The equator goes through the middle of an element, where p has its value.
  if (sector.cuts_an_element() && parity == Parity::odd) visit(flow_index(last - 2, flow_p));
}

// At a pole only motions have a value that look the same from every side: for m = 1 v_φ = ∓v_t.
struct PoleTie {
  int node;
  double sign;
};
std::vector<PoleTie> ties_of(const Sector& sector) {
  std::vector<PoleTie> ties{{0, -1}};
  if (!sector.is_half) ties.push_back({3 * sector.elements(), 1});
  return ties;
}
void tie_at_poles(const Sector& sector, FlowChain& R) {
  for (const auto& [node, sign] : ties_of(sector)) {
    FlowChain::Element& element = R.element(node == 0 ? 0 : R.elements() - 1);
    const int first = node == 0 ? 0 : 3 * flow_unknowns;
    element.row(first + flow_v_t) += sign * element.row(first + flow_v_phi);
    element.col(first + flow_v_t) += sign * element.col(first + flow_v_phi);
  }
}

// Along t, e_φ and ν, of each motion in a column.
Eigen::Matrix3Xd velocities_at(const std::vector<RigidMotion>& motions, const CurvePoint& p) {
  Eigen::Matrix3Xd V(3, motions.size());
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const Eigen::Vector2d v = motions[k].velocity.meridian(p.x);
    V.col(Eigen::Index(k)) << v.dot(p.t), motions[k].velocity.around(p.x), v.dot(p.nu);
  }
  return V;
}
Eigen::DiagonalMatrix<double, 3> friction(const model::Material& material) {
  return {material.friction_tangential, material.friction_tangential, material.friction_normal};
}

}  // namespace

FlowChain among_flow_unknowns(const NodeChain& matrix) {
  constexpr int n = node_unknowns, N = flow_unknowns;
  FlowChain among(matrix.elements());
  for (int e = 0; e < matrix.elements(); ++e)
    for (int b = 0; b < 4; ++b)
      for (int a = 0; a < 4; ++a)
        among.element(e).block<n, n>(N * a, N * b) = matrix.element(e).block<n, n>(n * a, n * b);
  return among;
}

Eigen::VectorXd among_flow_unknowns(const Eigen::VectorXd& x) {
  constexpr int n = node_unknowns, N = flow_unknowns;
  const Eigen::Index nodes = x.size() / n;
  Eigen::VectorXd among = Eigen::VectorXd::Zero(N * nodes);
  for (Eigen::Index i = 0; i < nodes; ++i) among.segment<n>(N * i) = x.segment<n>(n * i);
  return among;
}

FlowDissipation dissipation(const model::Material& material, const SecondVariation& second) {
  const StationaryState& state = second.state;
  const FlowChain empty(second.sector.elements());
  FlowDissipation R{{empty, empty, empty}};
  const Nodes n = node_normals(state.X);
  for (int e = 0; e < empty.elements(); ++e) {
    std::array<ElementMatrix, 3> element;
    element.fill(ElementMatrix::Zero());
    for (const ShapeValues& s : assembly_points()) {
      const NormalShapes shapes(n, e, s);
      const CurvePoint p = curve_point(state.X, e, s);
      const auto forms = forms_at(material, p, value_at(state.beta, e, s),
                                  slope_at(state.beta, e, s) / p.stretch, second.has_order);
      const auto rows = rows_of(shapes, s);
      for (std::size_t k = 0; k < 3; ++k)
        model::add_matrix(rows, rows, forms[k], s.weight * p.x[0] * p.stretch, element[k]);
    }
    for (std::size_t k = 0; k < 3; ++k)
      for (int j = 0; j < element_unknowns; ++j)
        for (int i = 0; i < element_unknowns; ++i)
          R.powers[k].element(e)(place(i), place(j)) += second.sector.copies(e) * element[k](i, j);
  }
  return R;
}

FlowChain FlowDissipation::form(const SecondVariation& second, int m, Parity parity) const {
  const Sector& sector = second.sector;
  FlowChain R = powers[0];
  if (m > 0) R.add(m, powers[1]);
  if (m > 0) R.add(m * m, powers[2]);
  fold<flow_unknowns>(sector, parity, flow_mirror(), R);
  if (m == 1) tie_at_poles(sector, R);
  hold_flow(sector, m, parity, 0, R);
  const int last = 3 * sector.elements();
  if (!second.has_order)
    for (int i = 0; i <= last; ++i) R.pin(flow_index(i, flow_beta), 0);
  if (m > 0)
    for (const int pole : {0, last})
      if (pole == 0 || !sector.is_half)
        for (const FlowUnknown c : {flow_d, flow_beta}) R.pin(flow_index(pole, c), 0);
  return R;
}

RigidDrag drag_on(const std::vector<RigidMotion>& motions, const model::Material& material,
                  const SecondVariation& second, int m, Parity parity) {
  const StationaryState& state = second.state;
  const Sector& sector = second.sector;
  const Nodes n = node_normals(state.X);
  const auto count = Eigen::Index(motions.size());
  const Eigen::Index unknowns = flow_unknowns * (3 * Eigen::Index(sector.elements()) + 1);
  RigidDrag drag{Eigen::MatrixXd::Zero(unknowns, count), Eigen::MatrixXd::Zero(count, count)};
  for (int e = 0; e < sector.elements(); ++e) {
    Eigen::MatrixXd element = Eigen::MatrixXd::Zero(element_unknowns, count);
    for (const ShapeValues& s : assembly_points()) {
      const NormalShapes shapes(n, e, s);
      const CurvePoint p = curve_point(state.X, e, s);
      const double weight = sector.copies(e) * s.weight * p.x[0] * p.stretch;
      const Eigen::Matrix3Xd V = velocities_at(motions, p);
      const Eigen::Matrix3Xd force = friction(material) * V;
      drag.squares += weight * V.transpose() * force;
      const Velocity of_unknowns(p);
      for (Eigen::Index k = 0; k < count; ++k) {
        const Linear against = force(0, k) * of_unknowns.t + force(1, k) * of_unknowns.phi
                             + force(2, k) * of_unknowns.normal;
        auto column = element.col(k);
        model::add_vector(rows_of(shapes, s), against, weight, column);
      }
    }
    for (int i = 0; i < element_unknowns; ++i)
      drag.loads.row(3 * flow_unknowns * e + place(i)) += element.row(i);
  }
  for (auto column : drag.loads.colwise()) {
    Eigen::VectorXd load = column;
    fold<flow_unknowns>(sector, parity, flow_mirror(), load);
    if (m == 1)
      for (const auto& [node, sign] : ties_of(sector))
        load[flow_index(node, flow_v_t)] += sign * load[flow_index(node, flow_v_phi)];
    for_each_held(sector, m, parity, [&](int i) { load[i] = 0; });
    column = load;
  }
  return drag;
}

void hold_flow(const Sector& sector, int m, Parity parity, double diagonal, FlowChain& matrix) {
  for_each_held(sector, m, parity, [&](int i) { matrix.pin(i, diagonal); });
}

}  // namespace sbeh::axisym
