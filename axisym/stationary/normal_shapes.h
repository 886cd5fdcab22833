// Fields that live on the node normals: Σ f_i φ_i n_i, with the P3 shape functions φ_i.
#pragma once

#include "axisym/curve.h"

namespace sbeh::axisym {

/// Shape values of element e at a point times a component of the node normals n; d = derivative by the element's
/// coordinate.
struct NormalShapes {
  std::array<double, 4> r, z, dr, dz;
  NormalShapes(const Nodes& n, int e, const ShapeValues& s) {
    for (std::size_t a = 0; a < 4; ++a) {
      const auto node = n.col(3 * e + int(a));
      r[a] = s.phi[a] * node[0];
      z[a] = s.phi[a] * node[1];
      dr[a] = s.dphi[a] * node[0];
      dz[a] = s.dphi[a] * node[1];
    }
  }
};

}  // namespace sbeh::axisym
