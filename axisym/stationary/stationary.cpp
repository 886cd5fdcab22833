#include "axisym/stationary/stationary.h"

#include "axisym/curvature.h"
#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/symmetry.h"

#include <Eigen/Dense>

#include <algorithm>
#include <limits>

namespace sbeh::axisym {

model::Material felt_material(const model::Material& material, model::Model model) {
  return has_free_order(model) ? material : material.without_gaussian().with_uniform_order();
}

model::Material held_material(const model::Material& material, const StationaryState& state) {
  return material.at_moment(state.moment).at_chemical_potential(state.chemical_potential);
}

double felt_tension(const model::Material& material, const StationaryState& state) {
  const double c = state.moment;
  return c == 0 ? state.tension : state.tension - c * c * material.area_difference.compliance() / 2;
}

StationaryState guess_from(const model::Material& whole, model::Model model, const State& shape) {
  const model::Material material = felt_material(whole, model);
  const Eigen::Index nodes = shape.beta.size();
  StationaryState guess{shape, mean_curvature(shape.X), Field(nodes)};
  const Nodes n = node_normals(shape.X);
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const double r = shape.X(0, i), beta = shape.beta[i];
    const double B_phi = r > 0 ? -n(0, i) / r : guess.H[i] / 2;
    guess.Lambda[i] = -(material.moment(beta, guess.H[i]) + material.kappa_gauss(beta) * B_phi);
  }
  const auto gradient = [&] {
    return gradient_at(material, guess, n, {element_count(guess.X), false});
  };
  LagrangianGradient lagrangian = gradient();
  if (material.conserves_order()) {
    // Least squares over the orders, each of which feels its own force and μ_β.
    const auto orders = Eigen::seqN(Eigen::Index(node_beta), nodes, Eigen::Index(node_unknowns));
    const Eigen::VectorXd column = lagrangian.of_order(orders);
    guess.chemical_potential = -column.dot(lagrangian.gradient(orders)) / column.squaredNorm();
    lagrangian = gradient();
  }
  const model::AreaDifference& ad = material.area_difference;
  const bool is_couple = ad.is_there() && ad.compliance() == 0;  // whose moment may be any
  if (ad.is_there() && !is_couple) {
    guess.moment = (lagrangian.W2 - ad.W2) / (lagrangian.area * ad.compliance());
    lagrangian = gradient();
  }
  // Least squares over the displacements alone: the other rows do not feel the multipliers.
  const auto displacements = Eigen::seqN(Eigen::Index(node_d), nodes, Eigen::Index(node_unknowns));
  Eigen::MatrixXd forces(nodes, is_couple ? 3 : 2);
  forces.leftCols(2) = lagrangian.constraints(displacements, Eigen::all);
  if (is_couple) forces.col(2) = lagrangian.of_W2(displacements);
  const Eigen::VectorXd multipliers =
      forces.completeOrthogonalDecomposition().solve(-lagrangian.gradient(displacements));
  guess.tension = multipliers[0];
  guess.pressure = multipliers[1];
  if (is_couple) guess.moment = multipliers[2];
  guess.Lambda.array() -= guess.moment;  // as with f + c for f
  return guess;
}

double residual_of(const model::Material& material, model::Model model,
                   const StationaryState& state) {
  return residual_of(lagrangian_at(material, model, state), model, state.X);
}

NewtonResult solve_stationary(const model::Material& material, model::Model model,
                              const Target& target, const StationaryState& guess,
                              const NewtonOptions& options) {
  NewtonResult result{NewtonStatus::diverged, guess, 0, 0};
  StationaryState& state = result.state;
  if (options.symmetric) state = symmetric_part(guess);
  NewtonSystem system(material, model, {element_count(state.X), options.symmetric});
  Increment step;
  while (result.iterations < options.most_iterations) {
    if (!system.linearise(state) || !system.newton_step(target, step)) {
      result.status = NewtonStatus::singular;
      return result;
    }
    ++result.iterations;
    result.determinant_sign = system.determinant_sign();
    const double change = largest_change(step);
    if (change > options.far) return result;
    displace(step, std::min(1., options.longest_step / change), state);
    if (change < options.tolerance) {
      result.status = NewtonStatus::converged;
      // The matrix lacks how normals turn: the error left is a small share of the change, not its square.
      if (options.corrects && system.newton_step_from(state, target, step)
          && largest_change(step) < options.tolerance)
        displace(step, 1, state);
      return result;
    }
    if (state.X.row(0).minCoeff() < 0) return result;
  }
  return result;
}

}  // namespace sbeh::axisym
