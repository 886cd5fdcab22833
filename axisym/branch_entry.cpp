#include "axisym/branch_entry.h"

#include "axisym/bifurcation.h"
#include "axisym/start_shapes.h"

#include <algorithm>

namespace sbeh::axisym {

using model::Model;

std::optional<BranchEntry> enter_branch(Branch branch, const model::Material& material,
                                        const Numerics& numerics) {
  const State start{
    spheroid(entry_volume, branch == Branch::prolate, numerics.elements, numerics.grading),
    Field::Constant(3 * numerics.elements + 1, model::full_order)};
  const NewtonResult r = solve_stationary(material, Model::SSH, target_of(entry_volume),
                                          guess_from(material, start));
  if (r.status != NewtonStatus::converged) return {};
  const BranchState state{{entry_volume, material.L1}, r.solution, r.determinant_sign};
  if (branch != Branch::stomatocyte) return BranchEntry{state, {}, {}};
  const FollowResult flat = follow(material, Model::SSH, state, {0.59, material.L1}, numerics);
  if (flat.arrival != Arrival::reached) return {};
  return enter_stomatocytes(flat.state, material, numerics);
}

std::optional<BranchEntry> enter_stomatocytes(const BranchState& oblate,
                                              const model::Material& material,
                                              const Numerics& numerics) {
  const PlanePoint end{0.45, material.L1};
  const auto pitchfork = find_pitchfork(material, Model::SSH, oblate, end, numerics);
  if (!pitchfork) return {};
  const Line line(material, Model::SSH, oblate.at, end);
  const auto state_of = [&](const PathState& p) {
    return BranchState{line.at(p.mu), p.s, p.determinant_sign};
  };
  // μ falls while V_r rises from the pitchfork; it turns at the fold.
  BranchEntry entry{{}, state_of(pitchfork->state), {}};
  PathState here = pitchfork->state;
  double ds = 0.1;
  for (int step = 0; step < 200 && ds > 1e-5; ++step) {
    const auto next = arc_step(line, here, ds);
    if (!next) {
      ds /= 2;
      continue;
    }
    if (step > 0 && here.tangent.parameter < 0 && next->tangent.parameter >= 0) {
      entry.fold = state_of(locate_fold(line, here, *next, ds));
      PathState beyond = *next;
      for (int k = 0; k < 20 && beyond.tangent.parameter < 0.5; ++k)
        if (const auto further = arc_step(line, beyond, ds)) beyond = *further;
      entry.state = state_of(with_fresh_nodes(line, beyond, numerics.grading));
      return entry;
    }
    here = with_fresh_nodes(line, *next, numerics.grading);
    ds = std::min(1.5 * ds, 0.5);
  }
  return {};
}

}  // namespace sbeh::axisym
