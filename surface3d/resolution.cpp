#include "surface3d/resolution.h"

#include "surface3d/diagnostics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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

double curvature_gap(const Triangulation& mesh, const Nodes& X, const Curvature& curvature) {
  double gap = 0, total = 0;
  for_each_point(mesh, X, assembly_points(),
                 [&](int e, const ShapeValues& s, const SurfacePoint& p) {
                   const double H = value_at(on_element(mesh, e, curvature.H), s);
                   const auto slope = gradient_at(on_element(mesh, e, curvature.normals), p);
                   const double H_n = -(p.frame.leftCols<2>().transpose() * slope).trace();
                   gap += p.dS * (H - H_n) * (H - H_n);
                   total += p.dS * H * H;
                 });
  return std::sqrt(gap / total);
}

}  // namespace

Resolution resolution_of(const Triangulation& mesh, const Nodes& X, const Curvature& curvature) {
  Resolution r{.mean_curvature = 0,
               .curvature = 0,
               .curvature_gap = curvature_gap(mesh, X, curvature),
               .mesh_quality = mesh_quality(mesh, X),
               .min_angle = std::numeric_limits<double>::infinity(),
               .sharpest = 0};
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X);
    const ElementField H = on_element(mesh, e, curvature.H);
    const double h = longest_side(local) / 3;
    const double turn =
        h * largest_shape_operator(local, on_element(mesh, e, curvature.normals), H);
    if (turn > r.curvature) r.sharpest = e;
    r.curvature = std::max(r.curvature, turn);
    r.mean_curvature = std::max(r.mean_curvature, h * H.cwiseAbs().maxCoeff());
    r.min_angle = std::min(r.min_angle, smallest_angle_of(local));
  }
  return r;
}

bool resolved(const Resolution& r) {
  return r.curvature <= largest_turn && r.curvature_gap <= largest_curvature_gap
      && r.mesh_quality >= smallest_quality && r.min_angle >= smallest_angle;
}

}  // namespace sbeh::surface3d
