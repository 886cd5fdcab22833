#include "surface3d/symmetry.h"

#include <cmath>
#include <numbers>

namespace sbeh::surface3d {

namespace {

meshing::CurvedMesh curved(const Triangulation& mesh, const State& state) {
  return {.order = 3, .triangles = mesh.triangles, .nodes = state.X};
}

}  // namespace

std::optional<meshing::MeshSymmetry> symmetry_of(const Triangulation& mesh, const State& state,
                                                 const meshing::PointGroup& group) {
  return meshing::symmetry_of(curved(mesh, state), group.operations());
}

meshing::MeshSymmetry required_symmetry(const Triangulation& mesh, const State& state,
                                        const meshing::PointGroup& group) {
  return meshing::required_symmetry(curved(mesh, state), group);
}

State symmetric_part(const meshing::MeshSymmetry& symmetry, const State& state) {
  return {symmetry.symmetric_part(state.X), symmetry.symmetric_part(state.beta)};
}

double asymmetry(const Triangulation& mesh, const State& state,
                 const meshing::MeshSymmetry& symmetry) {
  const Nodes off = state.X - symmetry.symmetric_part(state.X);
  const double R = std::sqrt(area(mesh, state.X) / (4 * std::numbers::pi));
  return off.cwiseProduct(node_normals(mesh, state.X)).colwise().sum().cwiseAbs().maxCoeff() / R;
}

}  // namespace sbeh::surface3d
