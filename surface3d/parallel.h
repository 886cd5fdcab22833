// Loops over triangles on all threads, with results that do not depend on how many there are.
#pragma once

#include "surface3d/linear/in_parallel.h"
#include "surface3d/surface.h"

#include <functional>
#include <vector>

namespace sbeh::surface3d {

/// Calls visit(e) for every triangle, from several threads; those with a node in common one after the
/// other and always in the same order, so that visit may add to what belongs to the nodes of e.
void for_each_by_colour(const Triangulation& mesh, const std::function<void(int)>& visit);

/// ∫ density dS, of N numbers; density(e) is a function of shape values and surface point on the triangle e.
/// The triangles are summed up one after the other.
template <int N, class Density>
Eigen::Array<double, N, 1> integrate(const Triangulation& mesh, const Nodes& X,
                                     std::span<const ShapeValues> points, Density&& density) {
  using Sum = Eigen::Array<double, N, 1>;
  std::vector<Sum> sums(std::size_t(mesh.count()), Sum::Zero());
  in_parallel(mesh.count(), [&](int e) {
    const ElementNodes local = on_element(mesh, e, X);
    const auto on_triangle = density(e);
    for (const ShapeValues& s : points) {
      const SurfacePoint p = surface_point(local, s);
      sums[std::size_t(e)] += p.dS * on_triangle(s, p);
    }
  });
  Sum total = Sum::Zero();
  for (const Sum& sum : sums) total += sum;
  return total;
}

/// The sparse (P3, P3) matrix and the right-hand side of a system; `element(e, matrix, vector)` has to
/// fill in the parts of the triangle e, and is called from several threads.
struct ScalarSystem {
  using Matrix = Eigen::Matrix<double, 10, 10>;
  SparseMatrix matrix;
  Field rhs;  // nodes

  template <class Element>
  ScalarSystem(const Triangulation& mesh, Element&& element)
      : matrix(mesh.scalars.zero()), rhs(Field::Zero(mesh.nodes)) {
    for_each_by_colour(mesh, [&](int e) {
      Matrix local = Matrix::Zero();
      ElementField vector = ElementField::Zero();
      element(e, local, vector);
      mesh.scalars.add(e, local, matrix);
      for (int a = 0; a < 10; ++a) rhs[mesh.triangles(a, e)] += vector[a];
    });
  }
};

}  // namespace sbeh::surface3d
