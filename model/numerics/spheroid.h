// Spheroids with semi-axes 1, 1 and q, oblate (q < 1) or prolate.
#pragma once

namespace sbeh::model {

/// For q > 1e-8; within 1e-12 of 1 that of the sphere.
double spheroid_area(double q);
double spheroid_reduced_volume(double q);
/// The q of this reduced volume, 0 < V_r <= 1.
double spheroid_axis_ratio(double reduced_volume, bool prolate);

}  // namespace sbeh::model
