// Surfaces that come near themselves, and surfaces that do not.
#include "surface3d/mesh/self_contact.h"

#include "meshing/revolution.h"
#include "tests/surface3d/cases.h"
#include "tests/surface3d/sheared.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;

// A biconcave disc, r = 1.2 sin θ, z = (gap/2 + 0.5 sin² θ) cos θ: its poles are `gap` apart.
meshing::CurvedMesh disc(double gap, int triangles) {
  constexpr int elements = 60;
  meshing::Profile profile{.X = Eigen::Matrix2Xd(2, 3 * elements + 1), .beta = {}};
  for (int i = 0; i <= 3 * elements; ++i) {
    const double theta = pi * i / (3 * elements), s = std::sin(theta);
    profile.X.col(i) << (i % (3 * elements) == 0 ? 0 : 1.2 * s),
        (gap / 2 + 0.5 * s * s) * std::cos(theta);
  }
  return meshing::revolved(profile, {.triangles = triangles}).mesh;
}

// A prolate spheroid bent about the y axis to a ring of radius 1 that does not close: between its tips
// there is an angle `open`.
meshing::CurvedMesh bent(double open, int triangles) {
  meshing::CurvedMesh mesh =
      meshing::ellipsoid(Eigen::Vector3d(0.3, 0.3, 1), {.triangles = triangles});
  for (auto x : mesh.nodes.colwise()) {
    const double angle = x.z() * (pi - open / 2), r = 1 + x.x();
    x = Eigen::Vector3d(r * std::cos(angle), x.y(), r * std::sin(angle));
  }
  return mesh;
}

std::vector<Contact> contacts_of(const meshing::CurvedMesh& mesh, double limit = contact_distance) {
  return self_contacts(Triangulation(mesh), mesh.nodes, limit);
}

// Side of the triangles around the poles, on the z axis.
double pole_side(const meshing::CurvedMesh& mesh) {
  double sum = 0, count = 0;
  for (const auto t : mesh.triangles.colwise())
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d pole = mesh.nodes.col(t[k]);
      if (pole.head<2>().norm() > 1e-12) continue;
      const Eigen::Vector3d a = mesh.nodes.col(t[(k + 1) % 3]) - pole,
                            b = mesh.nodes.col(t[(k + 2) % 3]) - pole;
      sum += std::sqrt(2 * a.cross(b).norm() / std::sqrt(3.));
      ++count;
    }
  return sum / count;
}

TEST(SelfContact, is_not_seen_where_there_is_none) {
  for (const int triangles : {320, 1280, 5120}) {
    EXPECT_TRUE(contacts_of(meshing::sphere({.triangles = triangles})).empty());
    for (const double v : {0.3, 0.5, 0.8})
      for (const bool prolate : {false, true})
        EXPECT_TRUE(contacts_of(meshing::ellipsoid(v, prolate, {.triangles = triangles})).empty())
            << v << (prolate ? " prolate, " : " oblate, ") << triangles;
    for (const double shear : {0., 0.6})
      EXPECT_TRUE(contacts_of(sheared(y53_radius(0.5), shear, triangles)).empty());
  }
}

TEST(SelfContact, of_the_poles_of_a_disc_is_where_they_are_and_as_near_as_they_are) {
  for (const int triangles : {320, 1280})
    for (const double part : {0.1, 0.25}) {  // of a triangle's side
      const double gap = part * pole_side(disc(0.05, triangles));
      const auto contacts = contacts_of(disc(gap, triangles));
      ASSERT_FALSE(contacts.empty());
      // Both poles are vertices.
      EXPECT_NEAR(contacts.front().distance, gap, 1e-12);
      EXPECT_LT(contacts.front().where.norm(), 1e-12);
      EXPECT_NEAR(contacts.front().relative, part, 0.1 * part);  // the sides change with the gap
      for (const Contact& contact : contacts) {
        EXPECT_LT(contact.triangles[0], contact.triangles[1]);
        EXPECT_LT(contact.relative, contact_distance);
        EXPECT_GE(contact.distance, contacts.front().distance);
      }
    }
}

TEST(SelfContact, begins_at_the_limit) {
  const double h = pole_side(disc(0.05, 1280));
  EXPECT_TRUE(contacts_of(disc(0.4 * h, 1280)).empty());
  EXPECT_FALSE(contacts_of(disc(0.3 * h, 1280)).empty());
  EXPECT_TRUE(contacts_of(disc(0.3 * h, 1280), 0.2).empty());
  EXPECT_FALSE(contacts_of(disc(0.4 * h, 1280), 0.5).empty());
}

TEST(SelfContact, is_seen_from_the_outside_as_well) {
  const double chord = 0.02;  // between the tips
  const auto mesh = bent(2 * std::asin(chord / 2), 1280);
  const auto contacts = contacts_of(mesh);
  ASSERT_FALSE(contacts.empty());
  // The tips had a radius of curvature of 0.09 before they were stretched by π along the axis, and have
  // nodes every 0.03: the nearest are within 0.015 of the axis, and π 0.015²/0.09 farther apart.
  EXPECT_GT(contacts.front().distance, chord - 1e-4);
  EXPECT_LT(contacts.front().distance, chord + 0.008);
  EXPECT_LT((contacts.front().where - Eigen::Vector3d(-1, 0, 0)).norm(), 0.02);
  EXPECT_TRUE(contacts_of(bent(0.3, 1280)).empty());
}

TEST(SelfContact, of_sheets_that_have_passed_through_each_other_has_no_distance) {
  // The dimples of the disc are pushed through each other by 0.2; the sheets cross in a circle.
  meshing::CurvedMesh mesh = disc(0.1, 1280);
  double radius = 0;  // of the circle, by the nodes that are last to change sides
  for (auto x : mesh.nodes.colwise()) {
    const double before = x.z(), rho = std::hypot(x.x(), x.y());
    if (rho > 1) continue;  // the rim
    x.z() -= std::copysign(0.15 * std::exp(-rho * rho / 0.09), before);
    if (before * x.z() < 0) radius = std::max(radius, rho);
  }
  ASSERT_GT(radius, 0.2);
  const auto contacts = contacts_of(mesh);
  int crossing = 0;
  std::set<int> sectors;
  for (const Contact& contact : contacts)
    if (contact.distance == 0) {
      ++crossing;
      const double rho = std::hypot(contact.where.x(), contact.where.y());
      EXPECT_NEAR(rho, radius, 0.1);  // a triangle's side
      sectors.insert(int(std::floor(std::atan2(contact.where.y(), contact.where.x()) * 4 / pi)));
    }
  EXPECT_GT(crossing, 8);
  EXPECT_EQ(sectors.size(), 8u);  // all around
  // At the smallest limit the same ones are found.
  const auto only = contacts_of(mesh, 1e-6);
  EXPECT_EQ(int(only.size()), crossing);
}

TEST(SelfContact, refuses_a_limit_out_of_range) {
  const auto mesh = meshing::sphere({.triangles = 80});
  for (const double limit : {0., -1., 0.6, std::nan("")})
    EXPECT_THROW(contacts_of(mesh, limit), std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::surface3d
