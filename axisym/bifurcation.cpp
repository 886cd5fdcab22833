#include "axisym/bifurcation.h"

#include <cmath>
#include <numbers>

namespace sbeh::axisym {

namespace {

// A motion that is odd about the equator and no translation: cos 3πs along the curve.
Increment antisymmetric_seed(Eigen::Index nodes) {
  Increment seed;
  seed.d.resize(nodes);
  for (Eigen::Index i = 0; i < nodes; ++i)
    seed.d[i] = std::cos(3 * std::numbers::pi * double(i) / double(nodes - 1));
  seed.Lambda = seed.H = seed.beta = Field::Zero(nodes);
  return seed;
}

double product(const Field& areas, const Increment& a, const Increment& b) {
  return areas.dot(a.d.cwiseProduct(b.d) + a.beta.cwiseProduct(b.beta));
}

}  // namespace

std::optional<SoftMode> antisymmetric_mode(const model::Material& material, model::Model model,
                                           const StationaryState& s) {
  const Eigen::Index nodes = s.state.beta.size();
  NewtonSystem system(material, model, int(nodes));
  if (!system.linearise(s)) return {};
  const Field& areas = system.areas();
  Increment x = antisymmetric_seed(nodes);
  double eigenvalue = 0;
  for (int iteration = 0; iteration < 40; ++iteration) {
    x = scaled(x, 1 / std::sqrt(product(areas, x, x)));
    Eigen::VectorXd load = Eigen::VectorXd::Zero(node_unknowns * nodes);
    for (Eigen::Index i = 0; i < nodes; ++i) {
      load[index(i, node_d)] = areas[i] * x.d[i];
      load[index(i, node_beta)] = areas[i] * x.beta[i];
    }
    Increment next;
    if (!system.tangent(-load, 0, next)) return {};
    next.parameter = 0;
    const double estimate = 1 / product(areas, x, next);
    x = next;
    if (std::abs(estimate - eigenvalue) <= 1e-9 * std::abs(estimate) + 1e-12) {
      x = scaled(x, 1 / std::sqrt(product(areas, x, x)));
      return SoftMode{estimate, x};
    }
    eigenvalue = estimate;
  }
  return {};
}

std::optional<Pitchfork> find_pitchfork(const model::Material& material, model::Model model,
                                        const BranchState& from, PlanePoint to,
                                        const Numerics& numerics) {
  const Line line(material, model, from.at, to);
  // The branch is followed in steps; within the step of the sign change by secants.
  BranchState a = from;
  double mu_a = 0;
  auto mode_a = antisymmetric_mode(line.material(0), model, a.solution);
  constexpr int steps = 16;
  for (int k = 1; k <= steps && mode_a; ++k) {
    const double mu_b = double(k) / steps;
    const FollowResult next = follow(material, model, a, line.at(mu_b), numerics);
    if (next.arrival != Arrival::reached) return {};
    BranchState b = next.state;
    auto mode_b = antisymmetric_mode(line.material(mu_b), model, b.solution);
    if (!mode_b) return {};
    if (mode_a->eigenvalue * mode_b->eigenvalue > 0) {
      a = b;
      mu_a = mu_b;
      mode_a = mode_b;
      continue;
    }
    // Secants. At the zero itself the matrix is singular: the last estimate is not solved for.
    double fa = mode_a->eigenvalue, fb = mode_b->eigenvalue, before = mu_a, mu = mu_b;
    const auto estimate = [&] { return (before * fb - mu * fa) / (fb - fa); };
    for (int iteration = 0; iteration < 12 && std::abs(estimate() - mu) > 1e-7; ++iteration) {
      const double next_mu = estimate();
      const FollowResult closer = follow(material, model, b, line.at(next_mu), numerics);
      if (closer.arrival != Arrival::reached) break;
      b = closer.state;
      const auto mode = antisymmetric_mode(line.material(next_mu), model, b.solution);
      if (!mode) break;
      before = mu;
      fa = fb;
      mu = next_mu;
      fb = mode->eigenvalue;
      mode_b = mode;
    }
    mu = estimate();
    Increment along = mode_b->direction;
    along.parameter = 0;
    const double rms = std::sqrt((along.d.squaredNorm() + along.beta.squaredNorm())
                                 / double(along.d.size()));
    return Pitchfork{{mu, b.solution, scaled(along, 1 / rms), b.determinant_sign}};
  }
  return {};
}

}  // namespace sbeh::axisym
