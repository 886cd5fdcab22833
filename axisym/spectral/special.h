// Special points of branches of spectral curves along V_r: where a symmetric state loses its up-down symmetry, and folds.
#pragma once

#include "axisym/spectral/newton.h"

#include <functional>

namespace sbeh::axisym::spectral {

/// A critical point at its reduced volume.
struct BranchPoint {
  double reduced_volume;
  Critical state;
};

/// A branch of critical points of one problem, each found from the last.
class Branchlet {
 public:
  Branchlet(Problem problem, Eigen::VectorXd start)
      : problem_(std::move(problem)), y_(std::move(start)) {}

  const Problem& problem() const { return problem_; }
  /// Empty where Newton's method does not converge from the last one, which stays.
  std::optional<Critical> at(double reduced_volume);

 private:
  Problem problem_;
  Eigen::VectorXd y_;
};

/// Of a symmetric problem's critical point: the lowest eigenvalue of the second variation by shapes and orders that are
/// odd under reflection.
double odd_stiffness(const Problem& symmetric, const Critical& state);

/// Where it vanishes along V_r, by secants from a and b. Empty where the branch is lost.
std::optional<BranchPoint> symmetry_loss(Branchlet& branch, double a, double b);

/// The fold of V_r near two critical points of one problem, which lie on the same branch before or beyond it, by secants
/// over planes across their difference. Empty where the branch is lost.
std::optional<BranchPoint> fold(const Problem& problem, const Critical& before,
                                const Critical& after);

}  // namespace sbeh::axisym::spectral
