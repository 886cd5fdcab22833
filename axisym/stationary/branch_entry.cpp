#include "axisym/stationary/branch_entry.h"

#include "axisym/redistribute.h"
#include "axisym/start_shapes.h"
#include "axisym/stationary/bifurcation.h"

#include <algorithm>

namespace sbeh::axisym {

using model::Model;

std::optional<BranchEntry> enter_branch(Branch branch, const model::Material& material,
                                        const Numerics& numerics) {
  const State start{
      spheroid(entry_volume, branch == Branch::prolate, numerics.elements, numerics.grading),
      Field::Constant(3 * numerics.elements + 1, model::full_order)};
  const NewtonResult r =
      solve_stationary(material, Model::SSH, target_of(entry_volume), guess_from(material, start));
  if (r.status != NewtonStatus::converged) return {};
  const BranchState state{{entry_volume, material.L1}, r.solution, r.determinant_sign};
  if (branch != Branch::stomatocyte) return BranchEntry{state, {}, {}};
  const FollowResult flat = follow(material, Model::SSH, state, {0.59, material.L1}, numerics);
  if (flat.arrival != Arrival::reached) return {};
  return enter_stomatocytes(flat.state, material, numerics);
}

namespace {

BranchState state_of(const Line& line, const PathState& p) {
  return {line.at(p.mu), p.s, p.determinant_sign};
}

// The state on a mesh of so many elements, on the same side of the fold, tangent towards it.
std::optional<PathState> lifted(const Line& line, const PathState& coarse,
                                const Numerics& numerics) {
  const NewtonResult r =
      solve_stationary(line.material(coarse.mu), line.model(), line.target(coarse.mu),
                       redistribute(coarse.s, numerics.grading, numerics.elements));
  if (r.status != NewtonStatus::converged) return {};
  auto fine = with_tangent(line, {coarse.mu, r.solution});
  if (fine && fine->slope() * coarse.slope() < 0) fine->tangent = scaled(fine->tangent, -1);
  return fine;
}

// The last state before the fold on the way up from a pitchfork: μ falls while V_r rises.
std::optional<PathState> climb(const Line& line, PathState here, double grading, double& ds) {
  bool left = false;  // the oblates, where the path is tangent to nothing
  while (const auto next = advance(line, here, ds, 1e-5)) {
    if (left && next->slope() >= 0) return here;
    left = left || next->slope() < -0.3;
    here = with_fresh_nodes(line, *next, grading);
    ds = std::min(1.5 * ds, 0.5);
    if (line.at(here.mu).reduced_volume > 0.95) return {};
  }
  return {};
}

}  // namespace

std::optional<BranchEntry> enter_stomatocytes(const BranchState& oblate,
                                              const model::Material& material,
                                              const Numerics& numerics) {
  const PlanePoint end{0.45, material.L1};
  const Line line(material, Model::SSH, oblate.at, end);
  const auto pitchfork = find_pitchfork(material, Model::SSH, oblate, end, numerics);
  if (!pitchfork) return {};
  BranchEntry entry{{}, state_of(line, pitchfork->state), {}};

  // The way up needs no fine mesh; the fold does.
  Numerics coarse = numerics;
  coarse.elements = std::min(numerics.elements, 32);
  BranchState start = oblate;
  start.solution = redistribute(oblate.solution, numerics.grading, coarse.elements);
  const auto rough = find_pitchfork(material, Model::SSH, start, end, coarse);
  double ds = 0.1;
  const auto near = rough ? climb(line, rough->state, coarse.grading, ds) : std::nullopt;
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
    entry.state = state_of(line, with_fresh_nodes(line, beyond, numerics.grading));
    return entry;
  }
  return {};
}

}  // namespace sbeh::axisym
