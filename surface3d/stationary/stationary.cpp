#include "surface3d/stationary/stationary.h"

#include "surface3d/curvature.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbeh::surface3d {

StationaryState guess_from(const Triangulation& mesh, const model::Material& material,
                           model::Model model, const State& shape) {
  const auto curvature = curvature_of(mesh, shape.X);
  if (!curvature) throw std::runtime_error("stationary state: the surface is degenerate");
  StationaryState guess{shape, curvature->H, Field(mesh.nodes)};
  for (int i = 0; i < mesh.nodes; ++i)
    guess.Lambda[i] = -material.moment(shape.beta[i], guess.H[i]);
  const StationaryLayout layout(mesh, model);
  LagrangianGradient lagrangian;
  const auto assemble_guess = [&] {
    assemble(material, layout, guess, curvature->node_normals, lagrangian);
  };
  assemble_guess();
  if (layout.free_order && material.conserves_order()) {
    // Least squares over the orders, each of which feels its own force and μ_β.
    const auto orders = layout.all(node_beta);
    const Eigen::VectorXd column = lagrangian.constraints.rightCols<1>()(orders);
    guess.chemical_potential = -column.dot(lagrangian.gradient(orders)) / column.squaredNorm();
    assemble_guess();
  }
  const model::AreaDifference& ad = material.area_difference;
  const bool is_couple = ad.is_there() && ad.compliance() == 0;  // whose moment may be any
  if (ad.is_there() && !is_couple) {
    guess.moment = (lagrangian.W2 - ad.W2) / (lagrangian.area * ad.compliance());
    assemble_guess();
  }
  // Least squares over the displacements alone: the other rows do not feel the multipliers.
  const auto displacements = layout.all(node_d);
  const Eigen::MatrixXd forces =
      lagrangian.constraints(displacements, Eigen::seqN(0, is_couple ? 3 : 2));
  const Eigen::VectorXd multipliers =
      forces.completeOrthogonalDecomposition().solve(-lagrangian.gradient(displacements));
  guess.tension = multipliers[0];
  guess.pressure = multipliers[1];
  if (is_couple) guess.moment = multipliers[2];
  guess.Lambda.array() -= guess.moment;  // as with f + c for f
  return guess;
}

double residual_of(const NewtonSystem& system, const StationaryState& state) {
  const StationaryLayout& layout = system.layout();
  Field areas = Field::Zero(layout.mesh.nodes);
  for_each_point(layout.mesh, state.X, assembly_points(),
                 [&](int e, const ShapeValues& s, const SurfacePoint& p) {
                   for (int a = 0; a < 10; ++a)
                     areas[layout.mesh.triangles(a, e)] += p.dS * std::abs(s.phi[std::size_t(a)]);
                 });
  const Eigen::VectorXd& gradient = system.derivatives().gradient;
  double largest = gradient(layout.all(node_d)).cwiseQuotient(areas).cwiseAbs().maxCoeff();
  if (layout.free_order)
    largest = std::max(largest,
                       gradient(layout.all(node_beta)).cwiseQuotient(areas).cwiseAbs().maxCoeff());
  return largest;
}

namespace {

// Steps with the factors that are there, as long as each is a small share of the one before; the last change.
double settle(NewtonSystem& system, const Target& target, double change, double enough, bool renews,
              NewtonResult& result) {
  constexpr double share = 0.1;
  Increment step;
  while (change > enough) {
    if (renews) result.normals = node_normals(system.layout().mesh, result.state.X);
    if (!system.newton_step_from(result.state, result.normals, target, step)) break;
    const double next = largest_change(step);
    if (!(next < share * change)) break;
    displace(step, 1, result.normals, result.state);
    change = next;
    result.changes.push_back(change);
  }
  return change;
}

}  // namespace

NewtonResult solve_stationary(NewtonSystem& system, const Target& target,
                              const StationaryState& guess, const NewtonOptions& options) {
  // Normals are renewed as long as that costs no iterations.
  constexpr double settled = 1e-2, decrease = 0.1;
  NewtonResult result{.status = NewtonStatus::diverged,
                      .state = guess,
                      .normals = node_normals(system.layout().mesh, guess.X)};
  StationaryState& state = result.state;
  Nodes& normals = result.normals;
  Increment step;
  bool renews = options.renews_normals;
  while (int(result.changes.size()) < options.most_iterations) {
    if (renews) normals = node_normals(system.layout().mesh, state.X);
    if (!system.linearise(state, normals, {{}, options.phase})
        || !system.newton_step(target, step)) {
      result.status = NewtonStatus::singular;
      return result;
    }
    double change = largest_change(step);
    if (!result.changes.empty() && change < settled && change > decrease * result.changes.back())
      renews = false;
    result.changes.push_back(change);
    result.negative_directions = system.negative_directions();
    result.rigid_motions = system.rigid_count();
    if (!(change < options.far)) return result;
    const double longest = options.longest_step / change,
                 factor = deflation(options.known, system.layout().mesh, state, normals, step);
    displace(step, std::clamp(factor, -longest, longest), normals, state);
    if (options.keeps_factors && change < settled)
      change = settle(system, target, change, options.tolerance * decrease, renews, result);
    if (change < options.tolerance) {
      result.status = NewtonStatus::converged;
      return result;
    }
  }
  return result;
}

}  // namespace sbeh::surface3d
