#include "axisym/stationary/newton_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sbeh::axisym {

namespace {

Eigen::VectorXd scattered(const Increment& row) {
  Eigen::VectorXd v = Eigen::VectorXd::Zero(node_unknowns * row.d.size());
  for (Eigen::Index i = 0; i < row.d.size(); ++i) {
    v[index(i, node_d)] = row.d[i];
    v[index(i, node_beta)] = row.beta[i];
  }
  return v;
}

}  // namespace

NewtonSystem::NewtonSystem(const model::Material& material, model::Model model,
                           const Sector& sector)
    : material_(felt_material(material, model)), model_(model), derivatives_(sector) {
  if (material_.conserves_order() && !material_.mean_order)
    throw std::invalid_argument("a conserved order at rest: mean_order must be given");
}

// What acts on the whole, on its part: what acts on mirror images is added.
Eigen::VectorXd NewtonSystem::folded(const Eigen::VectorXd& load) const {
  const Sector& sector = derivatives_.sector;
  const Eigen::Index part = node_unknowns * Eigen::Index(sector.nodes());
  Eigen::VectorXd sum = load.head(part);
  for (Eigen::Index i = part; i < load.size(); ++i)
    sum[index(sector.folded(int(i) / node_unknowns), NodeUnknown(i % node_unknowns))] += load[i];
  return sum;
}

bool NewtonSystem::linearise(const StationaryState& state) {
  assemble(material_, state, node_normals(state.X), derivatives_);
  moment_ = state.moment;
  for_each_pinned(model_, derivatives_.sector, [&](int i) {
    derivatives_.hessian.set_identity_row(i);
    derivatives_.gradient[i] = 0;
    derivatives_.constraints.row(i).setZero();
    derivatives_.of_W2[i] = 0;
    derivatives_.of_order[i] = 0;
  });
  return derivatives_.gradient.allFinite() && derivatives_.hessian.factor();
}

template <class Derivatives>
Eigen::Vector4d NewtonSystem::miss(const Derivatives& there, const Target& target,
                                   double moment) const {
  const model::AreaDifference& ad = material_.area_difference;
  const double of_W2 = ad.is_there() ? ad.W2 + moment * ad.compliance() * there.area - there.W2 : 0;
  const double of_order =
      material_.conserves_order() ? there.order - *material_.mean_order * there.area : 0;
  return {target.area - there.area, there.volume - target.volume, of_W2, of_order};
}

bool NewtonSystem::newton_step(const Target& target, Increment& step) {
  return solve(-derivatives_.gradient, miss(derivatives_, target, moment_), nullptr, step);
}

bool NewtonSystem::newton_step_from(const StationaryState& state, const Target& target,
                                    Increment& step) {
  const LagrangianGradient there =
      gradient_at(material_, state, node_normals(state.X), derivatives_.sector);
  return solve(-there.gradient, miss(there, target, state.moment), nullptr, step);
}

bool NewtonSystem::newton_step(const Target& target, const PathEquation& path, double arc,
                               Increment& step) {
  Eigen::Matrix<double, 5, 1> border;
  border << miss(derivatives_, target, moment_), arc;
  return solve(-derivatives_.gradient, border, &path, step);
}

bool NewtonSystem::tangent(const Eigen::VectorXd& gradient_rate, double volume_rate, double W2_rate,
                           Increment& direction) {
  const bool ok = solve(-folded(gradient_rate), Eigen::Vector4d(0, -volume_rate, W2_rate, 0),
                        nullptr, direction);
  direction.mu = 1;
  return ok;
}

bool NewtonSystem::tangent(const PathEquation& path, Increment& direction) {
  return solve(Eigen::VectorXd::Zero(derivatives_.gradient.size()), Eigen::VectorXd::Unit(5, 4),
               &path, direction);
}

bool NewtonSystem::solve(const Eigen::VectorXd& rhs, const Eigen::VectorXd& border_rhs,
                         const PathEquation* path, Increment& out) {
  const Eigen::Index n = rhs.size(), m = border_rhs.size();
  Eigen::MatrixXd B(n, m), C(n, m), D = Eigen::MatrixXd::Zero(m, m);
  B.leftCols(2) = C.leftCols(2) = derivatives_.constraints;
  B.col(2) = C.col(2) = derivatives_.of_W2;
  const model::AreaDifference& ad = material_.area_difference;
  D(2, 2) = ad.is_there() ? -ad.compliance() * derivatives_.area : 1;
  B.col(3) = C.col(3) = derivatives_.of_order;
  D(3, 3) = material_.conserves_order() ? 0 : 1;
  if (path) {
    B.col(4) = folded(path->gradient_rate);
    C.col(4) = folded(scattered(path->row));
    D(1, 4) = path->volume_rate;
    D(2, 4) = ad.is_there() ? -path->W2_rate : 0;
    D(4, 4) = path->row.mu;
  }
  Eigen::VectorXd f = rhs;
  const Sector& sector = derivatives_.sector;
  for_each_pinned(model_, sector, [&](int i) {
    f[i] = 0;
    B.row(i).setZero();
  });
  auto solution = model::solve_bordered(derivatives_.hessian, B, C, D, f, border_rhs);
  if (solution.x.size() == 0 || !solution.x.allFinite()) return false;
  determinant_sign_ = solution.determinant_sign;
  for_each_pinned(model_, sector, [&](int i) { solution.x[i] = 0; });  // to the bit

  const int nodes = 3 * sector.state_elements + 1;
  for (auto [field, c] : {std::pair{&out.d, node_d},
                          {&out.Lambda, node_Lambda},
                          {&out.H, node_H},
                          {&out.beta, node_beta}}) {
    field->resize(nodes);
    for (int i = 0; i < nodes; ++i) (*field)[i] = solution.x[index(sector.folded(i), c)];
  }
  out.tension = solution.y[0];
  out.pressure = solution.y[1];
  out.moment = solution.y[2];
  out.chemical_potential = solution.y[3];
  out.mu = path ? solution.y[4] : 0;
  return true;
}

// Not ∫ φ_i dS, which may vanish in P3.
Field node_areas(const Nodes& X) {
  Field areas = Field::Zero(X.cols());
  for_each_point(X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    for (int a = 0; a < 4; ++a) areas[3 * e + a] += p.dS * std::abs(s.phi[a]);
  });
  return areas;
}

double residual_of(const LagrangianDerivatives& lagrangian, model::Model model, const Nodes& X) {
  Eigen::VectorXd gradient = lagrangian.gradient;
  if (!gradient.allFinite()) return std::numeric_limits<double>::infinity();
  for_each_pinned(model, lagrangian.sector, [&](int i) { gradient[i] = 0; });
  const Field areas = node_areas(X);
  double largest = 0;
  for (Eigen::Index i = 0; i < areas.size(); ++i)
    for (const NodeUnknown c : {node_d, node_beta})
      largest = std::max(largest, std::abs(gradient[index(i, c)]) / areas[i]);
  return largest;
}

double largest_change(const Increment& step) {
  return std::max(step.d.cwiseAbs().maxCoeff(), step.beta.cwiseAbs().maxCoeff());
}

void displace(const Increment& step, double scale, StationaryState& state) {
  state.X += node_normals(state.X) * (scale * step.d).asDiagonal();
  state.beta += scale * step.beta;
  state.Lambda += scale * step.Lambda;
  state.H += scale * step.H;
  state.tension += scale * step.tension;
  state.pressure += scale * step.pressure;
  state.moment += scale * step.moment;
  state.chemical_potential += scale * step.chemical_potential;
}

}  // namespace sbeh::axisym
