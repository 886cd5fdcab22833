#include "surface3d/domains.h"

#include "meshing/quality.h"

#include <array>
#include <numeric>
#include <vector>

namespace sbeh::surface3d {

namespace {

// Sets of nodes that grow together.
class JoinedNodes {
 public:
  explicit JoinedNodes(int nodes) : above_(std::size_t(nodes)) {
    std::iota(above_.begin(), above_.end(), 0);
  }
  int first(int node) {
    while (above_[std::size_t(node)] != node) {
      above_[std::size_t(node)] = above_[std::size_t(above_[std::size_t(node)])];
      node = above_[std::size_t(node)];
    }
    return node;
  }
  void join(int a, int b) { above_[std::size_t(first(a))] = first(b); }

 private:
  std::vector<int> above_;
};

// Of a plain triangle, the corner that is alone on its side of 0 first.
void add_cut(const std::array<Eigen::Vector3d, 3>& x, const std::array<double, 3>& height,
             model::Domains& domains) {
  const double area = (x[1] - x[0]).cross(x[2] - x[0]).norm() / 2;
  const int above = int(height[0] > 0) + int(height[1] > 0) + int(height[2] > 0);
  if (above == 0) return;
  if (above == 3) {
    domains.area += area;
    return;
  }
  std::size_t alone = 0;
  while ((height[alone] > 0) != (above == 1)) ++alone;
  const std::size_t next = (alone + 1) % 3, last = (alone + 2) % 3;
  const double to_next = height[alone] / (height[alone] - height[next]),
               to_last = height[alone] / (height[alone] - height[last]);
  const double cut = area * to_next * to_last;
  domains.area += above == 1 ? cut : area - cut;
  domains.boundary += (to_next * (x[next] - x[alone]) - to_last * (x[last] - x[alone])).norm();
}

}  // namespace

model::Domains domains_of(const Triangulation& mesh, const State& state) {
  model::Domains domains;
  const double low = state.beta.minCoeff(), high = state.beta.maxCoeff();
  if (high - low < model::Domains::least_contrast) return domains;
  const Field height = state.beta.array() - (low + high) / 2;
  static const std::vector<Eigen::Vector3i> small = meshing::small_triangles(3);
  JoinedNodes joined(mesh.nodes);
  for (int e = 0; e < mesh.count(); ++e)
    for (const Eigen::Vector3i& corners : small) {
      std::array<Eigen::Vector3d, 3> x;
      std::array<double, 3> at;
      std::array<int, 3> node;
      for (std::size_t k = 0; k < 3; ++k) {
        node[k] = mesh.triangles(corners[Eigen::Index(k)], e);
        x[k] = state.X.col(node[k]);
        at[k] = height[node[k]];
      }
      add_cut(x, at, domains);
      for (std::size_t k = 0; k < 3; ++k)
        if (at[k] > 0 && at[(k + 1) % 3] > 0) joined.join(node[k], node[(k + 1) % 3]);
    }
  for (int i = 0; i < mesh.nodes; ++i)
    if (height[i] > 0 && joined.first(i) == i) ++domains.count;
  return domains;
}

}  // namespace sbeh::surface3d
