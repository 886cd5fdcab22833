// The assembled Lagrangian of stationary states: gradient against differences of its value, Hessian
// against differences of the gradient, in every block of unknowns.
#include "axisym/stationary/lagrangian.h"

#include "axisym/lipids.h"
#include "axisym/stationary/symmetry.h"
#include "tests/axisym/cases.h"
#include "tests/model/densely.h"

#include <fmt/format.h>

#include <random>

namespace sbeh::axisym {
namespace {

using namespace test;

constexpr int elements = 12;
constexpr const char* block_names[node_unknowns] = {"d", "Lambda", "H", "beta"};

struct NamedMaterial {
  const char* name;
  Material material;
};
std::vector<NamedMaterial> materials() {
  Material general;
  general.L1 = 0.05, general.L2 = 0.031, general.L3 = -0.023;
  general.residual_stiffness = 0.017;
  general.spontaneous_curvature = -0.7;
  general.flexoelectric = model::Polynomial({0.3, -0.8, 0.5});
  Material cubic = general;
  cubic.potential = model::Potential({0.3, -0.2, 1.1, -4., 5., 0.7});
  Material coupled = general;
  coupled.area_difference = {1.2, -20};
  Material conserved = general;
  conserved.order = model::OrderDynamics::conserved;
  conserved.mean_order = 0.4;
  Material lipids = general;
  lipids.lipid_density = model::Polynomial({0.8, 0.1, 0.4});
  return {{"one constant", paper_material(0.05)}, {"lipid density", lipids},
          {"unequal L, k0, H0, f", general},      {"potential of degree 5", cubic},
          {"area difference", coupled},           {"conserved order", conserved}};
}

// No solution of anything: smooth fields that have nothing to do with each other.
StationaryState any_state(int count = elements) {
  const Eigen::Index nodes = 3 * count + 1;
  StationaryState s{{Nodes(2, nodes), Field(nodes)}, Field(nodes), Field(nodes), 1.3, -2.1};
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const double t = pi * double(i) / double(nodes - 1);
    s.X.col(i) << (1 + 0.2 * std::cos(t)) * std::sin(t), 0.7 * std::cos(t);
    s.beta[i] = 0.5 + 0.1 * std::cos(2 * t) - 0.05 * std::cos(t);
    s.H[i] = -2 + 0.4 * std::cos(t) - 0.3 * std::cos(3 * t);
    s.Lambda[i] = 0.3 - 0.2 * std::cos(2 * t);
  }
  s.X(0, 0) = s.X(0, nodes - 1) = 0;
  return s;
}

// 𝓛 without its constants ΣA₀ and PV₀, by quadrature of the pointwise density.
double lagrangian(const Material& material, const StationaryState& s, const Nodes& normals) {
  double sum = 0;
  for (int e = 0; e < elements; ++e)
    for (const ShapeValues& shape : assembly_points()) {
      const CurvePoint p = curve_point(s.X, e, shape);
      const PointFields<double> q{p.x[0],
                                  p.dx[0],
                                  p.dx[1],
                                  value_at(s.H, e, shape),
                                  value_at(s.beta, e, shape),
                                  slope_at(s.beta, e, shape)};
      const auto density = lagrangian_density(material, s.tension, s.pressure, q);
      sum += shape.weight * density.energy;
      if (const auto& ad = material.area_difference; ad.is_there()) {
        const double c = s.moment;  // c (W₂ − W₂⁰) − c²A/(2π k_ad), but for the constant
        sum += shape.weight * area_density(material, q)
             * (c * q[at_H] - c * c / (2 * pi * ad.stiffness));
      }
      if (material.conserves_order())  // −μ_β ∫(β − β̄)dS
        sum -= shape.weight * area_density(material, q) * s.chemical_potential
             * (q[at_beta] - *material.mean_order);
      for (int k = 0; k < 2; ++k) {
        const Field Lambda_k = s.Lambda.cwiseProduct(normals.row(k).transpose());
        sum += shape.weight
             * (density.curvature[std::size_t(k)] * value_at(Lambda_k, e, shape)
                + density.curvature[std::size_t(k) + 2] * slope_at(Lambda_k, e, shape));
      }
    }
  return sum;
}

// s moved by h times a direction in all unknowns, node-wise as in the global vector.
StationaryState moved(const StationaryState& s, const Nodes& normals, const Eigen::VectorXd& v,
                      double h) {
  StationaryState m = s;
  for (Eigen::Index i = 0; i < s.H.size(); ++i) {
    const auto at = [&](NodeUnknown c) { return h * v[node_unknowns * i + c]; };
    m.X.col(i) += at(node_d) * normals.col(i);
    m.Lambda[i] += at(node_Lambda);
    m.H[i] += at(node_H);
    m.beta[i] += at(node_beta);
  }
  return m;
}

// A random direction in one block; poles stay on the axis because their normals lie along it.
Eigen::VectorXd random_direction(int block, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(node_unknowns * (3 * elements + 1));
  for (Eigen::Index i = block; i < v.size(); i += node_unknowns) v[i] = uniform(generator);
  return v;
}

// Central difference of order 4. A random nodal direction changes r near the pole, and the stretch, by
// up to 40 h relative: the next term, (40 h)⁴ times a factor of order 1, is below 1e-10 of the result
// for h = 5e-5, and so is rounding, 1e-16 |f|/h.
constexpr double h = 5e-5, accuracy = 1e-8;
template <class F>
auto difference(const F& f) {
  using Value = decltype(f(h));
  const Value near = (f(h) - f(-h)) / (2 * h), far = (f(2 * h) - f(-2 * h)) / (4 * h);
  return Value((4 * near - far) / 3);
}

LagrangianDerivatives assembled(const Material& material, const StationaryState& s,
                                const Nodes& normals) {
  LagrangianDerivatives out({elements, false});
  assemble(material, s, normals, out);
  return out;
}

// With a moment and a chemical potential where the material has them.
StationaryState any_state_in(const Material& material) {
  StationaryState s = any_state();
  if (material.area_difference.is_there()) s.moment = 0.9;
  if (material.conserves_order()) s.chemical_potential = -0.7;
  return s;
}

TEST(Lagrangian, gradient_is_the_difference_of_the_value_in_every_block) {
  for (const NamedMaterial& of : materials()) {
    const auto& material = of.material;
    const auto& name = of.name;
    const StationaryState s = any_state_in(material);
    const Nodes n = node_normals(s.X);
    const LagrangianDerivatives L = assembled(material, s, n);
    for (int block = 0; block < node_unknowns; ++block)
      for (unsigned seed : {1u, 2u, 3u}) {
        const Eigen::VectorXd v = random_direction(block, seed);
        const double expected =
            difference([&](double t) { return lagrangian(material, moved(s, n, v, t), n); });
        const double scale = L.gradient.cwiseAbs().dot(v.cwiseAbs());
        EXPECT_NEAR(L.gradient.dot(v), expected, accuracy * scale)
            << name << ", " << block_names[block];
        EXPECT_GT(scale, 0.1) << name << ", " << block_names[block];
      }
  }
}

TEST(Lagrangian, hessian_is_the_difference_of_the_gradient_in_every_block) {
  for (const NamedMaterial& of : materials()) {
    const auto& material = of.material;
    const auto& name = of.name;
    const StationaryState s = any_state_in(material);
    const Nodes n = node_normals(s.X);
    const LagrangianDerivatives L = assembled(material, s, n);
    for (int block = 0; block < node_unknowns; ++block) {
      const Eigen::VectorXd v = random_direction(block, 7);
      const Eigen::VectorXd expected = difference([&](double t) -> Eigen::VectorXd {
        return assembled(material, moved(s, n, v, t), n).gradient;
      });
      const Eigen::VectorXd product = densely(L.hessian) * v;
      // Rows block by block: they differ in size.
      for (int row = 0; row < node_unknowns; ++row) {
        const auto rows = Eigen::seqN(row, s.H.size(), Eigen::Index(node_unknowns));
        const double scale = product(rows).cwiseAbs().maxCoeff();
        EXPECT_LT((product(rows) - expected(rows)).cwiseAbs().maxCoeff(), accuracy * (scale + 0.1))
            << name << ", " << block_names[row] << " by " << block_names[block];
      }
    }
  }
}

TEST(Lagrangian, hessian_is_symmetric) {
  const StationaryState s = any_state();
  const Nodes n = node_normals(s.X);
  for (const NamedMaterial& of : materials()) {
    const auto& material = of.material;
    const auto& name = of.name;
    const Eigen::MatrixXd K = densely(assembled(material, s, n).hessian);
    const Eigen::MatrixXd below = K.triangularView<Eigen::StrictlyLower>();
    const double largest = below.cwiseAbs().maxCoeff();
    EXPECT_LT((K - K.transpose()).cwiseAbs().maxCoeff(), 1e-13 * largest)
        << name;  // sums of about 100 terms each
    EXPECT_GT(largest, 1);
  }
}

TEST(Lagrangian, knows_area_and_volume_and_their_gradients) {
  const StationaryState s = any_state();
  const Nodes n = node_normals(s.X);
  const LagrangianDerivatives L = assembled(paper_material(0.05), s, n);
  // Area: 6 against 10 Gauss points, the integrand is a root of a polynomial.
  EXPECT_NEAR(L.area, area(s.X), 1e-9);
  EXPECT_NEAR(L.volume, volume(s.X), 1e-13);
  const Eigen::VectorXd v = random_direction(node_d, 5);
  const double dA = difference([&](double t) { return assembled({}, moved(s, n, v, t), n).area; });
  const double dV =
      difference([&](double t) { return assembled({}, moved(s, n, v, t), n).volume; });
  EXPECT_NEAR(L.constraints.col(0).dot(v), dA, accuracy);
  EXPECT_NEAR(L.constraints.col(1).dot(v), -dV, accuracy);
}

TEST(Lagrangian, knows_the_area_of_its_lipids_and_its_gradient) {
  const Material material = materials()[1].material;
  const StationaryState s = any_state();
  const Nodes n = node_normals(s.X);
  const LagrangianDerivatives L = assembled(material, s, n);
  EXPECT_NEAR(L.area, lipid_area(material, s), 1e-13);
  EXPECT_GT(std::abs(L.area - area(s.X)), 0.1);
  for (const int block : {node_d, node_beta}) {
    const Eigen::VectorXd v = random_direction(block, 5);
    const double expected =
        difference([&](double t) { return lipid_area(material, moved(s, n, v, t)); });
    EXPECT_NEAR(L.constraints.col(0).dot(v), expected, accuracy);
    EXPECT_GT(std::abs(expected), 0.01);
  }
}

TEST(Lagrangian, knows_how_its_gradient_goes_with_the_moment) {
  for (const double stiffness : {1.2, std::numeric_limits<double>::infinity()}) {
    Material material = materials()[2].material;
    material.area_difference = {stiffness, -20};
    StationaryState s = any_state_in(material);
    const Nodes n = node_normals(s.X);
    const LagrangianDerivatives L = assembled(material, s, n);
    const Eigen::VectorXd expected = difference([&](double t) -> Eigen::VectorXd {
      StationaryState at = s;
      at.moment += t;
      return assembled(material, at, n).gradient;
    });
    EXPECT_LT((L.of_W2 - expected).cwiseAbs().maxCoeff(), accuracy);
    EXPECT_GT(L.of_W2.cwiseAbs().maxCoeff(), 0.1);
    const LagrangianGradient alone = gradient_at(material, s, n, {elements, false});
    EXPECT_LT((L.of_W2 - alone.of_W2).cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_NEAR(L.W2, alone.W2, 1e-13);
  }
}

TEST(Lagrangian, knows_how_its_gradient_goes_with_the_chemical_potential) {
  const Material material = materials().back().material;
  const StationaryState s = any_state_in(material);
  const Nodes n = node_normals(s.X);
  const LagrangianDerivatives L = assembled(material, s, n);
  const Eigen::VectorXd expected = difference([&](double t) -> Eigen::VectorXd {
    StationaryState at = s;
    at.chemical_potential += t;
    return assembled(material, at, n).gradient;
  });
  EXPECT_LT((L.of_order - expected).cwiseAbs().maxCoeff(), accuracy);
  EXPECT_GT(L.of_order.cwiseAbs().maxCoeff(), 0.1);
  EXPECT_NEAR(L.order, diagnose(material, s).order_mean * area(s.X), 1e-9);
  const LagrangianGradient alone = gradient_at(material, s, n, {elements, false});
  EXPECT_LT((L.of_order - alone.of_order).cwiseAbs().maxCoeff(), 1e-13);
}

// Of a symmetric state's nodes, in columns: what a change of a node of the upper half is to the whole.
Eigen::MatrixXd symmetric_changes(const Sector& half) {
  const int nodes = 3 * half.state_elements + 1;
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(node_unknowns * nodes, node_unknowns * half.nodes());
  for (int i = 0; i < nodes; ++i)
    for (int c = 0; c < node_unknowns; ++c)
      E(node_unknowns * i + c, node_unknowns * half.folded(i) + c) = 1;
  return E;
}

TEST(Lagrangian, over_half_a_symmetric_state_is_that_of_symmetric_changes) {
  for (const int count : {12, 11})  // the equator between elements, and within one
    for (const NamedMaterial& of : materials()) {
      const auto& material = of.material;
      const auto& name = of.name;
      SCOPED_TRACE(fmt::format("{} elements, {}", count, name));
      const StationaryState s = symmetric_part(any_state(count));
      const Nodes n = node_normals(s.X);
      LagrangianDerivatives whole({count, false}), half({count, true});
      assemble(material, s, n, whole);
      assemble(material, s, n, half);
      const Eigen::MatrixXd E = symmetric_changes(half.sector);
      const Eigen::MatrixXd K = E.transpose() * densely(whole.hessian) * E;
      const double rounding = 1e-13 * K.cwiseAbs().maxCoeff();  // sums of about 100 terms each
      EXPECT_LT((densely(half.hessian) - K).cwiseAbs().maxCoeff(), rounding);
      EXPECT_LT((half.gradient - E.transpose() * whole.gradient).cwiseAbs().maxCoeff(), rounding);
      EXPECT_LT((half.constraints - E.transpose() * whole.constraints).cwiseAbs().maxCoeff(),
                rounding);
      const LagrangianGradient alone = gradient_at(material, s, n, half.sector);
      EXPECT_LT((alone.gradient - half.gradient).cwiseAbs().maxCoeff(), rounding);
      EXPECT_NEAR(half.area, whole.area, rounding);
      EXPECT_NEAR(alone.volume, whole.volume, rounding);
    }
}

TEST(Lagrangian, at_exact_curvature_and_zero_multiplier_is_the_energy) {
  StationaryState s = any_state();
  s.tension = s.pressure = 0;
  s.Lambda.setZero();
  const Material material = materials()[2].material;
  const Energy e = energy(material, s, s.H);
  // The same density with 6 and with 10 Gauss points per element.
  EXPECT_NEAR(lagrangian(material, s, node_normals(s.X)), e.total(), 1e-8 * std::abs(e.total()));
}

TEST(Lagrangian, ties_H_to_the_curve_by_its_derivative_in_Lambda) {
  // ∂𝓛/∂Λ = 0 is the curvature equation: it holds for mean_curvature of any curve.
  StationaryState s = any_state();
  s.H = mean_curvature(s.X);
  const LagrangianDerivatives L = assembled(paper_material(0.05), s, node_normals(s.X));
  const auto rows = Eigen::seqN(int(node_Lambda), s.H.size(), Eigen::Index(node_unknowns));
  EXPECT_LT(L.gradient(rows).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace sbeh::axisym
