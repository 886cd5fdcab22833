#include "studies/rest_states/coarser_triangles.h"

namespace sbeh::studies {

namespace {

meshing::ClosestPoint points_of(const surface3d::Triangulation& mesh, const surface3d::Nodes& X) {
  return meshing::ClosestPoint({.order = 3, .triangles = mesh.triangles, .nodes = X});
}

}  // namespace

const RestStart& CoarserTriangles::at(const std::shared_ptr<const surface3d::Triangulation>& mesh,
                                      const surface3d::State& state,
                                      const model::Material& material, model::Model model) {
  if (mesh != fine_) {
    fine_ = mesh;
    make(state, material, model);
  } else if (start_.mesh) {
    carry(state);
  }
  return start_;
}

void CoarserTriangles::make(const surface3d::State& state, const model::Material& material,
                            model::Model model) {
  places_.clear();
  start_ = remeshed_start(*fine_, state, material, fine_->count() / 4);
  if (!start_.mesh) return;
  start_.system = std::make_shared<surface3d::NewtonSystem>(*start_.mesh, material, model);
  const meshing::ClosestPoint closest = points_of(*fine_, state.X);
  for (const auto x : start_.state.X.colwise()) places_.push_back(closest(x));
}

void CoarserTriangles::carry(const surface3d::State& state) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto& [triangle, at] = places_[i];
    const surface3d::ShapeValues s = surface3d::shape_values(at, 0);
    const auto node = Eigen::Index(i);
    start_.state.X.col(node) =
        surface3d::value_at(surface3d::on_element(*fine_, triangle, state.X), s);
    start_.state.beta[node] =
        surface3d::value_at(surface3d::on_element(*fine_, triangle, state.beta), s);
  }
}

}  // namespace sbeh::studies
