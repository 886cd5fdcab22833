#include "surface3d/diagnostics.h"

#include "model/energy_density.h"
#include "surface3d/domains.h"
#include "surface3d/gaussian_energy.h"
#include "surface3d/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sbeh::surface3d {

namespace {

// `gauss_curvature` of shape functions, point, normals and H of the triangle.
Energy integrated(const Triangulation& mesh, const model::Material& material, const State& state,
                  const Curvature& curvature, auto gauss_curvature) {
  const auto sum = integrate<5>(mesh, state.X, diagnostic_points(), [&](int e) {
    return [&material, gauss_curvature, H_nodes = on_element(mesh, e, curvature.H),
            normals = on_element(mesh, e, curvature.normals),
            beta = on_element(mesh, e, state.beta)](const ShapeValues& s, const SurfacePoint& p) {
      const double H = value_at(H_nodes, s);
      const auto density =
          model::energy_density(material, value_at(beta, s), gradient_at(beta, p).squaredNorm(), H,
                                gauss_curvature(p, normals, H));
      return Eigen::Array<double, 5, 1>{density.distortion, density.bending + density.gaussian,
                                        density.thermotropic, 1, H};
    };
  });
  return {.distortion = sum[0],
          .bending = sum[1],
          .thermotropic = sum[2],
          .area_difference = material.area_difference.energy(sum[3], sum[4])};
}

}  // namespace

Energy energy(const Triangulation& mesh, const model::Material& material, const State& state,
              const Curvature& curvature) {
  Energy energy = integrated(mesh, material, state, curvature,
                             [](const SurfacePoint&, const ElementNodes&, double) { return 0.; });
  energy.bending += gaussian_energy(material, mesh, state);
  return energy;
}

Energy energy_by_shape_operator(const Triangulation& mesh, const model::Material& material,
                                const State& state, const Curvature& curvature) {
  return integrated(mesh, material, state, curvature,
                    [](const SurfacePoint& p, const ElementNodes& normals, double H) {
                      return model::gauss_curvature(shape_operator(p, normals, H));
                    });
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
