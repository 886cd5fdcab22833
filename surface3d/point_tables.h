// The geometry of a triangle at all points of a rule at once, by products with tables of the shape functions.
//
// A quantity at the points is a row. Rows are filled up to whole vector registers with copies of the first point that have the weight 0,
// so that they add nothing and nothing is divided by 0.
#pragma once

#include "surface3d/surface.h"

#include <cassert>

namespace sbeh::surface3d {

/// Of the P3 functions at `Points` points, a multiple of 8.
template <int Points>
struct PointTables {
  static_assert(Points % 8 == 0);
  static constexpr int filled = 16;  // ten functions
  using Row = Eigen::Array<double, 1, Points>;
  using Vectors = Eigen::Matrix<double, 3, Points, Eigen::RowMajor>;
  using Functions = Eigen::Matrix<double, 10, Points, Eigen::RowMajor>;
  /// Numbers for the ten functions, then zeros.
  template <int Rows>
  using Sums = Eigen::Matrix<double, Rows, filled, Eigen::RowMajor>;

  Row weights;
  Functions phi;
  std::array<Functions, 2> dphi;  ///< by the two reference coordinates

  explicit PointTables(std::span<const ShapeValues> points) {
    assert(points.size() <= std::size_t(Points));
    for (int q = 0; q < Points; ++q) {
      const bool is_point = std::size_t(q) < points.size();
      const ShapeValues& s = points[is_point ? std::size_t(q) : 0];
      weights[q] = is_point ? s.weight : 0;
      phi.col(q) = Shapes(s.phi.data());
      for (std::size_t k = 0; k < 2; ++k) dphi[k].col(q) = Shapes(s.dphi[k].data());
    }
    by_points_[0].leftCols(10) = phi.transpose();
    for (std::size_t k = 0; k < 2; ++k) by_points_[k + 1].leftCols(10) = dphi[k].transpose();
  }

  /// Values, and derivatives by the reference coordinate k, of what has these values at the nodes.
  Vectors values(const ElementNodes& x) const { return x.lazyProduct(phi); }
  Vectors slopes(const ElementNodes& x, int k) const { return x.lazyProduct(dphi[std::size_t(k)]); }
  Row values(const ElementField& f) const { return f.transpose().lazyProduct(phi).array(); }
  Row slopes(const ElementField& f, int k) const {
    return f.transpose().lazyProduct(dphi[std::size_t(k)]).array();
  }
  /// Σ f φ_a over the points, and Σ f ∂_k φ_a; f has the weights in it.
  template <int Rows, int Options>
  Sums<Rows> against(const Eigen::Matrix<double, Rows, Points, Options>& f) const {
    return f.lazyProduct(by_points_[0]);
  }
  template <int Rows, int Options>
  Sums<Rows> against_slopes(const Eigen::Matrix<double, Rows, Points, Options>& f, int k) const {
    return f.lazyProduct(by_points_[std::size_t(k) + 1]);
  }

 private:
  using ByPoints = Eigen::Matrix<double, Points, filled, Eigen::RowMajor>;
  std::array<ByPoints, 3> by_points_{ByPoints::Zero(), ByPoints::Zero(), ByPoints::Zero()};
};

/// Of the points of the assembly, and of those of the diagnostics.
inline const PointTables<32>& assembly_tables() {
  static const PointTables<32> tables(assembly_points());
  return tables;
}
inline const PointTables<56>& diagnostic_tables() {
  static const PointTables<56> tables(diagnostic_points());
  return tables;
}

/// x × y at each of the points.
template <class Vectors>
Vectors cross(const Vectors& x, const Vectors& y) {
  Vectors z;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    z.row(k) = x.row(i).cwiseProduct(y.row(j)) - x.row(j).cwiseProduct(y.row(i));
  }
  return z;
}

/// A triangle at the points of these tables.
template <int Points>
struct TrianglePoints {
  using Tables = PointTables<Points>;
  using Row = typename Tables::Row;
  using Vectors = typename Tables::Vectors;

  std::array<Vectors, 2> a;  ///< derivatives of the position by the reference coordinates
  Vectors normal;            ///< a1 × a2 = √g ν
  Row dS;                    ///< with the weights
  Row inverse_11, inverse_12, inverse_22;  ///< the metric gⁱʲ

  TrianglePoints(const Tables& tables, const ElementNodes& X)
      : a{tables.slopes(X, 0), tables.slopes(X, 1)}, normal(cross(a[0], a[1])) {
    const Row g = normal.colwise().squaredNorm().array();
    dS = g.sqrt() * tables.weights;
    inverse_11 = a[1].colwise().squaredNorm().array() / g;
    inverse_22 = a[0].colwise().squaredNorm().array() / g;
    inverse_12 = -a[0].cwiseProduct(a[1]).colwise().sum().array() / g;
  }
  /// gⁱʲ x_ij of a symmetric form by the reference coordinates.
  Row trace(const Row& x_11, const Row& x_12, const Row& x_22) const {
    return inverse_11 * x_11 + 2 * inverse_12 * x_12 + inverse_22 * x_22;
  }
  /// Its determinant by that of the metric.
  Row determinant(const Row& x_11, const Row& x_12, const Row& x_22) const {
    return (x_11 * x_22 - x_12 * x_12) * (inverse_11 * inverse_22 - inverse_12 * inverse_12);
  }
};

/// x·y at each of the points.
template <int Points>
Eigen::Array<double, 1, Points> dot(const Eigen::Matrix<double, 3, Points, Eigen::RowMajor>& x,
                                    const Eigen::Matrix<double, 3, Points, Eigen::RowMajor>& y) {
  return x.cwiseProduct(y).colwise().sum().array();
}

}  // namespace sbeh::surface3d
