#include "meshing/cross_section.h"

#include "model/numerics/lagrange.h"
#include "model/numerics/root.h"

#include <array>
#include <optional>

namespace sbeh::meshing {

using Eigen::Vector2d, Eigen::Vector3d;

namespace {

constexpr int parts = 8;  // per edge of a curved triangle

struct Crossing {
  Vector3d x;
  double value;
};
using Segment = std::array<Crossing, 2>;

// One curved triangle, its height above the plane at each node.
struct Triangle {
  const model::TriangleElement& element;
  Eigen::Matrix3Xd X;
  Eigen::VectorXd height, field;

  double height_at(const Vector2d& at) const { return height.dot(element.values(at)); }

  // Between two places on different sides of the plane.
  Crossing crossing(const Vector2d& above, const Vector2d& below) const {
    const auto between = [&](double t) -> Vector2d { return above + t * (below - above); };
    const auto along = [&](double t) { return height_at(between(t)); };
    const Eigen::VectorXd phi = element.values(between(model::root_between(along, 0, 1).middle()));
    return {X * phi, field.dot(phi)};
  }

  // In the plain triangle of three places.
  std::optional<Segment> segment(const std::array<Vector2d, 3>& corners) const {
    std::array<bool, 3> above;
    for (int i = 0; i < 3; ++i) above[i] = height_at(corners[i]) >= 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      if (above[i] == above[j] || above[i] == above[k]) continue;
      const auto cut = [&](int other) {
        return above[i] ? crossing(corners[i], corners[other])
                        : crossing(corners[other], corners[i]);
      };
      return Segment{cut(j), cut(k)};
    }
    return {};
  }
};

std::vector<Segment> segments_of(const CurvedMesh& mesh, const Eigen::VectorXd& field,
                                 const Eigen::VectorXd& heights) {
  const model::TriangleElement element(mesh.order);
  const auto at = [](int i, int j) { return Vector2d(double(i) / parts, double(j) / parts); };
  std::vector<Segment> segments;
  for (const auto nodes : mesh.triangles.colwise()) {
    const Triangle triangle{element, mesh.nodes(Eigen::all, nodes), heights(nodes), field(nodes)};
    // Between its nodes the height of a cubic is at most three times theirs.
    const double low = triangle.height.minCoeff(), high = triangle.height.maxCoeff();
    if (low > 2 * (high - low) || high < -2 * (high - low)) continue;
    for (int j = 0; j < parts; ++j)
      for (int i = 0; i + j < parts; ++i) {
        if (const auto s = triangle.segment({at(i, j), at(i + 1, j), at(i, j + 1)}))
          segments.push_back(*s);
        if (i + j + 1 == parts) continue;
        if (const auto s = triangle.segment({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}))
          segments.push_back(*s);
      }
  }
  return segments;
}

// Takes away the segment with the end nearest to x and gives its other end; empty when none is near.
std::optional<Crossing> next(std::vector<Segment>& segments, const Vector3d& x, double near) {
  double least = near * near;
  std::size_t best = segments.size();
  int end = 0;
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (int e = 0; e < 2; ++e)
      if (const double d = (segments[s][e].x - x).squaredNorm(); d < least) {
        least = d;
        best = s;
        end = e;
      }
  if (best == segments.size()) return {};
  const Crossing other = segments[best][1 - end];
  segments[best] = segments.back();
  segments.pop_back();
  return other;
}

CrossSection curve_of(const std::vector<Crossing>& chain) {
  CrossSection curve{Eigen::Matrix3Xd(3, chain.size()), Eigen::VectorXd(chain.size())};
  for (std::size_t i = 0; i < chain.size(); ++i) {
    curve.points.col(Eigen::Index(i)) = chain[i].x;
    curve.values[Eigen::Index(i)] = chain[i].value;
  }
  return curve;
}

}  // namespace

std::vector<CrossSection> cross_section(const CurvedMesh& mesh, const Eigen::VectorXd& field,
                                        const Vector3d& point, const Vector3d& normal) {
  const Eigen::VectorXd heights =
      (normal.normalized().transpose() * (mesh.nodes.colwise() - point)).transpose();
  std::vector<Segment> segments = segments_of(mesh, field, heights);
  const double near =
      1e-7 * (mesh.nodes.rowwise().maxCoeff() - mesh.nodes.rowwise().minCoeff()).norm();
  std::vector<CrossSection> curves;
  while (!segments.empty()) {
    std::vector<Crossing> chain{segments.back()[0], segments.back()[1]};
    segments.pop_back();
    while (const auto more = next(segments, chain.back().x, near)) chain.push_back(*more);
    chain.push_back(chain.front());
    curves.push_back(curve_of(chain));
  }
  return curves;
}

}  // namespace sbeh::meshing
