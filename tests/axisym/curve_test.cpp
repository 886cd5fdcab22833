// Area, volume, normals and discrete curvature of generating curves against closed forms.
//
// Two ways to put P3 elements on a curve are measured, because they differ in order:
//  - nodes on the curve, equidistant in its parameter: cubic interpolation at equidistant points. Its
//    error per element is h⁴ X''''/4! · x(x − 1/3)(x − 2/3)(x − 1), whose mean −1/270 is not 0 (the
//    3/8 rule is exact for cubics only): area and volume are of order 4. The curvature equation tests
//    this error with φ'', a linear function: h⁴ h⁻² is left, H is of order 2 in L2.
//  - cubics through the Gauss–Lobatto points of every element: the error there is orthogonal to linear
//    functions (the Lobatto rule with 4 points is exact for quintics): area and volume are of order 6,
//    and H gains an order: 3.
// Gauss–Bonnet does not feel where the curve lies, only how well H fits it: the order 2k = 6 of
// smooth functionals in P3, for both.
#include "tests/axisym/cases.h"

#include <functional>

namespace sbeh::axisym {
namespace {

using namespace test;

using Curve = std::function<Eigen::Vector2d(double theta)>;

// Spheroid with equatorial semi-axis a, polar semi-axis c, a ≠ c.
struct Spheroid {
  double a, c;
  double focal() const { return std::sqrt(std::abs(a * a - c * c)); }
  // arctan-like function of the closed forms: ∫ dx/√(…) from the pole.
  double angle() const { return a > c ? std::acos(c / a) : std::acosh(c / a); }
  double area() const {
    return a > c ? 2 * pi * (a * a + a * c * c / focal() * std::atanh(focal() / a))
                 : 2 * pi * (a * a + a * c * c / focal() * std::asin(focal() / c));
  }
  double volume() const { return 4 * pi / 3 * a * a * c; }
  // ∫ H dS = −2 ∫ mean curvature = −4π (c + a²/f · angle)
  double W2() const { return -4 * pi * (c + a * a / focal() * angle()); }
  Curve curve() const {
    return [*this](double t) { return Eigen::Vector2d(a * std::sin(t), c * std::cos(t)); };
  }
  // H at parameter t
  double H(double t) const {
    const double w = std::hypot(a * std::cos(t), c * std::sin(t));
    return -(a * c / (w * w * w) + c / (a * w));
  }
};

void close_poles(Nodes& X) { X(0, 0) = X(0, X.cols() - 1) = 0; }

Nodes equidistant(const Curve& curve, int elements) {
  Nodes X(2, 3 * elements + 1);
  for (Eigen::Index i = 0; i < X.cols(); ++i) X.col(i) = curve(pi * double(i) / (3. * elements));
  close_poles(X);
  return X;
}

Nodes through_lobatto_points(const Curve& curve, int elements) {
  const double g = 1 / std::sqrt(5.);
  const std::array<double, 4> at{0, (1 - g) / 2, (1 + g) / 2, 1};
  Nodes X = Nodes::Zero(2, 3 * elements + 1);
  for (int e = 0; e < elements; ++e)
    for (int a = 0; a < 4; ++a) {
      X.col(3 * e + a).setZero();
      for (std::size_t k = 0; k < 4; ++k) {
        double l = 1;  // Lagrange polynomial of Lobatto point k at a/3
        for (std::size_t j = 0; j < 4; ++j)
          if (j != k) l *= (a / 3. - at[j]) / (at[k] - at[j]);
        X.col(3 * e + a) += l * curve(pi * (e + at[k]) / elements);
      }
    }
  close_poles(X);
  return X;
}

double H_error(const Nodes& X, const Spheroid& s) {
  const Field H = mean_curvature(X);
  double sum = 0;
  for_each_point(X, diagnostic_points(), [&](int e, const ShapeValues& q, const CurvePoint& p) {
    const double miss = value_at(H, e, q) - s.H(pi * (e + q.x) / element_count(X));
    sum += p.dS * miss * miss;
  });
  return std::sqrt(sum);
}

// ∫ H dS and ∫ K dS with the discrete curvature.
Eigen::Vector2d curvature_integrals(const Nodes& X) {
  const Field H = mean_curvature(X);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for_each_point(X, diagnostic_points(), [&](int e, const ShapeValues& q, const CurvePoint& p) {
    const double h = value_at(H, e, q);
    sum += p.dS * Eigen::Vector2d(h, gauss_curvature(h, p.B_phi));
  });
  return sum;
}

struct Orders {
  double area, volume, H, W2, gauss_bonnet;
};
Orders measure(const Spheroid& s, const char* name,
               const std::function<Nodes(const Curve&, int)>& place) {
  const std::string what = std::string(name) + ", a = " + std::to_string(s.a) + ": ";
  OrderTable A(what + "area", "h"), V(what + "volume", "h"), H(what + "H in L2", "h"),
      W(what + "int H dS", "h"), K(what + "int K dS - 4 pi", "h");
  for (const int elements : {12, 24, 48}) {
    const Nodes X = place(s.curve(), elements);
    const double h = 1. / elements;
    A.add(h, area(X) / s.area() - 1);
    V.add(h, volume(X) / s.volume() - 1);
    H.add(h, H_error(X, s));
    const Eigen::Vector2d sums = curvature_integrals(X);
    W.add(h, sums[0] / s.W2() - 1);
    K.add(h, sums[1] / (4 * pi) - 1);
  }
  return {A.print(), V.print(), H.print(), W.print(), K.print()};
}

const std::array<Spheroid, 2> spheroids{{{1.2, 0.6}, {0.7, 1.4}}};

// Observed orders come from ratios of two errors; what the next power of h still contributes at 24
// elements stays below a fifth of an order in all tables.
constexpr double slack = 0.2;

TEST(Curve, with_nodes_on_it_has_area_of_order_4_H_of_order_2_and_Gauss_Bonnet_of_6) {
  for (const Spheroid& s : spheroids) {
    const Orders p = measure(s, "nodes on the curve", equidistant);
    EXPECT_GT(p.area, 4 - slack);
    EXPECT_GT(p.volume, 4 - slack);
    EXPECT_GT(p.W2, 4 - slack);
    EXPECT_GT(p.H, 2 - slack);
    EXPECT_GT(p.gauss_bonnet, 6 - slack);
  }
}

TEST(Curve, through_lobatto_points_has_area_of_order_6_H_of_order_3_and_Gauss_Bonnet_of_6) {
  for (const Spheroid& s : spheroids) {
    const Orders p = measure(s, "Lobatto points", through_lobatto_points);
    EXPECT_GT(p.area, 6 - slack);
    EXPECT_GT(p.volume, 6 - slack);
    EXPECT_GT(p.H, 3 - slack);
    EXPECT_GT(p.W2, 6 - slack);
    EXPECT_GT(p.gauss_bonnet, 6 - slack);
  }
}

TEST(Curve, on_the_unit_sphere_has_H_minus_2_and_K_1) {
  const Curve circle = [](double t) { return Eigen::Vector2d(std::sin(t), std::cos(t)); };
  OrderTable A("sphere: area", "h"), V("sphere: volume", "h"), H("sphere: H + 2 in L2", "h"),
      K("sphere: K - 1 in L2", "h");
  for (const int elements : {12, 24, 48}) {
    const Nodes X = through_lobatto_points(circle, elements);
    const Field h = mean_curvature(X);
    Eigen::Vector2d miss = Eigen::Vector2d::Zero();
    for_each_point(X, diagnostic_points(), [&](int e, const ShapeValues& q, const CurvePoint& p) {
      const double value = value_at(h, e, q);
      miss += p.dS
            * Eigen::Vector2d(std::pow(value + 2, 2),
                              std::pow(gauss_curvature(value, p.B_phi) - 1, 2));
    });
    A.add(1. / elements, area(X) / (4 * pi) - 1);
    V.add(1. / elements, volume(X) / (4 * pi / 3) - 1);
    H.add(1. / elements, std::sqrt(miss[0]));
    K.add(1. / elements, std::sqrt(miss[1]));
  }
  EXPECT_GT(A.print(), 6 - slack);
  EXPECT_GT(V.print(), 6 - slack);
  EXPECT_GT(H.print(), 3 - slack);
  EXPECT_GT(K.print(), 3 - slack);
}

TEST(Curve, has_its_frame_right_handed_with_the_normal_outward) {
  // Convex and centred: outward means ν·x > 0. t runs from north to south: t_z < 0 off the poles.
  const Nodes X = equidistant(spheroids[0].curve(), 12);
  for_each_point(X, assembly_points(), [](int, const ShapeValues&, const CurvePoint& p) {
    EXPECT_GT(p.nu.dot(p.x), 0);
    EXPECT_NEAR(p.nu.dot(p.t), 0, 1e-15);
    EXPECT_NEAR(p.nu.norm(), 1, 1e-15);
    EXPECT_LT(p.t[1], 0);
    EXPECT_LT(p.B_phi, 0);
  });
}

TEST(NodeNormals, are_unit_vectors_along_the_axis_at_the_poles_and_of_order_3_inside) {
  // Normals come from the derivative of a cubic: order 3 at the nodes.
  const Spheroid s = spheroids[1];
  OrderTable table("normals at the nodes, largest miss", "h");
  for (const int elements : {12, 24, 48}) {
    const Nodes n = node_normals(equidistant(s.curve(), elements));
    const Eigen::Index last = n.cols() - 1;
    double miss = 0;
    for (Eigen::Index i = 0; i <= last; ++i) {
      const double t = pi * double(i) / double(last);
      const Eigen::Vector2d exact(s.c * std::sin(t), s.a * std::cos(t));
      miss = std::max(miss, (n.col(i) - exact.normalized()).norm());
      EXPECT_NEAR(n.col(i).norm(), 1, 1e-15);
    }
    EXPECT_EQ(n.col(0), Eigen::Vector2d(0, 1));
    EXPECT_EQ(n.col(last), Eigen::Vector2d(0, -1));
    table.add(1. / elements, miss);
  }
  EXPECT_GT(table.print(), 3 - slack);
}

TEST(ElementLengths, sum_to_the_arc_length_of_a_circle_at_order_4) {
  const Curve circle = [](double t) { return Eigen::Vector2d(std::sin(t), std::cos(t)); };
  OrderTable table("arc length of a half circle", "h");
  for (const int elements : {12, 24, 48})
    table.add(1. / elements, element_lengths(equidistant(circle, elements)).sum() / pi - 1);
  EXPECT_GT(table.print(), 4 - slack);
}

TEST(ReducedVolume, is_1_for_a_sphere_of_any_radius) {
  for (const double R : {0.5, 1., 3.})
    EXPECT_NEAR(reduced_volume(4 * pi * R * R, 4 * pi / 3 * R * R * R), 1, 1e-14);
}

}  // namespace
}  // namespace sbeh::axisym
