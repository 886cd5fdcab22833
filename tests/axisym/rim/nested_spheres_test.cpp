// The limit of ordered stomatocytes: its spheres, and that shapes on ever narrower necks come as near to it as one likes.
#include "axisym/rim/nested_spheres.h"

#include "axisym/diagnostics.h"
#include "model/energy_density.h"
#include "tests/axisym/cases.h"

#include <Eigen/Dense>

namespace sbeh::axisym {
namespace {

using namespace test;

struct At {
  double v, L;
};
constexpr std::array<At, 6> points{
    {{0.55, 0.0155}, {0.35, 0.005}, {0.6, 0.001}, {0.6, 0.05}, {0.75, 0.02}, {0.9, 0.01}}};

TEST(NestedSpheres, have_the_area_the_volume_and_each_its_order_of_least_energy) {
  for (const auto& [v, L] : points) {
    SCOPED_TRACE(testing::Message() << "V_r = " << v << ", L = " << L);
    const auto [outer, inner] = nested_radii(v);
    EXPECT_NEAR(outer * outer + inner * inner, 1, 1e-14);
    EXPECT_NEAR(std::pow(outer, 3) - std::pow(inner, 3), v, 1e-14);
    const RimRecord row = nested_spheres({}, v, L);
    EXPECT_NEAR(area(row.state.X), 4 * pi, 1e-5);
    EXPECT_NEAR(volume(row.state.X), 4 * pi / 3 * v, 1e-5);
    double energy = 0;
    for (const auto& [R, inside] : {std::pair{outer, false}, {inner, true}}) {
      const OrderedSphere sphere = ordered_sphere(paper_material(L), R, inside);
      // 60.75β² − 40.5β + 9L/R² = 0: model/order_step.h, with the radius
      EXPECT_NEAR(60.75 * sphere.order * sphere.order - 40.5 * sphere.order + 9 * L / (R * R), 0,
                  1e-12);
      energy += 4 * pi * R * R * sphere.energy;
    }
    EXPECT_NEAR(row.energy, energy, 1e-13);
    EXPECT_LT(row.energy, 16 * pi * L - 4 * pi);  // full order is one of those
  }
}

TEST(NestedSpheres, melt_the_inner_one_where_it_is_too_small_for_any_order) {
  const double v = 0.9, L = 0.07;
  const double inner = nested_radii(v).inner;
  EXPECT_GT(L / (inner * inner), 0.75);
  const OrderedSphere sphere = ordered_sphere(paper_material(L), inner, true);
  EXPECT_EQ(sphere.order, 0);
  EXPECT_EQ(sphere.energy, 0);
}

TEST(NestedSpheres, know_which_way_the_spontaneous_curvature_bends) {
  Material material = paper_material(0.05);
  material.spontaneous_curvature = -2 / 0.8;  // of a sphere of radius 0.8, its normal outward
  EXPECT_LT(ordered_sphere(material, 0.8, false).energy,
            ordered_sphere(material, 0.8, true).energy);
  material.spontaneous_curvature *= -1;
  EXPECT_GT(ordered_sphere(material, 0.8, false).energy,
            ordered_sphere(material, 0.8, true).energy);
}

TEST(NestedSpheres, have_the_pressure_of_their_energy_by_volume) {
  OrderTable table("central difference of U by V against P", "dv");
  for (const double dv : {4e-2, 2e-2, 1e-2})
    table.add(
        dv, (nested_spheres({}, 0.6 + dv, 0.05).energy - nested_spheres({}, 0.6 - dv, 0.05).energy)
                    / (8 * pi / 3 * dv)
                - nested_spheres({}, 0.6, 0.05).pressure);
  EXPECT_NEAR(table.print(), 2, 0.1);
}

TEST(NestedSpheres, are_refused_where_there_are_none) {
  for (const double v : {-0.1, 0., 1., 1.5})
    EXPECT_THROW(nested_spheres({}, v, 0.05), std::invalid_argument) << v;
}

// ---- caps on a ring ----------------------------------------------------------------------------------------

// A sphere without a cap of angular radius `hole`, its edge a ring of radius a.
struct Cap {
  double R, hole;
  double area() const { return 2 * pi * R * R * (1 + std::cos(hole)); }
  double volume() const {  // closed by a disc across the ring
    const double c = std::cos(hole);
    return pi / 3 * R * R * R * (1 + c) * (1 + c) * (2 - c);
  }
};

// Its energy, β rising from 0 at the ring with the logarithm of the angle, to the value of the whole sphere at `layer`.
double energy_of(const Cap& cap, const Material& material, double layer, bool inside) {
  const double rest = ordered_sphere(material, cap.R, inside).order, H = (inside ? 2 : -2) / cap.R;
  const double span = std::log(layer / cap.hole);
  const auto density = [&](double beta, double slope) {  // slope: by the angle
    return model::energy_density(material, beta, slope * slope / (cap.R * cap.R), H,
                                 1 / (cap.R * cap.R))
        .total();
  };
  constexpr int intervals = 40000;  // of the logarithm x, midpoints
  double energy = 2 * pi * cap.R * cap.R * (1 + std::cos(layer)) * density(rest, 0);
  for (int k = 0; k < intervals; ++k) {
    const double x = (k + 0.5) / intervals, angle = cap.hole * std::exp(span * x);
    energy += 2 * pi * cap.R * cap.R * std::sin(angle) * angle * span / intervals
            * density(rest * x, rest / (span * angle));
  }
  return energy;
}

// Both caps on a ring of radius a, with the area 4π and the reduced volume.
std::array<Cap, 2> caps_on(double a, double v) {
  const auto [outer, inner] = nested_radii(v);
  Eigen::Vector2d R(outer, inner);
  const auto caps = [&](const Eigen::Vector2d& radii) {
    return std::array{Cap{radii[0], std::asin(a / radii[0])},
                      Cap{radii[1], std::asin(a / radii[1])}};
  };
  const auto miss = [&](const Eigen::Vector2d& radii) {
    const auto [o, i] = caps(radii);
    return Eigen::Vector2d(o.area() + i.area() - 4 * pi, o.volume() - i.volume() - 4 * pi / 3 * v);
  };
  for (int iteration = 0; iteration < 20; ++iteration) {
    Eigen::Matrix2d J;
    constexpr double h = 1e-6;
    for (int k = 0; k < 2; ++k)
      J.col(k) = (miss(R + h * Eigen::Vector2d::Unit(k)) - miss(R - h * Eigen::Vector2d::Unit(k)))
               / (2 * h);
    R -= J.inverse() * miss(R);
  }
  EXPECT_LT(miss(R).norm(), 1e-10);
  return caps(R);
}

// β vanishes at the ring, where the tangent turns: a kink, at no cost. The distortion is the price of it, and what the layer
// of width √L costs besides is about u″/(6 ln(√L/a)) of that.
TEST(NestedSpheres, are_approached_by_caps_on_a_shrinking_ring_at_the_price_of_the_distortion) {
  for (const auto& [v, L] : points) {
    SCOPED_TRACE(testing::Message() << "V_r = " << v << ", L = " << L);
    const Material material = paper_material(L);
    const double limit = nested_spheres({}, v, L).energy, width = std::sqrt(L);
    double before = std::numeric_limits<double>::infinity();
    for (const double share : {0.3, 0.1, 0.03, 0.01, 1e-3, 1e-5, 1e-8, 1e-16, 1e-32, 1e-64}) {
      const auto caps = caps_on(share * width, v);
      double energy = 0, price = 0;
      for (const bool inside : {false, true}) {
        const Cap& cap = caps[inside ? 1 : 0];
        energy += energy_of(cap, material, width / cap.R, inside);
        price += 1.5 * pi * L * std::pow(ordered_sphere(material, cap.R, inside).order, 2)
               / std::log(1 / share);
      }
      std::printf("  V_r %.2f L %.4f a %.0e: U - limit = %.3e, distortion %.3e\n", v, L,
                  share * width, energy - limit, price);
      EXPECT_GT(energy, limit) << share;
      EXPECT_LT(energy, before) << share;
      if (share < 1e-2) {
        EXPECT_NEAR((energy - limit) / price, 1, 27. / 6 / std::log(1 / share)) << share;
      }
      before = energy;
    }
  }
}

}  // namespace
}  // namespace sbeh::axisym
