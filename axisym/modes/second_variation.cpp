#include "axisym/modes/second_variation.h"

#include "axisym/modes/mode_density.h"
#include "axisym/stationary/normal_shapes.h"
#include "axisym/stationary/symmetry.h"
#include "model/numerics/contraction.h"
#include "model/numerics/second_order.h"

namespace sbeh::axisym {

namespace {

using Hessian = Eigen::Matrix<double, mode_data, mode_data>;

// What a perturbation is at a point: displacement, H, β and Λ with their derivatives by ξ.
enum Perturbation {
  of_r,
  of_r_xi,
  of_z,
  of_z_xi,
  of_H,
  of_beta,
  of_beta_xi,
  of_Lambda_r,
  of_Lambda_r_xi,
  of_Lambda_z,
  of_Lambda_z_xi,
  perturbations
};
using Form = Eigen::Matrix<double, perturbations, perturbations>;

// A perturbation that goes with cos mφ: the data that go with it too, and those with −m sin mφ and −m² cos mφ.
struct Link {
  Perturbation from;
  ModeData to;
};
constexpr std::array even_links{
    Link{of_r, in_r},
    Link{of_r_xi, in_r_xi},
    Link{of_z_xi, in_z_xi},
    Link{of_H, in_H},
    Link{of_beta, in_beta},
    Link{of_beta_xi, in_beta_xi},
    Link{of_Lambda_r, in_Lambda_r},
    Link{of_Lambda_z, in_Lambda_z},
    Link{of_Lambda_r_xi, in_Lambda_r_xi},
    Link{of_Lambda_z_xi, in_Lambda_z_xi},
};
constexpr std::array odd_links{
    Link{of_r, in_r_phi},
    Link{of_z, in_z_phi},
    Link{of_r_xi, in_r_xi_phi},
    Link{of_z_xi, in_z_xi_phi},
    Link{of_beta, in_beta_phi},
    Link{of_Lambda_r, in_Lambda_r_phi},
    Link{of_Lambda_z, in_Lambda_z_phi},
};
constexpr std::array twice_links{Link{of_r, in_r_phi_phi}, Link{of_z, in_z_phi_phi}};

// The forms of SecondVariation at a point: those of the powers of m².
std::array<Form, 3> forms_of(const Hessian& h) {
  std::array<Form, 3> f;
  f.fill(Form::Zero());
  for (const Link a : even_links) {
    for (const Link b : even_links) f[0](a.from, b.from) += h(a.to, b.to);
    for (const Link b : twice_links) {
      f[1](a.from, b.from) -= h(a.to, b.to);
      f[1](b.from, a.from) -= h(b.to, a.to);
    }
  }
  for (const Link a : odd_links)
    for (const Link b : odd_links) f[1](a.from, b.from) += h(a.to, b.to);
  for (const Link a : twice_links)
    for (const Link b : twice_links) f[2](a.from, b.from) += h(a.to, b.to);
  return f;
}

// (u² + b²) of u = d·ν.
Form squares(const Eigen::Vector2d& nu, bool has_order) {
  Form f = Form::Zero();
  f(of_r, of_r) = nu[0] * nu[0];
  f(of_z, of_z) = nu[1] * nu[1];
  f(of_r, of_z) = f(of_z, of_r) = nu[0] * nu[1];
  if (has_order) f(of_beta, of_beta) = 1;
  return f;
}

// At an axisymmetric state data that go with cos mφ and those that go with sin mφ do not meet in the Hessian.
constexpr std::array with_cosine{in_r,         in_r_xi, in_z_xi, in_r_phi_phi,
                                 in_z_phi_phi, in_H,    in_beta, in_beta_xi};
constexpr std::array with_sine{in_r_phi, in_z_phi, in_r_xi_phi, in_z_xi_phi, in_beta_phi};

// Adds the part of the Hessian that belongs to these data and Λ.
template <std::size_t N>
void add_hessian(const model::Material& material, const StationaryState& state,
                 const std::array<double, mode_data>& at, const std::array<ModeData, N>& variables,
                 Hessian& h) {
  using Second = model::SecondOrder<int(N)>;
  ModeFields<Second> q;
  for (std::size_t k = 0; k < q.size(); ++k) q[k] = Second(at[k]);
  for (std::size_t k = 0; k < N; ++k)
    q[std::size_t(variables[k])] = Second(at[std::size_t(variables[k])], int(k));
  const auto density = mode_density(material, state.tension, state.pressure, q);
  auto nonlinear = density.energy.h;
  for (std::size_t c = 0; c < density.curvature.size(); ++c)
    nonlinear += at[std::size_t(nonlinear_mode_data) + c] * density.curvature[c].h;
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < N; ++j)
      h(variables[i], variables[j]) = nonlinear(Eigen::Index(i), Eigen::Index(j));
    for (std::size_t c = 0; c < density.curvature.size(); ++c) {
      const auto Lambda = nonlinear_mode_data + Eigen::Index(c);
      h(variables[i], Lambda) = h(Lambda, variables[i]) = density.curvature[c].g[Eigen::Index(i)];
    }
  }
}

constexpr int unknown(NodeUnknown c) { return 4 * c; }  // of an element, component by component

std::array<model::DataRow<4>, perturbations> rows_of(const NormalShapes& n, const ShapeValues& s) {
  constexpr int d = unknown(node_d), Lambda = unknown(node_Lambda);
  return {{{d, n.r.data()},
           {d, n.dr.data()},
           {d, n.z.data()},
           {d, n.dz.data()},
           {unknown(node_H), s.phi.data()},
           {unknown(node_beta), s.phi.data()},
           {unknown(node_beta), s.dphi.data()},
           {Lambda, n.r.data()},
           {Lambda, n.dr.data()},
           {Lambda, n.z.data()},
           {Lambda, n.dz.data()}}};
}

double sum(const std::array<double, 4>& shape, const Field& f, int e) {
  double value = 0;
  for (int a = 0; a < 4; ++a) value += shape[std::size_t(a)] * f[3 * e + a];
  return value;
}

// What an axisymmetric state has of the data: no derivatives by φ.
std::array<double, mode_data> point_data(const StationaryState& state, const NormalShapes& n,
                                         const CurvePoint& p, int e, const ShapeValues& s) {
  std::array<double, mode_data> q{};
  q[in_r] = p.x[0];
  q[in_r_xi] = p.dx[0];
  q[in_z_xi] = p.dx[1];
  q[in_H] = value_at(state.H, e, s);
  q[in_beta] = value_at(state.beta, e, s);
  q[in_beta_xi] = slope_at(state.beta, e, s);
  q[in_Lambda_r] = sum(n.r, state.Lambda, e);
  q[in_Lambda_z] = sum(n.z, state.Lambda, e);
  q[in_Lambda_r_xi] = sum(n.dr, state.Lambda, e);
  q[in_Lambda_z_xi] = sum(n.dz, state.Lambda, e);
  return q;
}

using ElementMatrix = Eigen::Matrix<double, 4 * node_unknowns, 4 * node_unknowns>;
using ElementVector = Eigen::Matrix<double, 4 * node_unknowns, 1>;

// From component by component to node by node.
constexpr int place(int k) { return node_unknowns * (k % 4) + k / 4; }

void put(const ElementMatrix& element, double copies, NodeChain::Element& to) {
  for (int j = 0; j < element.cols(); ++j)
    for (int i = 0; i < element.rows(); ++i) to(place(i), place(j)) = copies * element(i, j);
}

// First variations of area, volume, W₂ and ∫β dS, by the data of the perturbation.
using FormVector = Eigen::Matrix<double, perturbations, 1>;
std::array<FormVector, 4> first_variations(const model::Material& m, const CurvePoint& p, double H,
                                           double beta) {
  FormVector of_area = FormVector::Zero(), of_volume = FormVector::Zero();
  of_area[of_r] = p.stretch;
  of_area[of_r_xi] = p.x[0] * p.t[0];
  of_area[of_z_xi] = p.x[0] * p.t[1];
  of_volume[of_r] = -p.x[0] * p.dx[1];
  of_volume[of_z_xi] = -p.x[0] * p.x[0] / 2;
  FormVector of_W2 = H * of_area;
  of_W2[of_H] = p.x[0] * p.stretch;
  FormVector of_order = beta * of_area;
  of_order[of_beta] = p.x[0] * p.stretch;
  if (m.has_lipid_density()) {  // of the area at full order
    of_area *= m.packing(beta);
    of_area[of_beta] = p.x[0] * p.stretch * m.packing_slope(beta);
  }
  return {of_area, of_volume, of_W2, of_order};
}

Hessian hessian_at(const model::Material& material, const StationaryState& state,
                   const std::array<double, mode_data>& at) {
  Hessian hessian = Hessian::Zero();
  add_hessian(material, state, at, with_cosine, hessian);
  add_hessian(material, state, at, with_sine, hessian);
  return hessian;
}

void assemble(const model::Material& material, const Nodes& normals, int e, SecondVariation& out) {
  std::array<ElementMatrix, 3> powers;
  powers.fill(ElementMatrix::Zero());
  ElementMatrix mass = ElementMatrix::Zero();
  std::array<ElementVector, 4> kept;
  kept.fill(ElementVector::Zero());
  for (const ShapeValues& s : assembly_points()) {
    const NormalShapes shapes(normals, e, s);
    const CurvePoint p = curve_point(out.state.X, e, s);
    const auto forms =
        forms_of(hessian_at(material, out.state, point_data(out.state, shapes, p, e, s)));
    const auto rows = rows_of(shapes, s);
    for (std::size_t k = 0; k < 3; ++k)
      model::add_matrix(rows, rows, forms[k], s.weight, powers[k]);
    model::add_matrix(rows, rows, squares(p.nu, out.has_order), s.weight * p.x[0] * p.stretch,
                      mass);
    const auto variations =
        first_variations(material, p, value_at(out.state.H, e, s), value_at(out.state.beta, e, s));
    for (std::size_t k = 0; k < 4; ++k) model::add_vector(rows, variations[k], s.weight, kept[k]);
  }
  const double copies = out.sector.copies(e);
  for (std::size_t k = 0; k < 3; ++k) put(powers[k], copies, out.powers[k].element(e));
  put(mass, copies, out.mass.element(e));
  for (int k = 0; k < int(out.constraints.cols()); ++k)
    for (int i = 0; i < 4 * node_unknowns; ++i)
      out.constraints(3 * node_unknowns * e + place(i), k) +=
          copies * kept[std::size_t(k < 2 ? k : 3)][i];
  for (int i = 0; out.moment.b.size() > 0 && i < 4 * node_unknowns; ++i)
    out.moment.b[3 * node_unknowns * e + place(i)] += copies * kept[2][i];
}

// What is not free. A mode vanishes at the poles like s^m, and Λ with the change of B_φφ, which for m = 2 has a value
// there: its rows are needed, and those of H.
template <class Visit>
void for_each_held(const SecondVariation& of, int m, Parity parity, Visit&& visit) {
  const int last = 3 * of.sector.elements();
  if (!of.has_order)
    for (int i = 0; i <= last; ++i) visit(index(i, node_beta));
  for_each_mirrored<node_unknowns>(of.sector, parity, node_mirror(), visit);
  if (m == 0) return;
  for (const int node : {0, last}) {
    if (node == last && of.sector.is_half) continue;
    visit(index(node, node_d));
    visit(index(node, node_beta));
    if (m == 2) continue;
    visit(index(node, node_H));
    visit(index(node, node_Lambda));
  }
}

void keep_what_is_free(const SecondVariation& of, int m, Parity parity, double diagonal,
                       NodeChain& matrix) {
  fold<node_unknowns>(of.sector, parity, node_mirror(), matrix);
  for_each_held(of, m, parity, [&](int i) { matrix.pin(i, diagonal); });
}

}  // namespace

SecondVariation second_variation(const model::Material& whole, model::Model model,
                                 const StationaryState& state) {
  const model::Material material = held_material(felt_material(whole, model), state);
  const Sector sector{element_count(state.X), is_symmetric(state.X)};
  const NodeChain empty(sector.elements());
  SecondVariation out{
      .sector = sector,
      .powers = {empty, empty, empty},
      .mass = empty,
      .constraints = Eigen::MatrixXd::Zero(empty.size(), material.conserves_order() ? 3 : 2),
      .moment = {},
      .has_order = has_free_order(model),
      .stiffness = material.kappa(state.beta.maxCoeff()),
      .state = sector.is_half ? symmetric_part(state) : state};
  out.state.tension = felt_tension(whole, state);
  if (whole.area_difference.is_there())
    out.moment = {Eigen::VectorXd::Zero(empty.size()),
                  area(state.X) * whole.area_difference.compliance() / (2 * std::numbers::pi)};
  const Nodes normals = node_normals(out.state.X);
  for (int e = 0; e < sector.elements(); ++e) assemble(material, normals, e, out);
  return out;
}

NodeChain SecondVariation::form(int m, Parity parity) const {
  const double square = m * m;
  NodeChain A = powers[0];
  if (m > 0) A.add(square, powers[1]);
  if (m > 0) A.add(square * square, powers[2]);
  keep_what_is_free(*this, m, parity, 1, A);
  return A;
}

NodeChain SecondVariation::mass_of(int m, Parity parity) const {
  NodeChain M = mass;
  keep_what_is_free(*this, m, parity, 0, M);
  return M;
}

Eigen::MatrixXd SecondVariation::constraints_of(int m, Parity parity) const {
  if (m > 0 || parity == Parity::odd) return {};
  Eigen::MatrixXd kept = constraints;
  for (auto column : kept.colwise()) column = folded(column, parity);
  return kept;
}

SoftConstraint SecondVariation::moment_of(int m, Parity parity) const {
  if (m > 0 || parity == Parity::odd || moment.b.size() == 0) return {};
  return {folded(moment.b, parity), moment.softness};
}

Eigen::VectorXd SecondVariation::folded(const Eigen::VectorXd& row, Parity parity) const {
  Eigen::VectorXd load = row;
  fold<node_unknowns>(sector, parity, node_mirror(), load);
  return load;
}

}  // namespace sbeh::axisym
