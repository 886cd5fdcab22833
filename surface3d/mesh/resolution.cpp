#include "surface3d/mesh/resolution.h"

#include "surface3d/diagnostics.h"
#include "surface3d/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace sbeh::surface3d {

namespace {

double longest_side(const ElementNodes& X) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) longest = std::max(longest, (X.col((k + 1) % 3) - X.col(k)).norm());
  return longest;
}

double smallest_angle_of(const ElementNodes& X) {
  double smallest = std::numbers::pi;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d u = X.col((k + 1) % 3) - X.col(k), v = X.col((k + 2) % 3) - X.col(k);
    smallest = std::min(smallest, std::atan2(u.cross(v).norm(), u.dot(v)));
  }
  return smallest * 180 / std::numbers::pi;
}

double largest_shape_operator(const ElementNodes& X, const ElementNodes& normals,
                              const ElementField& H) {
  double largest = 0;
  for (int a = 0; a < 10; ++a) {
    const SurfacePoint p = surface_point(X, node_points()[std::size_t(a)]);
    largest = std::max(largest, shape_operator(p, normals, H[a]).norm());
  }
  return largest;
}

struct OfTriangle {
  double resolution, mean_curvature, angle;
};

double curvature_gap(const Triangulation& mesh, const Nodes& X, const Curvature& curvature) {
  const auto squares = integrate<2>(mesh, X, assembly_points(), [&](int e) {
    return [H_nodes = on_element(mesh, e, curvature.H),
            normals = on_element(mesh, e, curvature.normals)](const ShapeValues& s,
                                                              const SurfacePoint& p) {
      const double H = value_at(H_nodes, s);
      const double gap = H + p.frame.leftCols<2>().cwiseProduct(gradient_at(normals, p)).sum();
      return Eigen::Array2d(gap * gap, H * H);
    };
  });
  return std::sqrt(squares[0] / squares[1]);
}

}  // namespace

Indicators indicators_of(const Triangulation& mesh, const Nodes& X, const Curvature& curvature) {
  Indicators r{.mean_curvature = 0,
               .resolution = 0,
               .curvature_gap = curvature_gap(mesh, X, curvature),
               .mesh_quality = mesh_quality(mesh, X),
               .min_angle = std::numeric_limits<double>::infinity()};
  std::vector<OfTriangle> triangles(std::size_t(mesh.count()));
  in_parallel(mesh.count(), [&](int e) {
    const ElementNodes local = on_element(mesh, e, X);
    const ElementField H = on_element(mesh, e, curvature.H);
    const double h = longest_side(local) / 3;
    triangles[std::size_t(e)] = {
        .resolution = h * largest_shape_operator(local, on_element(mesh, e, curvature.normals), H),
        .mean_curvature = h * H.cwiseAbs().maxCoeff(),
        .angle = smallest_angle_of(local)};
  });
  for (const auto& [resolution, mean_curvature, angle] : triangles) {
    r.resolution = std::max(r.resolution, resolution);
    r.mean_curvature = std::max(r.mean_curvature, mean_curvature);
    r.min_angle = std::min(r.min_angle, angle);
  }
  return r;
}

bool resolved(const Indicators& r) {
  return r.resolution <= largest_resolution && r.curvature_gap <= largest_curvature_gap
      && r.mesh_quality >= smallest_quality && r.min_angle >= smallest_angle;
}

}  // namespace sbeh::surface3d
