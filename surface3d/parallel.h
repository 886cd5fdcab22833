// Loops over triangles on all threads, with results that do not depend on how many there are.
#pragma once

#include "surface3d/surface.h"

#include <functional>
#include <vector>

namespace sbeh::surface3d {

/// Calls visit(i) for 0 … count − 1, from several threads and in any order.
void in_parallel(int count, const std::function<void(int)>& visit);

/// ∫ density(e, shape values, surface point) dS, of N numbers: the triangles are summed up one after
/// the other.
template <int N, class Density>
Eigen::Array<double, N, 1> integrate(const Triangulation& mesh, const Nodes& X,
                                     std::span<const ShapeValues> points, Density&& density) {
  using Sum = Eigen::Array<double, N, 1>;
  std::vector<Sum> sums(std::size_t(mesh.count()), Sum::Zero());
  in_parallel(mesh.count(), [&](int e) {
    const ElementNodes local = on_element(mesh, e, X);
    for (const ShapeValues& s : points) {
      const SurfacePoint p = surface_point(local, s);
      sums[std::size_t(e)] += p.dS * density(e, s, p);
    }
  });
  Sum total = Sum::Zero();
  for (const Sum& sum : sums) total += sum;
  return total;
}

/// The sparse (P3, P3) matrix and the right-hand sides of a system; `element(e, matrix, vectors)` has to
/// fill in the parts of the triangle e.
template <int Columns>
struct ScalarSystem {
  using Vectors = Eigen::Matrix<double, 10, Columns>;
  using Matrix = Eigen::Matrix<double, 10, 10>;
  SparseMatrix matrix;
  Eigen::Matrix<double, Eigen::Dynamic, Columns> rhs;  // nodes x columns

  template <class Element>
  ScalarSystem(const Triangulation& mesh, Element&& element)
      : matrix(mesh.scalars.zero()), rhs(decltype(rhs)::Zero(mesh.nodes, Columns)) {
    struct Piece {
      Matrix matrix = Matrix::Zero();
      Vectors vectors = Vectors::Zero();
    };
    std::vector<Piece> pieces(std::size_t(mesh.count()));
    in_parallel(mesh.count(), [&](int e) {
      Piece& piece = pieces[std::size_t(e)];
      element(e, piece.matrix, piece.vectors);
    });
    for (int e = 0; e < mesh.count(); ++e) {
      const Piece& piece = pieces[std::size_t(e)];
      mesh.scalars.add(e, piece.matrix, matrix);
      for (int a = 0; a < 10; ++a) rhs.row(mesh.triangles(a, e)) += piece.vectors.row(a);
    }
  }
};

}  // namespace sbeh::surface3d
