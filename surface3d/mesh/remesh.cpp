#include "surface3d/mesh/remesh.h"

#include "meshing/closest_point.h"
#include "meshing/curving.h"
#include "meshing/mesh_symmetry.h"
#include "meshing/quality.h"
#include "meshing/remeshing.h"
#include "meshing/resolution.h"
#include "meshing/triangle_search.h"
#include "surface3d/diagnostics.h"
#include "surface3d/lipids.h"
#include "surface3d/mesh/resolution.h"
#include "surface3d/order_step.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace sbeh::surface3d {

using Eigen::Vector3d;

void RemeshOptions::validate() const {
  using meshing::fewest_triangles, meshing::most_triangles;
  if (triangles != 0 && (triangles < fewest_triangles || triangles > most_triangles))
    throw std::invalid_argument(fmt::format("remesh: triangles = {}: must be 0 or in {} ... {}",
                                            triangles, fewest_triangles, most_triangles));
  if (!(grading >= 0 && grading <= 10))
    throw std::invalid_argument(fmt::format("remesh: grading = {}: must be in 0 ... 10", grading));
  if (!(largest_energy_change >= 0 && largest_energy_change <= 1))
    throw std::invalid_argument(fmt::format(
        "remesh: largest_energy_change = {}: must be in 0 ... 1", largest_energy_change));
}

namespace {

double radius(const Triangulation& mesh, const Nodes& X) {
  return std::sqrt(area(mesh, X) / (4 * std::numbers::pi));
}

// |B| at the nodes, the mean over the triangles there.
Field node_curvature(const Triangulation& mesh, const Nodes& X, const Curvature& curvature) {
  Field sum = Field::Zero(mesh.nodes), count = Field::Zero(mesh.nodes);
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X);
    const ElementNodes normals = on_element(mesh, e, curvature.normals);
    for (int a = 0; a < 10; ++a) {
      const SurfacePoint p = surface_point(local, node_points()[std::size_t(a)]);
      const int node = mesh.triangles(a, e);
      sum[node] += shape_operator(p, normals, curvature.H[node]).norm();
      ++count[node];
    }
  }
  return sum.cwiseQuotient(count);
}

// Neighbouring triangles may differ in size by little.
void limit_slope(const meshing::TriangleMesh& lattice, Field& size) {
  constexpr double steepest = 0.2, rounding = 1e-12;
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto c : lattice.triangles.colwise())
      for (int k = 0; k < 3; ++k) {
        const int a = c[k], b = c[(k + 1) % 3];
        const double way = (lattice.points.col(a) - lattice.points.col(b)).norm();
        const double limit = std::min(size[a], size[b]) + steepest * way;
        for (const int i : {a, b})
          if (size[i] > limit * (1 + rounding)) {
            size[i] = limit;
            changed = true;
          }
      }
  }
}

// How many equilateral triangles with these sides the surface has.
double count_of(const Triangulation& mesh, const Nodes& X, const Field& side) {
  double count = 0;
  for_each_point(mesh, X, assembly_points(),
                 [&](int e, const ShapeValues& s, const SurfacePoint& p) {
                   const double a = value_at(on_element(mesh, e, side), s);
                   count += p.dS * 4 / (std::sqrt(3.) * a * a);
                 });
  return count;
}

// The surface that gets new triangles, prepared for searching.
class OldSurface {
 public:
  OldSurface(const Triangulation& mesh, const State& state, const Curvature& curvature,
             const RemeshOptions& options)
      : mesh_(mesh),
        state_(state),
        curved_{.order = 3, .triangles = mesh.triangles, .nodes = state.X},
        grading_(options.grading),
        symmetry_(options.symmetry),
        lattice_(meshing::lattice(curved_)),
        closest_(std::make_shared<const meshing::ClosestPoint>(curved_)) {
    relative_size_ = (1
                      + options.grading * radius(mesh, state.X) / std::sqrt(2.)
                            * node_curvature(mesh, state.X, curvature).array())
                         .inverse();
  }

  meshing::Projection projection() const { return meshing::onto(closest_); }
  double min_angle() const { return meshing::min_angle(meshing::corners(curved_)); }
  /// About so many P3 triangles in its place.
  meshing::CurvedMesh triangles(int wanted) const;
  double order_at(const Vector3d& x) const {
    return std::clamp(closest_->value(state_.beta, (*closest_)(x)), state_.beta.minCoeff(),
                      state_.beta.maxCoeff());
  }
  double distance_to(const Vector3d& x) const { return (projection()(x) - x).norm(); }

 private:
  meshing::SizeField sizes_for(double triangles) const;
  meshing::CurvedMesh covered(double asked) const;

  const Triangulation& mesh_;
  const State& state_;
  meshing::CurvedMesh curved_;
  double grading_;
  meshing::PointGroup symmetry_;
  meshing::TriangleMesh lattice_;  // the small plain triangles between the nodes
  std::shared_ptr<const meshing::ClosestPoint> closest_;
  Field relative_size_;  // of triangles, at the nodes
};

// The sides with which so many triangles cover the surface.
meshing::SizeField OldSurface::sizes_for(double triangles) const {
  constexpr int iterations = 30;
  constexpr double accuracy = 1e-3;
  double scale = radius(mesh_, state_.X);
  Field size;
  for (int i = 0; i < iterations; ++i) {
    size = scale * relative_size_;
    limit_slope(lattice_, size);
    const double excess = count_of(mesh_, state_.X, size) / triangles;
    if (std::abs(excess - 1) < accuracy) break;
    scale *= std::sqrt(excess);
  }
  const double lowest = size.minCoeff(), highest = size.maxCoeff();  // a cubic may leave them
  return [closest = closest_, size, lowest, highest](const Vector3d& x) {
    return std::clamp(closest->value(size, (*closest)(x)), lowest, highest);
  };
}

meshing::CurvedMesh OldSurface::covered(double asked) const {
  const bool symmetric = !symmetry_.is_trivial();
  meshing::TriangleMesh plain =
      symmetric ? meshing::corners(curved_)
                : meshing::remeshed(lattice_, int(std::lround(asked)), projection(), 0);
  if (grading_ > 0 || symmetric)
    plain = meshing::graded(plain, sizes_for(asked), projection(), symmetry_);
  meshing::CurvedMesh fresh = meshing::curved(plain, 3, projection());
  symmetrise(fresh, symmetry_, projection());
  return fresh;
}

// How well a mesh meets what is wanted; from 1 on: good enough.
double score(const meshing::CurvedMesh& mesh, int wanted) {
  constexpr double good_angle = 32, good_jacobian = 0.4, accuracy = 0.03;
  const double miss = std::abs(double(mesh.triangle_count()) / wanted - 1);
  return std::min({1., meshing::min_angle(meshing::corners(mesh)) / good_angle,
                   meshing::min_jacobian(mesh) / good_jacobian})
       - std::max(0., miss / accuracy - 1);
}

// Where new triangles come to lie at a sharp place is chance: the best of a few tries.
meshing::CurvedMesh OldSurface::triangles(int wanted) const {
  constexpr int tries = 5;
  constexpr double usual_excess = 1.08, another = 1.015;
  meshing::CurvedMesh best;
  double asked = wanted / usual_excess, best_score = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < tries && best_score < 1; ++i) {
    meshing::CurvedMesh fresh = covered(asked);
    asked *= another * wanted / fresh.triangle_count();
    const double its_score = score(fresh, wanted);
    if (its_score > best_score) best = std::move(fresh);
    best_score = std::max(best_score, its_score);
  }
  return best;
}

void measure_before(const Triangulation& mesh, const State& state, const OldSurface& old,
                    const Energy& U, RemeshReport& report) {
  report.triangles_before = mesh.count();
  report.min_angle_before = old.min_angle();
  report.quality_before = mesh_quality(mesh, state.X);
  report.energy_before = U.total();
}

// Angles, quality and distance of the new mesh.
void measure_mesh(const meshing::CurvedMesh& fresh, const Triangulation& mesh, const Nodes& X,
                  const OldSurface& old, RemeshReport& report) {
  report.triangles_after = mesh.count();
  report.min_angle_after = meshing::min_angle(meshing::corners({3, fresh.triangles, X}));
  report.quality_after = mesh_quality(mesh, X);
  for_each_point(mesh, X, assembly_points(), [&](int, const ShapeValues&, const SurfacePoint& p) {
    report.distance = std::max(report.distance, old.distance_to(p.x));
  });
  report.distance /= radius(mesh, X);
}

// What its triangles are worse in than those before; empty where in nothing.
std::string worse_triangles(const RemeshReport& r) {
  constexpr double good_angle = 25, good_quality = 0.4;
  if (r.quality_after < std::min(good_quality, std::max(r.quality_before, degenerate_quality)))
    return fmt::format("the quality of the new mesh is {:.2g}, of the old one {:.2g}",
                       r.quality_after, r.quality_before);
  if (r.min_angle_after < std::min(good_angle, r.min_angle_before))
    return fmt::format("the new mesh has an angle of {:.1f} degrees, the old one of {:.1f}",
                       r.min_angle_after, r.min_angle_before);
  return {};
}

// That so many triangles are too few for the surface, of which bad ones come; empty where they are enough.
std::string too_sharp(const Triangulation& mesh, const Nodes& X) {
  const auto curvature = curvature_of(mesh, X);
  if (!curvature) return {};
  const double turn = indicators_of(mesh, X, *curvature).resolution;
  if (turn <= largest_resolution) return {};
  return fmt::format(
      "the surface is too sharp for {} triangles: |B| times the node spacing is {:.3g} > {} on the "
      "new ones; ",
      mesh.count(), turn, largest_resolution);
}

// Why the new mesh is not good enough; empty when it is.
std::string fault_of(const meshing::CurvedMesh& fresh, const Triangulation& mesh, const Nodes& X,
                     const RemeshReport& r) {
  if (const std::string worse = worse_triangles(r); !worse.empty())
    return too_sharp(mesh, X) + worse;
  const auto crossing = meshing::self_intersections(meshing::lattice(fresh));
  if (!crossing.empty())
    return fmt::format("the new mesh intersects itself at {} places", crossing.size());
  return {};
}

std::string fault_of(double energy_change, double bound) {
  if (std::abs(energy_change) <= bound) return {};
  return fmt::format("the energy would change by {:.1e} of the elastic energy, more than {:.1e}",
                     energy_change, bound);
}

RemeshResult refused(RemeshReport report, std::string reason) {
  return {.mesh = {}, .state = {}, .refusal = std::move(reason), .report = report};
}

}  // namespace

RemeshResult remesh(const Triangulation& mesh, const State& state, const model::Material& material,
                    const RemeshOptions& options) {
  options.validate();
  RemeshReport report;
  const auto curvature = curvature_of(mesh, state.X);
  if (!curvature) return refused(report, "the surface is degenerate");
  const OldSurface old(mesh, state, *curvature, options);
  const Energy before = energy(mesh, material, state, *curvature);
  measure_before(mesh, state, old, before, report);

  meshing::CurvedMesh fresh;
  try {
    fresh = old.triangles(options.triangles > 0 ? options.triangles : mesh.count());
  } catch (const std::invalid_argument& error) {
    return refused(report, fmt::format("no new triangles: {}", error.what()));
  }
  RemeshResult result{.mesh = std::make_shared<const Triangulation>(fresh),
                      .state = {fresh.nodes, Field(fresh.node_count())},
                      .refusal = {},
                      .report = report};
  Nodes& X = result.state.X;
  for (int i = 0; i < fresh.node_count(); ++i) result.state.beta[i] = old.order_at(X.col(i));
  const meshing::MeshSymmetry symmetry = required_symmetry(fresh, options.symmetry);
  result.state.beta = symmetry.symmetric_part(result.state.beta);
  const Target wanted = lipids_and_volume(mesh, material, state),
               found = lipids_and_volume(*result.mesh, material, result.state);
  report.area_change = found.area / wanted.area - 1;
  report.volume_change = found.volume / wanted.volume - 1;
  const auto rough = curvature_of(*result.mesh, X);
  if (!(rough && correct_lipids_volume(*result.mesh, material, rough->H, wanted, result.state)))
    return refused(report, "area and volume cannot be restored");
  X = symmetry.symmetric_part(X);  // but for rounding it is
  if (material.conserves_order())
    result.state.beta.array() +=
        (total_order(mesh, state) - total_order(*result.mesh, result.state)) / wanted.area;
  fresh.nodes = X;
  measure_mesh(fresh, *result.mesh, X, old, report);
  if (std::string fault = fault_of(fresh, *result.mesh, X, report); !fault.empty())
    return refused(report, fault);

  const auto new_curvature = curvature_of(*result.mesh, X);
  if (!new_curvature) return refused(report, "the new surface is degenerate");
  report.energy_after = energy(*result.mesh, material, result.state, *new_curvature).total();
  report.energy_change =
      (report.energy_after - report.energy_before) / (before.distortion + before.bending);
  if (std::string fault = fault_of(report.energy_change, options.largest_energy_change);
      !fault.empty())
    return refused(report, fault);
  result.report = report;
  return result;
}

}  // namespace sbeh::surface3d
