// Fewer triangles for the states of a path, to tell by them how well it is resolved.
#pragma once

#include "meshing/closest_point.h"
#include "studies/rest_states/rest_start.h"

#include <memory>
#include <vector>

namespace sbeh::studies {

/// About a quarter of the triangles of a mesh, made on its surface once and carried along with it from then on: making them
/// anew takes longer than the state on them.
class CoarserTriangles {
 public:
  /// A start on them. They are made anew where the mesh is another one than before.
  const RestStart& at(const std::shared_ptr<const surface3d::Triangulation>& mesh,
                      const surface3d::State& state, const model::Material& material,
                      model::Model model);

 private:
  void make(const surface3d::State& state, const model::Material& material, model::Model model);
  void carry(const surface3d::State& state);

  std::shared_ptr<const surface3d::Triangulation> fine_;
  RestStart start_;
  std::vector<meshing::SurfacePlace> places_;  // of their nodes on the mesh
};

}  // namespace sbeh::studies
