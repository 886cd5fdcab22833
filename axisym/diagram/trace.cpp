#include "axisym/diagram/trace.h"

#include "axisym/redistribute.h"
#include "axisym/shape_class.h"
#include "axisym/stationary/accuracy.h"
#include "axisym/stationary/soft_mode.h"
#include "axisym/stationary/stability.h"
#include "axisym/stationary/symmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sbeh::axisym {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double shortest = 1e-6;

// The lowest eigenvalue of every m and parity, but the even one of m = 0, and the count of negative ones.
struct Survey {
  struct Lowest {
    int m;
    Parity parity;
    double eigenvalue;
  };
  std::vector<Lowest> lowest;
  int negative_directions;
  std::optional<int> negative_directions_3d;
};

Survey survey(const Line& line, const LineState& state, int largest_m) {
  const model::Material material = line.material_at(state.mu);
  const SecondVariation second = second_variation(material, line.model, state);
  const int within = negative_directions(material, line.model, state);
  Survey seen{.lowest = {}, .negative_directions = within, .negative_directions_3d = within};
  // Oblates fall by m = 2 and 3 first: with fewer m than these it is not known what a state is among all shapes. What comes
  // after an m without negative ones grows like m⁴.
  constexpr int telling_m = 4, last_m = 64;
  double rigid_residual = 0, nearest_to_zero = infinite;
  bool falls = false;  // by the last m
  const bool tells = largest_m >= telling_m;
  for (int m = 0; m <= largest_m || (tells && falls && m <= last_m); ++m) {
    falls = false;
    for (const Parity parity : second.sector.parities()) {
      if (m == 0 && parity != Parity::odd) continue;  // its zeros are the determinant's
      const auto found = lowest_and_negative_modes(second, m, parity, 1);
      if (!found || found->modes.empty()) {
        seen.negative_directions_3d.reset();
        continue;
      }
      rigid_residual = std::max(rigid_residual, found->rigid_residual);
      if (m <= largest_m) seen.lowest.push_back({m, parity, found->modes.front().eigenvalue});
      for (const Eigenmode& mode : found->modes) {
        nearest_to_zero = std::min(nearest_to_zero, std::abs(mode.eigenvalue));
        falls = falls || mode.eigenvalue < 0;
        if (m > 0 && mode.eigenvalue < 0 && seen.negative_directions_3d)
          *seen.negative_directions_3d += 2;
      }
    }
  }
  if (!tells || falls || nearest_to_zero <= rigid_residual) seen.negative_directions_3d.reset();
  return seen;
}

// ∫ z dV about the middle of the height: 0 of a symmetric shape, and changes its sign upside down.
double lopsidedness(const StationaryState& state) {
  const double middle = (state.X(1, 0) + state.X(1, state.X.cols() - 1)) / 2;
  double sum = 0;
  for_each_point(state.X, assembly_points(), [&](int, const ShapeValues&, const CurvePoint& p) {
    // ½(z − middle)² ν_z dS
    sum += p.dS * p.nu[1] * (p.x[1] - middle) * (p.x[1] - middle) / 2;
  });
  return sum;
}

Special special_of(const Survey::Lowest& lowest) {
  return lowest.m > 0 ? Special::mode : Special::symmetry_loss;
}

class Tracer {
 public:
  Tracer(const Line& line, const PathState& from, const Numerics& numerics,
         const TraceOptions& options)
      : line_(line), numerics_(numerics), options_(options), here_(from) {}

  Trace run() {
    if (here_.slope() != 0) {
      before_ = survey(line_, here_, options_.largest_m);
      add(here_, *before_);
    }
    double ds = std::min(0.05, options_.longest_step);
    const auto stops = [&] { return options_.stops && options_.stops(); };
    for (int step = 0; step < options_.most_steps && !stops(); ++step) {
      auto next = advance(line_, here_, ds, shortest);
      if (!next) return ended(TraceEnd::lost);
      if (next->mu < 0 || next->mu > 1 || is_forced(*next)) return ended(TraceEnd::bound);
      if (is_beyond_symmetric(*next)) return ended(TraceEnd::parent);
      if (here_.slope() * next->slope() < 0) {
        keep_fold(*next, ds);
        ++leg_;
        before_ = {};
      }
      const Survey now = survey(line_, *next, options_.largest_m);
      if (before_) keep_zeros(*before_, now, *next, ds);
      const double radius = thinnest_neck(next->X);
      const bool closes = radius < options_.narrowest && radius < thinnest_neck(here_.X);
      here_ = with_fresh_nodes(line_, *next, numerics_);
      before_ = now;
      add(here_, now);
      if (closes) return ended(TraceEnd::limit);
      ds = std::min(1.5 * ds, options_.longest_step);
    }
    return ended(TraceEnd::length);
  }

 private:
  Trace ended(TraceEnd end) {
    trace_.end = end;
    return std::move(trace_);
  }
  // Whether the next state leans to the other side than the last: between them the shape has been symmetric.
  bool is_beyond_symmetric(const PathState& next) const {
    return !line_.symmetric && !trace_.points.empty()
        && lopsidedness(here_) * lopsidedness(next) < 0;
  }
  bool is_forced(const PathState& state) const {
    return std::abs(state.moment)
         > options_.largest_moment * line_.material.kappa(model::full_order);
  }
  void add(const PathState& state, const Survey& seen) {
    trace_.points.push_back({state, leg_, seen.negative_directions, seen.negative_directions_3d,
                             crosses_itself(state.X)});
  }

  void keep_fold(const PathState& beyond, double ds) {
    const PathState fold = locate_fold(line_, here_, beyond, ds);
    const FollowResult found{
        Arrival::fold, {fold, line_.at(fold.mu), fold.determinant_sign}, line_, fold.mu};
    const ResolvedState resolved = resolved_fold(found, numerics_, options_.promised);
    PathState state = fold;
    static_cast<StationaryState&>(state) = resolved.state;
    state.mu = mu_of(resolved.state.at);
    trace_.specials.push_back({Special::fold, 0, std::move(state), resolved.place_error, leg_});
  }

  // What changes its sign between the last state and the next.
  void keep_zeros(const Survey& before, const Survey& now, const PathState& next, double ds) {
    for (const Survey::Lowest& a : before.lowest)
      for (const Survey::Lowest& b : now.lowest) {
        if (a.m != b.m || a.parity != b.parity || (a.eigenvalue < 0) == (b.eigenvalue < 0))
          continue;
        const Threshold found =
            threshold_within(line_, here_, ds, a.m, a.parity, numerics_, options_.promised);
        PathState state = next;
        static_cast<StationaryState&>(state) = found.state;
        state.mu = mu_of(found.state.at);
        trace_.specials.push_back({special_of(a), a.m, std::move(state), found.error, leg_});
      }
  }

  double mu_of(const PlanePoint& at) const {
    return (at.reduced_volume - line_.from.reduced_volume)
         / (line_.to.reduced_volume - line_.from.reduced_volume);
  }

  const Line& line_;
  const Numerics& numerics_;
  const TraceOptions& options_;
  PathState here_;
  std::optional<Survey>
      before_;  // of the last state; empty beyond a fold, across which nothing is compared
  int leg_ = 0;
  Trace trace_{};
};

}  // namespace

Trace trace(const Line& line, const PathState& from, const Numerics& numerics,
            const TraceOptions& options) {
  return Tracer(line, from, numerics, options).run();
}

Trace trace_both_ways(const Line& line, const PathState& from, const Numerics& numerics,
                      const TraceOptions& options) {
  PathState back = from;
  back.tangent = scaled(from.tangent, -1);
  const bool grows = from.slope() > 0;
  Trace joined = trace(line, grows ? back : from, numerics, options);
  Trace ahead = trace(line, grows ? from : back, numerics, options);
  std::ranges::reverse(joined.points);
  std::ranges::reverse(joined.specials);
  const int before = joined.points.empty() ? 0 : joined.points.front().leg;
  for (TracePoint& p : joined.points) {
    p.leg = before - p.leg;
    p.state.tangent = scaled(p.state.tangent, -1);
  }
  // A fold belongs to the leg that ends with it, which is another one from the other side.
  for (SpecialState& s : joined.specials)
    s.leg = before - s.leg - (s.kind == Special::fold ? 1 : 0);
  for (std::size_t k = 1; k < ahead.points.size(); ++k) {  // the first is there
    joined.points.push_back(std::move(ahead.points[k]));
    joined.points.back().leg += before;
  }
  for (SpecialState& s : ahead.specials) {
    joined.specials.push_back(std::move(s));
    joined.specials.back().leg += before;
  }
  joined.begin = joined.end;
  joined.end = ahead.end;
  return joined;
}

std::optional<PathState> leaving(const Line& line, const SpecialState& loss,
                                 const Numerics& numerics) {
  const model::Material material = line.material_at(loss.state.mu);
  const auto there =
      solve_at(material, line.model, line.at(loss.state.mu),
               symmetric_part(redistribute(loss.state, numerics.grading, numerics.elements)),
               {.symmetric = true});
  if (!there) return {};
  const auto mode = antisymmetric_mode(material, line.model, *there);
  if (!mode) return {};
  return along_mode({*there, loss.state.mu}, *mode);
}

}  // namespace sbeh::axisym
