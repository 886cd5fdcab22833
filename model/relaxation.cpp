#include "model/relaxation.h"

#include "model/order_step.h"

#include <algorithm>
#include <cmath>

namespace sbeh::model {

double relaxation_rate(const Material& material, Model model) {
  const Material m = effective(material, model);
  const double order =
      has_free_order(model) ? sphere_rest_order(m).value_or(full_order) : full_order;
  const double eta = std::max(m.eta(order), m.eta(0));  // the order may melt, or switch η off
  const double drag = m.friction_normal + 2. / 3 * m.friction_tangential + 8. / 3 * eta;
  const double of_shape = m.kappa(order) / drag;
  if (!has_free_order(model)) return of_shape;
  const double excess = -2 - m.spontaneous_curvature;
  const double stiffness = m.kappa_secant(order) * excess * excess / 2 + m.kappa_gauss_secant(order)
                         + std::abs(m.potential.curvature(order));
  return std::min(of_shape, stiffness / m.order_drag());
}

double speed_at_rest(double rest_speed, const Material& material, Model model) {
  return rest_speed * relaxation_rate(material, model) / relaxation_rate({}, Model::SBEH);
}

}  // namespace sbeh::model
