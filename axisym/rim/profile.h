// A state on elements graded towards the rim as a curve of the finite elements.
#pragma once

#include "axisym/curve.h"
#include "axisym/rim/path.h"

namespace sbeh::axisym::spectral {

/// The whole curve from pole to pole, three P3 elements for each of the rim mesh and side: nodes are exact,
/// what is between them is interpolated. The equator is at z = 0.
State profile_of(const RimProblem& problem, const Eigen::VectorXd& y);

}  // namespace sbeh::axisym::spectral
