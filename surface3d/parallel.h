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

}  // namespace sbeh::surface3d
