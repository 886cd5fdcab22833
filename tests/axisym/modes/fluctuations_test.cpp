// Fluctuations of the contour: Milner and Safran's sphere, its extension by the order, and the sum over modes.
#include "axisym/modes/fluctuations.h"

#include "axisym/modes/eigenmodes.h"
#include "model/order_step.h"
#include "tests/axisym/modes/states.h"

namespace sbeh::axisym {
namespace {

using namespace test;
using model::Material;
using model::Model;

// Σ_l of the variances of real orthonormal harmonics cos mφ, at the equator.
template <class Variance>
double equator_sum(int m, Variance&& variance) {
  constexpr unsigned largest_l = 4000;  // beyond, less than 1e-12 of the sum
  double sum = 0;
  for (unsigned l = unsigned(std::max(m, 2)); l <= largest_l; ++l) {
    if ((int(l) - m) % 2 != 0) continue;
    const double Y = std::sph_legendre(l, unsigned(m), pi / 2);
    sum += (m == 0 ? 1 : 2) * Y * Y * variance(double(l));
  }
  return sum;
}

// S. T. Milner and S. A. Safran, Phys. Rev. A 36 (1987) 4371: ⟨|u_l|²⟩ = k_BT/((l − 1)(l + 2)(κ l(l + 1) + Σ)). As accurate
// as the eigenvalues are where the lowest ones count, and of fifth order at least where the waves are short.
TEST(Fluctuations, of_the_SSH_sphere_are_those_of_Milner_and_Safran) {
  constexpr int long_waves = 6, short_wave = 12;
  const Material material;
  const double kappa = material.kappa(model::full_order);
  for (const double tension : {0., 0.1, 2., -0.3}) {
    const auto exact = [&](double l) {
      return 1 / ((l - 1) * (l + 2) * (kappa * l * (l + 1) + tension));
    };
    OrderTable table("contour, m = 12", "1/elements");
    for (const auto& [elements, accuracy] : {std::pair{48, 2e-7}, {96, 1e-8}}) {
      const auto second = second_variation(
          material, Model::SSH,
          sphere_at_rest(material, Model::SSH, model::full_order, tension, elements));
      const auto error_of = [&](int m) {
        return contour_variance(second, m).value_or(0) / equator_sum(m, exact) - 1;
      };
      for (int m = 0; m <= long_waves; ++m)
        EXPECT_NEAR(error_of(m), 0, accuracy) << "m = " << m << ", tension " << tension;
      table.add(1. / elements, error_of(short_wave));
    }
    EXPECT_GT(table.print(), 5);
  }
}

// The variance of u where shape and order fluctuate together: an entry of the inverse of their form.
TEST(Fluctuations, of_the_SBEH_sphere_are_those_of_shape_and_order_together) {
  for (const double L : {0.01, 0.05}) {
    const Material material = Material{}.with_L(L);
    const double order = model::sphere_rest_order(material).value();
    const double kappa = material.kappa(order), tension = 0.05;
    const double curvature = (182.25 * order - 81) * order;  // u″ of the paper's potential
    const auto exact = [&](double l) {
      const double bend = (l - 1) * (l + 2), coupling = 9 * L * order * bend;
      const double stiffness = 1.5 * L * l * (l + 1) + 9 * L + curvature;
      return 1 / (bend * (kappa * l * (l + 1) + tension) - coupling * coupling / stiffness);
    };
    const auto second = second_variation(material, Model::SBEH,
                                         sphere_at_rest(material, Model::SBEH, order, tension, 96));
    for (int m = 0; m <= 6; ++m) {
      const auto found = contour_variance(second, m);
      ASSERT_TRUE(found);
      EXPECT_NEAR(*found / equator_sum(m, exact), 1, 1e-8) << "m = " << m << ", L = " << L;
    }
  }
}

}  // namespace
}  // namespace sbeh::axisym
