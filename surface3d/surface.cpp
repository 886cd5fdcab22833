#include "surface3d/surface.h"

#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"
#include "surface3d/parallel.h"
#include "surface3d/point_tables.h"

#include <metis.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>
#include <stdexcept>
#include <vector>

namespace sbeh::surface3d {

namespace {

using Patch = Triangulation::Patch;
using Triangles = decltype(Triangulation::triangles);

// Corners have the first numbers.
int corners_of(const Triangles& triangles) { return triangles.topRows<3>().maxCoeff() + 1; }

// Grown from triangle to triangle over their corners, so that few nodes belong to several patches.
std::vector<Patch> patches_of(const Triangles& triangles, const std::vector<int>& own) {
  constexpr std::size_t size = 16;
  std::vector<std::vector<int>> at_corner(std::size_t(corners_of(triangles)));
  for (const int e : own)
    for (const int corner : triangles.col(e).head<3>()) at_corner[std::size_t(corner)].push_back(e);
  std::vector<bool> taken(std::size_t(triangles.cols()), false);
  std::vector<Patch> patches;
  for (const int first : own) {
    if (taken[std::size_t(first)]) continue;
    Patch& patch = patches.emplace_back(Patch{first});
    taken[std::size_t(first)] = true;
    for (std::size_t k = 0; k < patch.size(); ++k)
      for (const int corner : triangles.col(patch[k]).head<3>())
        for (const int e : at_corner[std::size_t(corner)])
          if (!taken[std::size_t(e)] && patch.size() < size) {
            patch.push_back(e);
            taken[std::size_t(e)] = true;
          }
  }
  return patches;
}

// Each patch is given the first colour that no other has at its corners.
std::vector<std::vector<Patch>> coloured(const Triangles& triangles,
                                         const std::vector<Patch>& patches) {
  std::vector<std::vector<Patch>> colours;
  std::vector<std::set<int>> met(std::size_t(corners_of(triangles)));  // colours at the corners
  for (const Patch& patch : patches) {
    std::set<int> corners;
    for (const int e : patch)
      for (const int corner : triangles.col(e).head<3>()) corners.insert(corner);
    int colour = 0;
    while (std::ranges::any_of(
        corners, [&](int corner) { return met[std::size_t(corner)].contains(colour); }))
      ++colour;
    for (const int corner : corners) met[std::size_t(corner)].insert(colour);
    if (colour == int(colours.size())) colours.emplace_back();
    colours[std::size_t(colour)].push_back(patch);
  }
  return colours;
}

std::vector<int> all_of(int count) {
  std::vector<int> all(std::size_t(count), 0);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

// Those of a rank, by METIS: parts of one size with few sides between them.
std::vector<int> part_of(const Triangles& triangles, const Ranks& ranks) {
  idx_t elements = idx_t(triangles.cols()), corners = idx_t(corners_of(triangles)), common = 2,
        parts = ranks.count(), cut = 0;
  std::vector<idx_t> start{0}, corner_of, part(std::size_t(elements), 0),
      part_of_corner(std::size_t(corners), 0);
  for (idx_t e = 0; e < elements; ++e) {
    for (const int corner : triangles.col(e).head<3>()) corner_of.push_back(corner);
    start.push_back(idx_t(corner_of.size()));
  }
  METIS_PartMeshDual(&elements, &corners, start.data(), corner_of.data(), nullptr, nullptr, &common,
                     &parts, nullptr, nullptr, &cut, part.data(), part_of_corner.data());
  std::vector<int> own;
  for (idx_t e = 0; e < elements; ++e)
    if (part[std::size_t(e)] == ranks.rank()) own.push_back(e);
  return own;
}

}  // namespace

Triangulation::Triangulation(const meshing::CurvedMesh& mesh)
    : triangles((mesh.order == 3 && mesh.triangles.rows() == 10)
                    ? mesh.triangles
                    : throw std::invalid_argument("surface3d: the mesh must be of order 3")),
      quadratic(6, mesh.triangle_count()),
      nodes(mesh.node_count()),
      quadratic_nodes(mesh.vertex_count() + mesh.edge_count()),
      scalars(nodes, mesh.triangles, SparsePattern::Mask::Constant(10, 10, true)),
      own(all_of(count())),
      place(own),
      colours(coloured(triangles, patches_of(triangles, own))) {
  const int vertices = mesh.vertex_count();
  quadratic.topRows<3>() = triangles.topRows<3>();
  for (int e = 0; e < count(); ++e)
    for (int k = 0; k < 3; ++k)  // two consecutive P3 nodes are one edge
      quadratic(3 + k, e) = vertices + (triangles(3 + 2 * k, e) - vertices) / 2;
}

Triangulation::Triangulation(const Triangulation& whole, const Ranks& all) : Triangulation(whole) {
  if (all.is_alone()) return;
  ranks = all;
  own = part_of(triangles, ranks);
  std::ranges::fill(place, -1);
  for (std::size_t k = 0; k < own.size(); ++k) place[std::size_t(own[k])] = int(k);
  colours = coloured(triangles, patches_of(triangles, own));
}

ShapeValues shape_values(const Eigen::Vector2d& x, double weight) {
  static const model::TriangleElement cubic(3), quadratic(2);
  ShapeValues s{.weight = weight, .phi = {}, .dphi = {}, .quadratic = {}};
  using Column = Eigen::Map<Eigen::Matrix<double, 10, 1>>;
  Column(s.phi.data()) = cubic.values(x);
  const Eigen::Matrix2Xd slopes = cubic.derivatives(x);
  for (int k = 0; k < 2; ++k) Column(s.dphi[std::size_t(k)].data()) = slopes.row(k).transpose();
  Eigen::Map<Eigen::Matrix<double, 6, 1>>(s.quadratic.data()) = quadratic.values(x);
  return s;
}

namespace {

std::vector<ShapeValues> tabulate(const model::TriangleRule& rule) {
  std::vector<ShapeValues> table;
  table.reserve(std::size_t(rule.size()));
  for (int q = 0; q < rule.size(); ++q)
    table.push_back(shape_values(rule.points.col(q), rule.weights[q]));
  return table;
}

}  // namespace

std::span<const ShapeValues> assembly_points() {
  static const std::vector<ShapeValues> table = tabulate(model::symmetric_triangle_rule());
  return table;
}

std::span<const ShapeValues> diagnostic_points() {
  static const std::vector<ShapeValues> table = tabulate(model::triangle_rule(12));
  return table;
}

std::span<const ShapeValues> node_points() {
  static const std::vector<ShapeValues> table =
      tabulate({.points = model::TriangleElement(3).nodes(), .weights = Eigen::VectorXd::Zero(10)});
  return table;
}

SurfacePoint surface_point(const ElementNodes& X, const ShapeValues& s) {
  SurfacePoint p;
  p.x = value_at(X, s);
  const Eigen::Vector3d a1 = X * Shapes(s.dphi[0].data()), a2 = X * Shapes(s.dphi[1].data());
  const Eigen::Vector3d n = a1.cross(a2);
  const double jacobian = n.norm(), length = a1.norm();
  p.frame.col(0) = a1 / length;
  p.frame.col(2) = n / jacobian;
  p.frame.col(1) = p.frame.col(2).cross(p.frame.col(0));
  const double inverse = 1 / length, along = a2.dot(p.frame.col(0)),
               inverse_across = 1 / a2.dot(p.frame.col(1));
  for (std::size_t a = 0; a < 10; ++a) {
    p.grad[0][a] = s.dphi[0][a] * inverse;
    p.grad[1][a] = (s.dphi[1][a] - along * p.grad[0][a]) * inverse_across;
  }
  p.dS = jacobian * s.weight;
  return p;
}

Target area_and_volume(const Triangulation& mesh, const Nodes& X) {
  const auto sum = sum_over_triangles<2>(mesh, [&](int e) {
    const auto& tables = diagnostic_tables();
    const ElementNodes local = on_element(mesh, e, X);
    const auto normal = cross(tables.slopes(local, 0), tables.slopes(local, 1));
    return Eigen::Array2d((tables.weights * normal.colwise().norm().array()).sum(),
                          (tables.weights * dot(tables.values(local), normal)).sum() / 3);
  });
  return {sum[0], sum[1]};
}

double area(const Triangulation& mesh, const Nodes& X) { return area_and_volume(mesh, X).area; }
double volume(const Triangulation& mesh, const Nodes& X) { return area_and_volume(mesh, X).volume; }

bool is_sphere(const Triangulation& mesh, double area, double volume) {
  return reduced_volume(area, volume) > 1 - 1e-7 - 32 / std::pow(mesh.count(), 3);
}

// Those of a fixed direction, which is no axis of anything, turned with it to the normal.
std::array<Nodes, 2> node_tangents(const Nodes& normals) {
  static const Eigen::Vector3d from(0.36, 0.48, 0.8), first(0.8, -0.6, 0);
  std::array<Nodes, 2> tangents{Nodes(3, normals.cols()), Nodes(3, normals.cols())};
  for (Eigen::Index i = 0; i < normals.cols(); ++i) {
    const auto turn = Eigen::Quaterniond::FromTwoVectors(from, normals.col(i));
    tangents[0].col(i) = turn * first;
    tangents[1].col(i) = turn * from.cross(first);
  }
  return tangents;
}

Nodes node_normals(const Triangulation& mesh, const Nodes& X) {
  Nodes n = Nodes::Zero(3, X.cols());
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X);
    for (int a = 0; a < 10; ++a) {
      const auto& dphi = node_points()[std::size_t(a)].dphi;
      const Eigen::Vector3d a1 = local * Shapes(dphi[0].data()),
                            a2 = local * Shapes(dphi[1].data());
      n.col(mesh.triangles(a, e)) += a1.cross(a2);
    }
  }
  n.colwise().normalize();
  return n;
}

}  // namespace sbeh::surface3d
