#include "axisym/time_step.h"

#include "axisym/curvature.h"
#include "axisym/weak_form.h"
#include "model/numerics/band_matrix.h"
#include "model/numerics/contraction.h"

#include <ceres/jet.h>

#include <cmath>

namespace sbeh::axisym {

namespace {

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

// The rows of B, in the order of CoupledData: V_r V_z V_r' V_z' p H H' Y_r Y_z Y_r' Y_z'.
std::array<model::DataRow<4>, coupled_data_size> data_rows(const ShapeValues& s) {
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

template <class Array, class T>
void to_rows(const CoupledData<T>& d, Array& rows) {
  rows = {d.V[0], d.V[1], d.dV[0], d.dV[1], d.p, d.H, d.dH, d.Y[0], d.Y[1], d.dY[0], d.dY[1]};
}

using Jet = ceres::Jet<double, int(coupled_data_size)>;

// The data as independent variables at zero: the step is linear, so that the value of the pointwise
// function there is its constant part and the derivative its matrix.
CoupledData<Jet> independent_data() {
  int k = 0;
  const auto next = [&k] { return Jet(0., k++); };
  CoupledData<Jet> d;
  d.V = {next(), next()};
  d.dV = {next(), next()};
  d.p = next();
  d.H = next();
  d.dH = next();
  d.Y = {next(), next()};
  d.dY = {next(), next()};
  return d;
}

}  // namespace

struct TimeStepper::Workspace {
  explicit Workspace(int count)
      : elements(count),
        coupled(stride * count + 6, half_width),
        order(3 * count + 1, 3),
        rhs(coupled.size()),
        normal_flux(coupled.size()) {}
  int elements;
  model::BandMatrix coupled, order;
  Eigen::VectorXd rhs;          // of the coupled step
  Eigen::VectorXd normal_flux;  // (ν, W): the column and the row of λ

  // Each solve is false when its matrix is singular.
  bool solve_coupled(const model::Material& m, const State& old, const Field& H,
                     const Target& target, double tau, StepFields& out);
  bool solve_order(const model::Material& m, const State& old, const Field& H,
                   const StepFields& fields, double tau, Field& beta);

  void assemble_coupled(const model::Material& m, const State& old, const Field& H,
                        const StepParameters& step);
  void pin(int i);
  StepFields fields_of(const Eigen::VectorXd& x) const;
};

void TimeStepper::Workspace::assemble_coupled(const model::Material& m, const State& old,
                                              const Field& H, const StepParameters& step) {
  coupled.set_zero();
  rhs.setZero();
  normal_flux.setZero();
  const CoupledData<Jet> independent = independent_data();
  Eigen::Matrix<double, padded_unknowns, padded_unknowns> matrix;
  Eigen::Matrix<double, padded_unknowns, 1> vector;
  for (int e = 0; e < elements; ++e) {
    matrix.setZero();
    vector.setZero();
    const auto index = unknowns_of(e);
    for (const ShapeValues& s : assembly_points()) {
      OldPoint point{.geometry = curve_point(old.X, e, s),
                     .beta = value_at(old.beta, e, s),
                     .beta_s = 0,
                     .H = value_at(H, e, s)};
      point.beta_s = slope_at(old.beta, e, s) / point.geometry.stretch;
      std::array<Jet, coupled_data_size> g;
      to_rows(coupled_step_point(m, point, step, independent), g);
      const auto rows = data_rows(s);
      const double dS = point.geometry.dS;
      model::add_matrix(
          rows, [&g](Eigen::Index i, Eigen::Index j) { return g[std::size_t(i)].v[j]; }, dS,
          matrix);
      Eigen::Matrix<double, int(coupled_data_size), 1> constant;
      for (std::size_t i = 0; i < coupled_data_size; ++i) constant[Eigen::Index(i)] = -g[i].a;
      model::add_vector(rows, constant, dS, vector);
      for (int a = 0; a < 4; ++a)
        for (int k = 0; k < 2; ++k)
          normal_flux[index[4 * k + a]] += dS * s.phi[a] * point.geometry.nu[k];  // (V4), (P2)
    }
    for (int j = 0; j < element_unknowns; ++j)
      for (int i = 0; i < element_unknowns; ++i) coupled(index[i], index[j]) += matrix(i, j);
    for (int i = 0; i < element_unknowns; ++i) rhs[index[i]] += vector[i];
  }
}

// The unknown is 0.
void TimeStepper::Workspace::pin(int i) {
  coupled.set_identity_row(i);
  rhs[i] = normal_flux[i] = 0;
}

StepFields TimeStepper::Workspace::fields_of(const Eigen::VectorXd& x) const {
  const int nodes = 3 * elements + 1;
  StepFields f{Nodes(2, nodes), Nodes(2, nodes), Field(nodes), Field(2 * elements + 1), 0};
  for (int i = 0; i < nodes; ++i) {
    f.V.col(i) << x[unknown(i, V_r)], x[unknown(i, V_z)];
    f.Y.col(i) << x[unknown(i, Y_r)], x[unknown(i, Y_z)];
    f.H[i] = x[unknown(i, H_)];
  }
  for (int k = 0; k <= 2 * elements; ++k) f.p[k] = x[pressure_unknown(k)];
  return f;
}

namespace {

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

bool TimeStepper::Workspace::solve_coupled(const model::Material& m, const State& old,
                                           const Field& H, const Target& target, double tau,
                                           StepFields& out) {
  const double A = area(old.X), V = volume(old.X);
  assemble_coupled(m, old, H, {.tau = tau, .area_rate = (target.area - A) / (tau * A)});
  const int last = 3 * elements;
  for (const int axis : {unknown(0, V_r), unknown(last, V_r), unknown(0, Y_r), unknown(last, Y_r)})
    pin(axis);
  // Without friction nothing resists a motion along the axis: hold the north pole, and let the whole
  // surface rest in the mean, the limit of small friction.
  const bool free_axis = m.friction_tangential == 0 && m.friction_normal == 0;
  if (free_axis) pin(unknown(0, V_z));
  if (!coupled.factor()) return false;

  // On a sphere a constant p and λ are the same unknown: area alone is kept there.
  const Eigen::Index borders = is_sphere(A, V) ? 0 : 1;
  const Eigen::VectorXd volume_rate = Eigen::VectorXd::Constant(borders, (target.volume - V) / tau);
  const auto solution =
      model::solve_bordered(coupled, normal_flux.leftCols(borders), normal_flux.leftCols(borders),
                            Eigen::MatrixXd::Zero(borders, borders), rhs, volume_rate);
  if (solution.x.size() == 0 || !solution.x.allFinite()) return false;
  out = fields_of(solution.x);
  if (borders > 0) out.lambda = solution.y[0];
  if (free_axis) rest_in_the_mean(old.X, tau, out);
  return true;
}

bool TimeStepper::Workspace::solve_order(const model::Material& m, const State& old, const Field& H,
                                         const StepFields& fields, double tau, Field& beta) {
  order.set_zero();
  beta = Field::Zero(old.beta.size());
  const Nodes relative = fields.V - fields.Y / tau;
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    double slip = 0;
    for (int a = 0; a < 4; ++a) slip += s.phi[a] * relative.col(3 * e + a).dot(p.t);
    const OrderData d = order_step_point(
        m,
        {.geometry = p, .beta_old = value_at(old.beta, e, s), .H = value_at(H, e, s), .slip = slip},
        tau);
    for (int a = 0; a < 4; ++a) {
      beta[3 * e + a] += p.dS * d.rhs * s.phi[a];
      for (int b = 0; b < 4; ++b)
        order(3 * e + a, 3 * e + b) +=
            p.dS
            * (d.matrix[0][0] * s.phi[a] * s.phi[b] + d.matrix[0][1] * s.phi[a] * s.dphi[b]
               + d.matrix[1][1] * s.dphi[a] * s.dphi[b]);
    }
  });
  if (!order.factor()) return false;
  order.solve(beta);
  return beta.allFinite();
}

namespace {

Dissipation dissipation_of(const model::Material& m, const State& old, const StepFields& f,
                           const Field& beta_new, double tau) {
  Dissipation d;
  const Field rate = (beta_new - old.beta) / tau;
  const Nodes relative = f.V - f.Y / tau;
  for_each_point(old.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    Eigen::Vector2d V = Eigen::Vector2d::Zero(), dV = V, slip = V;
    for (int a = 0; a < 4; ++a) {
      V += s.phi[a] * f.V.col(3 * e + a);
      dV += s.dphi[a] * f.V.col(3 * e + a);
      slip += s.phi[a] * relative.col(3 * e + a);
    }
    const double beta = value_at(old.beta, e, s);
    const double beta_dot =
        value_at(rate, e, s) + slip.dot(p.t) * slope_at(beta_new, e, s) / p.stretch;
    const double V_t = V.dot(p.t), V_n = V.dot(p.nu);
    d.friction += p.dS * (m.friction_tangential * V_t * V_t + m.friction_normal * V_n * V_n);
    d.order += p.dS * m.order_drag() * beta_dot * beta_dot;
    d.viscous += p.dS * m.eta(beta) / 2
               * model::rate_of_strain(surface_gradient<double>(p, V, dV)).squaredNorm();
  });
  return d;
}

}  // namespace

TimeStepper::TimeStepper(const model::Material& material, model::Model model, int elements)
    : material_(material), model_(model), work_(std::make_unique<Workspace>(elements)) {}
TimeStepper::~TimeStepper() = default;
TimeStepper::TimeStepper(TimeStepper&&) noexcept = default;
TimeStepper& TimeStepper::operator=(TimeStepper&&) noexcept = default;

StepResult TimeStepper::step(const State& old, const Target& target, double tau) {
  StepResult result;
  const Field H = mean_curvature(old.X);
  if (H.size() == 0 || !H.allFinite()) return result;
  if (!work_->solve_coupled(material_, old, H, target, tau, result.fields)) return result;
  result.state.X = old.X + result.fields.Y;
  result.state.X(0, 0) = result.state.X(0, old.X.cols() - 1) = 0;  // exactly
  result.state.beta = old.beta;
  if (model_ == model::Model::SBEH
      && !work_->solve_order(material_, old, H, result.fields, tau, result.state.beta))
    return result;
  result.dissipation = dissipation_of(material_, old, result.fields, result.state.beta, tau);
  result.ok = true;
  return result;
}

}  // namespace sbeh::axisym
