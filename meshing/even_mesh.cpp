#include "meshing/even_mesh.h"

#include "meshing/curving.h"
#include "meshing/icosphere.h"
#include "meshing/mesh_symmetry.h"
#include "meshing/quality.h"
#include "meshing/remeshing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace sbeh::meshing {

void Resolution::validate() const {
  if (triangles < fewest_triangles || triangles > most_triangles)
    throw std::invalid_argument(fmt::format("triangles = {}: must be in {} ... {}", triangles,
                                            fewest_triangles, most_triangles));
  if (order < 1 || order > 3)
    throw std::invalid_argument(fmt::format("order = {}: must be 1, 2 or 3", order));
  if (!(grading >= 0 && grading <= 10))
    throw std::invalid_argument(fmt::format("grading = {}: must be in 0 ... 10", grading));
}

namespace {

// Smooths; then so many times divides each triangle into four, projects and smooths again.
TriangleMesh refined(TriangleMesh mesh, int times, const Projection& onto_surface,
                     const Smoothing& aim) {
  constexpr int sweeps = 40;
  project(mesh, onto_surface);
  // Long waves settle as the square of their length.
  smooth(mesh, onto_surface, aim, sweeps + mesh.triangle_count() / 40);
  for (int level = 0; level < times; ++level) {
    mesh = subdivided(mesh);
    project(mesh, onto_surface);
    smooth(mesh, onto_surface, aim, sweeps);
  }
  return mesh;
}

struct Candidate {
  CurvedMesh mesh;
  double min_jacobian = 0;
  double score = 0;  // 1: good enough
};

Candidate candidate(const TriangleMesh& plain, const Resolution& resolution,
                    const Projection& onto_surface) {
  constexpr double good_angle = 40, good_jacobian = 0.4;
  Candidate c{.mesh = curved(plain, resolution.order, onto_surface)};
  symmetrise(c.mesh, resolution.symmetry, onto_surface);
  c.min_jacobian = min_jacobian(c.mesh);
  c.score = std::min(min_angle(plain) / good_angle, c.min_jacobian / good_jacobian);
  return c;
}

// That the shape is symmetric itself.
void require_symmetric(const TriangleMesh& sphere, const Projection& from_sphere,
                       const PointGroup& group) {
  constexpr double tolerance = 1e-6;  // in units of the largest radius
  double farthest = 0, off = 0;
  for (const auto d : sphere.points.colwise()) {
    const Eigen::Vector3d x = from_sphere(d);
    farthest = std::max(farthest, x.norm());
    for (const Operation& operation : group.operations())
      off = std::max(off, (from_sphere(operation * d) - operation * x).norm());
  }
  if (!(off <= tolerance * farthest))
    throw std::invalid_argument(
        fmt::format("symmetry = \"{}\": the shape has not this symmetry, turned or mirrored it is "
                    "off by {:.2g} of its radius",
                    group.symbol(), off / farthest));
}

// New triangles, where they come out better.
void remesh(Candidate& best, const Resolution& resolution, const Projection& onto_surface) {
  try {
    const TriangleMesh plain =
        remeshed(corners(best.mesh), best.mesh.triangle_count(), onto_surface, 0);
    Candidate other = candidate(plain, resolution, onto_surface);
    if (other.score > best.score) best = std::move(other);
  } catch (const std::invalid_argument&) {  // none so large go round it
  }
}

}  // namespace

std::optional<CurvedMesh> even_mesh_if_any(const Resolution& resolution,
                                           const Projection& from_sphere,
                                           const Projection& onto_surface) {
  constexpr int coarsest = 4;  // divisions that a shape needs for its triangles to settle
  const TriangleMesh body = body_with(resolution.symmetry);
  int n = std::max(
          1, int(std::lround(std::sqrt(double(resolution.triangles) / body.triangle_count())))),
      halvings = 0;
  for (; n % 2 == 0 && n / 2 >= coarsest; n /= 2) ++halvings;
  TriangleMesh start = on_sphere(body, n);
  require_symmetric(start, from_sphere, resolution.symmetry);
  project(start, from_sphere);

  Candidate best;
  for (const double evenness : {0.5, 1.}) {
    const Smoothing aim{
        .grading = resolution.grading, .evenness = evenness, .symmetry = resolution.symmetry};
    const TriangleMesh plain = refined(start, halvings, onto_surface, aim);
    Candidate other = candidate(plain, resolution, onto_surface);
    if (best.mesh.triangle_count() == 0 || other.score > best.score) best = std::move(other);
    if (best.score >= 1) return best.mesh;
  }
  if (resolution.grading == 0 && resolution.symmetry.is_trivial())
    remesh(best, resolution, onto_surface);
  if (!(best.min_jacobian > 0)) return {};
  return best.mesh;
}

CurvedMesh even_mesh(const Resolution& resolution, const Projection& from_sphere,
                     const Projection& onto_surface) {
  auto mesh = even_mesh_if_any(resolution, from_sphere, onto_surface);
  if (!mesh) refuse_as_too_sharp(resolution);
  return std::move(*mesh);
}

void refuse_as_too_sharp(const Resolution& resolution) {
  throw std::invalid_argument(
      fmt::format("the shape bends too sharply for {} triangles, some fold over when they are "
                  "curved: take more",
                  resolution.triangles));
}

}  // namespace sbeh::meshing
