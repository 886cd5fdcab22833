// How fast a membrane comes to rest, and below which speed it is there.
#pragma once

#include "model/material.h"

namespace sbeh::model {

/// The rate at which a nearly spherical membrane of size 1 relaxes, up to a factor of shape: the smaller
/// one of its shape, κ over the drag on the mode l = 2, and, where the order is free, of the order, its
/// stiffness over m_β; at the order that rests on the sphere, full order where none does. With all
/// energies it grows, with all viscosities and frictions it falls in proportion.
double relaxation_rate(const Material& material, Model model);

/// The speed below which a membrane is at rest, where it is `rest_speed` for one of the default material
/// with free order: in proportion to the relaxation rate.
double speed_at_rest(double rest_speed, const Material& material, Model model);

}  // namespace sbeh::model
