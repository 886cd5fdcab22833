#include "meshing/mesh_symmetry.h"

#include "model/numerics/lagrange.h"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace sbeh::meshing {

namespace {

// A side of a triangle: from its corner `side` to the next one.
struct Side {
  int triangle, side;
};

// Where a triangle is taken to: corner k to corner turn + k there, or to turn − k by a mirror.
struct Place {
  int triangle = -1, turn = 0;
  bool operator==(const Place&) const = default;
};
int corner_of(const Place& place, int k, bool mirrored) {
  return (place.turn + (mirrored ? 3 - k : k)) % 3;
}

// Triangles and their neighbours, of a closed mesh.
class Neighbours {
 public:
  explicit Neighbours(const Eigen::MatrixXi& triangles) : triangles_(triangles) {
    std::map<std::pair<int, int>, Side> sides;
    for (int t = 0; t < count(); ++t)
      for (int k = 0; k < 3; ++k) sides[{corner(t, k), corner(t, (k + 1) % 3)}] = {t, k};
    across_.resize(std::size_t(count()));
    valence_.resize(std::size_t(triangles.topRows<3>().maxCoeff()) + 1);
    for (int t = 0; t < count(); ++t)
      for (int k = 0; k < 3; ++k) {
        const auto other = sides.find({corner(t, (k + 1) % 3), corner(t, k)});
        if (other == sides.end()) throw std::invalid_argument("symmetry of a mesh that is open");
        across_[std::size_t(t)][std::size_t(k)] = other->second;
        ++valence_[std::size_t(corner(t, k))];
      }
  }
  int count() const { return int(triangles_.cols()); }
  int corner(int triangle, int k) const { return triangles_(k, triangle); }
  Side across(int triangle, int side) const {
    return across_[std::size_t(triangle)][std::size_t(side)];
  }
  int valence(int triangle, int k) const { return valence_[std::size_t(corner(triangle, k))]; }
  bool alike(int triangle, const Place& place, bool mirrored) const {
    for (int k = 0; k < 3; ++k)
      if (valence(triangle, k) != valence(place.triangle, corner_of(place, k, mirrored)))
        return false;
    return true;
  }
  // A corner with a number of triangles that few points have.
  Side rarest() const {
    std::map<int, int> points;
    for (const int valence : valence_) ++points[valence];
    Side rarest{0, 0};
    for (int t = 0; t < count(); ++t)
      for (int k = 0; k < 3; ++k)
        if (points[valence(t, k)] < points[valence(rarest.triangle, rarest.side)]) rarest = {t, k};
    return rarest;
  }

 private:
  const Eigen::MatrixXi& triangles_;
  std::vector<std::array<Side, 3>> across_;
  std::vector<int> valence_;
};

using Places = std::vector<Place>;  // of each triangle

// What follows from the place of one triangle; empty where that contradicts itself.
Places continued(const Neighbours& mesh, int first, const Place& place, bool mirrored) {
  Places places(std::size_t(mesh.count()));
  if (!mesh.alike(first, place, mirrored)) return {};
  places[std::size_t(first)] = place;
  std::vector<int> todo{first};
  while (!todo.empty()) {
    const int t = todo.back();
    todo.pop_back();
    const Place here = places[std::size_t(t)];
    for (int k = 0; k < 3; ++k) {
      const Side next = mesh.across(t, k);
      const int side = corner_of(here, mirrored ? (k + 1) % 3 : k, mirrored);
      const Side there = mesh.across(here.triangle, side);
      const int turn = mirrored ? next.side + there.side + 1 : there.side - next.side + 3;
      const Place implied{there.triangle, turn % 3};
      Place& known = places[std::size_t(next.triangle)];
      if (known == implied) continue;
      if (known.triangle >= 0 || !mesh.alike(next.triangle, implied, mirrored)) return {};
      known = implied;
      todo.push_back(next.triangle);
    }
  }
  return places;
}

// Which node of a triangle is where the corners' places take a node, all by their place in the list.
class LocalNodes {
 public:
  explicit LocalNodes(int order) {
    const Eigen::Matrix2Xd nodes = model::TriangleElement(order).nodes();
    for (const auto x : nodes.colwise()) {
      const double second = x[0] * order, third = x[1] * order;
      weights_.push_back({order - int(std::lround(second + third)), int(std::lround(second)),
                          int(std::lround(third))});
    }
  }
  int size() const { return int(weights_.size()); }
  int image(int node, const Place& place, bool mirrored) const {
    std::array<int, 3> moved{};
    for (int k = 0; k < 3; ++k)
      moved[std::size_t(corner_of(place, k, mirrored))] =
          weights_[std::size_t(node)][std::size_t(k)];
    return int(std::find(weights_.begin(), weights_.end(), moved) - weights_.begin());
  }

 private:
  std::vector<std::array<int, 3>> weights_;  // of the corners
};

// All ways to take the mesh to itself, as images of its nodes: with mirrors, or without.
std::vector<Eigen::VectorXi> automorphisms(const CurvedMesh& mesh, bool mirrored) {
  const Neighbours neighbours(mesh.triangles);
  const LocalNodes local(mesh.order);
  const Side rare = neighbours.rarest();
  std::vector<Eigen::VectorXi> found;
  for (int t = 0; t < neighbours.count(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (neighbours.valence(t, k) != neighbours.valence(rare.triangle, rare.side)) continue;
      const int turn = mirrored ? k + rare.side : k - rare.side + 3;
      const Places places = continued(neighbours, rare.triangle, {t, turn % 3}, mirrored);
      if (places.empty()) continue;
      Eigen::VectorXi& image = found.emplace_back(mesh.node_count());
      for (int from = 0; from < neighbours.count(); ++from) {
        const Place& to = places[std::size_t(from)];
        for (int j = 0; j < local.size(); ++j)
          image[mesh.triangles(j, from)] =
              mesh.triangles(local.image(j, to, mirrored), to.triangle);
      }
    }
  return found;
}

double distance(const Eigen::Matrix3Xd& nodes, const Operation& operation,
                const Eigen::VectorXi& image) {
  return (nodes(Eigen::all, image) - operation * nodes).norm();
}

CurvedMesh plain(const TriangleMesh& mesh) {
  return {.order = 1, .triangles = mesh.triangles, .nodes = mesh.points};
}

constexpr double tolerance = 1e-6;  // in units of the largest radius
bool fits(const MeshSymmetry& symmetry, const Eigen::Matrix3Xd& nodes) {
  return symmetry.misfit(nodes) <= tolerance * nodes.colwise().norm().maxCoeff();
}

}  // namespace

Eigen::Matrix3Xd MeshSymmetry::symmetric_part(const Eigen::Matrix3Xd& vectors) const {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, vectors.cols());
  for (std::size_t g = 0; g < operations.size(); ++g)
    sum += operations[g].transpose() * vectors(Eigen::all, image.col(Eigen::Index(g)));
  return sum / double(operations.size());
}

Eigen::VectorXd MeshSymmetry::symmetric_part(const Eigen::VectorXd& values) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.size());
  for (Eigen::Index g = 0; g < image.cols(); ++g) sum += values(image.col(g));
  return sum / double(image.cols());
}

double MeshSymmetry::misfit(const Eigen::Matrix3Xd& nodes) const {
  double largest = 0;
  for (std::size_t g = 0; g < operations.size(); ++g)
    largest =
        std::max(largest, (nodes(Eigen::all, image.col(Eigen::Index(g))) - operations[g] * nodes)
                              .colwise()
                              .norm()
                              .maxCoeff());
  return largest;
}

std::optional<MeshSymmetry> symmetry_of(const CurvedMesh& mesh,
                                        const std::vector<Operation>& operations) {
  const std::array<std::vector<Eigen::VectorXi>, 2> ways{automorphisms(mesh, false),
                                                         automorphisms(mesh, true)};
  MeshSymmetry symmetry{operations,
                        Eigen::MatrixXi(mesh.node_count(), Eigen::Index(operations.size()))};
  for (std::size_t g = 0; g < operations.size(); ++g) {
    const auto& among = ways[operations[g].determinant() < 0 ? 1 : 0];
    if (among.empty()) return {};
    const auto best = std::min_element(
        among.begin(), among.end(), [&](const Eigen::VectorXi& a, const Eigen::VectorXi& b) {
          return distance(mesh.nodes, operations[g], a) < distance(mesh.nodes, operations[g], b);
        });
    for (std::size_t before = 0; before < g; ++before)
      if (symmetry.image.col(Eigen::Index(before)) == *best) return {};
    symmetry.image.col(Eigen::Index(g)) = *best;
  }
  return symmetry;
}

namespace {

MeshSymmetry of_triangles(const CurvedMesh& mesh, const PointGroup& group) {
  if (group.is_trivial())
    return {group.operations(),
            Eigen::VectorXi::LinSpaced(mesh.node_count(), 0, mesh.node_count() - 1)};
  auto symmetry = symmetry_of(mesh, group.operations());
  if (!symmetry)
    throw std::invalid_argument(
        fmt::format("symmetry = \"{}\": the triangles have not this symmetry", group.symbol()));
  return std::move(*symmetry);
}

}  // namespace

MeshSymmetry required_symmetry(const CurvedMesh& mesh, const PointGroup& group) {
  MeshSymmetry symmetry = of_triangles(mesh, group);
  if (!fits(symmetry, mesh.nodes))
    throw std::invalid_argument(
        fmt::format("symmetry = \"{}\": the surface has not this symmetry about the origin, it is "
                    "off by {:.2g}",
                    group.symbol(), symmetry.misfit(mesh.nodes)));
  return symmetry;
}

MeshSymmetry symmetry_of_triangles(const TriangleMesh& mesh, const PointGroup& group) {
  return of_triangles(plain(mesh), group);
}

void symmetrise(CurvedMesh& mesh, const PointGroup& group, const Projection& onto_surface) {
  if (group.is_trivial()) return;
  const MeshSymmetry symmetry = of_triangles(mesh, group);
  mesh.nodes = symmetry.symmetric_part(mesh.nodes);
  for (auto x : mesh.nodes.colwise()) x = onto_surface(x);
  mesh.nodes = symmetry.symmetric_part(mesh.nodes);
}

bool has_symmetry(const TriangleMesh& mesh, const PointGroup& group) {
  const auto symmetry = symmetry_of(plain(mesh), group.operations());
  return symmetry && fits(*symmetry, mesh.points);
}

}  // namespace sbeh::meshing
