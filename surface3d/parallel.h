// Loops over triangles on all threads, with results that do not depend on how many there are.
#pragma once

#include "surface3d/linear/in_parallel.h"
#include "surface3d/surface.h"

#include <vector>

namespace sbeh::surface3d {

/// Calls visit(e) for every triangle, from several threads; those with a node in common one after the
/// other and always in the same order, so that visit may add to what belongs to the nodes of e.
template <class Visit>
void for_each_by_colour(const Triangulation& mesh, Visit&& visit) {
  for (const auto& patches : mesh.colours)
    in_parallel(
        int(patches.size()),
        [&](int k) {
          for (const int e : patches[std::size_t(k)]) visit(e);
        },
        1);
}

/// What each rank has added up on its own triangles becomes the sum over all.
template <class Derived>
void sum_over_ranks(const Triangulation& mesh, Eigen::PlainObjectBase<Derived>& x) {
  mesh.ranks.sum({x.data(), std::size_t(x.size())});
}
inline void sum_over_ranks(const Triangulation& mesh, SparseMatrix& A) {
  mesh.ranks.sum({A.valuePtr(), std::size_t(A.nonZeros())});
}

/// Σ of N numbers for each triangle, which are computed in parallel and summed up one after the other.
template <int N>
Eigen::Array<double, N, 1> sum_over_triangles(const Triangulation& mesh, auto&& on_triangle) {
  using Sum = Eigen::Array<double, N, 1>;
  std::vector<Sum> sums(mesh.own.size(), Sum::Zero());
  in_parallel(int(mesh.own.size()),
              [&](int k) { sums[std::size_t(k)] = on_triangle(mesh.own[std::size_t(k)]); });
  Sum total = Sum::Zero();
  for (const Sum& sum : sums) total += sum;
  sum_over_ranks(mesh, total);
  return total;
}

/// ∫ density dS, of N numbers; density(e) is a function of shape values and surface point on the triangle e.
template <int N, class Density>
Eigen::Array<double, N, 1> integrate(const Triangulation& mesh, const Nodes& X,
                                     std::span<const ShapeValues> points, Density&& density) {
  return sum_over_triangles<N>(mesh, [&](int e) {
    const ElementNodes local = on_element(mesh, e, X);
    const auto on_triangle = density(e);
    Eigen::Array<double, N, 1> sum = decltype(sum)::Zero();
    for (const ShapeValues& s : points) {
      const SurfacePoint p = surface_point(local, s);
      sum += p.dS * on_triangle(s, p);
    }
    return sum;
  });
}

}  // namespace sbeh::surface3d
