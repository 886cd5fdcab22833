#include "surface3d/variational/variational_stepper.h"

#include "surface3d/diagnostics.h"
#include "surface3d/lipids.h"
#include "surface3d/parallel.h"
#include "surface3d/stationary/stationary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sbeh::surface3d {

using model::FlowFault;

/// All of a step, by StepLayout, with the next state that it gives.
struct VariationalStepper::Unknowns {
  Eigen::VectorXd x;
  Eigen::Matrix<double, 7, 1> borders =
      decltype(borders)::Zero();  // c, and what holds rigid motions
  StationaryState next;
};

VariationalStepper::VariationalStepper(const std::shared_ptr<const Triangulation>& mesh,
                                       const model::Material& material, model::Model model,
                                       const Numerics& numerics)
    : mesh_(mesh),
      material_(effective(material, model)),
      model_(model),
      always_factors_(numerics.factorisation == Factorisation::every_step),
      tolerance_(numerics.tolerance),
      layout_(*mesh, material_, model),
      along_(*mesh),
      matrix_(layout_, numerics) {}

// Of the mesh towards its own equilibrium: (H1) tested along the surface, with V = 0.
std::optional<Nodes> VariationalStepper::motion_along(const State& old, const Curvature& curvature,
                                                      double tau) {
  along_.begin(*mesh_, curvature.node_normals, tau);
  for_each_by_colour(*mesh_, [&](int e) {
    static thread_local FlowPiece none{Eigen::MatrixXd::Zero(FlowPiece::Y, FlowPiece::Y),
                                       Eigen::VectorXd::Zero(FlowPiece::Y)};
    const MovingTriangle triangle{.e = e,
                                  .tau = tau,
                                  .X = on_element(*mesh_, e, old.X),
                                  .node_normals = on_element(*mesh_, e, curvature.node_normals),
                                  .from = on_element(*mesh_, e, old.X),
                                  .H_from = on_element(*mesh_, e, curvature.H)};
    MeshSums sums;
    for (const ShapeValues& s : assembly_points())
      sums.add(surface_point(triangle.X, s), Shapes(s.phi.data()));
    along_.add(*mesh_, triangle, sums.equation(), none);
  });
  const Nodes still = Nodes::Zero(3, mesh_->nodes);
  Eigen::VectorXd motion = along_.motion_rhs(still, curvature.H);
  if (!motion_solver_.factor(along_.motion().matrix)) return {};
  motion_solver_.solve(motion);
  Nodes Y = along_.displacement(still, {}, motion);
  if (!Y.allFinite()) return {};
  return Y;
}

// Of the past: the rates of the last step, or of the last two, extrapolated.
VariationalStepper::Unknowns VariationalStepper::guess(const StepBase& base) const {
  const State from{base.old.X + base.Y, base.old.beta};
  Unknowns x{.x = Eigen::VectorXd::Zero(layout_.size()), .next = {}};
  const StationaryLayout& state = layout_.state;
  const Solution &last = memory_.last, &before = memory_.before;
  if (!has_past()) {
    x.next = guess_from(*mesh_, material_, model_, from);
  } else {
    Eigen::VectorXd rates = last.flow;
    if (before.flow.size() > 0) rates += base.tau / last.tau * (last.flow - before.flow);
    const Eigen::Index n = mesh_->nodes;
    auto part = [&, at = Eigen::Index(0)](Eigen::Index size) mutable {
      return rates.segment(std::exchange(at, at + size), size);
    };
    const Nodes V = part(3 * n).reshaped(3, n);
    const auto along = [&](const Nodes& direction) {
      return (base.tau * V.cwiseProduct(direction).colwise().sum().transpose()).eval();
    };
    const Field d = along(base.curvature.node_normals);
    x.x(layout_.all(node_d)) = d;
    for (int k = 0; k < 2; ++k)
      x.x(layout_.all(state.per_node + k)) = along(base.tangents[std::size_t(k)]);
    x.next = {{from.X + base.curvature.node_normals * d.asDiagonal(), from.beta}};
    const Field order_rates = part(n);
    if (state.free_order) x.next.beta += base.tau * order_rates;
    x.next.Lambda = part(n);
    x.next.H = part(n);
    x.x.tail(mesh_->quadratic_nodes) = part(mesh_->quadratic_nodes);
    x.borders = part(7);
    set_multipliers(material_, part(multipliers()), x.next);
  }
  x.x(layout_.all(node_Lambda)) = x.next.Lambda;
  x.x(layout_.all(node_H)) = x.next.H;
  if (state.free_order) x.x(layout_.all(node_beta)) = x.next.beta;
  return x;
}

Nodes VariationalStepper::motion_of(const StepBase& base, const Unknowns& x) const {
  Nodes u = base.curvature.node_normals * x.x(layout_.all(node_d)).asDiagonal();
  for (int k = 0; k < 2; ++k)
    u += base.tangents[std::size_t(k)] * x.x(layout_.all(layout_.state.per_node + k)).asDiagonal();
  return u;
}

// Velocities, β̇, Λ, H, p and the other multipliers.
Eigen::Index VariationalStepper::past_size() const {
  return 6 * mesh_->nodes + mesh_->quadratic_nodes + 7 + multipliers();
}

void VariationalStepper::remember(const StepBase& base, const Unknowns& x) {
  memory_.before = std::exchange(memory_.last, {});
  Eigen::VectorXd& rates = memory_.last.flow;
  rates.resize(past_size());
  rates << motion_of(base, x).reshaped() / base.tau, (x.next.beta - base.old.beta) / base.tau,
      x.next.Lambda, x.next.H, x.x.tail(mesh_->quadratic_nodes), x.borders,
      surface3d::multipliers(material_, x.next);
  memory_.last.tau = base.tau;
}

// As LaggedSolver, and where the steps have become longer than the factors are sure for.
bool VariationalStepper::worth_factoring(double tau) const {
  if (memory_.solves == 0 || tau > memory_.factored_tau) return true;
  const double all = 2 * matrix_.cost_of_factoring() + memory_.iterations;
  return memory_.last_iterations > all / memory_.solves;
}

// At a state at rest, for steps up to tau: the shorter ones have minima where the longest has.
bool VariationalStepper::factor(const State& at, const Curvature& curvature, double tau) {
  const std::array<Nodes, 2> tangents = node_tangents(curvature.node_normals);
  assemble(material_, layout_, {at, curvature, tangents, Nodes::Zero(3, mesh_->nodes), tau},
           factored_);
  memory_.factored_at = at;
  memory_.factored_tau = tau;
  memory_.solves = memory_.iterations = memory_.last_iterations = 0;
  return matrix_.factor(material_, guess_from(*mesh_, material_, model_, at),
                        curvature.node_normals, factored_);
}

// Where the iteration is; the next step does not begin with these factors.
bool VariationalStepper::factor_here(const StepBase& base, const Unknowns& x) {
  memory_.solves = 0;
  if (!matrix_.factor(material_, x.next, base.curvature.node_normals, resistance_)) return false;
  matrix_.begin(resistance_);
  return true;
}

bool VariationalStepper::recall(const StepperMemory& memory) {
  if (memory.solves > 0) {
    const auto curvature = curvature_of(*mesh_, memory.factored_at.X);
    if (!curvature || !factor(memory.factored_at, *curvature, memory.factored_tau)) return false;
  }
  memory_ = memory;
  for (Solution* x : {&memory_.last, &memory_.before})
    if (x->flow.size() != past_size()) *x = {};  // of another scheme
  return true;
}

// A step of Newton's method, and how far it leads. Returns how often the factors were applied; 0: they are too old.
int VariationalStepper::correct(const StepBase& base, const Target& target, Unknowns& x,
                                double& change) {
  const int n = layout_.size(), m = multipliers();
  const StationaryLayout& state = layout_.state;
  assemble(material_, state, x.next, base.curvature.node_normals, energy_);
  if (!energy_.gradient.allFinite()) return 0;
  Eigen::VectorXd rhs(n + m + 7), step = Eigen::VectorXd::Zero(n + m + 7);
  const Eigen::VectorXd force = product(resistance_.matrix, x.x),
                        held = resistance_.borders * x.borders;
  rhs.head(n) = -(force + resistance_.linear + held);
  value_ = value_of(x.next, target) + (force / 2 + resistance_.linear + held).dot(x.x);
  rhs(layout_.unknowns) -= energy_.gradient;
  rhs.segment(n, m) = energy_.miss(material_, target, x.next.moment);
  rhs.tail<7>() = -resistance_.borders.transpose() * x.x;
  const int iterations = matrix_.solve(energy_, rhs, step);
  if (iterations == 0 || !step.allFinite()) return 0;

  const Field d = step(layout_.all(node_d));
  change = d.cwiseAbs().maxCoeff();
  x.x += step.head(n);
  x.borders += step.tail<7>();
  x.next.X += base.curvature.node_normals * d.asDiagonal();
  x.next.Lambda = x.x(layout_.all(node_Lambda));
  x.next.H = x.x(layout_.all(node_H));
  if (state.free_order) {
    change = std::max(change, step(layout_.all(node_beta)).cwiseAbs().maxCoeff());
    x.next.beta = x.x(layout_.all(node_beta));
  }
  set_multipliers(material_, surface3d::multipliers(material_, x.next) + step.segment(n, m),
                  x.next);
  return iterations;
}

// What is to be stationary, but for a constant, where nothing moves but the mesh along itself, and what rounding may leave of it more.
double VariationalStepper::value_at_rest(const StepBase& base, const Field& H, const Target& target,
                                         const Unknowns& x) {
  constexpr double rounding = 1e-10;
  StationaryState from{{base.old.X + base.Y, base.old.beta}, H, Field::Zero(mesh_->nodes)};
  from.tension = x.next.tension;
  from.pressure = x.next.pressure;
  from.chemical_potential = x.next.chemical_potential;
  const model::AreaDifference& ad = material_.area_difference;
  if (ad.is_there() && ad.compliance() == 0) from.moment = x.next.moment;
  assemble(material_, layout_.state, from, base.curvature.node_normals, energy_);
  Eigen::VectorXd still = Eigen::VectorXd::Zero(layout_.size());
  if (layout_.state.free_order) still(layout_.all(node_beta)) = base.old.beta;
  return value_of(from, target) + ad.energy(energy_.area, energy_.W2)
       + rounding * std::abs(energy_.value) + still.dot(product(resistance_.matrix, still)) / 2
       + resistance_.linear.dot(still);
}

// The Lagrangian that was assembled at a state.
double VariationalStepper::value_of(const StationaryState& state, const Target& target) const {
  return energy_.value - state.tension * target.area + state.pressure * target.volume
       - state.moment * material_.area_difference.W2;
}

// What may be left of the error of a solution: nothing that the error of the step shows, nor its speeds. What is to be minimal is then
// within 1e-6 of its fall.
double VariationalStepper::enough(const StepBase& base, const Unknowns& x) const {
  constexpr double small = 1e-3, rounding = 1e-10;
  const double moved = x.x(layout_.all(node_d)).cwiseAbs().maxCoeff(),
               changed = (x.next.beta - base.old.beta).cwiseAbs().maxCoeff();
  return std::max(rounding, small * std::min(tolerance_, std::max(moved, changed)));
}

FlowFault VariationalStepper::solve(const StepBase& base, const Target& target, Unknowns& x,
                                    bool always_factors) {
  constexpr int most_iterations = 20;
  constexpr double far = 0.5, slow = 0.3;
  double before = std::numeric_limits<double>::infinity();
  bool own = false;  // the matrix is that of an iterate
  int applied = 0;   // the factors
  for (int i = 0; i < most_iterations; ++i) {
    if (always_factors && !(own = factor_here(base, x))) return FlowFault::linear_solve;
    double change = 0;
    int times = correct(base, target, x, change);
    if (times == 0 && !own && (own = factor_here(base, x)))
      times = correct(base, target, x, change);
    if (times == 0) return FlowFault::linear_solve;
    applied += times;
    if (!(change < far)) return FlowFault::error;
    const double rate = change / std::exchange(before, change);
    const double left = i == 0 ? change : rate < 1 ? change * rate / (1 - rate) : far;
    if (left <= enough(base, x)) {
      memory_.solves += own ? 0 : 1;
      memory_.iterations += applied;
      memory_.last_iterations = applied;
      return is_minimum(base, x) ? FlowFault::none : FlowFault::energy_rises;
    }
    if (rate > slow && !(own = factor_here(base, x))) return FlowFault::linear_solve;
  }
  return FlowFault::error;
}

// As long as Newton's method converges with it, the matrix has as many negative eigenvalues as that of the solution: none changes its
// sign on the way from one to the other.
bool VariationalStepper::is_minimum(const StepBase& base, const Unknowns& x) {
  return matrix_.minimum() || (factor_here(base, x) && matrix_.minimum());
}

FlowStep VariationalStepper::result_of(const StepBase& base, const Unknowns& x) {
  const double tau = base.tau;
  fields_.Y = base.Y + base.curvature.node_normals * x.x(layout_.all(node_d)).asDiagonal();
  fields_.V = motion_of(base, x) / tau;
  fields_.H = x.next.H;
  fields_.p = x.x.tail(mesh_->quadratic_nodes).array() + x.next.tension;
  fields_.lambda = -x.next.pressure;
  const State next{x.next.X, x.next.beta};
  if (!(mesh_quality(*mesh_, next.X) > 0)) return {.fault = FlowFault::degenerate};
  const Dissipation dissipation = dissipation_of(*mesh_, material_, base.old,
                                                 {.velocity = fields_.V,
                                                  .slip = fields_.V - fields_.Y / tau,
                                                  .order_rate = (next.beta - base.old.beta) / tau,
                                                  .order = base.old.beta});
  return {.fault = FlowFault::none,
          .state = next,
          .dissipation = dissipation,
          .lambda = fields_.lambda,
          .speed_max = fields_.V.colwise().norm().maxCoeff(),
          .order_speed =
              std::sqrt(dissipation.order / (material_.order_drag() * area(*mesh_, base.old.X)))};
}

FlowStep VariationalStepper::step(const State& old, const std::optional<Target>& target,
                                  double tau) {
  constexpr double reach = 2;  // of the factors, in steps
  const auto curvature = curvature_of(*mesh_, old.X);
  if (!curvature) return {.fault = FlowFault::degenerate};
  const auto Y = motion_along(old, *curvature, tau);
  if (!Y) return {};
  const State from{old.X + *Y, old.beta};
  const auto there = curvature_of(*mesh_, from.X);
  if (!there) return {.fault = FlowFault::degenerate};
  if (!always_factors_ && worth_factoring(tau) && !factor(old, *curvature, reach * tau))
    return memory_ = {}, FlowStep{};
  const std::array<Nodes, 2> tangents = node_tangents(curvature->node_normals);
  const StepBase base{old, *curvature, tangents, *Y, tau};
  assemble(material_, layout_, base, resistance_);
  if (!always_factors_) matrix_.begin(resistance_);
  const Target keep = target.value_or(lipids_and_volume(*mesh_, material_, old));
  Unknowns x = guess(base);
  FlowFault fault = solve(base, keep, x, always_factors_);
  if (fault == FlowFault::error && !always_factors_) {  // the past led astray, or an old matrix
    memory_ = {};
    x = guess(base);
    fault = solve(base, keep, x, true);
  }
  if (fault == FlowFault::none && !(value_ <= value_at_rest(base, there->H, keep, x)))
    fault = FlowFault::energy_rises;
  if (fault != FlowFault::none) return memory_ = {}, FlowStep{.fault = fault};
  remember(base, x);
  return result_of(base, x);
}

}  // namespace sbeh::surface3d
