// Area, volume and curvature integrals of curved meshes converge to exact ones.
#include "meshing/revolution.h"
#include "tests/meshing/cases.h"
#include "tests/order_table.h"

#include <gtest/gtest.h>

namespace sbeh::meshing {
namespace {

using namespace test;
using sbeh::test::OrderTable;

/// With P2 and P3 triangles all five errors are of the fourth order; this much of it must be seen
/// between the two finest meshes. The error of W2 is so small that it may pass through zero there:
/// it must be below h⁴.
constexpr double least_order = 3.5;

void expect_orders(const std::string& name, const Integrals& exact,
                   const std::function<CurvedMesh(const Resolution&)>& make, int order,
                   std::initializer_list<int> triangles = {320, 1280, 5120}) {
  std::array<OrderTable, 5> tables{
      OrderTable(name + ": area", "h"), OrderTable(name + ": volume", "h"),
      OrderTable(name + ": W2 = integral of H", "h"), OrderTable(name + ": integral of H^2", "h"),
      OrderTable(name + ": integral of K", "h")};
  double last_error_of_W2 = 0;
  for (const int count : triangles) {
    const Integrals found = integrals_of(make({.triangles = count, .order = order}));
    const double h = std::sqrt(20. / count);
    tables[0].add(h, found.area / exact.area - 1);
    tables[1].add(h, found.volume / exact.volume - 1);
    last_error_of_W2 = std::abs(found.H / exact.H - 1);
    tables[2].add(h, last_error_of_W2);
    tables[3].add(h, found.H_squared / exact.H_squared - 1);
    tables[4].add(h, found.K / exact.K - 1);
  }
  for (const std::size_t k : {0, 1, 3, 4})
    EXPECT_GT(tables[k].print(), least_order) << name << ' ' << k;
  tables[2].print();
  EXPECT_LT(last_error_of_W2, std::pow(20. / triangles.end()[-1], 2)) << name;
}

TEST(Integrals, of_the_exact_witness_have_their_closed_forms) {
  const Integrals s = exact_integrals([](const Point& n) { return n; }, 20);
  EXPECT_NEAR(s.area, 4 * pi, 1e-12);
  EXPECT_NEAR(s.volume, 4 * pi / 3, 1e-12);
  EXPECT_NEAR(s.H, -8 * pi, 1e-11);
  EXPECT_NEAR(s.H_squared, 16 * pi, 1e-11);
  for (const SphereImage& image : {SphereImage(y53_image), SphereImage(disc_image)}) {
    const Integrals coarse = exact_integrals(image, 100), fine = exact_integrals(image, 140);
    EXPECT_NEAR(fine.K, 4 * pi, 1e-9);
    EXPECT_NEAR(coarse.H_squared / fine.H_squared, 1, 1e-9);
  }
}

TEST(Integrals, of_the_sphere_converge) {
  const Integrals exact{4 * pi, 4 * pi / 3, -8 * pi, 16 * pi, 4 * pi};
  expect_orders("sphere, P3", exact, sphere, 3);
  expect_orders("sphere, P2", exact, sphere, 2);
}

TEST(Integrals, of_an_ellipsoid_converge) {
  const Integrals exact = exact_integrals([](const Point& n) -> Point {
    return {1.1 * n[0], 0.9 * n[1], 0.7 * n[2]};
  });
  const auto make = [](const Resolution& r) { return ellipsoid({1.1, 0.9, 0.7}, r); };
  expect_orders("ellipsoid, P3", exact, make, 3);
}

TEST(Integrals, of_the_Y53_surface_converge) {
  expect_orders("Y53, P3", exact_integrals(y53_image), y53, 3, {1280, 5120, 20480});
}

TEST(Integrals, of_a_revolved_biconcave_profile_converge) {
  constexpr int elements = 200;  // their own error is below 1e-8
  Profile profile{.X = Eigen::Matrix2Xd(2, 3 * elements + 1), .beta = {}};
  for (int i = 0; i <= 3 * elements; ++i) {
    const double theta = pi * i / (3 * elements), s = std::sin(theta), c = std::cos(theta);
    profile.X.col(i) << 1.2 * s, (0.2 + 0.5 * s * s) * c;
  }
  profile.X(0, 0) = profile.X(0, 3 * elements) = 0;
  const auto make = [&](const Resolution& r) { return revolved(profile, r).mesh; };
  expect_orders("revolved disc, P3", exact_integrals(disc_image), make, 3, {1280, 5120, 20480});
}

TEST(Y53, has_the_reduced_volume_of_the_paper) {
  const Integrals exact = exact_integrals(y53_image);
  EXPECT_NEAR(reduced_volume(exact.area, exact.volume), 0.7376, 5e-5);
  const CurvedMesh mesh = y53({.triangles = 5120});
  EXPECT_NEAR(reduced_volume(mesh), reduced_volume(exact.area, exact.volume), 1e-5);
}

}  // namespace
}  // namespace sbeh::meshing
