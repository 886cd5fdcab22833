#include "surface3d/stationary/point_density.h"

namespace sbeh::surface3d::at_point {

namespace {

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

}  // namespace

void add_box_product(double c, int first, const Raw& q, RawGradient& out) {
  const Eigen::Vector3d a1 = c * vector(q, raw_a1), a2 = c * vector(q, raw_a2),
                        w = vector(q, first), normal = a1.cross(vector(q, raw_a2));
  out.value += w.dot(normal);
  out.gradient.segment<3>(raw_a1) += a2.cross(w);
  out.gradient.segment<3>(raw_a2) += w.cross(a1);
  out.gradient.segment<3>(first) += normal;
}

void add_box_product(double c, int first, const Raw& q, RawDerivatives& out) {
  add_box_product(c, first, q, static_cast<RawGradient&>(out));
  const Eigen::Vector3d a1 = c * vector(q, raw_a1), a2 = c * vector(q, raw_a2),
                        w = vector(q, first);
  const auto add_pair = [&](int row, int column, const Eigen::Matrix3d& block) {
    out.hessian.block<3, 3>(row, column) += block;
    out.hessian.block<3, 3>(column, row) += block.transpose();
  };
  add_pair(raw_a1, raw_a2, cross_matrix(-c * w));
  add_pair(raw_a1, first, cross_matrix(a2));
  add_pair(raw_a2, first, cross_matrix(-a1));
}

namespace {

// The rate by H.
void add_slope_by_H(const Raw& q, RawGradient& out) {
  out.gradient[raw_H] +=
      vector(q, raw_Lambda).dot(Eigen::Vector3d(vector(q, raw_a1)).cross(vector(q, raw_a2)));
}

}  // namespace

void add_normal_part(const Raw& q, RawGradient& out) {
  add_box_product(q[raw_H], raw_Lambda, q, out);
  add_slope_by_H(q, out);
}

void add_normal_part(const Raw& q, RawDerivatives& out) {
  const Eigen::Vector3d a1 = vector(q, raw_a1), a2 = vector(q, raw_a2),
                        Lambda = vector(q, raw_Lambda);
  add_box_product(q[raw_H], raw_Lambda, q, out);
  add_slope_by_H(q, out);
  const auto add_pair = [&](int column, const Eigen::Vector3d& slope) {
    out.hessian.block<1, 3>(raw_H, column) += slope.transpose();
    out.hessian.block<3, 1>(column, raw_H) += slope;
  };
  add_pair(raw_Lambda, a1.cross(a2));
  add_pair(raw_a1, a2.cross(Lambda));
  add_pair(raw_a2, Lambda.cross(a1));
}

}  // namespace sbeh::surface3d::at_point
