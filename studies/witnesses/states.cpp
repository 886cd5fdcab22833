// The axisymmetric state, revolved, by Newton's method in 3D.
#include "meshing/revolution.h"
#include "studies/witnesses/surface_nodes.h"
#include "surface3d/diagnostics.h"
#include "surface3d/stationary/stationary.h"

#include <fmt/format.h>

#include <numbers>

namespace sbeh::studies {

namespace {

std::string directions(int falls) {
  if (falls == 0) return "a minimum";
  return fmt::format("a saddle, whose energy falls in {} direction{}", falls,
                     falls == 1 ? "" : "s");
}

}  // namespace

WitnessState rest_state(const axisym::StationaryCase& of, int triangles,
                        const axisym::State* profile) {
  using namespace surface3d;
  WitnessState found{.witness = Witness::states};
  const auto newton = profile ? std::nullopt : newton_state(of).profile;
  if (!profile && !newton) {
    found.failure = "newton has no state to revolve";
    return found;
  }
  const meshing::RevolvedMesh revolved =
      meshing::revolved(profile ? *profile : *newton, {.triangles = triangles});
  const Triangulation mesh(revolved.mesh);
  NewtonSystem system(mesh, of.material, of.model);
  const double area = 4 * std::numbers::pi;
  const NewtonResult rest = solve_stationary(
      system, {area, of.reduced_volume * area / 3},
      guess_from(mesh, of.material, of.model, {revolved.mesh.nodes, revolved.beta}));
  if (rest.status != NewtonStatus::converged) {
    found.failure = "Newton's method does not converge from the revolved state";
    return found;
  }
  found.remark = fmt::format("{} triangles, {} steps, {}", mesh.count(), rest.changes.size(),
                             directions(rest.negative_directions));
  found.measures = measures_of(energy(of.material, mesh, rest.state),
                               diagnose(mesh, of.material, rest.state), rest.state.pressure);
  found.measures.tension = rest.state.tension;
  place_nodes(mesh, rest.state, rest.state.H, found);
  found.mesh = revolved.mesh;
  found.mesh->nodes = rest.state.X;
  return found;
}

}  // namespace sbeh::studies
