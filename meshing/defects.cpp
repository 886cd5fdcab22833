#include "meshing/defects.h"

#include "meshing/measures.h"
#include "meshing/near_points.h"
#include "meshing/triangle_search.h"

#include <Eigen/Geometry>
#include <boost/pending/disjoint_sets.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace sbeh::meshing {

namespace {

using Found = std::optional<Defect>;

// A mesh and what its parts are called.
struct Named {
  const TriangleMesh& mesh;
  const Names& names;
  std::string point(int i) const { return point_name(mesh, i, names); }
  std::string edge(int a, int b) const { return edge_name(mesh, a, b, names); }
  std::string triangle(int t) const { return triangle_name(mesh, t, names); }
  std::string whole(int t) const { return whole_triangle_name(mesh, t, names); }
};

Found find_bad_numbers(const Named& named) {
  const TriangleMesh& mesh = named.mesh;
  if (mesh.triangle_count() == 0) return Defect{DefectKind::empty, "there are no triangles"};
  for (int i = 0; i < mesh.point_count(); ++i)
    if (!mesh.points.col(i).allFinite())
      return Defect{DefectKind::not_finite,
                    fmt::format("{} ({}, {}, {}): must be finite numbers", named.point(i),
                                mesh.points(0, i), mesh.points(1, i), mesh.points(2, i))};
  for (int t = 0; t < mesh.triangle_count(); ++t)
    if (mesh.triangles.col(t).minCoeff() < 0
        || mesh.triangles.col(t).maxCoeff() >= mesh.point_count())
      return Defect{DefectKind::no_such_point,
                    fmt::format("triangle {} (points {}, {}, {}): there are only {} points", t,
                                mesh.triangles(0, t), mesh.triangles(1, t), mesh.triangles(2, t),
                                mesh.point_count())};
  return {};
}

// Zero to rounding: the height of the triangle over its longest edge is below 1e-10 of that edge.
Found find_degenerate(const Named& named) {
  const TriangleMesh& mesh = named.mesh;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Matrix3d x = mesh.points(Eigen::all, mesh.triangles.col(t));
    const Eigen::Vector3d u = x.col(1) - x.col(0), v = x.col(2) - x.col(0), w = v - u;
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), w.squaredNorm()});
    if (!(u.cross(v).norm() > 1e-10 * longest))
      return Defect{DefectKind::degenerate, named.whole(t) + ": has no area"};
  }
  return {};
}

Found find_repeated(const Named& named) {
  const TriangleMesh& mesh = named.mesh;
  std::vector<std::array<int, 4>> sorted;  // corners ascending, triangle
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto c = mesh.triangles.col(t);
    sorted.push_back({c[0], c[1], c[2], t});
    std::sort(sorted.back().begin(), sorted.back().begin() + 3);
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (std::equal(sorted[i].begin(), sorted[i].begin() + 3, sorted[i - 1].begin()))
      return Defect{DefectKind::repeated,
                    fmt::format("{}: has the same corners as {}", named.whole(sorted[i][3]),
                                named.triangle(sorted[i - 1][3]))};
  return {};
}

Found find_unused(const Named& named) {
  const TriangleMesh& mesh = named.mesh;
  std::vector<bool> used(std::size_t(mesh.point_count()), false);
  for (const int corner : mesh.triangles.reshaped()) used[std::size_t(corner)] = true;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused == used.end()) return {};
  return Defect{DefectKind::unused_point,
                named.point(int(unused - used.begin())) + ": belongs to no triangle"};
}

// An edge as one of its triangles runs along it.
struct DirectedEdge {
  int low, high;
  bool upwards;
  int triangle;
  auto ends() const { return std::pair(low, high); }
};

std::vector<DirectedEdge> sorted_edges(const TriangleMesh& mesh) {
  std::vector<DirectedEdge> edges;
  edges.reserve(3 * std::size_t(mesh.triangle_count()));
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(k, t), b = mesh.triangles((k + 1) % 3, t);
      edges.push_back({std::min(a, b), std::max(a, b), a < b, t});
    }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const auto& a, const auto& b) { return a.ends() < b.ends(); });
  return edges;
}

std::string near_pair(const Named& named) {
  const auto pair = near_points(named.mesh).example;
  if (!pair) return {};
  return fmt::format("; {} and {} are {:.2g} apart", named.point(pair->a), named.point(pair->b),
                     pair->distance);
}

// Edges with more than two triangles, then neighbours of different orientation, then open edges.
Found find_bad_edge(const Named& named, const std::vector<DirectedEdge>& edges) {
  Found turned, open;
  for (std::size_t i = 0, next = 0; i < edges.size(); i = next) {
    while (next < edges.size() && edges[next].ends() == edges[i].ends()) ++next;
    const auto edge = [&] { return named.edge(edges[i].low, edges[i].high); };
    const auto triangle = [&](std::size_t k) { return named.triangle(edges[i + k].triangle); };
    if (next - i > 2)
      return Defect{DefectKind::not_manifold_edge,
                    fmt::format("{}: belongs to {} triangles ({}, {}, {}{}), must belong to two",
                                edge(), next - i, triangle(0), triangle(1), triangle(2),
                                next - i > 3 ? ", ..." : "")};
    if (next - i == 1 && !open)
      open = Defect{DefectKind::open,
                    fmt::format("{} of {}: belongs to no other triangle, the surface is open{}",
                                edge(), named.whole(edges[i].triangle), near_pair(named))};
    if (next - i == 2 && edges[i].upwards == edges[i + 1].upwards && !turned)
      turned = Defect{DefectKind::orientation_differs,
                      fmt::format("{}: {} and {} see it from different sides", edge(),
                                  named.whole(edges[i].triangle), triangle(1))};
  }
  return turned ? turned : open;
}

// Numbers that hang together.
using Pieces = boost::disjoint_sets_with_storage<>;

// On a mesh whose edges all have two triangles.
Found find_bad_point(const Named& named, const std::vector<DirectedEdge>& edges) {
  const TriangleMesh& mesh = named.mesh;
  // Corner k of triangle t is number 3t + k; those of a point that share an edge hang together.
  Pieces fans(3 * std::size_t(mesh.triangle_count()));
  const auto corner = [&](int t, int point) {
    int k = 0;
    while (mesh.triangles(k, t) != point) ++k;
    return 3 * std::size_t(t) + std::size_t(k);
  };
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2)
    for (const int point : {edges[i].low, edges[i].high})
      fans.union_set(corner(edges[i].triangle, point), corner(edges[i + 1].triangle, point));
  std::vector<int> first(std::size_t(mesh.point_count()), -1);  // corner at each point
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      int& seen = first[std::size_t(mesh.triangles(k, t))];
      if (seen < 0) seen = 3 * t + k;
      if (fans.find_set(std::size_t(seen)) != fans.find_set(3 * std::size_t(t) + std::size_t(k)))
        return Defect{DefectKind::not_manifold_point,
                      fmt::format("{}: {} and {} meet only there, the surface touches itself",
                                  named.point(mesh.triangles(k, t)), named.whole(t),
                                  named.triangle(seen / 3))};
    }
  return {};
}

Found find_bad_topology(const Named& named, const std::vector<DirectedEdge>& edges) {
  const TriangleMesh& mesh = named.mesh;
  Pieces pieces(std::size_t(mesh.triangle_count()));
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2)
    pieces.union_set(std::size_t(edges[i].triangle), std::size_t(edges[i + 1].triangle));
  for (int t = 0; t < mesh.triangle_count(); ++t)
    if (pieces.find_set(std::size_t(t)) != pieces.find_set(std::size_t(0)))
      return Defect{DefectKind::several_pieces,
                    fmt::format("{}: is not connected with {}, there are several surfaces",
                                named.whole(t), named.triangle(0))};
  const int euler = mesh.point_count() - mesh.triangle_count() / 2;
  if (euler != 2)
    return Defect{DefectKind::wrong_genus,
                  fmt::format("the surface has {} handle(s) (Euler characteristic {}), must have "
                              "none, like a sphere",
                              (2 - euler) / 2, euler)};
  return {};
}

}  // namespace

std::optional<Defect> find_defect(const TriangleMesh& mesh, const Names& names) {
  const Named named{mesh, names};
  for (const auto find : {find_bad_numbers, find_degenerate, find_repeated, find_unused})
    if (auto defect = find(named)) return defect;
  const std::vector<DirectedEdge> edges = sorted_edges(mesh);
  for (const auto find : {find_bad_edge, find_bad_point, find_bad_topology})
    if (auto defect = find(named, edges)) return defect;
  if (volume(mesh) < 0)
    return Defect{DefectKind::inward,
                  named.whole(0) + " and all others: the surface is seen from inside"};
  const auto pairs = self_intersections(mesh);
  if (!pairs.empty())
    return Defect{DefectKind::self_intersecting,
                  fmt::format("{} and {} pass through each other ({} such pairs)",
                              named.whole(pairs[0][0]), named.whole(pairs[0][1]), pairs.size())};
  return {};
}

std::optional<Defect> find_defect(const TriangleMesh& mesh) {
  return find_defect(mesh, own_numbers(mesh));
}

}  // namespace sbeh::meshing
