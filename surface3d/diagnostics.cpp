#include "surface3d/diagnostics.h"

#include "model/energy_density.h"

#include <algorithm>
#include <cmath>

namespace sbeh::surface3d {

Energy energy(const Triangulation& mesh, const model::Material& material, const State& state,
              const Curvature& curvature) {
  Energy sum;
  for_each_point(
      mesh, state.X, diagnostic_points(), [&](int e, const ShapeValues& s, const SurfacePoint& p) {
        const double H = value_at(on_element(mesh, e, curvature.H), s);
        const ElementField beta = on_element(mesh, e, state.beta);
        const auto B = shape_operator(p, on_element(mesh, e, curvature.normals), H);
        const auto density =
            model::energy_density(material, value_at(beta, s), gradient_at(beta, p).squaredNorm(),
                                  H, model::gauss_curvature(B));
        sum.distortion += p.dS * density.distortion;
        sum.bending += p.dS * (density.bending + density.gaussian);
        sum.thermotropic += p.dS * density.thermotropic;
      });
  return sum;
}

}  // namespace sbeh::surface3d
