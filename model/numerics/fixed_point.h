// Fixed points of maps that are affine, or nearly so.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

namespace sbeh::model {

/// What counts as a fixed point: |F(x) − x| <= relative |F(x)| + absolute.
struct FixedPointTolerance {
  double relative, absolute;
  int most_steps = 40;
};

/// x = F(x) by Anderson's acceleration with all values so far (J. ACM 12, 547, 1965), from the x given. For an affine F this is
/// GMRES on x − F(x), which no contraction is needed for. At the end F has been evaluated at x last. False where F has no
/// value (an empty vector) or the tolerance is not met.
template <class Map>
[[nodiscard]] bool find_fixed_point(Map&& F, const FixedPointTolerance& tolerance,
                                    Eigen::VectorXd& x) {
  Eigen::MatrixXd changes(x.size(), 0), of_values(x.size(), 0);  // of F(x) − x and of F(x)
  Eigen::VectorXd excess, value;
  for (int step = 0; step < tolerance.most_steps; ++step) {
    const Eigen::VectorXd next = F(x);
    if (next.size() == 0 || !next.allFinite()) return false;
    const Eigen::VectorXd over = next - x;
    if (over.norm() <= tolerance.relative * next.norm() + tolerance.absolute) return true;
    if (step > 0) {
      changes.conservativeResize(Eigen::NoChange, step);
      of_values.conservativeResize(Eigen::NoChange, step);
      changes.col(step - 1) = over - excess;
      of_values.col(step - 1) = next - value;
    }
    excess = over;
    value = next;
    x = value;
    if (step > 0) x -= of_values * changes.colPivHouseholderQr().solve(excess);
  }
  return false;
}

}  // namespace sbeh::model
