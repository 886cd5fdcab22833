#include "axisym/stationary/classical_branches.h"

#include "axisym/curvature.h"
#include "axisym/diagnostics.h"
#include "axisym/shape_class.h"
#include "axisym/stationary/accuracy.h"
#include "axisym/stationary/stability.h"
#include "model/numerics/root.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace sbeh::axisym {

using std::numbers::pi;

model::Material classical_material() {
  model::Material m;
  m.potential = model::Potential({0});
  return m.with_L(0.5);
}

double reduced_energy(const BranchState& b) {
  const Energy u = energy(classical_material(), b, b.H);
  return (u.bending + 4 * pi) / (8 * pi);
}

ClassicalShape shape_of(Branch branch, const BranchState& b) {
  ClassicalShape shape{
      .branch = branch,
      .reduced_volume = b.at.reduced_volume,
      .energy = reduced_energy(b),
      .H_pole = 0,
      .pressure = b.pressure,
      .tension = b.tension,
      .self_contact = crosses_itself(b.X),
      .profile = b.X,
      .negative_directions = negative_directions(classical_material(), model::Model::SSH, b)};
  const auto [north, south] = pole_curvatures(b.X, b.H);
  shape.H_pole = std::max(north, south);
  if (south > north) {
    shape.profile = shape.profile.rowwise().reverse().eval();
    shape.profile.row(1) *= -1;
  }
  return shape;
}

namespace {

BranchState moved(const BranchState& from, double reduced_volume, const Numerics& numerics) {
  const model::Material m = classical_material();
  const FollowResult r = follow(m, model::Model::SSH, from, {reduced_volume, m.L1}, numerics);
  if (r.arrival != Arrival::reached)
    throw std::domain_error(
        fmt::format("classical branch: not reached at reduced volume {}, it {}", reduced_volume,
                    r.arrival == Arrival::fold ? "ends in a fold" : "was lost"));
  return r.state;
}

// On exactly as many elements as are asked for, placed afresh, so that half as many tell the error.
BranchState moved_on_elements(const BranchState& from, double reduced_volume,
                              const Numerics& numerics) {
  const BranchState there = moved(from, reduced_volume, numerics);
  const auto placed = on_elements(classical_material(), model::Model::SSH, there, numerics.elements,
                                  numerics.grading);
  if (!placed)
    throw std::domain_error(
        fmt::format("classical branch: {} elements do not resolve it at reduced volume {}",
                    numerics.elements, reduced_volume));
  return *placed;
}

// Two reduced volumes and energies of branches at equal V_r, moved by Newton to equal energy; the
// slope of the energy is P/6.
SpecialPoint equal_energy(BranchState a, BranchState b, double start, const Numerics& numerics) {
  double v = start;
  for (int iteration = 0; iteration < 8; ++iteration) {
    a = moved_on_elements(a, v, numerics);
    b = moved_on_elements(b, v, numerics);
    const double gap = reduced_energy(a) - reduced_energy(b);
    const double step = gap / ((a.pressure - b.pressure) / 6);
    if (std::abs(step) < 1e-12) break;
    v -= step;
  }
  return {v, reduced_energy(a), 0};
}

SpecialPoint self_contact(BranchState oblate, const Numerics& numerics) {
  const auto thickness = [&](double v) {
    oblate = moved_on_elements(oblate, v, numerics);
    const Nodes& X = oblate.X;
    return X(1, 0) - X(1, X.cols() - 1);
  };
  const double v = model::root_near(0.52, 0.505, thickness, 1e-11);
  return {v, reduced_energy(oblate), 0};
}

SpecialPoint point_of(const BranchState& b) { return {b.at.reduced_volume, reduced_energy(b), 0}; }

template <class Compute>
const auto& once(auto& slot, Compute&& compute) {
  if (!slot) slot = compute();
  return *slot;
}

}  // namespace

const BranchState& ElementBranches::entry(Branch branch) {
  return once(entries_[std::size_t(branch)], [&] {
    if (branch == Branch::stomatocyte) return stomatocytes().state;
    const auto found = enter_branch(branch, classical_material(), numerics_);
    if (!found)
      throw std::domain_error(
          fmt::format("classical {}s: Newton's method failed at the entry", name(branch)));
    return found->state;
  });
}

const BranchState& ElementBranches::flat_oblate() {
  return once(flat_, [&] { return moved_on_elements(entry(Branch::oblate), 0.59, numerics_); });
}

const BranchEntry& ElementBranches::stomatocytes() {
  return once(stomatocytes_, [&] {
    auto found = enter_stomatocytes(flat_oblate(), classical_material(), numerics_);
    if (!found) throw std::domain_error("classical stomatocytes: the branch was lost");
    return *found;
  });
}

SpecialPoints ElementBranches::special_points() {
  const BranchState oblate = moved(flat_oblate(), 0.65, numerics_);
  const BranchState prolate = moved(entry(Branch::prolate), 0.65, numerics_);
  return {
      .prolate_oblate = equal_energy(oblate, prolate, 0.651, numerics_),
      .oblate_stomatocyte = equal_energy(flat_oblate(), stomatocytes().state, 0.591, numerics_),
      .stomatocyte_fold = point_of(*stomatocytes().fold),
      .oblate_symmetry_loss = point_of(*stomatocytes().pitchfork),
      .oblate_self_contact = self_contact(flat_oblate(), numerics_),
  };
}

std::vector<BranchState> ElementBranches::states(Branch branch,
                                                 std::span<const double> reduced_volumes) {
  // Downwards from the entry, then upwards from it; stomatocytes downwards from the fold.
  std::vector<std::size_t> order(reduced_volumes.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
            [&](auto i, auto j) { return reduced_volumes[i] > reduced_volumes[j]; });
  const BranchState& start = entry(branch);
  const auto first_below = std::stable_partition(order.begin(), order.end(), [&](std::size_t i) {
    return reduced_volumes[i] > start.at.reduced_volume;
  });
  std::reverse(order.begin(), first_below);

  std::vector<BranchState> states(reduced_volumes.size());
  const auto walk = [&](auto begin, auto end) {
    BranchState here = start;
    for (auto i = begin; i != end; ++i) {
      here = moved(here, reduced_volumes[*i], numerics_);
      states[*i] = here;
    }
  };
  walk(order.begin(), first_below);
  walk(first_below, order.end());
  return states;
}

std::vector<ClassicalShape> ElementBranches::shapes(Branch branch,
                                                    std::span<const double> reduced_volumes) {
  std::vector<ClassicalShape> shapes;
  for (const BranchState& state : states(branch, reduced_volumes))
    shapes.push_back(shape_of(branch, state));
  return shapes;
}

SpecialPoints ElementBranches::special_points_with_errors() {
  SpecialPoints points = special_points();
  Numerics coarse = numerics_;
  coarse.elements /= 2;
  const SpecialPoints rough = ElementBranches(coarse).special_points();
  for (const auto member : {&SpecialPoints::prolate_oblate, &SpecialPoints::oblate_stomatocyte,
                            &SpecialPoints::stomatocyte_fold, &SpecialPoints::oblate_symmetry_loss,
                            &SpecialPoints::oblate_self_contact})
    (points.*member).error =
        std::abs((points.*member).reduced_volume - (rough.*member).reduced_volume);
  return points;
}

}  // namespace sbeh::axisym
