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
  t.moment *= factor;
  t.chemical_potential *= factor;
  t.mu *= factor;
  return t;
}

Direction unit(const Direction& t) { return scaled(t, 1 / std::sqrt(product(t, t))); }

// a + factor b
Direction sum(Direction a, double factor, const Direction& b) {
  a.d += factor * b.d;
  a.Lambda += factor * b.Lambda;
  a.H += factor * b.H;
  a.beta += factor * b.beta;
  a.tension += factor * b.tension;
  a.pressure += factor * b.pressure;
  a.moment += factor * b.moment;
  a.chemical_potential += factor * b.chemical_potential;
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
  const LagrangianDerivatives& here = system.derivatives();
  const Eigen::VectorXd change =
      (here.miss(after, high, x.moment) - here.miss(before, low, x.moment)) / (2 * h);
  Direction b;
  if (!system.respond(-rate, change, b)) return {};
  b.mu = 1;
  return b;
}

bool linearise(const Path& path, const PathSolution& x, const Eigen::VectorXd& amplitude = {}) {
  path.system->set_material(path.material(x.mu));
  return path.system->linearise(x, x.normals, {amplitude, x.phase});
}

// On the unknowns: what a perturbation is orthogonal to in ∫ (u u' + b b') dS.
Eigen::VectorXd load_of(const Path& path, const PathSolution& x, const Eigenmode& mode) {
  const StationaryLayout& layout = path.system->layout();
  Eigen::VectorXd unknowns = Eigen::VectorXd::Zero(layout.size());
  unknowns(layout.all(node_d)) = mode.u;
  if (layout.free_order) unknowns(layout.all(node_beta)) = mode.b;
  return perturbation_mass(layout, x, x.normals) * unknowns;
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

namespace {

// A direction with displacements in space, 3 x nodes, in the place of those along normals.
struct Way : Direction {
  Nodes X;
};
Way way_of(const Direction& t, const Nodes& normals) {
  Way way{t, normals * t.d.asDiagonal()};
  way.d = Field::Zero(t.d.size());
  return way;
}
double product(const Way& a, const Way& b) {
  return product(static_cast<const Direction&>(a), static_cast<const Direction&>(b))
       + a.X.cwiseProduct(b.X).sum() / double(a.X.cols());
}
// Of another point, along the tangent of this one.
double length_to(const PathPoint& from, const PathPoint& other) {
  const Nodes along = from.normals * from.tangent.d.asDiagonal(), way = other.X - from.X;
  return (along.cwiseProduct(way).sum() + from.tangent.beta.dot(other.beta - from.beta))
           / double(way.cols())
       + from.tangent.mu * (other.mu - from.mu);
}
void add(PathSolution& x, double factor, const Way& way) {
  move(x, way, factor);
  x.X += factor * way.X;
}

// The bend of the branch by the tangents of two points, as a function of the length s along the tangent t of the second:
// s²/2 (t₀/(t₀·t) − t)/s₀, s₀ and t₀ length and tangent at the first. (The cubic through both points is of one order more, and unstable:
// nothing corrects where nodes lie along the surface.)
void add_bend(PathSolution& x, const PathPoint& from, double ds) {
  constexpr double longest = 2.5;  // of the way back
  const PathPoint& before = *from.before;
  const Way tangent = way_of(from.tangent, from.normals),
            tangent_before = way_of(before.tangent, before.normals);
  const double cosine = product(tangent_before, tangent), length = length_to(from, before);
  if (cosine < model::least_cosine || std::abs(ds) > longest * std::abs(length)) return;
  const double share = ds * ds / (2 * length);
  add(x, share / cosine, tangent_before);
  add(x, -share, tangent);
}

}  // namespace

std::optional<PathSolution> predicted(const Path& path, const PathPoint& from, double ds) {
  PathSolution guess = from;
  move(guess, from.tangent, ds);
  if (from.before) add_bend(guess, from, ds);
  guess.normals = node_normals(path.system->layout().mesh, guess.X);
  return guess;
}

namespace {

// Newton's step on the hyperplane across the tangent, and more of them with its matrix as long as each is a small share of the one
// before, but for the last; empty where the first changes more than `most`.
std::optional<double> step_across(const Path& path, PathSolution& x, const Direction& tangent,
                                  double most) {
  Direction a;
  if (!linearise(path, x) || !path.system->newton_step(path.target(x.mu), a)) return {};
  const auto b = along_mu(path, x);
  if (!b) return {};
  const auto across = [&](const Direction& free) {
    return sum(free, -product(tangent, free) / product(tangent, *b), *b);
  };
  Direction step = across(a);
  double change = largest(step);
  if (!(change < most)) return {};
  move(x, step, 1);
  constexpr double share = 0.1, settled = 1e-9;
  while (change > settled) {
    path.system->set_material(path.material(x.mu));
    if (!path.system->newton_step_from(x, x.normals, path.target(x.mu), a)) break;
    step = across(a);
    if (!(largest(step) < share * change)) break;
    change = largest(step);
    move(x, step, 1);
  }
  return change;
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
  return PathPoint{x, scaled(unit(*b), sign), path.system->negative_directions()};
}

// Here the number of negative directions tells no jump: where a mode breaks a symmetry it changes without a turn of μ. Who follows a
// path halves its steps until a fold or a branching point accounts for every change.
bool continues(const Path& /*path*/, const PathPoint& from, const PathPoint& next, double /*ds*/) {
  return product(from.tangent, next.tangent) > model::least_cosine;
}

std::optional<PathPoint> settled(const Path& path, const StationaryState& guess, double mu,
                                 const Eigen::VectorXd& phase) {
  path.system->set_material(path.material(mu));
  const NewtonResult found =
      solve_stationary(*path.system, path.target(mu), guess, {.phase = phase});
  if (found.status != NewtonStatus::converged) return {};
  return with_tangent(path, {found.state, mu, found.normals, phase});
}

std::optional<PathPoint> on_other_triangles(const Path& path, const State& surface,
                                            const PathPoint& from, double near) {
  const StationaryLayout& layout = path.system->layout();
  const model::Model model = layout.free_order ? model::Model::SBEH : model::Model::SSH;
  auto there =
      settled(path, guess_from(layout.mesh, path.material(from.mu), model, surface), from.mu);
  if (!there || (there->X - surface.X).colwise().norm().maxCoeff() > near) return {};
  if (from.phase.size() > 0 && path.system->rigid_count() < 6) return {};
  // Rates along the branch that do not depend on the triangles.
  const auto rates = [](const Direction& t) {
    return Eigen::Vector3d(t.mu, t.tension, t.pressure);
  };
  if (rates(there->tangent).dot(rates(from.tangent)) < 0)
    there->tangent = scaled(there->tangent, -1);
  return there;
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

namespace {

// Newton's step at the amplitude that a load prescribes: μ so that no force is needed for it.
std::optional<double> step_at_amplitude(const Path& path, PathSolution& x,
                                        const Eigen::VectorXd& amplitude) {
  Direction a;
  if (!linearise(path, x, amplitude) || !path.system->newton_step(path.target(x.mu), a)) return {};
  const auto b = along_mu(path, x);
  if (!b) return {};
  const Direction step = sum(a, -a.hold / b->hold, *b);
  if (!(largest(step) < Path::limits.far)) return {};
  move(x, step, 1);
  return largest(step);
}

Direction direction_of(const Eigenmode& mode) {
  Direction along;
  along.d = mode.u;
  along.beta = mode.b;
  along.Lambda = along.H = Field::Zero(mode.u.size());
  return unit(along);
}

// What is left of x beyond a step from a branching point along its branch and an amplitude of the first mode.
double off(const BranchingPoint& branching, double amplitude, const PathSolution& x) {
  const PathPoint& from = branching.at;
  // Where a matrix is nearly singular a tangent has any amount of what it nearly maps to 0.
  Direction tangent = from.tangent;
  for (const Eigenmode& mode : branching.modes) {
    const Direction along = direction_of(mode);
    tangent = sum(tangent, -product(tangent, along), along);
  }
  tangent = unit(tangent);
  Direction way;
  way.d = (x.X - from.X).cwiseProduct(from.normals).colwise().sum().transpose();
  way.beta = x.beta - from.beta;
  way.Lambda = way.H = Field::Zero(way.d.size());
  way.mu = x.mu - from.mu;
  way = sum(way, -amplitude, direction_of(branching.modes.front()));
  way = sum(way, -product(way, tangent), tangent);
  return std::sqrt(product(way, way));
}

}  // namespace

std::optional<PathPoint> switched(const Path& path, const BranchingPoint& from, double amplitude) {
  // Of the amplitude. What is beyond it is of second order near the branching point; where two branch next to each other, other
  // states have as much of the first mode, and more of the second.
  constexpr double most = 1;
  PathPoint start = from.at;
  start.tangent = direction_of(from.modes.front());
  auto x = predicted(path, start, amplitude);
  if (!x) return {};
  const Eigen::VectorXd load = load_of(path, from.at, from.modes.front());
  if (from.modes.size() > 1) x->phase = load_of(path, from.at, from.modes.back());
  if (!model::converges(*x, Path::limits, [&](auto& s) { return step_at_amplitude(path, s, load); })
      || off(from, amplitude, *x) > most * std::abs(amplitude))
    return {};
  const Direction forward = scaled(start.tangent, amplitude < 0 ? -1 : 1);
  return with_tangent(path, *x, &forward);
}

}  // namespace sbeh::surface3d
