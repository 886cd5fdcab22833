// Zeros of a function of one variable.
#pragma once

#include <functional>

namespace sbeh::model {

using Function = std::function<double(double)>;

struct Bracket {
  double low, high;
  double middle() const { return (low + high) / 2; }
};

/// The zero of f between low and high, where its signs differ or it vanishes, to about 2^(1 - bits) of
/// itself (algorithm 748). Throws std::domain_error where the signs are the same.
Bracket root_between(const Function& f, double low, double high, int bits = 52);

/// The zero of f next to a and b, by secants: where f is smooth and not known farther away. The last value
/// computed is the one there. `tolerance` is that of the last change.
double root_near(double a, double b, const Function& f, double tolerance);

}  // namespace sbeh::model
