#include "surface3d/symmetry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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

meshing::PointGroup kept_symmetry(const Triangulation& mesh, const State& state,
                                  const meshing::PointGroup& group) {
  constexpr double tolerance = 1e-6;
  const auto symmetry = symmetry_of(mesh, state, group);
  if (!symmetry) return {};
  std::vector<meshing::Operation> kept;
  for (Eigen::Index k = 0; k < symmetry->image.cols(); ++k) {
    const meshing::Operation& operation = symmetry->operations[std::size_t(k)];
    const auto image = symmetry->image.col(k);
    const Nodes off = operation * state.X - state.X(Eigen::all, image);
    const Field order = state.beta - state.beta(image);
    if (off.colwise().norm().maxCoeff() < tolerance && order.cwiseAbs().maxCoeff() < tolerance)
      kept.push_back(operation);
  }
  return group.part([&](const meshing::Operation& operation) {
    return std::ranges::find(kept, operation) != kept.end();
  });
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
