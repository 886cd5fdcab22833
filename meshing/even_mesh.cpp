#include "meshing/even_mesh.h"

#include "meshing/icosphere.h"
#include "meshing/remeshing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace sbeh::meshing {

namespace {
int divisions(int triangles) { return std::max(1, int(std::lround(std::sqrt(triangles / 20.)))); }
}  // namespace

void Resolution::validate() const {
  constexpr int most = 200'000;
  if (triangles < 20 || triangles > most)
    throw std::invalid_argument(
        fmt::format("triangles = {}: must be in 20 ... {}", triangles, most));
  if (order < 1 || order > 3)
    throw std::invalid_argument(fmt::format("order = {}: must be 1, 2 or 3", order));
  if (!(grading >= 0 && grading <= 10))
    throw std::invalid_argument(fmt::format("grading = {}: must be in 0 ... 10", grading));
}

int triangle_count(int wanted) {
  const int n = divisions(wanted);
  return 20 * n * n;
}

TriangleMesh even_mesh(const Resolution& resolution, const Projection& from_sphere,
                       const Projection& onto_surface) {
  constexpr int coarsest = 4;  // divisions that a shape needs for its triangles to settle
  constexpr double good_angle = 40;
  int n = divisions(resolution.triangles), halvings = 0;
  for (; n % 2 == 0 && n / 2 >= coarsest; n /= 2) ++halvings;
  TriangleMesh mesh = icosphere(n);
  project(mesh, from_sphere);
  mesh = refined(std::move(mesh), halvings, onto_surface, resolution.grading);
  if (resolution.grading > 0 || min_angle(mesh) >= good_angle) return mesh;
  TriangleMesh other = remeshed(mesh, mesh.triangle_count(), onto_surface, resolution.grading);
  return min_angle(other) > min_angle(mesh) ? other : mesh;
}

}  // namespace sbeh::meshing
