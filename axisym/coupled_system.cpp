#include "axisym/coupled_system.h"

#include "axisym/curvature.h"
#include "axisym/lipids.h"
#include "model/numerics/contraction.h"

#include <ceres/jet.h>

namespace sbeh::axisym {

namespace {

using model::AreaConstraint;

// Element unknowns: V_r, V_z, H, Y_r, Y_z in P3 (4 each), p in P2 (3, padded to 4).
constexpr int element_unknowns = 23, padded_unknowns = 24;
enum Component { V_r, V_z, H_, Y_r, Y_z, components };
constexpr int first_pressure = 4 * components;

// Global numbering that keeps the band narrow. Per element: joint (V_r V_z H Y_r Y_z p), node 1,
// middle p, node 2.
constexpr int stride = 17, half_width = 22;
int unknown(int node, Component c) {
  constexpr int offset[3] = {0, 6, 12};
  return stride * (node / 3) + offset[node % 3] + c;
}
int pressure_unknown(int k) { return stride * (k / 2) + (k % 2 == 0 ? 5 : 11); }

// Element unknown → global unknown.
std::array<int, element_unknowns> unknowns_of(int e) {
  std::array<int, element_unknowns> index{};
  for (int c = 0; c < components; ++c)
    for (int a = 0; a < 4; ++a) index[4 * c + a] = unknown(3 * e + a, Component(c));
  for (int k = 0; k < 3; ++k) index[first_pressure + k] = pressure_unknown(2 * e + k);
  return index;
}

// In the order of Unknowns: V_r V_z V_r' V_z' p H H' Y_r Y_z Y_r' Y_z'.
std::array<model::DataRow<4>, unknowns_size> unknown_rows(const ShapeValues& s) {
  const double *v = s.phi.data(), *d = s.dphi.data();
  return {{{4 * V_r, v},
           {4 * V_z, v},
           {4 * V_r, d},
           {4 * V_z, d},
           {first_pressure, s.phi2.data()},
           {4 * H_, v},
           {4 * H_, d},
           {4 * Y_r, v},
           {4 * Y_z, v},
           {4 * Y_r, d},
           {4 * Y_z, d}}};
}

// In the order of Tested: W stands at V, q at p, G at H and Z at Y; H' has no counterpart.
std::array<model::DataRow<4>, tested_size> test_rows(const ShapeValues& s) {
  const auto [V, V2, dV, dV2, p, H, dH, Y, Y2, dY, dY2] = unknown_rows(s);
  return {V, V2, dV, dV2, p, H, Y, Y2, dY, dY2};
}

template <class T>
std::array<T, tested_size> in_order(const Tested<T>& t) {
  return {t.W[0], t.W[1], t.dW[0], t.dW[1], t.q, t.G, t.Z[0], t.Z[1], t.dZ[0], t.dZ[1]};
}

using Jet = ceres::Jet<double, int(unknowns_size)>;

// The unknowns as independent variables at zero: the step is linear, so that the value of the pointwise
// function there is its constant part and the derivative its matrix.
Unknowns<Jet> independent_unknowns() {
  int k = 0;
  const auto next = [&k] { return Jet(0., k++); };
  Unknowns<Jet> d;
  d.V = {next(), next()};
  d.dV = {next(), next()};
  d.p = next();
  d.H = next();
  d.dH = next();
  d.Y = {next(), next()};
  d.dY = {next(), next()};
  return d;
}

// The part of an element in the system; row: test function, column: unknown.
struct Element {
  Eigen::Matrix<double, padded_unknowns, padded_unknowns> matrix;
  Eigen::Matrix<double, padded_unknowns, 1> rhs;
  Eigen::Matrix<double, padded_unknowns, 1> normal_flux;  // (ν, W) of (V4), (P2)
  Eigen::Matrix<double, padded_unknowns, 1> moment;       // of (V13), (P3)
};

Element assemble_element(const model::Material& m, const State& old, const Field& H,
                         const StepParameters& step, int e) {
  static const Unknowns<Jet> independent = independent_unknowns();
  Element out;
  out.matrix.setZero();
  out.rhs.setZero();
  out.normal_flux.setZero();
  out.moment.setZero();
  for (const ShapeValues& s : assembly_points()) {
    OldPoint point{.geometry = curve_point(old.X, e, s),
                   .beta = value_at(old.beta, e, s),
                   .beta_s = 0,
                   .H = value_at(H, e, s)};
    point.beta_s = slope_at(old.beta, e, s) / point.geometry.stretch;
    const auto factors = in_order(coupled_step_point(m, point, step, independent));
    const auto tests = test_rows(s);
    const double dS = point.geometry.dS;
    const auto moment = moment_point(point);
    model::add_matrix(
        tests, unknown_rows(s),
        [&factors](Eigen::Index i, Eigen::Index j) { return factors[std::size_t(i)].v[j]; }, dS,
        out.matrix);
    Eigen::Matrix<double, int(tested_size), 1> constant;
    for (std::size_t i = 0; i < tested_size; ++i) constant[Eigen::Index(i)] = -factors[i].a;
    model::add_vector(tests, constant, dS, out.rhs);
    for (int a = 0; a < 4; ++a)
      for (int k = 0; k < 2; ++k) {
        out.normal_flux[4 * k + a] += dS * s.phi[a] * point.geometry.nu[k];
        out.moment[4 * k + a] += dS * (s.phi[a] * moment.W[k] + s.dphi[a] * moment.dW[k]);
      }
  }
  return out;
}

// V = Σ v_a φ_a n_a with the node normals n (2 x 4), W likewise, p a number: v stands in the place of
// V_r, the number in that of the first p. What is left of V_z and p has no equation any more.
void restrict_to_normals(const Eigen::Matrix<double, 2, 4>& n, Element& element) {
  auto T = decltype(element.matrix)::Identity().eval();  // row: unknown before, column: after
  for (int a = 0; a < 4; ++a) {
    T(4 * V_r + a, 4 * V_r + a) = n(0, a);
    T(4 * V_z + a, 4 * V_r + a) = n(1, a);
    T(4 * V_z + a, 4 * V_z + a) = 0;
  }
  for (int k = 0; k < 3; ++k) {
    T(first_pressure + k, first_pressure + k) = 0;
    T(first_pressure + k, first_pressure) = 1;
  }
  element.matrix = (T.transpose() * element.matrix * T).eval();
  element.rhs = (T.transpose() * element.rhs).eval();
  element.normal_flux = (T.transpose() * element.normal_flux).eval();
  element.moment = (T.transpose() * element.moment).eval();
}

// Takes the mean axial velocity from the surface, and its displacement from the mesh.
void rest_in_the_mean(const Nodes& X, double tau, StepFields& f) {
  double drift = 0, A = 0;
  for_each_point(X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    drift += p.dS * value_at(f.V.row(1).transpose(), e, s);
    A += p.dS;
  });
  f.V.row(1).array() -= drift / A;
  f.Y.row(1).array() -= tau * drift / A;
}

}  // namespace

CoupledSystem::CoupledSystem(const model::Material& material, AreaConstraint area, int elements)
    : material_(material),
      area_(area),
      elements_(elements),
      matrix_(stride * elements + 6, half_width),
      rhs_(matrix_.size()) {}

void CoupledSystem::Multiplier::set_zero(Eigen::Index size) {
  column.setZero(size);
  row.setZero(size);
  rhs = diagonal = 0;
}

void CoupledSystem::assemble(const State& old, const Field& H, const StepParameters& step) {
  matrix_.set_zero();
  rhs_.setZero();
  lambda_.set_zero(rhs_.size());
  p_.set_zero(rhs_.size());
  moment_.set_zero(rhs_.size());
  normals_ = node_normals(old.X);
  for (int e = 0; e < elements_; ++e) {
    Element element = assemble_element(material_, old, H, step, e);
    const auto index = unknowns_of(e);
    if (area_ == AreaConstraint::global) {
      restrict_to_normals(normals_.middleCols<4>(3 * e), element);
      for (int i = 0; i < first_pressure; ++i) {
        p_.column[index[i]] += element.matrix(i, first_pressure);  // (V3)
        p_.row[index[i]] += element.matrix(first_pressure, i);     // (P1)
      }
      p_.rhs += element.rhs[first_pressure];
    }
    for (int j = 0; j < element_unknowns; ++j)
      for (int i = 0; i < element_unknowns; ++i)
        matrix_(index[i], index[j]) += element.matrix(i, j);
    for (int i = 0; i < element_unknowns; ++i) {
      rhs_[index[i]] += element.rhs[i];
      lambda_.row[index[i]] += element.normal_flux[i];  // (P2)
      moment_.row[index[i]] += element.moment[i];       // (P3)
    }
  }
  lambda_.column = lambda_.row;  // (V4)
  moment_.column = moment_.row;  // (V13)
}

// c A/(π k_ad) = W₂ − W₂⁰ at the end of the step, W₂ to first order.
void CoupledSystem::set_moment(const Nodes& X, const Field& H, double tau, double area) {
  const model::AreaDifference& ad = material_.area_difference;
  moment_.diagonal = -area * ad.compliance() / tau;
  moment_.rhs = (ad.W2 - total_mean_curvature(X, H)) / tau;  // (P3)
}

// The unknown is 0.
void CoupledSystem::pin(int i) {
  matrix_.set_identity_row(i);
  rhs_[i] = lambda_.column[i] = p_.column[i] = moment_.column[i] = 0;
}

void CoupledSystem::pin_what_is_not_free() {
  const int last = 3 * elements_;
  for (const int pole : {0, last}) pin(unknown(pole, Y_r));
  if (area_ == AreaConstraint::global) {
    for (int i = 0; i <= last; ++i) pin(unknown(i, V_z));
    for (int k = 0; k <= 2 * elements_; ++k) pin(pressure_unknown(k));
  } else {
    for (const int pole : {0, last}) pin(unknown(pole, V_r));
  }
}

bool CoupledSystem::solve_with(const Eigen::VectorXd& rhs, StepFields& out) const {
  const auto count = Eigen::Index(multipliers_.size());
  Eigen::MatrixXd columns(rhs_.size(), count), rows(rhs_.size(), count);
  Eigen::VectorXd values(count);
  Eigen::MatrixXd diagonal = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Multiplier& multiplier = *multipliers_[std::size_t(k)];
    columns.col(k) = multiplier.column;
    rows.col(k) = multiplier.row;
    values[k] = multiplier.rhs;
    diagonal(k, k) = multiplier.diagonal;
  }
  const auto solution = model::solve_bordered(matrix_, columns, rows, diagonal, rhs, values);
  const Eigen::VectorXd& x = solution.x;
  if (x.size() == 0 || !x.allFinite()) return false;

  const int nodes = 3 * elements_ + 1;
  out = {Nodes(2, nodes), Nodes(2, nodes), Field(nodes), Field(2 * elements_ + 1), 0, 0};
  for (int i = 0; i < nodes; ++i) {
    out.V.col(i) << x[unknown(i, V_r)], x[unknown(i, V_z)];
    if (area_ == AreaConstraint::global) out.V.col(i) = x[unknown(i, V_r)] * normals_.col(i);
    out.Y.col(i) << x[unknown(i, Y_r)], x[unknown(i, Y_z)];
    out.H[i] = x[unknown(i, H_)];
  }
  for (int k = 0; k <= 2 * elements_; ++k) out.p[k] = x[pressure_unknown(k)];
  for (Eigen::Index k = 0; k < count; ++k) {
    if (multipliers_[std::size_t(k)] == &p_) out.p.setConstant(solution.y[k]);
    if (multipliers_[std::size_t(k)] == &lambda_) out.lambda = solution.y[k];
    if (multipliers_[std::size_t(k)] == &moment_) out.moment = solution.y[k];
  }
  return true;
}

bool CoupledSystem::prepare(const State& old, const Field& H, const std::optional<Target>& target,
                            double tau) {
  const double A = area(old.X), V = volume(old.X);
  const double lipids = material_.has_lipid_density() ? lipid_area(material_, old) : A;
  const Target wanted = target.value_or(Target{lipids, V});
  X_ = old.X;
  tau_ = tau;
  assemble(old, H,
           {.tau = tau, .area_rate = (wanted.area - lipids) / (tau * A), .area_constraint = area_});
  lambda_.rhs = (wanted.volume - V) / tau;
  if (material_.area_difference.is_there()) set_moment(old.X, H, tau, A);
  pin_what_is_not_free();
  // Without friction nothing resists a motion along the axis: hold the north pole, and let the whole
  // surface rest in the mean, the limit of small friction.
  if (material_.frictionless()) pin(unknown(0, V_z));
  multipliers_.clear();
  if (area_ == AreaConstraint::global) multipliers_.push_back(&p_);
  // On a sphere a constant p, λ and c are the same unknown: area alone is kept there.
  if (!is_sphere(A, V)) {
    multipliers_.push_back(&lambda_);
    if (material_.area_difference.is_there()) multipliers_.push_back(&moment_);
  }
  return matrix_.factor();
}

bool CoupledSystem::solve(const Field& lipids, StepFields& out) {
  Eigen::VectorXd rhs = rhs_;
  for (int k = 0; k <= 2 * elements_; ++k) rhs[pressure_unknown(k)] -= lipids[k];  // (P1)
  if (!solve_with(rhs, out)) return false;
  if (material_.frictionless()) rest_in_the_mean(X_, tau_, out);
  return true;
}

}  // namespace sbeh::axisym
