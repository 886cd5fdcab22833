#include "studies/rest_states/rest_start.h"

#include "meshing/resolution.h"
#include "studies/evolution/run_start.h"
#include "studies/scan/branch_points.h"
#include "surface3d/mesh/remesh.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sbeh::studies {

namespace {

RestStart failed(std::string why) { return {{}, {}, std::move(why), {}}; }

RestStart revolved(const StatesInput& input, const axisym::State& profile, int triangles) {
  meshing::RevolvedMesh made =
      meshing::revolved(profile, {.triangles = triangles, .symmetry = input.symmetry});
  try {
    if (!input.perturbation.empty()) perturb(made.mesh, input.perturbation);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("[states] perturbation: {}", error.what()));
  }
  auto mesh = std::make_shared<const surface3d::Triangulation>(made.mesh);
  return {std::move(mesh), {made.mesh.nodes, made.beta}, {}, {}};
}

RestStart from_branch(const StatesInput& input, const axisym::PlanePoint& at, int triangles) {
  const PointOutcome point = branch_point({.model = input.model,
                                           .branch = input.branch,
                                           .reduced_volume = at.reduced_volume,
                                           .material = input.material.with_L1(at.L),
                                           .numerics = input.numerics});
  if (point.row.status != PointStatus::stationary || !point.state)
    return failed("there is no axisymmetric state to start from: " + point.row.stop_reason);
  return revolved(input, *point.state, triangles);
}

// A row that the scan does not have, or of nothing at rest, is no start; the others are.
RestStart from_scan(const StatesInput& input, const axisym::PlanePoint& at, int triangles) {
  axisym::State profile;
  try {
    profile = state_of(row_of(input, at));
  } catch (const OutputError& error) {
    return failed(error.what());
  }
  return revolved(input, profile, triangles);
}

RestStart from_file(const StatesInput& input, const axisym::PlanePoint& at, int triangles) {
  RunInput run;
  run.model = input.model;
  run.material = input.material.with_L1(at.L);
  run.perturbation = input.perturbation;
  if (input.start == StatesStart::frame)
    run.start = FrameStart{input.file};
  else
    run.start = MeshFileStart{input.file};
  const FlowMoment moment = start_of(run).moment;
  if (triangles == 0) return {moment.mesh, moment.state, {}, {}};
  return remeshed_start(*moment.mesh, moment.state, run.material, triangles);
}

}  // namespace

RestStart remeshed_start(const surface3d::Triangulation& mesh, const surface3d::State& state,
                         const model::Material& material, int triangles) {
  if (triangles < meshing::fewest_triangles) return failed("there are too few triangles");
  auto made = surface3d::remesh(mesh, state, material,
                                {.triangles = triangles, .largest_energy_change = 1});
  return {made.mesh, made.state, made.refusal, {}};
}

RestStart coarser_start(const StatesInput& input, const axisym::PlanePoint& at, int triangles) {
  if (triangles < meshing::fewest_triangles) return failed("there are too few triangles");
  try {
    return rest_start(input, at, triangles);
  } catch (const std::invalid_argument& error) {
    return failed(error.what());
  }
}

RestStart rest_start(const StatesInput& input, const axisym::PlanePoint& at, int triangles) {
  if (brings_its_mesh(input.start)) return from_file(input, at, triangles);
  const int count = triangles == 0 ? input.triangles : triangles;
  return input.start == StatesStart::scan ? from_scan(input, at, count)
                                          : from_branch(input, at, count);
}

}  // namespace sbeh::studies
