#include "surface3d/mesh/self_contact.h"

#include "meshing/quality.h"
#include "meshing/triangle_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbeh::surface3d {

using Eigen::Vector3d;

namespace {

// Which corners of the triangles are joined by an edge, or are the same.
class Neighbours {
 public:
  explicit Neighbours(const Triangulation& mesh) : mesh_(mesh) {
    const int corners = mesh.triangles.topRows<3>().maxCoeff() + 1;
    for (int i = 0; i < corners; ++i) joined_.push_back({i});
    for (const auto t : mesh.triangles.colwise())
      for (int k = 0; k < 3; ++k)  // the triangle beyond the edge has the way back
        joined_[std::size_t(t[k])].push_back(t[(k + 1) % 3]);
  }

  /// Whether a triangle has corners in common with both.
  bool near(int e, int f) const {
    for (int k = 0; k < 3; ++k)
      for (const int corner : joined_[std::size_t(mesh_.triangles(k, e))])
        for (int l = 0; l < 3; ++l)
          if (mesh_.triangles(l, f) == corner) return true;
    return false;
  }

 private:
  const Triangulation& mesh_;
  std::vector<std::vector<int>> joined_;
};

// Side of the equilateral triangle that has the area of the plain one.
double side_of(const ElementNodes& X) {
  const Vector3d a = X.col(1) - X.col(0), b = X.col(2) - X.col(0);
  return std::sqrt(2 * a.cross(b).norm() / std::sqrt(3.));
}

// The point of a plain triangle nearest to x (Ericson, Real-Time Collision Detection, 5.1.5).
Vector3d nearest_on_triangle(const Vector3d& a, const Vector3d& b, const Vector3d& c,
                             const Vector3d& x) {
  const Vector3d ab = b - a, ac = c - a, ax = x - a;
  const double d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return a;
  const Vector3d bx = x - b;
  const double d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const Vector3d cx = x - c;
  const double d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / (d4 - d3 + d5 - d6) * (c - b);
  return a + (vb * ab + vc * ac) / (va + vb + vc);
}

// The small plain triangles between the nodes of a curved one, by its nodes.
using SmallTriangles = std::vector<Eigen::Vector3i>;

struct Approach {
  double distance;
  Vector3d middle;
};

// From the nodes of one triangle to the small triangles of the other, if nearer than `best`.
void approach(const ElementNodes& nodes, const ElementNodes& other, const SmallTriangles& small,
              Approach& best) {
  for (const Eigen::Vector3i& s : small) {
    const Vector3d a = other.col(s[0]), b = other.col(s[1]), c = other.col(s[2]);
    const Vector3d centre = (a + b + c) / 3;
    const double radius = std::sqrt(std::max(
        {(a - centre).squaredNorm(), (b - centre).squaredNorm(), (c - centre).squaredNorm()}));
    for (int k = 0; k < 10; ++k) {
      const Vector3d x = nodes.col(k);
      if ((x - centre).squaredNorm() >= std::pow(best.distance + radius, 2)) continue;
      const Vector3d y = nearest_on_triangle(a, b, c, x);
      const double distance = (x - y).norm();
      if (distance < best.distance) best = {distance, (x + y) / 2};
    }
  }
}

bool cross(const ElementNodes& X, const ElementNodes& Y, const SmallTriangles& small) {
  for (const Eigen::Vector3i& s : small)
    for (const Eigen::Vector3i& t : small) {
      const Eigen::Matrix3d a = X(Eigen::all, s), b = Y(Eigen::all, t);
      const Eigen::Array3d gap = (a.rowwise().minCoeff() - b.rowwise().maxCoeff())
                                     .cwiseMax(b.rowwise().minCoeff() - a.rowwise().maxCoeff());
      if (gap.maxCoeff() <= 0 && meshing::intersect(a, b)) return true;
    }
  return false;
}

}  // namespace

std::vector<Contact> self_contacts(const Triangulation& mesh, const Nodes& X, double limit) {
  if (!(limit > 0 && limit <= 0.5))
    throw std::invalid_argument(
        fmt::format("self_contacts: limit = {}: must be > 0 and <= 0.5", limit));
  // Where triangles cross, some node is nearer than the spacing of the nodes.
  const double searched = std::max(limit, contact_distance);
  Eigen::VectorXd side(mesh.count());
  Eigen::Matrix3Xd low(3, mesh.count()), high(3, mesh.count());
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X);
    side[e] = side_of(local);
    const double margin = searched * side[e] / 2;
    low.col(e) = local.rowwise().minCoeff().array() - margin;
    high.col(e) = local.rowwise().maxCoeff().array() + margin;
  }
  const SmallTriangles small = meshing::small_triangles(3);
  const Neighbours neighbours(mesh);
  std::vector<Contact> contacts;
  for (const auto& [e, f] : meshing::overlapping_boxes(low, high)) {
    if (neighbours.near(e, f)) continue;
    const ElementNodes x = on_element(mesh, e, X), y = on_element(mesh, f, X);
    const double size = std::min(side[e], side[f]);
    Approach nearest{searched * size, Vector3d::Zero()};
    approach(x, y, small, nearest);
    approach(y, x, small, nearest);
    if (!(nearest.distance < searched * size)) continue;
    if (cross(x, y, small))
      nearest.distance = 0;
    else if (!(nearest.distance < limit * size))
      continue;
    contacts.push_back({{e, f}, nearest.middle, nearest.distance, nearest.distance / size});
  }
  std::stable_sort(contacts.begin(), contacts.end(),
                   [](const Contact& a, const Contact& b) { return a.distance < b.distance; });
  return contacts;
}

}  // namespace sbeh::surface3d
