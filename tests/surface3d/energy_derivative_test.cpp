// The discrete energy of a surface without symmetry, its discrete stresses and forces: each labelled term
// against its exact value, and every part of the energy against finite differences of itself.
#include "surface3d/order_step.h"
#include "tests/model/analytic_surface.h"
#include "tests/model/energy_parts.h"
#include "tests/model/finite_difference.h"
#include "tests/model/order_cases.h"
#include "tests/surface3d/cases.h"

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;
using model::Gradient;
using model::test::contract;
using model::test::Density;
using model::test::derivative_at_zero;
using model::test::general_material;
using model::test::Part;
using model::test::parts;
using model::test::Parts;
using model::test::Point;
using model::test::Taylor;
using namespace std::string_literals;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

const model::test::Example& example = model::test::examples[1];

const std::vector<int> refinements{80, 320, 1280, 5120};
double mesh_size(int triangles) { return 1 / std::sqrt(triangles); }

// The example at the nodes of an icosphere.
struct Discrete {
  Surface surface;
  Nodes displacement;  // W
  Field order_change;  // ψ
  const Triangulation& mesh() const { return *surface.mesh; }
};
Discrete discrete(int triangles) {
  Discrete d{.surface = uniform_sphere(0, triangles), .displacement = {}, .order_change = {}};
  State& s = d.surface.state;
  d.displacement = Nodes(3, s.X.cols());
  d.order_change = Field(s.X.cols());
  const auto value = [](const Taylor& t) { return t.derivative(0, 0).a; };
  for (Eigen::Index i = 0; i < s.X.cols(); ++i) {
    const Eigen::Vector3d x = s.X.col(i);
    const Point n = model::test::unit_sphere(std::acos(x[2]), std::atan2(x[1], x[0]));
    const Point X = example.position(n), W = example.displacement(n);
    s.X.col(i) << value(X[0]), value(X[1]), value(X[2]);
    d.displacement.col(i) << value(W[0]), value(W[1]), value(W[2]);
    s.beta[i] = value(example.order(n));
    d.order_change[i] = value(example.order_change(n));
  }
  return d;
}

// Visits every point with the discrete B, H, β as the step reads them.
template <class Visit>
void for_each_elastic_point(const Triangulation& mesh, const State& s, const Curvature& c,
                            std::span<const ShapeValues> points, Visit&& visit) {
  for_each_point(mesh, s.X, points, [&](int e, const ShapeValues& v, const SurfacePoint& p) {
    const ElementField beta = on_element(mesh, e, s.beta), H = on_element(mesh, e, c.H);
    const double h = value_at(H, v);
    visit(e, v, p,
          model::ElasticPoint<double, double>{
              .beta = value_at(beta, v),
              .grad_beta = gradient_at(beta, p),
              .B = shape_operator(p, on_element(mesh, e, c.normals), h),
              .H = h,
              .grad_H = gradient_at(H, p)});
  });
}

Density density_at(const Material& m, const model::ElasticPoint<double, double>& x) {
  return model::energy_density(m, x.beta, x.grad_beta.squaredNorm(), x.H,
                               model::gauss_curvature(x.B));
}

Parts energy_parts(const Material& m, const Triangulation& mesh, const State& s) {
  const auto curvature = curvature_of(mesh, s.X);
  EXPECT_TRUE(curvature.has_value());
  Parts sum = Parts::Zero();
  for_each_elastic_point(mesh, s, *curvature, diagnostic_points(),
                         [&](int, const ShapeValues&, const SurfacePoint& p, const auto& x) {
                           const Density density = density_at(m, x);
                           for (std::size_t k = 0; k < parts().size(); ++k)
                             sum[Eigen::Index(k)] += p.dS * density.*parts()[k].density;
                         });
  return sum;
}

// The part of W along the node normals.
Nodes along_normals(const Discrete& d) {
  const Nodes n = node_normals(d.mesh(), d.surface.state.X);
  return n * n.cwiseProduct(d.displacement).colwise().sum().asDiagonal();
}

// The discrete power of each term of each part, of which (e, Div_C W) is the last.
std::vector<std::vector<double>> discrete_powers(const Discrete& d,
                                                 std::span<const ShapeValues> points) {
  const State& s = d.surface.state;
  std::vector<std::vector<double>> powers;
  for (const Part& part : parts()) powers.emplace_back(part.terms.size() + 1, 0.);
  for_each_elastic_point(
      d.mesh(), s, *curvature_of(d.mesh(), s.X), points,
      [&](int e, const ShapeValues&, const SurfacePoint& p, const auto& x) {
        const Gradient<double> grad_W =
            p.frame.transpose() * gradient_at(on_element(d.mesh(), e, d.displacement), p);
        for (std::size_t k = 0; k < parts().size(); ++k) {
          const Part& part = parts()[k];
          for (std::size_t t = 0; t < part.terms.size(); ++t)
            powers[k][t] += p.dS * contract(part.terms[t].stress(general_material(), x), grad_W);
          if (part.isotropic)
            powers[k].back() +=
                p.dS * density_at(general_material(), x).*part.density * model::divergence(grad_W);
        }
      });
  return powers;
}

// The same from the formulas, by a quadrature that is exact to ten digits.
std::vector<std::vector<double>> exact_powers() {
  std::vector<std::vector<double>> powers;
  const auto all = model::test::directions(false, 32);
  for (const Part& part : parts()) {
    auto& sums = powers.emplace_back(part.terms.size() + 1, 0.);
    for (const auto& direction : all) {
      const auto p = model::test::surface_point(example.position(direction.n));
      const auto x = p.with_order(example.order(direction.n));
      const Gradient<double> grad_W = p.gradient(example.displacement(direction.n));
      const double dS = p.area / direction.sin_theta * direction.weight;
      for (std::size_t t = 0; t < part.terms.size(); ++t)
        sums[t] += dS * contract(part.terms[t].stress(general_material(), x), grad_W);
      if (part.isotropic)
        sums.back() +=
            dS * density_at(general_material(), x).*part.density * model::divergence(grad_W);
    }
  }
  return powers;
}

TEST(Stress, converges_to_its_exact_power_term_by_term) {
  const auto exact = exact_powers();
  std::vector<std::vector<OrderTable>> tables;
  for (const Part& part : parts()) {
    auto& row = tables.emplace_back();
    for (const auto& term : part.terms) row.emplace_back(term.label, "h");
    row.emplace_back(std::string(part.label) + ", isotropic", "h");
  }
  for (const int triangles : refinements) {
    const auto powers = discrete_powers(discrete(triangles), diagnostic_points());
    for (std::size_t k = 0; k < powers.size(); ++k)
      for (std::size_t t = 0; t < powers[k].size(); ++t)
        tables[k][t].add(mesh_size(triangles), powers[k][t] - exact[k][t]);
  }
  for (std::size_t k = 0; k < tables.size(); ++k)
    for (std::size_t t = 0; t < tables[k].size(); ++t)
      if (t < parts()[k].terms.size() || parts()[k].isotropic) {
        EXPECT_GT(std::abs(exact[k][t]), 1e-4);
        EXPECT_GT(tables[k][t].print(), 3.85);
      }
}

// Without curvature the discrete energy is differentiated exactly.
bool has_curvature(const Part& part) { return part.label == "E2"s || part.label == "E3"s; }

TEST(Stress, is_minus_the_derivative_of_every_part_of_the_discrete_energy) {
  constexpr double step = 0.02;
  std::vector<OrderTable> tables;
  for (const Part& part : parts())
    tables.emplace_back(std::string(part.label) + ", its derivative", "h");
  for (const int triangles : refinements) {
    const Discrete d = discrete(triangles);
    const auto powers = discrete_powers(d, diagnostic_points());
    const Parts derivative = derivative_at_zero(
        [&](double amount) -> Parts {
          return energy_parts(general_material(), d.mesh(),
                              {d.surface.state.X + amount * d.displacement, d.surface.state.beta});
        },
        step);
    for (std::size_t k = 0; k < parts().size(); ++k) {
      double total = -powers[k].back();
      for (std::size_t t = 0; t < parts()[k].terms.size(); ++t) total += powers[k][t];
      const double miss = derivative[Eigen::Index(k)] + total;
      tables[k].add(mesh_size(triangles), miss);
      if (!has_curvature(parts()[k])) {
        // Differences of sums of as many numbers as there are points, over the smallest step.
        const double points = triangles * double(diagnostic_points().size());
        EXPECT_LT(std::abs(miss), 2 * std::sqrt(points) * epsilon / (step / 8)) << parts()[k].label;
      }
    }
  }
  for (std::size_t k = 0; k < parts().size(); ++k) {
    if (!has_curvature(parts()[k])) continue;
    EXPECT_GT(tables[k].print(), 3.85);
  }
}

// ---- what the step assembles ------------------------------------------------------------------------

// (f, g)
double product(const Discrete& d, const Field& f, const Field& g) {
  double sum = 0;
  for_each_point(d.mesh(), d.surface.state.X, assembly_points(),
                 [&](int e, const ShapeValues& v, const SurfacePoint& p) {
                   sum += p.dS * value_at(on_element(d.mesh(), e, f), v)
                        * value_at(on_element(d.mesh(), e, g), v);
                 });
  return sum;
}

// (h ∇β, W)
double power_of_order(const Discrete& d, const Field& h, const Nodes& W) {
  double sum = 0;
  for_each_point(d.mesh(), d.surface.state.X, assembly_points(),
                 [&](int e, const ShapeValues& v, const SurfacePoint& p) {
                   const Eigen::Vector3d gradient =
                       p.frame.leftCols<2>()
                       * gradient_at(on_element(d.mesh(), e, d.surface.state.beta), p);
                   sum += p.dS * value_at(on_element(d.mesh(), e, h), v)
                        * gradient.dot(value_at(on_element(d.mesh(), e, W), v));
                 });
  return sum;
}

// ∫ e(β + amount ψ), the curvature and the quadrature points those of the order step.
double energy_of_changed_order(const Discrete& d, const Curvature& curvature, const Material& m,
                               double amount) {
  double sum = 0;
  const State changed{d.surface.state.X, d.surface.state.beta + amount * d.order_change};
  for_each_elastic_point(d.mesh(), changed, curvature, assembly_points(),
                         [&](int, const ShapeValues&, const SurfacePoint& p, const auto& x) {
                           sum += p.dS * density_at(m, x).total();
                         });
  return sum;
}

TEST(Momentum, along_the_normals_has_the_whole_elastic_force_and_across_them_that_of_the_order) {
  Discrete d = discrete(80);
  const State& s = d.surface.state;
  const auto curvature = curvature_of(d.mesh(), s.X);
  CoupledSystem system(d.mesh(), general_material(), Scheme::monolithic);
  const Field h = order_force(d.mesh(), general_material(), s, *curvature);
  system.assemble(d.mesh(), s, *curvature, h, {s.X, curvature->H}, 1e-3,
                  {.area_rate = 0.3, .volume_rate = 0.2, .keep_volume = true, .area = 4 * pi});
  const int N = d.mesh().nodes;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(system.flow().rhs.size());
  x.segment(3 * N + d.mesh().quadratic_nodes, N) = curvature->H;
  const Eigen::VectorXd residual = system.flow().matrix * x - system.flow().rhs;
  const Nodes W = d.displacement, W_n = along_normals(d);
  const double across = power_of_order(d, h, W - W_n);
  d.displacement = W_n;
  double expected = -across, magnitude = std::abs(across);
  const auto powers = discrete_powers(d, assembly_points());
  for (std::size_t k = 0; k < powers.size(); ++k) {
    for (const double power : powers[k]) magnitude += std::abs(power);
    for (std::size_t t = 0; t < parts()[k].terms.size(); ++t) expected -= powers[k][t];
    expected += powers[k].back();
  }
  EXPECT_NEAR(residual.head(3 * N).dot(W.reshaped()), expected, 1e-12 * magnitude);
}

// A displacement across the normals moves nothing but the order relative to the surface.
TEST(Momentum, across_the_normals_is_minus_the_derivative_of_the_discrete_energy) {
  OrderTable table("(V12), its derivative", "h");
  for (const int triangles : refinements) {
    const Discrete d = discrete(triangles);
    const State& s = d.surface.state;
    const Nodes W = d.displacement - along_normals(d);
    const double derivative = derivative_at_zero(
        [&](double amount) -> double {
          return energy_parts(general_material(), d.mesh(), {s.X + amount * W, s.beta}).sum();
        },
        0.02);
    const Field h = order_force(d.mesh(), general_material(), s, *curvature_of(d.mesh(), s.X));
    const double power = power_of_order(d, h, W);
    EXPECT_GT(std::abs(power), 1e-2);
    table.add(mesh_size(triangles), derivative + power);
  }
  EXPECT_GT(table.print(), 3);
}

TEST(OrderForce, is_the_derivative_of_the_energy_by_the_order) {
  const Discrete d = discrete(80);
  const State& s = d.surface.state;
  const auto curvature = curvature_of(d.mesh(), s.X);
  for (const auto& [label, material] : model::test::order_cases()) {
    const Material& m = material;
    const double derivative = derivative_at_zero(
        [&](double amount) { return energy_of_changed_order(d, *curvature, m, amount); }, 0.5);
    const Field h = order_force(d.mesh(), m, s, *curvature);
    EXPECT_NEAR(product(d, h, d.order_change), derivative, 1e-8 * std::abs(derivative)) << label;
  }
}

TEST(OrderStep, begins_with_minus_the_derivative_of_the_energy_by_the_order) {
  const Discrete d = discrete(80);
  const State& s = d.surface.state;
  const auto curvature = curvature_of(d.mesh(), s.X);
  const Nodes no_slip = Nodes::Zero(3, d.mesh().nodes);
  for (const auto& [label, material] : model::test::order_cases()) {
    const Material& m = material;
    const double derivative = derivative_at_zero(
        [&](double amount) { return energy_of_changed_order(d, *curvature, m, amount); }, 0.5);
    OrderTable table("(B1) against " + label + ", relative", "tau");
    for (const double tau : {1e-3, 1e-4, 1e-5}) {
      const Field beta = order_step(d.mesh(), m, s, {*curvature, no_slip, s.beta, s.X, tau}).beta;
      ASSERT_EQ(beta.size(), s.beta.size());
      const double drag = m.order_drag() * product(d, (beta - s.beta) / tau, d.order_change);
      table.add(tau, drag / derivative + 1);
    }
    // Of first order down to 1e-5: nothing else is left but what vanishes with τ.
    EXPECT_NEAR(table.print(), 1, 0.05) << label;
  }
}

// A sphere that turns about an axis with the angular velocity 1, and nothing but this acts on its order.
struct TurningSphere {
  Material inert;
  Surface s = uniform_sphere(0, 320);
  Eigen::Vector3d axis = Eigen::Vector3d(1, 2, -1).normalized();
  Nodes slip{3, s.mesh->nodes};

  TurningSphere() {
    inert.L1 = 0;
    inert.potential = model::Potential(std::vector<double>{});
    for (int i = 0; i < s.mesh->nodes; ++i)
      slip.col(i) = axis.cross(Eigen::Vector3d(s.state.X.col(i)));
  }
  // Of order(x) at the nodes after the time τ, the largest difference from the turned one.
  double error(const std::function<double(const Eigen::Vector3d&)>& order, double tau) const {
    State start = s.state;
    for (int i = 0; i < s.mesh->nodes; ++i) start.beta[i] = order(start.X.col(i));
    const auto curvature = curvature_of(*s.mesh, start.X);
    const Field beta =
        order_step(*s.mesh, inert, start, {*curvature, slip, start.beta, start.X, tau}).beta;
    if (beta.size() == 0) return std::numeric_limits<double>::infinity();
    const Eigen::Matrix3d back = Eigen::AngleAxisd(-tau, axis).toRotationMatrix();
    double worst = 0;
    for (int i = 0; i < s.mesh->nodes; ++i)
      worst = std::max(worst, std::abs(beta[i] - order(back * start.X.col(i))));
    return worst;
  }
};

TEST(OrderStep, carries_the_order_with_the_material) {
  const TurningSphere sphere;
  OrderTable table("largest error of the order after one step", "tau");
  for (const double tau : {0.2, 0.1, 0.05})
    table.add(
        tau, sphere.error([](const auto& x) { return 0.4 + 0.1 * x[0] - 0.2 * x[1] * x[2]; }, tau));
  EXPECT_NEAR(table.print(), 2, 0.2);
}

TEST(OrderStep, carries_the_order_past_many_triangles) {
  // Order that is the same all around the axis stays as it is, however far the sphere turns.
  const TurningSphere sphere;
  const auto order = [&](const Eigen::Vector3d& x) {
    const double z = sphere.axis.dot(x);
    return 0.4 + 0.1 * z - 0.2 * z * z;
  };
  for (const double tau : {1., 10., 100.}) EXPECT_LT(sphere.error(order, tau), 1e-3) << tau;
}

}  // namespace
}  // namespace sbeh::surface3d
