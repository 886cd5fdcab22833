// Minima of the bending energy of spectral curves: Ceres from afar, Newton's method to rounding.
#pragma once

#include "axisym/classical_shape.h"
#include "axisym/spectral/newton.h"

#include <numbers>

namespace sbeh::axisym::spectral {

/// A minimum of F/κ that is of the class asked for.
struct ClassicalMinimum {
  double reduced_volume;
  Problem problem;
  Critical state;

  Curve curve() const { return curve_of(problem, state.y); }
  double reduced_energy() const { return state.energy / (8 * std::numbers::pi); }  ///< F/(8πκ)
  double tension() const { return state.multipliers[0]; }
  double pressure() const { return -state.multipliers[1]; }
};

/// The basis on which a shape is computed: the points gather at a stomatocyte's narrow rim.
std::shared_ptr<const Basis> basis_for(Branch branch, double reduced_volume, int cutoff);

/// Newton's method on the basis of `start`. Empty unless it ends in a minimum of this class.
std::optional<ClassicalMinimum> sharpen(Branch branch, double reduced_volume, const Curve& start);

/// Least squares on a coarse basis from a spheroid, or from a sphere with an invagination; then Newton's
/// method with as many modes as it takes for the last coefficients to be below 1e-11.
std::optional<ClassicalMinimum> minimum(Branch branch, double reduced_volume);
/// The same from a shape of the branch at another volume, in as many steps as it takes.
std::optional<ClassicalMinimum> minimum_along(Branch branch, double reduced_volume,
                                              double start_volume, Curve start);

/// Largest coefficient among the last tenth of the modes.
double tail(const Eigen::VectorXd& coefficients);

/// Whether a curve is of the class: oblate and prolate by which axis is longer, symmetric top to bottom;
/// stomatocyte if the first pole is invaginated, the last one is not.
bool is_of_class(Branch branch, const Curve& curve);

}  // namespace sbeh::axisym::spectral
