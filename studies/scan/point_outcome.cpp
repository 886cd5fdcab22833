#include "studies/scan/point_outcome.h"

#include "axisym/diagram/closing.h"
#include "axisym/domains.h"
#include "axisym/shape_class.h"
#include "axisym/stationary/fold_kind.h"
#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/stability.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace sbeh::studies {

using axisym::Branch;
using axisym::BranchState;
using axisym::PlanePoint;
using axisym::StationaryCase;
using axisym::StationaryState;
using model::Model;

StationaryCase moved_to(const PlanePoint& at, StationaryCase of) {
  of.reduced_volume = at.reduced_volume;
  of.material = of.material.with_L1(at.L);
  return of;
}

PointOutcome failed_point(std::string reason) {
  return {{.status = PointStatus::failed, .stop_reason = std::move(reason)}, {}};
}

namespace {

// Why a state is not of the branch that is asked for; empty where it is. The shape of states with domains may go from one class to
// another, their interfaces stay.
std::string why_another_branch(const StationaryCase& of, const PointResult& row) {
  if (of.interfaces == 0)
    return row.shape == name(of.branch)
             ? ""
             : fmt::format("the state found is of class {}: the branch was left", row.shape);
  if (row.interfaces == of.interfaces) return "";
  if (row.interfaces == 0)
    return "the domains have vanished: the order of the state found is uniform";
  return fmt::format("the state found has {} interface{} and not {}: the branch was left",
                     *row.interfaces, row.interfaces == 1 ? "" : "s", of.interfaces);
}

}  // namespace

PointOutcome outcome_of(const StationaryCase& of, const StationaryState& state,
                        const axisym::Diagnostics& diagnostics) {
  PointOutcome point{
      {.status = PointStatus::stationary, .diagnostics = diagnostics, .stop_reason = "stationary"},
      state};
  PointResult& row = point.row;
  const double resolution = row.diagnostics->resolution;
  row.shape = sbeh::name(axisym::classify(state.X));
  row.interfaces = int(axisym::interfaces(state).size());
  row.self_contact = axisym::crosses_itself(state.X);
  const auto is = [&](PointStatus status, std::string reason) {
    row.status = status;
    row.stop_reason = std::move(reason);
  };
  if (resolution > axisym::largest_resolution)
    is(PointStatus::unresolved,
       fmt::format("the profile's curvature times its node spacing is {:.2f}, more than {}: use "
                   "more elements",
                   resolution, axisym::largest_resolution));
  else if (row.self_contact)
    is(PointStatus::unresolved, "the surface passes through itself: contact is not in the model");
  else if (const std::string reason = why_another_branch(of, row); !reason.empty())
    is(PointStatus::failed, reason);
  return point;
}

namespace {

bool is_along_L(const axisym::Line& line) { return line.from.L != line.to.L; }

// As a clause; empty where the order is not what gives way.
std::string what_gives_way(const StationaryCase& of, const BranchState& fold) {
  const auto kind = of.model == Model::SBEH && of.interfaces == 0
                      ? axisym::fold_kind(of.material, fold.at.L, fold)
                      : std::nullopt;
  if (!kind) return "";
  return *kind == axisym::FoldKind::whole
           ? ", where the order of the whole surface is lost"
           : fmt::format(", where the order is lost at the {}", name(*kind));
}

// What the branch's end in a fold means for the point.
void describe_fold(const StationaryCase& of, const axisym::ResolvedState& fold, bool along_L,
                   PointResult& row) {
  const PlanePoint& at = fold.state.at;
  row.status = PointStatus::unresolved;
  row.fold_side = "at";
  (along_L ? row.fold_L : row.fold_reduced_volume) = along_L ? at.L : at.reduced_volume;
  (along_L ? row.fold_L_error : row.fold_reduced_volume_error) = fold.place_error;
  row.stop_reason = fmt::format(
      "the smooth {} branch ends in a fold at V_r = {:.6g}{}{}; the values are those at the fold{}",
      name(of.branch), at.reduced_volume,
      of.model == Model::SBEH ? fmt::format(", L = {:.6g}", at.L) : "",
      what_gives_way(of, fold.state),
      row.self_contact ? ", where the surface passes through itself" : "");
}

}  // namespace

std::optional<axisym::TouchingSpheres> limit_of(Branch branch, double reduced_volume, int spheres) {
  if (branch == Branch::stomatocyte) return axisym::sphere_in_sphere(reduced_volume);
  if (branch == Branch::pear) return axisym::sphere_beside_sphere(reduced_volume);
  const double equal = 1 / std::sqrt(spheres);
  if (std::abs(reduced_volume - equal) > 0.01) return {};
  return axisym::chain_of_spheres(spheres);
}

PointOutcome resolved_point(const StationaryCase& of, const BranchState& state) {
  const axisym::ResolvedState found = axisym::resolved(of.material, of.model, state, of.numerics);
  PointOutcome point = outcome_of(of, found.state, found.diagnostics);
  PointResult& row = point.row;
  const auto lagrangian = axisym::lagrangian_at(of.material, of.model, found.state);
  row.residual = axisym::residual_of(lagrangian, of.model, found.state.X);
  row.negative_directions = axisym::negative_directions(lagrangian, of.material, of.model);
  row.fold_side = "before";
  row.error = found.error;
  if (!found.is_resolved && row.status == PointStatus::stationary) {
    row.status = PointStatus::unresolved;
    row.stop_reason = fmt::format(
        "with {} elements the estimated errors are still {:.1e} of the energy and {:.1e} of W2, "
        "more than is promised",
        axisym::element_count(found.state.X), found.error.energy, found.error.W2);
  }
  return point;
}

namespace {

// How many parts necks that are about to close leave.
int parts_of(const axisym::Nodes& X) {
  constexpr double closing = 0.5;
  return 1 + int(std::ranges::count_if(axisym::necks(X), [](const auto& neck) {
           return neck.depth > closing;
         }));
}

std::string shapes_of(const axisym::TouchingSpheres& spheres) {
  const auto& radii = spheres.radii;
  if (radii.front() == radii.back())
    return fmt::format("a chain of {} spheres of radius {:.6g}", radii.size(), radii[0]);
  if (radii.size() == 2)
    return fmt::format("two spheres one {} the other, of radii {:.6g} and {:.6g}",
                       spheres.nested ? "within" : "beside", radii.front(), radii.back());
  return fmt::format("{} spheres {}, of radii {:.6g} and {:.6g}", radii.size(),
                     spheres.nested ? "within each other" : "in a chain", radii.front(),
                     radii.back());
}

std::optional<axisym::TouchingSpheres> spheres_beyond(const StationaryCase& of,
                                                      const BranchState& last) {
  const model::AreaDifference& ad = of.material.area_difference;
  const double v = is_symmetric(of.branch) ? last.at.reduced_volume : of.reduced_volume;
  if (!ad.is_there())
    if (auto spheres = limit_of(of.branch, v, parts_of(last.X))) return spheres;
  const model::Material there = of.material.with_L1(last.at.L);
  return axisym::closing_shape(there, axisym::diagnose(there, last));
}

}  // namespace

void put_limit(const StationaryCase& of, const axisym::TouchingSpheres& spheres, PointResult& row) {
  row.diagnostics = axisym::diagnose(of.material, spheres);
  row.error = axisym::Accuracy{.energy = 0, .W2 = 0, .H_pole = not_known};
}

PointOutcome limit_point(const StationaryCase& of, const BranchState& last) {
  PointOutcome point{{.status = PointStatus::limit}, {}};
  point.row.stop_reason =
      fmt::format("a neck closes: its radius is {:.2g}", axisym::thinnest_neck(last.X));
  const auto spheres = of.model == Model::SSH ? spheres_beyond(of, last) : std::nullopt;
  if (!spheres) return point;
  put_limit(of, *spheres, point.row);
  point.row.stop_reason += fmt::format(
      "; the branch tends to {}, with V_r = {:.6g}, whose neck closes at H0 = {:.6g}; the values "
      "are theirs",
      shapes_of(*spheres), point.row.diagnostics->reduced_volume, axisym::closing_H0(*spheres));
  return point;
}

namespace {

PointOutcome fold_point(const StationaryCase& of, const axisym::FollowResult& result) {
  const axisym::ResolvedState fold = axisym::resolved_fold(result, of.numerics);
  const StationaryCase there = moved_to(fold.state.at, of);
  PointOutcome point = outcome_of(there, fold.state, fold.diagnostics);
  PointResult& row = point.row;
  row.residual = axisym::residual_of(there.material, of.model, fold.state);
  row.error = fold.error;
  // At the fold itself one eigenvalue is zero, and rounding would say whether it counts.
  row.negative_directions =
      axisym::negative_directions(of.material.with_L1(result.before.at.L), of.model, result.before);
  if (row.status != PointStatus::failed) describe_fold(of, fold, is_along_L(result.line), row);
  return point;
}

// Of a branch that ends before the point.
PointOutcome none_here(std::string reason) {
  PointOutcome point = failed_point(std::move(reason));
  point.row.status = PointStatus::unresolved;
  return point;
}

}  // namespace

PointOutcome outcome_of(const StationaryCase& of, const axisym::FollowResult& result,
                        double share) {
  const PlanePoint at = result.state.at;
  const double H0 = result.line.material_at(result.mu).spontaneous_curvature,
               coupling = result.line.coupling(result.mu) * result.line.scale(result.mu) * share;
  const double W2 = result.line.material_at(result.mu).area_difference.W2;
  const bool is_on_the_way = H0 != of.material.spontaneous_curvature
                          || W2 != of.material.area_difference.W2 || coupling != 1;
  if (result.arrival == axisym::Arrival::reached) return resolved_point(of, result.state);
  if (result.arrival == axisym::Arrival::neck) return limit_point(of, result.state);
  std::vector<std::string> where;
  if (H0 != 0 || of.material.spontaneous_curvature != 0)
    where.push_back(fmt::format("H0 = {:.6g}", H0));
  if (of.material.area_difference.is_there())
    where.push_back(fmt::format("area_difference's W2 = {:.6g}", W2));
  if (of.material.has_given() && coupling != 1)
    where.push_back(fmt::format("{:.4g} of what does not go along with L", coupling));
  const std::string shape = name(axisym::classify(result.state.X));
  where.push_back(fmt::format("V_r = {:.6g}", at.reduced_volume));
  where.push_back(fmt::format("L = {:.6g}", at.L));
  const std::string place = fmt::format("{}", fmt::join(where, ", "));
  if (result.arrival == axisym::Arrival::lost && of.interfaces == 0 && shape != name(of.branch))
    return none_here(fmt::format("the states to which the {} branch leads are of class {} at {}",
                                 name(of.branch), shape, place));
  if (result.arrival == axisym::Arrival::lost)
    return failed_point(fmt::format("Newton's method lost the branch near {}", place));
  if (!is_on_the_way) return fold_point(of, result);
  return none_here(fmt::format("the smooth {} branch ends in a fold at {}, before this material",
                               name(of.branch), place));
}

}  // namespace sbeh::studies
