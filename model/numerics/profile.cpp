#include "model/numerics/profile.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace sbeh::model {

using Eigen::Vector2d;

namespace {

// On which side of the line a–b is c?
double side(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool segments_meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const bool boxes_meet = (a.cwiseMin(b).array() <= c.cwiseMax(d).array()).all()
                       && (c.cwiseMin(d).array() <= a.cwiseMax(b).array()).all();
  return boxes_meet && side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

// Sides that are neighbours on the polygon, in one box.
constexpr Eigen::Index stretch = 16;
std::vector<Eigen::AlignedBox2d> boxes_of_stretches(const Eigen::Matrix2Xd& polygon) {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (Eigen::Index i = 0; i + 1 < polygon.cols(); i += stretch) {
    const auto points = polygon.middleCols(i, std::min(stretch + 1, polygon.cols() - i));
    boxes.emplace_back(points.rowwise().minCoeff(), points.rowwise().maxCoeff());
  }
  return boxes;
}

bool stretches_meet(const Eigen::Matrix2Xd& p, Eigen::Index first, Eigen::Index second) {
  const Eigen::Index last = p.cols() - 1;
  for (Eigen::Index i = first; i < std::min(first + stretch, last); ++i)
    for (Eigen::Index j = std::max(second, i + 2); j < std::min(second + stretch, last); ++j)
      if (segments_meet(p.col(i), p.col(i + 1), p.col(j), p.col(j + 1))) return true;
  return false;
}

}  // namespace

bool meets_itself(const Eigen::Matrix2Xd& polygon) {
  const auto boxes = boxes_of_stretches(polygon);
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = a; b < boxes.size(); ++b)
      if (boxes[a].intersects(boxes[b])
          && stretches_meet(polygon, Eigen::Index(a) * stretch, Eigen::Index(b) * stretch))
        return true;
  return false;
}

}  // namespace sbeh::model
