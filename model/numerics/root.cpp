#include "model/numerics/root.h"

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>

namespace sbeh::model {

Bracket root_between(const Function& f, double low, double high, int bits) {
  std::uintmax_t iterations = 200;
  const auto [a, b] = boost::math::tools::toms748_solve(
      f, low, high, boost::math::tools::eps_tolerance<double>(bits), iterations);
  return {a, b};
}

double root_near(double a, double b, const Function& f, double tolerance) {
  constexpr int most_iterations = 20;
  double fa = f(a), fb = f(b);
  for (int i = 0; i < most_iterations && std::abs(b - a) > tolerance && fb != fa; ++i) {
    const double next = b - fb * (b - a) / (fb - fa);
    a = b, fa = fb;
    b = next, fb = f(b);
  }
  return b;
}

}  // namespace sbeh::model
