#include "axisym/stationary/stationary.h"

#include "axisym/curvature.h"
#include "axisym/stationary/newton_system.h"

#include <Eigen/Dense>

#include <algorithm>
#include <limits>

namespace sbeh::axisym {

StationaryState guess_from(const model::Material& material, const State& state) {
  const Eigen::Index nodes = state.beta.size();
  StationaryState s{.state = state,
                    .H = mean_curvature(state.X),
                    .Lambda = Field(nodes),
                    .tension = 0,
                    .pressure = 0};
  const Nodes n = node_normals(state.X);
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const double r = state.X(0, i), beta = state.beta[i];
    const double B_phi = r > 0 ? -n(0, i) / r : s.H[i] / 2;
    s.Lambda[i] = -(material.kappa(beta) * (s.H[i] - material.spontaneous_curvature)
                    + material.kappa_gauss(beta) * B_phi);
  }
  LagrangianDerivatives L{int(nodes)};
  assemble(material, s, n, L);
  // Least squares over the displacements alone: the other rows do not feel tension and pressure.
  const auto displacements = Eigen::seqN(Eigen::Index(node_d), nodes, Eigen::Index(node_unknowns));
  const Eigen::MatrixXd forces = L.constraints(displacements, Eigen::all);
  const Eigen::Vector2d multipliers =
      forces.completeOrthogonalDecomposition().solve(-L.gradient(displacements));
  s.tension = multipliers[0];
  s.pressure = multipliers[1];
  return s;
}

double residual_of(const model::Material& material, model::Model model, const StationaryState& s) {
  NewtonSystem system(material, model, int(s.state.beta.size()));
  return system.linearise(s) ? system.residual() : std::numeric_limits<double>::infinity();
}

NewtonResult solve_stationary(const model::Material& material, model::Model model,
                              const Target& target, const StationaryState& guess,
                              const NewtonOptions& options) {
  NewtonResult result{NewtonStatus::diverged, guess, 0, 0};
  StationaryState& s = result.solution;
  NewtonSystem system(material, model, int(s.state.beta.size()));
  Increment step;
  while (result.iterations < options.iterations) {
    if (!system.linearise(s) || !system.newton_step(target, step)) {
      result.status = NewtonStatus::singular;
      return result;
    }
    ++result.iterations;
    result.determinant_sign = system.determinant_sign();
    const double change = std::max(step.d.cwiseAbs().maxCoeff(), step.beta.cwiseAbs().maxCoeff());
    displace(step, std::min(1., options.longest_step / change), s);
    if (change < options.tolerance) {
      result.status = NewtonStatus::converged;
      return result;
    }
    if (s.state.X.row(0).minCoeff() < 0) return result;
  }
  return result;
}

}  // namespace sbeh::axisym
