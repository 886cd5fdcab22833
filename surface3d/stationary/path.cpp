#include "surface3d/stationary/path.h"

#include <algorithm>
#include <cmath>

namespace sbeh::surface3d {

namespace {

using Direction = PathPoint::Direction;
static_assert(model::ContinuationSystem<Path>);

double product(const Direction& a, const Direction& b) {
  return (a.d.dot(b.d) + a.beta.dot(b.beta)) / double(a.d.size()) + a.mu * b.mu;
}

Direction scaled(Direction t, double factor) {
  for (Field* f : {&t.d, &t.Lambda, &t.H, &t.beta}) *f *= factor;
  t.tension *= factor;
  t.pressure *= factor;
  t.mu *= factor;
  return t;
}

// a + factor b
Direction sum(Direction a, double factor, const Direction& b) {
  a.d += factor * b.d;
  a.Lambda += factor * b.Lambda;
  a.H += factor * b.H;
  a.beta += factor * b.beta;
  a.tension += factor * b.tension;
  a.pressure += factor * b.pressure;
  a.mu += factor * b.mu;
  return a;
}

constexpr double h = 1e-3;  // of μ: energies are polynomials of low degree in it, volumes smooth

// The change of the solution per change of μ.
std::optional<Direction> along_mu(const Path& path, const PathSolution& x) {
  NewtonSystem& system = *path.system;
  const model::Material before = path.material(x.mu - h), after = path.material(x.mu + h);
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(system.layout().size());
  if (!(before == after))
    rate = (system.gradient_with(after, x, x.normals) - system.gradient_with(before, x, x.normals))
         / (2 * h);
  const Target low = path.target(x.mu - h), high = path.target(x.mu + h);
  Direction b;
  if (!system.respond(-rate,
                      {(high.area - low.area) / (2 * h), -(high.volume - low.volume) / (2 * h)}, b))
    return {};
  b.mu = 1;
  return b;
}

bool linearise(const Path& path, const PathSolution& x) {
  path.system->set_material(path.material(x.mu));
  return path.system->linearise(x, x.normals);
}

void move(PathSolution& x, const Direction& step, double scale) {
  displace(step, scale, x.normals, x);
  x.mu += scale * step.mu;
}

double largest(const Direction& step) { return std::max(largest_change(step), std::abs(step.mu)); }

}  // namespace

Path::Path(const Triangulation& mesh, model::Model model,
           std::function<model::Material(double)> material_at,
           std::function<Target(double)> target_at)
    : material(std::move(material_at)),
      target(std::move(target_at)),
      system(std::make_shared<NewtonSystem>(mesh, material(0), model)) {}

std::optional<PathSolution> predicted(const Path& path, const PathPoint& from, double ds) {
  PathSolution guess = from;
  move(guess, from.tangent, ds);
  guess.normals = node_normals(path.system->layout().mesh, guess.X);
  return guess;
}

namespace {

// Newton's step on the hyperplane across the tangent; empty where it changes more than `most`.
std::optional<double> step_across(const Path& path, PathSolution& x, const Direction& tangent,
                                  double most) {
  Direction a;
  if (!linearise(path, x) || !path.system->newton_step(path.target(x.mu), a)) return {};
  const auto b = along_mu(path, x);
  if (!b) return {};
  const Direction step = sum(a, -product(tangent, a) / product(tangent, *b), *b);
  if (!(largest(step) < most)) return {};
  move(x, step, 1);
  return largest(step);
}

}  // namespace

std::optional<double> newton_step(const Path& path, PathSolution& x, const PathPoint& from,
                                  double ds) {
  constexpr double share = 0.5, always = 1e-3;
  return step_across(path, x, from.tangent,
                     std::max(always, share * std::abs(ds) * largest(from.tangent)));
}

std::optional<PathPoint> with_tangent(const Path& path, const PathSolution& x,
                                      const Direction* forward) {
  if (!linearise(path, x)) return {};
  const auto b = along_mu(path, x);
  if (!b) return {};
  const double sign = forward && product(*forward, *b) < 0 ? -1 : 1;
  return PathPoint{x, scaled(*b, sign / std::sqrt(product(*b, *b))),
                   path.system->negative_directions()};
}

bool continues(const Path& /*path*/, const PathPoint& from, const PathPoint& next, double /*ds*/) {
  return product(from.tangent, next.tangent) > model::least_cosine;
}

std::optional<PathPoint> settled(const Path& path, const StationaryState& guess, double mu) {
  path.system->set_material(path.material(mu));
  const NewtonResult found = solve_stationary(*path.system, path.target(mu), guess);
  if (found.status != NewtonStatus::converged) return {};
  return with_tangent(path, {found.state, mu, found.normals});
}

std::optional<BranchingPoint> locate_branching(const Path& path, const PathPoint& start,
                                               const PathPoint& beyond, double ds) {
  const int first = std::min(start.negative_directions, beyond.negative_directions),
            count = std::abs(start.negative_directions - beyond.negative_directions);
  // The mean of those that change their sign: they are one, or two alike.
  const auto modes_at = [&](const PathPoint& p) -> std::vector<Eigenmode> {
    if (!linearise(path, p)) return {};
    auto modes = lowest_modes(*path.system, p, p.normals, first + count);
    if (!modes || int(modes->size()) < first + count) return {};
    return {modes->begin() + first, modes->begin() + first + count};
  };
  const auto mean = [&](const std::vector<Eigenmode>& modes) {
    double total = 0;
    for (const Eigenmode& mode : modes) total += mode.eigenvalue;
    return total / count;
  };
  if (count == 0) return {};
  constexpr int most_iterations = 12;
  // Of ds: nearer, the matrix is singular. There the mesh, which has not the symmetry that is lost, may turn the branch
  // off before.
  constexpr double near = 1e-6, nearly = 1e-3;
  const auto low = modes_at(start), high = modes_at(beyond);
  if (low.empty() || high.empty()) return {};
  PathPoint before = start;
  double value = mean(low), slope = (mean(high) - value) / ds;
  std::vector<Eigenmode> modes = low;
  for (int i = 0; i < most_iterations; ++i) {
    const double step = -value / slope;
    if (std::abs(step) < near * std::abs(ds)) return BranchingPoint{before, modes};
    const auto next = arc_step(path, before, step);
    if (!next && std::abs(step) < nearly * std::abs(ds)) return BranchingPoint{before, modes};
    if (!next) return {};
    modes = modes_at(*next);
    if (modes.empty()) return {};
    const double there = mean(modes);
    slope = (there - value) / step;
    value = there;
    // Secants on either side: the arc goes on from the nearer point, backwards too.
    before = *next;
  }
  return {};
}

std::optional<PathPoint> switched(const Path& path, const PathPoint& at, const Eigenmode& mode,
                                  double amplitude) {
  PathPoint from = at;
  const int nodes = path.system->layout().mesh.nodes;
  Direction along;
  along.d = mode.u;
  along.beta = mode.b;
  along.Lambda = along.H = Field::Zero(nodes);
  from.tangent = scaled(along, 1 / std::sqrt(product(along, along)));
  auto x = predicted(path, from, amplitude);
  if (!x || !model::converges(*x, Path::limits, [&](auto& s) {
        return step_across(path, s, from.tangent, Path::limits.far);
      }))
    return {};
  Direction forward = scaled(from.tangent, amplitude < 0 ? -1 : 1);
  return with_tangent(path, *x, &forward);
}

}  // namespace sbeh::surface3d
