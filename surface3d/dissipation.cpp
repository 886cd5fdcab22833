#include "surface3d/dissipation.h"

#include "surface3d/parallel.h"

namespace sbeh::surface3d {

Dissipation dissipation_of(const Triangulation& mesh, const model::Material& m, const State& at,
                           const Motion& motion) {
  const auto sum = integrate<3>(mesh, at.X, assembly_points(), [&](int e) {
    return
        [&m, rate = OrderRate(mesh, motion, e), velocities = on_element(mesh, e, motion.velocity),
         orders = on_element(mesh, e, at.beta)](const ShapeValues& s, const SurfacePoint& p) {
          const Eigen::Vector3d V = value_at(velocities, s);
          const double V_n = V.dot(p.nu()), beta_dot = rate.at(s, p), beta = value_at(orders, s);
          const model::Gradient<double> grad_V = p.frame.transpose() * gradient_at(velocities, p);
          return Eigen::Array3d(
              m.friction_tangential * (V.squaredNorm() - V_n * V_n) + m.friction_normal * V_n * V_n,
              m.order_drag(beta) * beta_dot * beta_dot,
              m.eta(beta) / 2 * model::rate_of_strain(grad_V).squaredNorm());
        };
  });
  return {.friction = sum[0], .order = sum[1], .viscous = sum[2]};
}

}  // namespace sbeh::surface3d
