#include "axisym/stationary/branch_entry.h"

#include "axisym/redistribute.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/soft_mode.h"
#include "axisym/stationary/symmetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbeh::axisym {

using model::Model;

std::optional<BranchEntry> enter_branch(Branch branch, const model::Material& material,
                                        const Numerics& numerics) {
  const State start{
      spheroid(entry_volume, branch == Branch::prolate, numerics.elements, numerics.grading),
      Field::Constant(3 * numerics.elements + 1, model::full_order)};
  auto state = solve_at(material, Model::SSH, {entry_volume, material.L1},
                        guess_from(material, Model::SSH, start), {.symmetric = true});
  if (!state) return {};
  static_cast<StationaryState&>(*state) = symmetric_part(*state);
  if (branch != Branch::stomatocyte) return BranchEntry{*state, {}, {}};
  const FollowResult flat = follow(material, Model::SSH, *state, {0.59, material.L1}, numerics);
  if (flat.arrival != Arrival::reached) return {};
  return enter_stomatocytes(flat.state, material, numerics);
}

namespace {

// --- Pitchfork: the classical stomatocytes leave the oblates ------------------------------------------

// A symmetric state on the line with its softest antisymmetric mode.
struct Sample : LineState {
  SoftMode mode;
};

// Plain Newton steps keep the symmetry; the arclength's tangent would see the other branch.
std::optional<Sample> sample(const Line& line, double mu, const StationaryState& near,
                             const Numerics& numerics) {
  const auto solved =
      solve_at(line.material_at(mu), line.model, line.at(mu), redistribute(near, numerics.grading));
  if (!solved) return {};
  const auto mode = antisymmetric_mode(line.material_at(mu), line.model, *solved);
  if (!mode) return {};
  return Sample{{*solved, mu}, *mode};
}

// Follows the symmetric branch of `from` along the line until the antisymmetric mode's eigenvalue
// changes sign, and locates its zero to about 1e-10 in μ; the state is the one last solved for, within
// 1e-6 of it, its tangent that of the crossing branch. Empty when it does not on 0 <= μ <= 1.
std::optional<PathState> find_pitchfork(const Line& line, const StationaryState& from,
                                        const Numerics& numerics) {
  auto a = sample(line, 0, from, numerics);
  constexpr int steps = 16;
  for (int k = 1; k <= steps && a; ++k) {
    auto b = sample(line, double(k) / steps, *a, numerics);
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
      const auto next = sample(line, zero(), *b, numerics);
      if (!next) break;
      a = b;
      b = next;
    }
    return along_mode({*b, zero()}, b->mode);
  }
  return {};
}

// --- The way up from it -------------------------------------------------------------------------------

BranchState state_of(const Line& line, const PathState& p) {
  return {p, line.at(p.mu), p.determinant_sign};
}

// The state on a mesh of so many elements, on the same side of the fold, tangent towards it.
std::optional<PathState> lifted(const Line& line, const PathState& coarse,
                                const Numerics& numerics) {
  const auto solved = solve_at(line.material_at(coarse.mu), line.model, line.at(coarse.mu),
                               redistribute(coarse, numerics.grading, numerics.elements));
  if (!solved) return {};
  auto fine = with_tangent(line, {*solved, coarse.mu});
  if (fine && fine->slope() * coarse.slope() < 0) fine->tangent = scaled(fine->tangent, -1);
  return fine;
}

// The last state before the fold on the way up from a pitchfork: μ falls while V_r rises.
std::optional<PathState> climb(const Line& line, PathState here, const Numerics& numerics,
                               double& ds) {
  bool left = false;  // the oblates, where the path is tangent to nothing
  while (const auto next = advance(line, here, ds, 1e-5)) {
    if (left && next->slope() >= 0) return here;
    left = left || next->slope() < -0.3;
    here = with_fresh_nodes(line, *next, numerics);
    ds = std::min(1.5 * ds, 0.5);
    if (line.at(here.mu).reduced_volume > 0.95) return {};
  }
  return {};
}

}  // namespace

std::optional<BranchEntry> enter_stomatocytes(const BranchState& oblate,
                                              const model::Material& material,
                                              const Numerics& numerics) {
  const Line line{material, Model::SSH, oblate.at, {0.45, material.L1}};
  const auto pitchfork = find_pitchfork(line, oblate, numerics);
  if (!pitchfork) return {};
  BranchEntry entry{{}, state_of(line, *pitchfork), {}};

  // The way up needs no fine mesh; the fold does.
  Numerics coarse = numerics;
  coarse.elements = std::min(numerics.elements, 32);
  const auto rough =
      find_pitchfork(line, redistribute(oblate, numerics.grading, coarse.elements), coarse);
  double ds = 0.1;
  const auto near = rough ? climb(line, *rough, coarse, ds) : std::nullopt;
  auto here = near ? lifted(line, *near, numerics) : std::nullopt;
  for (int step = 0; here && step < 60; ++step) {
    const auto next = advance(line, *here, ds, 1e-6);
    if (!next || next->slope() < 0) {
      here = next;
      continue;
    }
    entry.fold = state_of(line, locate_fold(line, *here, *next, ds));
    PathState beyond = *next;
    for (int k = 0; k < 20 && beyond.slope() < 0.5; ++k)
      if (const auto further = arc_step(line, beyond, ds)) beyond = *further;
    entry.state = state_of(line, with_fresh_nodes(line, beyond, numerics));
    if (entry.state.H[0] < 0)  // the pole of the dimple first
      static_cast<StationaryState&>(entry.state) = upside_down(entry.state);
    return entry;
  }
  return {};
}

}  // namespace sbeh::axisym
