#include "meshing/fitted_surface.h"

#include "meshing/half_edge_mesh.h"
#include "meshing/measures.h"
#include "meshing/triangle_search.h"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace sbeh::meshing {

using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr int highest_degree = 4;

// Without the constant.
int monomial_count(int degree) { return (degree + 1) * (degree + 2) / 2 - 1; }

// u, v, u², uv, v², …
VectorXd monomials(int degree, double u, double v) {
  VectorXd m(monomial_count(degree));
  Eigen::Index k = 0, before = -1;
  for (int d = 1; d <= degree; ++d) {
    const Eigen::Index start = k;
    for (int i = 0; i < d; ++i) m[k++] = (d == 1 ? 1 : m[before + i]) * u;
    m[k++] = (d == 1 ? 1 : m[before + d - 1]) * v;
    before = start;
  }
  return m;
}

// Points ring by ring around each, nearest ring first.
class Rings {
 public:
  explicit Rings(const HalfEdgeMesh& mesh) : mesh_(mesh), mark_(mesh.n_vertices(), -1) {}

  /// At least `count` of them, if there are as many.
  std::vector<int> around(int point, std::size_t count) {
    std::vector<int> found;
    std::vector<int> ring{point};
    mark_[std::size_t(point)] = point;
    while (found.size() < count && !ring.empty()) {
      std::vector<int> next;
      for (const int inner : ring)
        for (const auto v : mesh_.vv_range(mesh_.vertex_handle(unsigned(inner))))
          if (mark_[std::size_t(v.idx())] != point) {
            mark_[std::size_t(v.idx())] = point;
            next.push_back(v.idx());
          }
      found.insert(found.end(), next.begin(), next.end());
      ring = next;
    }
    return found;
  }

 private:
  const HalfEdgeMesh& mesh_;
  std::vector<int> mark_;  // by which centre a point was seen last
};

double mean_edge(const HalfEdgeMesh& mesh, int point) {
  double sum = 0;
  int count = 0;
  for (const auto h : mesh.voh_range(mesh.vertex_handle(unsigned(point)))) {
    sum += mesh.calc_edge_length(h);
    ++count;
  }
  return sum / count;
}

}  // namespace

// No fit makes sense across a sharp edge: the icosahedron has 42 degrees between its triangles.
void require_smooth(const TriangleMesh& plain, const Names& names) {
  const HalfEdgeMesh mesh = half_edge_mesh(plain);
  constexpr double sharpest = 60;  // degrees between the normals
  constexpr double most_sharp =
      0.1;  // of the edges, unless there are few: no places, but all of the surface
  constexpr std::size_t few = 100;
  const auto normal = [&](OpenMesh::SmartHalfedgeHandle h) {
    const Vector3d a = meshing::point(mesh, h.from());
    return Vector3d(
        (meshing::point(mesh, h.to()) - a).cross(meshing::point(mesh, h.next().to()) - a));
  };
  std::string first;
  std::size_t sharp = 0;
  for (const auto edge : mesh.edges()) {
    if (edge.is_boundary()) throw std::invalid_argument("fitted surface: the mesh is open");
    const Vector3d n = normal(edge.h0()), m = normal(edge.h1());
    const double angle = std::atan2(n.cross(m).norm(), n.dot(m)) * 180 / std::numbers::pi;
    if (angle <= sharpest || ++sharp > 1) continue;
    first = fmt::format(
        "{}: {} and {} meet at {:.0f} degrees, more than {}: no smooth surface can be put through "
        "them",
        edge_name(plain, edge.v0().idx(), edge.v1().idx(), names),
        triangle_name(plain, edge.h0().face().idx(), names),
        triangle_name(plain, edge.h1().face().idx(), names), angle, sharpest);
  }
  if (sharp == 0) return;
  const bool everywhere =
      mesh.n_faces() > few && double(sharp) > most_sharp * double(mesh.n_edges());
  throw std::invalid_argument(
      first
      + (everywhere ? fmt::format("; nor at {} of the {} edges: the surface of voxels, say, should "
                                  "be smoothed in the program it comes from",
                                  sharp, mesh.n_edges())
                    : "; more triangles there would help"));
}

FittedSurface::FittedSurface(const TriangleMesh& mesh, const Names& names) : mesh_(mesh) {
  const HalfEdgeMesh half_edges = half_edge_mesh(mesh);
  require_smooth(mesh, names);
  const Eigen::Matrix3Xd normals = point_normals(mesh);
  Rings rings(half_edges);
  constexpr double same_side = 0.3;  // cosine between normals: beyond, a graph cannot follow
  for (int i = 0; i < mesh.point_count(); ++i) {
    std::vector<int> around = rings.around(i, 2 * std::size_t(monomial_count(highest_degree)));
    std::erase_if(around, [&](int j) { return normals.col(j).dot(normals.col(i)) < same_side; });
    graphs_.push_back(graph_at(i, around, normals.col(i), mean_edge(half_edges, i)));
  }
  // A wave of height a and length 2h has the curvature (π/h)² a. Second derivatives are c₂, c₃, c₄.
  constexpr double k = std::numbers::pi;
  double waves = 0, bending = 0;
  for (const Graph& g : graphs_) {
    if (g.degree < 2) continue;
    const auto c = g.coefficients.segment<3>(2) / g.scale;
    waves += std::pow(k * k * g.scatter / g.scale, 2);
    bending += 2 * (4 * c[0] * c[0] + 2 * c[1] * c[1] + 4 * c[2] * c[2]);  // 2 |B|²: H² of a sphere
  }
  roughness_ = bending > 0 ? std::sqrt(waves / bending) : 0;
}

FittedSurface::Graph FittedSurface::graph_at(int point, const std::vector<int>& around,
                                             const Vector3d& normal, double edge_length) const {
  Graph g;
  const Vector3d tangent = normal.unitOrthogonal();
  g.frame << tangent, normal.cross(tangent), normal;
  g.degree = highest_degree;
  const auto count = Eigen::Index(around.size());
  while (g.degree > 1 && 5 * count < 6 * monomial_count(g.degree)) --g.degree;
  if (count < monomial_count(g.degree)) {
    g.coefficients = VectorXd::Zero(2);
    g.degree = 1;
    return g;
  }
  Eigen::Matrix3Xd local(3, count);  // in the frame
  for (Eigen::Index k = 0; k < count; ++k)
    local.col(k) =
        g.frame.transpose() * (mesh_.points.col(around[std::size_t(k)]) - mesh_.points.col(point));
  g.scale = edge_length;
  local /= g.scale;
  Eigen::MatrixXd A(count, monomial_count(g.degree));
  VectorXd b(count);
  double weights_squared = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const double weight = std::exp(-local.col(k).squaredNorm());
    weights_squared += weight * weight;
    A.row(k) = weight * monomials(g.degree, local(0, k), local(1, k));
    b[k] = weight * local(2, k);
  }
  g.coefficients = A.colPivHouseholderQr().solve(b);
  g.scatter = std::sqrt((A * g.coefficients - b).squaredNorm() / weights_squared);
  return g;
}

Vector3d FittedSurface::onto_graph(int point, const Vector3d& x) const {
  const Graph& g = graphs_[std::size_t(point)];
  const Vector3d local = g.frame.transpose() * (x - mesh_.points.col(point)) / g.scale;
  const double height = monomials(g.degree, local[0], local[1]).dot(g.coefficients);
  return x + (height - local[2]) * g.scale * g.frame.col(2);
}

Vector3d FittedSurface::at(int triangle, const Vector3d& barycentric) const {
  const auto c = mesh_.triangles.col(triangle);
  const Eigen::Matrix3d corner = mesh_.points(Eigen::all, c);
  const Vector3d x = corner * barycentric;
  Vector3d mean = Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
    if (barycentric[k] != 0) mean += barycentric[k] * onto_graph(c[k], x);
  return mean;
}

Projection onto(std::shared_ptr<const FittedSurface> surface) {
  auto nearest = nearest_triangle(surface->mesh());
  return [surface = std::move(surface), nearest = std::move(nearest)](const Vector3d& x) {
    const auto [triangle, barycentric] = nearest(x);
    return surface->at(triangle, barycentric);
  };
}

}  // namespace sbeh::meshing
