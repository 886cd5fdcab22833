#include "surface3d/diagnostics.h"

#include "model/energy_density.h"
#include "surface3d/domains.h"
#include "surface3d/gaussian_energy.h"
#include "surface3d/parallel.h"
#include "surface3d/point_tables.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sbeh::surface3d {

namespace {

using Tables = PointTables<56>;
using Row = Tables::Row;
using Points = TrianglePoints<56>;

// H²/4 less the square of what is traceless in −sym(∇_C n): det B, see shape_operator.
Row gauss_curvature(const Points& p, const ElementNodes& normals, const Row& H) {
  const Tables& tables = diagnostic_tables();
  const Tables::Vectors n_1 = tables.slopes(normals, 0), n_2 = tables.slopes(normals, 1);
  const Row slope_11 = dot(p.a[0], n_1), slope_22 = dot(p.a[1], n_2),
            slope_12 = (dot(p.a[0], n_2) + dot(p.a[1], n_1)) / 2;
  const Row trace = p.trace(slope_11, slope_12, slope_22);
  return H * H / 4 - trace * trace / 4 + p.determinant(slope_11, slope_12, slope_22);
}

// `gauss_curvature` of points, normals and H of the triangle.
Energy integrated(const Triangulation& mesh, const model::Material& material, const State& state,
                  const Curvature& curvature, auto gauss_curvature) {
  const auto sum = sum_over_triangles<5>(mesh, [&](int e) {
    const Tables& tables = diagnostic_tables();
    const Points p(tables, on_element(mesh, e, state.X));
    const ElementField beta_nodes = on_element(mesh, e, state.beta);
    const Row H = tables.values(on_element(mesh, e, curvature.H)), beta = tables.values(beta_nodes),
              beta_1 = tables.slopes(beta_nodes, 0), beta_2 = tables.slopes(beta_nodes, 1),
              slope = p.trace(beta_1 * beta_1, beta_1 * beta_2, beta_2 * beta_2),
              K = gauss_curvature(p, on_element(mesh, e, curvature.normals), H);
    Eigen::Array<double, 5, 1> part = decltype(part)::Zero();
    for (std::size_t q = 0; q < diagnostic_points().size(); ++q) {
      const auto i = Eigen::Index(q);
      const auto density = model::energy_density(material, beta[i], slope[i], H[i], K[i]);
      part += p.dS[i]
            * Eigen::Array<double, 5, 1>{density.distortion, density.bending + density.gaussian,
                                         density.thermotropic, 1, H[i]};
    }
    return part;
  });
  return {.distortion = sum[0],
          .bending = sum[1],
          .thermotropic = sum[2],
          .area_difference = material.area_difference.energy(sum[3], sum[4])};
}

}  // namespace

Energy energy(const Triangulation& mesh, const model::Material& material, const State& state,
              const Curvature& curvature) {
  Energy energy =
      integrated(mesh, material, state, curvature,
                 [](const Points&, const ElementNodes&, const Row&) -> Row { return Row::Zero(); });
  energy.bending += gaussian_energy(material, mesh, state);
  return energy;
}

Energy energy_by_shape_operator(const Triangulation& mesh, const model::Material& material,
                                const State& state, const Curvature& curvature) {
  return integrated(mesh, material, state, curvature, gauss_curvature);
}

double mesh_quality(const Triangulation& mesh, const Nodes& X) {
  double worst = 1;
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X);
    const Eigen::Vector3d a = local.col(1) - local.col(0), b = local.col(2) - local.col(0),
                          c = local.col(2) - local.col(1), normal = a.cross(b);
    const double sides = a.squaredNorm() + b.squaredNorm() + c.squaredNorm();
    double least = std::numeric_limits<double>::infinity(), largest = 0;
    for (const ShapeValues& s : node_points()) {
      const Eigen::Vector3d n =
          (local * Shapes(s.dphi[0].data())).cross(local * Shapes(s.dphi[1].data()));
      const double along = n.dot(normal) > 0 ? n.norm() : -n.norm();
      least = std::min(least, along);
      largest = std::max(largest, n.norm());
    }
    worst = std::min(worst, least / largest * 2 * std::sqrt(3.) * normal.norm() / sides);
  }
  return worst;
}

Diagnostics diagnose(const Triangulation& mesh, const model::Material& material,
                     const State& state) {
  const auto curvature = curvature_of(mesh, state.X);
  if (!curvature) throw std::runtime_error("diagnose: the surface is degenerate");
  Diagnostics d{};
  d.energy = energy(mesh, material, state, *curvature);
  d.area = area(mesh, state.X);
  d.volume = volume(mesh, state.X);
  d.reduced_volume = reduced_volume(d.area, d.volume);
  d.mesh_quality = mesh_quality(mesh, state.X);
  d.asymmetry = std::numeric_limits<double>::quiet_NaN();
  d.H_abs_max = curvature->H.cwiseAbs().maxCoeff();
  d.order_min = state.beta.minCoeff();
  d.order_max = state.beta.maxCoeff();
  double order_integral = 0;
  for_each_point(mesh, state.X, diagnostic_points(),
                 [&](int e, const ShapeValues& s, const SurfacePoint& p) {
                   const double H = value_at(on_element(mesh, e, curvature->H), s);
                   const auto B = shape_operator(p, on_element(mesh, e, curvature->normals), H);
                   d.W2 += p.dS * H;
                   d.total_gauss_curvature += p.dS * model::gauss_curvature(B);
                   order_integral += p.dS * value_at(on_element(mesh, e, state.beta), s);
                   const double side =
                       std::sqrt(2 * p.dS / s.weight);  // of the square with twice the triangle
                   d.resolution = std::max(d.resolution, B.norm() * side / 3);
                 });
  d.order_mean = order_integral / d.area;
  for_each_point(
      mesh, state.X, diagnostic_points(), [&](int e, const ShapeValues& s, const SurfacePoint& p) {
        const double excess = value_at(on_element(mesh, e, state.beta), s) - d.order_mean;
        d.order_variance += p.dS * excess * excess / d.area;
      });
  d.order_std = std::sqrt(d.order_variance);
  d.domains = domains_of(mesh, state);
  return d;
}

}  // namespace sbeh::surface3d
