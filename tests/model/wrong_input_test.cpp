// What model/ refuses, and with which words.
#include "model/material.h"
#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace sbeh::model {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// The message with which validate() refuses the changed default material, or "accepted".
std::string refusal(const std::function<void(Material&)>& change) {
  Material m;
  change(m);
  try {
    m.validate();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Material, that_is_wrong_is_refused_with_name_value_and_constraint) {
  EXPECT_EQ(refusal([](Material& m) { m.L1 = 0; }),
            "6 L1 + L2 + L3 = 0: must be > 0 (distortion energy)");
  EXPECT_EQ(refusal([](Material& m) { m.L1 = 0.125, m.L2 = -1; }),
            "6 L1 + L2 + L3 = -0.25: must be > 0 (distortion energy)");
  EXPECT_EQ(refusal([](Material& m) { m.L1 = 0.5, m.L2 = -1.5; }),
            "2 L1 + L2 + L3 = -0.5: must be >= 0 (bending energy)");
  EXPECT_EQ(refusal([](Material& m) { m.viscosity = -1; }), "viscosity = -1: must be >= 0");
  EXPECT_EQ(refusal([](Material& m) { m.immobility = 0; }), "immobility = 0: must be > 0");
  EXPECT_EQ(refusal([](Material& m) { m.friction_tangential = -0.1; }),
            "friction_tangential = -0.1: must be >= 0");
  EXPECT_EQ(refusal([](Material& m) { m.friction_normal = -0.1; }),
            "friction_normal = -0.1: must be >= 0");
  EXPECT_EQ(refusal([](Material& m) { m.viscosity = m.friction_tangential = 0; }),
            "viscosity + friction_tangential = 0: must be > 0 (else nothing resists the flow)");
  EXPECT_EQ(refusal([](Material& m) { m.residual_stiffness = -2; }),
            "residual_stiffness = -2: must be >= 0");
}

TEST(Material, that_is_not_finite_is_refused_with_name_and_value) {
  struct Member {
    std::string name;
    double Material::*value;
  };
  const std::vector<Member> members{
      {"L1", &Material::L1},
      {"L2", &Material::L2},
      {"L3", &Material::L3},
      {"viscosity", &Material::viscosity},
      {"immobility", &Material::immobility},
      {"friction_tangential", &Material::friction_tangential},
      {"friction_normal", &Material::friction_normal},
      {"order_viscosity", &Material::order_viscosity},
      {"residual_stiffness", &Material::residual_stiffness},
      {"spontaneous_curvature", &Material::spontaneous_curvature},
  };
  for (const auto& member : members)
    for (const double bad : {nan, infinity}) {
      const std::string& name = member.name;
      const std::string message = refusal([&](Material& m) { m.*(member.value) = bad; });
      EXPECT_NE(message.find(name), std::string::npos) << name << ": " << message;
      EXPECT_NE(message.find(bad == infinity ? "= inf:" : "= nan:"), std::string::npos)
          << name << ": " << message;
    }
}

TEST(Material, may_have_no_friction_or_no_viscosity) {
  EXPECT_EQ(refusal([](Material& m) { m.friction_tangential = m.friction_normal = 0; }),
            "accepted");
  EXPECT_EQ(refusal([](Material& m) { m.viscosity = 0; }), "accepted");
}

TEST(Material, must_have_an_elastic_energy_bounded_below_in_the_curvatures) {
  // (κ/2)H² + κ_G K is a form in the two principal curvatures.
  EXPECT_EQ(refusal([](Material& m) { m.L2 = -0.1; }),
            "2 L1 + 2 L2 + L3 = -0.1: must be >= 0 (Gaussian energy)");
  EXPECT_EQ(refusal([](Material& m) { m.L3 = -0.15; }),
            "2 L1 + L2 + L3 = -0.04999999999999999: must be >= 0 (bending energy)");
}

TEST(Potential, that_is_not_finite_is_refused_with_the_place_of_the_coefficient) {
  for (const double bad : {nan, infinity}) {
    try {
      const Potential refused({0, 1, bad});
      FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(), "coefficient 2 is not finite");
    }
  }
}

TEST(Elements, are_of_order_1_to_3) {
  for (const int order : {-1, 0, 4}) {
    EXPECT_THROW(IntervalElement{order}, std::invalid_argument);
    EXPECT_THROW(TriangleElement{order}, std::invalid_argument);
  }
}

TEST(Quadrature, needs_a_point_and_a_degree) {
  for (const int n : {-1, 0}) EXPECT_THROW(gauss_rule(n), std::invalid_argument);
  EXPECT_THROW(triangle_rule(-1), std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::model
