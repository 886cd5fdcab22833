// The thermotropic potential u(β): energy per area that the lipids' order costs by itself.
#pragma once

#include "model/polynomial.h"

namespace sbeh::model {

/// u(β), any polynomial. Dimensionless energy per area; β is the scalar order.
class Potential : public Polynomial {
 public:
  using Polynomial::Polynomial;
  Potential() : Potential(landau_de_gennes()) {}

  /// The form of Landau and de Gennes, u(β) = (β²/8)(12a + 4bβ + 9cβ²), whose secant is (3/2)(2a + bβ + 3cβ²).
  /// The default arguments are the paper's: minimum u(2/3) = −1, critical point at 0.
  static Potential landau_de_gennes(double a = 0, double b = -27, double c = 13.5);
};

}  // namespace sbeh::model
