#include "axisym/stationary/bifurcation.h"

#include "axisym/redistribute.h"

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

namespace {

// A symmetric state on the line with its softest antisymmetric mode.
struct Sample {
  double mu;
  StationaryState s;
  SoftMode mode;
};

// Plain Newton steps keep the symmetry; the arclength's tangent would see the other branch.
std::optional<Sample> sample(const Line& line, double mu, const StationaryState& near,
                             const Numerics& numerics) {
  const NewtonResult r = solve_stationary(line.material(mu), line.model(), line.target(mu),
                                          redistribute(near, numerics.grading));
  if (r.status != NewtonStatus::converged) return {};
  const auto mode = antisymmetric_mode(line.material(mu), line.model(), r.solution);
  if (!mode) return {};
  return Sample{mu, r.solution, *mode};
}

}  // namespace

std::optional<Pitchfork> find_pitchfork(const model::Material& material, model::Model model,
                                        const BranchState& from, PlanePoint to,
                                        const Numerics& numerics) {
  const Line line(material, model, from.at, to);
  auto a = sample(line, 0, from.solution, numerics);
  constexpr int steps = 16;
  for (int k = 1; k <= steps && a; ++k) {
    auto b = sample(line, double(k) / steps, a->s, numerics);
    if (!b) return {};
    if (a->mode.eigenvalue * b->mode.eigenvalue > 0) {
      a = b;
      continue;
    }
    // Secants. At the zero itself the matrix is singular: the last estimate is not solved for.
    const auto zero = [&] {
      const double fa = a->mode.eigenvalue, fb = b->mode.eigenvalue;
      return (a->mu * fb - b->mu * fa) / (fb - fa);
    };
    for (int iteration = 0; iteration < 12 && std::abs(zero() - b->mu) > 1e-7; ++iteration) {
      const auto next = sample(line, zero(), b->s, numerics);
      if (!next) break;
      a = b;
      b = next;
    }
    Increment along = b->mode.direction;
    along.parameter = 0;
    const double rms =
        std::sqrt((along.d.squaredNorm() + along.beta.squaredNorm()) / double(along.d.size()));
    return Pitchfork{{{zero(), b->s}, scaled(along, 1 / rms), 0}};
  }
  return {};
}

}  // namespace sbeh::axisym
