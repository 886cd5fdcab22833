#include "surface3d/variational/variational_stepper.h"

#include "surface3d/diagnostics.h"
#include "surface3d/linear/bordered.h"
#include "surface3d/parallel.h"
#include "surface3d/stationary/stationary.h"

#include <algorithm>
#include <cmath>

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
                                       const Numerics&)
    : mesh_(mesh),
      material_(effective(material, model)),
      model_(model),
      layout_(*mesh, model),
      along_(*mesh) {}

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

// The matrix at x, factored, with the gradient of U in energy_.
bool VariationalStepper::linearise(const StepBase& base, const Unknowns& x) {
  assemble(material_, layout_.state, x.next, base.curvature.node_normals, energy_);
  if (!energy_.gradient.allFinite()) return false;
  matrix_ = resistance_.matrix;
  const double* entry = energy_.hessian.valuePtr();
  for (const int place : layout_.places) matrix_.valuePtr()[place] += *entry++;
  Eigen::MatrixXd borders = Eigen::MatrixXd::Zero(layout_.size(), 9);
  borders(layout_.unknowns, {0, 1}) = energy_.constraints;
  borders.rightCols<7>() = resistance_.borders;
  set_bordered(matrix_, borders, bordered_);
  return solver_.factor(bordered_);
}

FlowFault VariationalStepper::solve(const StepBase& base, const Target& target, Unknowns& x) {
  constexpr int most_iterations = 12;
  constexpr double converged = 1e-6, far = 0.5;
  const int n = layout_.size();
  const StationaryLayout& state = layout_.state;
  for (int i = 0; i < most_iterations; ++i) {
    if (!linearise(base, x)) return FlowFault::linear_solve;
    Eigen::VectorXd step(n + 9);
    step.head(n) =
        -(resistance_.matrix * x.x + resistance_.linear + resistance_.borders * x.borders);
    step(layout_.unknowns) -= energy_.gradient;
    step.segment<2>(n) << target.area - energy_.area, energy_.volume - target.volume;
    step.tail<7>() = -resistance_.borders.transpose() * x.x;
    solver_.solve(step);
    if (!step.allFinite()) return FlowFault::linear_solve;

    const Field d = step(layout_.all(node_d));
    double change = d.cwiseAbs().maxCoeff();
    x.x += step.head(n);
    x.borders += step.tail<7>();
    x.next.X += base.curvature.node_normals * d.asDiagonal();
    x.next.Lambda = x.x(layout_.all(node_Lambda));
    x.next.H = x.x(layout_.all(node_H));
    if (state.free_order) {
      change = std::max(change, step(layout_.all(node_beta)).cwiseAbs().maxCoeff());
      x.next.beta = x.x(layout_.all(node_beta));
    }
    x.next.tension += step[n];
    x.next.pressure += step[n + 1];
    if (!(change < far)) return FlowFault::error;
    if (change > converged) continue;
    const int multipliers = mesh_->nodes + mesh_->quadratic_nodes + 8;
    return solver_.negative_eigenvalues() == multipliers ? FlowFault::none
                                                         : FlowFault::energy_rises;
  }
  return FlowFault::error;
}

FlowStep VariationalStepper::result_of(const StepBase& base, const Unknowns& x) {
  const double tau = base.tau;
  Nodes u = base.curvature.node_normals * x.x(layout_.all(node_d)).asDiagonal();
  fields_.Y = base.Y + u;
  for (int k = 0; k < 2; ++k)
    u += base.tangents[std::size_t(k)] * x.x(layout_.all(layout_.state.per_node + k)).asDiagonal();
  fields_.V = u / tau;
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
  const auto curvature = curvature_of(*mesh_, old.X);
  if (!curvature) return {.fault = FlowFault::degenerate};
  const auto Y = motion_along(old, *curvature, tau);
  if (!Y) return {};
  const State from{old.X + *Y, old.beta};
  if (!curvature_of(*mesh_, from.X)) return {.fault = FlowFault::degenerate};
  const std::array<Nodes, 2> tangents = node_tangents(curvature->node_normals);
  const StepBase base{old, *curvature, tangents, *Y, tau};
  assemble(material_, layout_, base, resistance_);

  Unknowns x{.x = Eigen::VectorXd::Zero(layout_.size()),
             .next = guess_from(*mesh_, material_, model_, from)};
  x.x(layout_.all(node_Lambda)) = x.next.Lambda;
  x.x(layout_.all(node_H)) = x.next.H;
  if (layout_.state.free_order) x.x(layout_.all(node_beta)) = x.next.beta;
  const FlowFault fault = solve(base, target.value_or(area_and_volume(*mesh_, old.X)), x);
  if (fault != FlowFault::none) return {.fault = fault};
  return result_of(base, x);
}

}  // namespace sbeh::surface3d
