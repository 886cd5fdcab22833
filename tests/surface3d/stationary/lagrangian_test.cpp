// The assembled Lagrangian of stationary states in 3D: gradient against differences of its value, Hessian against
// differences of the gradient, in every block of unknowns; the Gaussian energy against exact ones.
#include "surface3d/stationary/lagrangian.h"

#include "model/numerics/quadrature.h"
#include "surface3d/gaussian_energy.h"
#include "surface3d/lipids.h"
#include "tests/model/finite_difference.h"
#include "tests/model/general_material.h"
#include "tests/surface3d/cases.h"

#include <array>
#include <functional>
#include <random>

namespace sbeh::surface3d {
namespace {

using namespace test;
using model::test::general_material;

constexpr std::array blocks{node_d, node_Lambda, node_H, node_beta};
constexpr const char* block_names[node_unknowns] = {"d", "Lambda", "H", "beta"};

struct Case {
  Triangulation mesh;
  StationaryState state;
  Nodes normals;
};

// No solution of anything: a bumpy surface without symmetry and smooth fields that have nothing to do with it.
Case any_case() {
  const std::array modes{meshing::Harmonic{2, 0, -0.4}, meshing::Harmonic{3, 2, 0.25},
                         meshing::Harmonic{4, -3, 0.1}};
  const meshing::CurvedMesh mesh = meshing::harmonic_sphere(modes, {.triangles = 80});
  Case c{Triangulation(mesh), {}, {}};
  StationaryState& s = c.state;
  s.X = mesh.nodes;
  s.beta = s.H = s.Lambda = Field(mesh.node_count());
  for (int i = 0; i < mesh.node_count(); ++i) {
    const Eigen::Vector3d x = s.X.col(i);
    s.beta[i] = 0.5 + 0.1 * std::cos(2 * x[0]) - 0.05 * std::sin(x[1] - x[2]);
    s.H[i] = -2 + 0.4 * x[1] - 0.3 * std::cos(3 * x[2]);
    s.Lambda[i] = 0.3 - 0.2 * std::cos(2 * x[0] + x[1]);
  }
  s.tension = 1.3;
  s.pressure = -2.1;
  c.normals = node_normals(c.mesh, s.X);
  return c;
}

Material with_areas() {
  Material material = general_material();
  material.area_difference = {.stiffness = 0.7, .W2 = -21};
  return material;
}
Material with_lipid_density() {
  Material material = general_material();
  material.lipid_density = model::Polynomial({0.8, 0.1, 0.4});
  return material;
}
Material with_conserved_order() {
  Material material = with_areas();
  material.order = model::OrderDynamics::conserved;
  material.mean_order = 0.4;
  return material;
}
Case any_case(const Material& material) {
  Case c = any_case();
  if (material.area_difference.is_there()) c.state.moment = 0.6;
  if (material.conserves_order()) c.state.chemical_potential = -0.7;
  return c;
}

// 𝓛 without its constants ΣA₀, PV₀ and cW₂⁰, in the terms of the time step's geometry.
double lagrangian(const Material& material, const Case& c, const StationaryState& s) {
  const Nodes Lambda = c.normals * s.Lambda.asDiagonal();
  double sum = gaussian_energy(material, c.mesh, s);
  const model::AreaDifference& ad = material.area_difference;
  const double moment = s.moment,
               tension = s.tension - (ad.is_there() ? moment * moment * ad.compliance() / 2 : 0);
  for_each_point(
      c.mesh, s.X, assembly_points(), [&](int e, const ShapeValues& shape, const SurfacePoint& p) {
        const ElementField beta = on_element(c.mesh, e, s.beta);
        const double H = value_at(on_element(c.mesh, e, s.H), shape);
        const auto density = model::energy_density(material, value_at(beta, shape),
                                                   gradient_at(beta, p).squaredNorm(), H, 0.);
        const ElementNodes Lambda_e = on_element(c.mesh, e, Lambda);
        const double divergence =
            p.frame.leftCols<2>().cwiseProduct(gradient_at(Lambda_e, p)).sum();
        sum += p.dS
             * (density.total() + moment * H + tension * material.packing(value_at(beta, shape))
                - s.pressure * p.x.dot(p.nu()) / 3 + H * p.nu().dot(value_at(Lambda_e, shape))
                + divergence);
      });
  return sum;
}

StationaryState moved(const Case& c, const StationaryLayout& layout, const Eigen::VectorXd& v,
                      double h) {
  StationaryState m = c.state;
  m.X += c.normals * Field(h * v(layout.all(node_d))).asDiagonal();
  m.Lambda += h * v(layout.all(node_Lambda));
  m.H += h * v(layout.all(node_H));
  if (layout.free_order) m.beta += h * v(layout.all(node_beta));
  return m;
}

// A random direction in one block.
Eigen::VectorXd random_direction(const StationaryLayout& layout, NodeUnknown block, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd v = Eigen::VectorXd::Zero(layout.size());
  for (int i = 0; i < layout.mesh.nodes; ++i) v[layout.index(i, block)] = uniform(generator);
  return v;
}

// A random nodal direction changes the stretch by up to 30 h relative: in differences up to h = 4e-4 the error left,
// (30 h)⁸ times a factor of order 1, and rounding, 1e-16 |f|/(h/8), are below 1e-10 of the result.
constexpr double accuracy = 1e-8;
template <class F>
auto difference(const F& f) {
  return model::test::derivative_at_zero(f, 4e-4);
}

LagrangianDerivatives assembled(const Material& material, const StationaryLayout& layout,
                                const Case& c, const StationaryState& s) {
  LagrangianDerivatives out;
  assemble(material, layout, s, c.normals, out);
  return out;
}

TEST(Lagrangian3d, gradient_is_the_difference_of_the_value_in_every_block) {
  for (const Material& material :
       {paper_material(0.05), general_material(), with_areas(), with_lipid_density()}) {
    const Case c = any_case(material);
    const StationaryLayout layout(c.mesh, Model::SBEH);
    const LagrangianDerivatives L = assembled(material, layout, c, c.state);
    EXPECT_NEAR(L.value, lagrangian(material, c, c.state), 1e-11 * std::abs(L.value));
    for (const NodeUnknown block : blocks)
      for (unsigned seed : {1u, 2u, 3u}) {
        const Eigen::VectorXd v = random_direction(layout, block, seed);
        const double expected =
            difference([&](double t) { return lagrangian(material, c, moved(c, layout, v, t)); });
        const double scale = L.gradient.cwiseAbs().dot(v.cwiseAbs());
        EXPECT_NEAR(L.gradient.dot(v), expected, accuracy * scale) << block_names[block];
        EXPECT_GT(scale, 0.1) << block_names[block];
      }
  }
}

TEST(Lagrangian3d, hessian_is_the_difference_of_the_gradient_in_every_block) {
  for (const Material& material :
       {paper_material(0.05), general_material(), with_areas(), with_lipid_density()}) {
    const Case c = any_case(material);
    const StationaryLayout layout(c.mesh, Model::SBEH);
    const LagrangianDerivatives L = assembled(material, layout, c, c.state);
    for (const NodeUnknown block : blocks) {
      const Eigen::VectorXd v = random_direction(layout, block, 7);
      const Eigen::VectorXd expected = difference([&](double t) -> Eigen::VectorXd {
        return assembled(material, layout, c, moved(c, layout, v, t)).gradient;
      });
      const Eigen::VectorXd product = L.hessian * v;
      for (const NodeUnknown row : blocks) {
        const auto rows = layout.all(row);
        const double scale = product(rows).cwiseAbs().maxCoeff();
        EXPECT_LT((product(rows) - expected(rows)).cwiseAbs().maxCoeff(), accuracy * (scale + 0.1))
            << block_names[row] << " by " << block_names[block];
      }
    }
  }
}

TEST(Lagrangian3d, has_the_same_gradient_without_its_hessian) {
  const Case c = any_case();
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const StationaryLayout layout(c.mesh, model);
    const LagrangianDerivatives with = assembled(general_material(), layout, c, c.state);
    LagrangianGradient without;
    assemble(general_material(), layout, c.state, c.normals, without);
    // Sums of about 100 terms each.
    const auto expect_same = [](const auto& a, const auto& b) {
      EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-13 * b.cwiseAbs().maxCoeff());
    };
    expect_same(without.gradient, with.gradient);
    expect_same(without.constraints, with.constraints);
    expect_same(Eigen::Vector3d(without.area, without.volume, without.value),
                Eigen::Vector3d(with.area, with.volume, with.value));
  }
}

TEST(Lagrangian3d, hessian_is_symmetric) {
  const Case c = any_case();
  const StationaryLayout layout(c.mesh, Model::SBEH);
  const SparseMatrix K = assembled(general_material(), layout, c, c.state).hessian;
  const SparseMatrix odd = K - SparseMatrix(K.transpose());
  // Sums of about 100 terms each.
  EXPECT_LT(odd.coeffs().abs().maxCoeff(), 1e-13 * K.coeffs().abs().maxCoeff());
}

TEST(Lagrangian3d, of_a_uniform_order_has_the_same_derivatives_by_what_else_there_is) {
  const Case c = any_case();
  const StationaryLayout whole(c.mesh, Model::SBEH), part(c.mesh, Model::SSH);
  StationaryState uniform = c.state;
  uniform.beta.setConstant(model::full_order);
  const LagrangianDerivatives with = assembled(general_material(), whole, c, uniform),
                              without = assembled(general_material(), part, c, uniform);
  // The Gaussian energy is constant: its parts cancel to rounding.
  const double scale = with.gradient.cwiseAbs().maxCoeff();
  for (const NodeUnknown block : {node_d, node_Lambda, node_H})
    EXPECT_LT(
        (with.gradient(whole.all(block)) - without.gradient(part.all(block))).cwiseAbs().maxCoeff(),
        1e-13 * scale)
        << block_names[block];
}

TEST(Lagrangian3d, knows_area_and_volume_and_their_gradients) {
  const Case c = any_case();
  const StationaryLayout layout(c.mesh, Model::SSH);
  const LagrangianDerivatives L = assembled({}, layout, c, c.state);
  EXPECT_NEAR(L.area, area(c.mesh, c.state.X), 1e-6);  // degree 8 against 12
  EXPECT_NEAR(L.volume, volume(c.mesh, c.state.X), 1e-13);
  const Eigen::VectorXd v = random_direction(layout, node_d, 5);
  const auto after = [&](double t) { return assembled({}, layout, c, moved(c, layout, v, t)); };
  EXPECT_NEAR(L.constraints.col(0).dot(v), difference([&](double t) { return after(t).area; }),
              accuracy);
  EXPECT_NEAR(L.constraints.col(1).dot(v), -difference([&](double t) { return after(t).volume; }),
              accuracy);
}

TEST(Lagrangian3d, knows_the_area_of_its_lipids_and_its_gradient) {
  const Case c = any_case();
  const Material material = with_lipid_density();
  const StationaryLayout layout(c.mesh, Model::SBEH);
  const LagrangianDerivatives L = assembled(material, layout, c, c.state);
  EXPECT_NEAR(L.area, lipids_and_volume(c.mesh, material, c.state).area, 1e-6);
  EXPECT_GT(std::abs(L.area - area(c.mesh, c.state.X)), 0.1);
  for (const NodeUnknown block : {node_d, node_beta}) {
    const Eigen::VectorXd v = random_direction(layout, block, 5);
    const double expected = difference(
        [&](double t) { return assembled(material, layout, c, moved(c, layout, v, t)).area; });
    EXPECT_NEAR(L.constraints.col(0).dot(v), expected, accuracy);
    EXPECT_GT(std::abs(expected), 1e-3);
  }
}

TEST(Lagrangian3d, knows_what_the_moment_is_the_multiplier_of) {
  const Material material = with_areas();
  const Case c = any_case(material);
  const StationaryLayout layout(c.mesh, Model::SBEH);
  const LagrangianDerivatives L = assembled(material, layout, c, c.state);
  const auto at_moment = [&](double t) {
    StationaryState other = c.state;
    other.moment += t;
    return assembled(material, layout, c, other);
  };
  const Eigen::VectorXd border =
      difference([&](double t) -> Eigen::VectorXd { return at_moment(t).gradient; });
  EXPECT_LT((L.constraints.col(2) - border).cwiseAbs().maxCoeff(),
            accuracy * border.cwiseAbs().maxCoeff());
  // ∂𝓛/∂c without W₂⁰, and once more.
  const double slope = difference([&](double t) { return at_moment(t).value; });
  const Target same{L.area, L.volume};
  EXPECT_NEAR(slope, material.area_difference.W2 - L.miss(material, same, c.state.moment)[2],
              accuracy * 30);
  EXPECT_NEAR(L.corner[2], difference([&](double t) {
                return -at_moment(t).miss(material, same, c.state.moment + t)[2];
              }),
              accuracy);
}

TEST(Lagrangian3d, knows_what_the_chemical_potential_is_the_multiplier_of) {
  const Material material = with_conserved_order();
  const Case c = any_case(material);
  const StationaryLayout layout(c.mesh, Model::SBEH);
  const LagrangianDerivatives L = assembled(material, layout, c, c.state);
  ASSERT_EQ(L.multipliers(), 4);
  const auto at_potential = [&](double t) {
    StationaryState other = c.state;
    other.chemical_potential += t;
    return assembled(material, layout, c, other);
  };
  const Eigen::VectorXd border =
      difference([&](double t) -> Eigen::VectorXd { return at_potential(t).gradient; });
  EXPECT_LT((L.constraints.col(3) - border).cwiseAbs().maxCoeff(),
            accuracy * border.cwiseAbs().maxCoeff());
  EXPECT_NEAR(difference([&](double t) { return at_potential(t).value; }),
              -L.miss(material, {L.area, L.volume}, c.state.moment)[3], accuracy * 30);
  // What the multiplier adds is in the Hessian, too.
  const Eigen::VectorXd v = random_direction(layout, node_beta, 3);
  const Eigen::VectorXd expected = difference([&](double t) -> Eigen::VectorXd {
    return assembled(material, layout, c, moved(c, layout, v, t)).gradient;
  });
  const Eigen::VectorXd product = L.hessian.selfadjointView<Eigen::Lower>() * v;
  EXPECT_LT((product - expected).cwiseAbs().maxCoeff(),
            1e-6 * (1 + expected.cwiseAbs().maxCoeff()));
}

TEST(Lagrangian3d, ties_H_to_the_surface_by_its_derivative_in_Lambda) {
  Case c = any_case();
  c.state.H = curvature_of(c.mesh, c.state.X)->H;
  const StationaryLayout layout(c.mesh, Model::SSH);
  const LagrangianDerivatives L = assembled({}, layout, c, c.state);
  EXPECT_LT(L.gradient(layout.all(node_Lambda)).cwiseAbs().maxCoeff(), 1e-11);
}

TEST(GaussianEnergy, of_a_constant_stiffness_is_that_of_Gauss_and_Bonnet) {
  const Case c = any_case();
  const Material material = general_material();
  State uniform = c.state;
  uniform.beta.setConstant(0.6);
  EXPECT_NEAR(gaussian_energy(material, c.mesh, uniform), 4 * pi * material.kappa_gauss(0.6),
              1e-12);
}

// x²/a² + y²/b² + z²/c² = 1: K = 1/(a²b²c² p⁴)… with p² = x²/a⁴ + y²/b⁴ + z²/c⁴, and on the sphere's angles
// dS = abc p sin θ dθ dφ, so that K dS = sin θ/(abc p³).
double exact_gaussian_energy(const Material& material, const Eigen::Vector3d& axes,
                             const std::function<double(const Eigen::Vector3d&)>& order) {
  const model::IntervalRule heights = model::gauss_rule(60);
  constexpr int longitudes = 120;
  double sum = 0;
  for (int k = 0; k < heights.size(); ++k)
    for (int j = 0; j < longitudes; ++j) {
      const double z = 2 * heights.points[k] - 1, r = std::sqrt(1 - z * z),
                   phi = 2 * pi * j / longitudes;
      const Eigen::Vector3d x =
          axes.cwiseProduct(Eigen::Vector3d(r * std::cos(phi), r * std::sin(phi), z));
      const double p = x.cwiseQuotient(axes.cwiseAbs2()).norm();
      sum += 2 * heights.weights[k] * 2 * pi / longitudes * material.kappa_gauss(order(x))
           / (axes.prod() * p * p * p);
    }
  return sum;
}

TEST(GaussianEnergy, converges_with_fourth_order) {
  const Eigen::Vector3d axes(1.1, 0.9, 0.6);
  const auto order = [](const Eigen::Vector3d& x) {
    return 0.4 + 0.15 * x[0] - 0.2 * x[1] * x[2] + 0.1 * std::cos(3 * x[2]);
  };
  const Material material = general_material();
  const double exact = exact_gaussian_energy(material, axes, order);
  OrderTable table("Gaussian energy of an ellipsoid with an uneven order", "h");
  for (int triangles : {80, 320, 1280, 5120}) {
    const meshing::CurvedMesh mesh = meshing::ellipsoid(axes, {.triangles = triangles});
    State state{mesh.nodes, Field(mesh.node_count())};
    for (int i = 0; i < mesh.node_count(); ++i) state.beta[i] = order(mesh.nodes.col(i));
    table.add(1 / std::sqrt(triangles),
              gaussian_energy(material, Triangulation(mesh), state) - exact);
  }
  EXPECT_GT(table.print(), 3.7);
}

}  // namespace
}  // namespace sbeh::surface3d
