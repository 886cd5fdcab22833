#include "model/numerics/profile.h"

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

}  // namespace

bool meets_itself(const Eigen::Matrix2Xd& polygon) {
  for (Eigen::Index i = 0; i + 1 < polygon.cols(); ++i)
    for (Eigen::Index j = i + 2; j + 1 < polygon.cols(); ++j)
      if (segments_meet(polygon.col(i), polygon.col(i + 1), polygon.col(j), polygon.col(j + 1)))
        return true;
  return false;
}

}  // namespace sbeh::model
