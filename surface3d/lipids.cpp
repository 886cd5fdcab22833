#include "surface3d/lipids.h"

#include "surface3d/parallel.h"

#include <cmath>

namespace sbeh::surface3d {

namespace {

double lipid_area(const Triangulation& mesh, const model::Material& material, const State& state) {
  return integrate<1>(mesh, state.X, diagnostic_points(), [&](int e) {
    return [&material, beta = on_element(mesh, e, state.beta)](const ShapeValues& s,
                                                               const SurfacePoint&) {
      return Eigen::Array<double, 1, 1>(material.packing(value_at(beta, s)));
    };
  })[0];
}

}  // namespace

Target lipids_and_volume(const Triangulation& mesh, const model::Material& material,
                         const State& state) {
  Target target = area_and_volume(mesh, state.X);
  if (material.has_lipid_density()) target.area = lipid_area(mesh, material, state);
  return target;
}

bool correct_lipids_volume(const Triangulation& mesh, const model::Material& material,
                           const Field& H, const Target& target, State& state) {
  if (!material.has_lipid_density())
    return correct_area_volume(mesh, state.X, H, target.area, target.volume);
  constexpr int most_steps = 20;
  for (int step = 0; step < most_steps; ++step) {
    const double now = lipid_area(mesh, material, state), miss = target.area - now;
    const bool is_met = std::abs(miss) < 1e-12 * target.area;
    if (!correct_area_volume(mesh, state.X, H, area(mesh, state.X) * (1 + miss / now),
                             target.volume))
      return false;
    if (is_met) return true;
  }
  return false;
}

Field lipid_load(const Triangulation& mesh, const model::Material& material, const State& at,
                 const Motion& motion) {
  Field load = Field::Zero(mesh.quadratic_nodes);
  for_each_by_colour(mesh, [&](int e) {
    const ElementNodes X = on_element(mesh, e, at.X);
    const ElementField beta = on_element(mesh, e, at.beta);
    const OrderRate rate(mesh, motion, e);
    Eigen::Matrix<double, 6, 1> local = decltype(local)::Zero();
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(X, s);
      local += p.dS * material.packing_slope(value_at(beta, s)) * rate.at(s, p)
             * Shapes(s.quadratic.data()).head<6>();
    }
    for (int a = 0; a < 6; ++a) load[mesh.quadratic(a, e)] += local[a];
  });
  sum_over_ranks(mesh, load);
  return load;
}

}  // namespace sbeh::surface3d
