// The systems of the coupled step against a dense sum of whole element systems, and what rigid motions
// do in them.
#include "surface3d/coupled_system.h"

#include "model/mesh_motion.h"
#include "surface3d/order_step.h"
#include "tests/model/general_material.h"
#include "tests/surface3d/cases.h"

#include <limits>
#include <vector>

namespace sbeh::surface3d {
namespace {

using namespace test;
using model::test::general_material;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double tau = 0.3;
constexpr Constraints pulled{
    .area_rate = 0.7, .volume_rate = -0.4, .keep_volume = true, .area = 4 * pi};

// A bumpy surface with an order that is nowhere constant.
Surface bumpy(int triangles) {
  const std::vector<meshing::Harmonic> modes{{2, 1, 0.1}, {3, -2, 0.15}, {4, 3, 0.1}};
  Surface s = surface_of(meshing::harmonic_sphere(modes, {.triangles = triangles}));
  for (Eigen::Index i = 0; i < s.state.beta.size(); ++i) {
    const Eigen::Vector3d x = s.state.X.col(i);
    s.state.beta[i] = 0.4 + 0.1 * x[0] - 0.15 * x[1] * x[2] + 0.12 * x[2];
  }
  return s;
}

Material frictionless() {
  Material m = general_material();
  m.friction_tangential = m.friction_normal = 0;
  return m;
}

// Positions from which the displacement counts: not those of the surface, as in a two-step method.
Nodes origin(const Surface& s) {
  Nodes from = s.state.X;
  for (Eigen::Index i = 0; i < from.cols(); ++i)
    from.col(i) += 0.02 * Eigen::Vector3d(from(1, i), from(0, i) * from(2, i), 0.3 - from(2, i));
  return from;
}
Field curvature_of_origin(const Surface& s) {
  const Nodes from = origin(s);
  return curvature_of(*s.mesh, s.state.X, &from)->H_from;
}

// All unknowns of all triangles, nothing left out: V, p, H, Y, then the multipliers.
struct Dense {
  int nodes, quadratic, multipliers;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd rhs;
  int p() const { return 3 * nodes; }
  int H() const { return p() + quadratic; }
  int Y() const { return H() + nodes; }
  int border() const { return Y() + 3 * nodes; }
};

Field some_order_force(const Surface& s) {
  return 0.3 * s.state.beta + 0.2 * s.state.X.row(1).transpose();
}

// (Y1) and (H1) for the displacement from the origin.
void add_mesh_equations(const Surface& s, int e, const ElementSystem& element, Dense& d) {
  const Nodes from = origin(s), n = node_normals(*s.mesh, s.state.X);
  for (int a = 0; a < 10; ++a)
    for (int b = 0; b < 10; ++b) {
      const int i = s.mesh->triangles(a, e), j = s.mesh->triangles(b, e);
      for (int k = 0; k < 3; ++k) {
        const double mass = element.mesh.normal_mass[std::size_t(k)](a, b);
        d.matrix(d.H() + i, d.Y() + 3 * j + k) += mass;
        d.matrix.block<1, 3>(d.H() + i, 3 * j) -= tau * mass * n(k, j) * n.col(j).transpose();
        d.matrix(d.Y() + 3 * i + k, d.H() + j) += mass;
        d.matrix(d.Y() + 3 * i + k, d.Y() + 3 * j + k) += element.mesh.stiffness(a, b);
        d.rhs[d.Y() + 3 * i + k] -= element.mesh.stiffness(a, b) * from(k, j);
      }
    }
}

Dense dense_system(const Surface& s, const Material& material, int multipliers) {
  const Triangulation& mesh = *s.mesh;
  const auto curvature = curvature_of(mesh, s.state.X);
  Dense d{.nodes = mesh.nodes,
          .quadratic = mesh.quadratic_nodes,
          .multipliers = multipliers,
          .matrix = {},
          .rhs = {}};
  const int size = d.border() + multipliers;
  d.matrix = Eigen::MatrixXd::Zero(size, size);
  d.rhs = Eigen::VectorXd::Zero(size);
  for (int e = 0; e < mesh.count(); ++e) {
    ElementSystem element;
    assemble_element(material,
                     {.X = on_element(mesh, e, s.state.X),
                      .node_normals = on_element(mesh, e, curvature->node_normals),
                      .projected_normals = on_element(mesh, e, curvature->normals),
                      .beta = on_element(mesh, e, s.state.beta),
                      .H = on_element(mesh, e, curvature->H),
                      .order_force = on_element(mesh, e, some_order_force(s))},
                     pulled.area_rate, element);
    Eigen::VectorXi index(ElementSystem::unknowns);
    for (int a = 0; a < 10; ++a) {
      for (int k = 0; k < 3; ++k) index[FlowPiece::V + 10 * k + a] = 3 * mesh.triangles(a, e) + k;
      if (a < 6) index[FlowPiece::p + a] = d.p() + mesh.quadratic(a, e);
      index[FlowPiece::H + a] = d.H() + mesh.triangles(a, e);
    }
    for (int i = 0; i < ElementSystem::tests; ++i) {
      d.rhs[index[i]] += element.rhs[i];
      for (int j = 0; j < ElementSystem::unknowns; ++j)
        d.matrix(index[i], index[j]) += element.flow(i, j);
    }
    add_mesh_equations(s, e, element, d);
    for (int i = 0; i < 30; ++i)
      for (int k = 0; k < multipliers; ++k) {
        d.matrix(index[i], d.border() + k) += element.constraints(i, k);
        d.matrix(d.border() + k, index[i]) += element.constraints(i, k);
      }
  }
  d.rhs[d.border()] = pulled.volume_rate;
  // The mesh settles at a finite rate: of the residual of (H1) on the old surface the share θ only.
  const double theta = model::mesh_share(tau);
  const auto H1 = d.matrix.block(d.Y(), d.H(), 3 * d.nodes, d.nodes);
  auto rhs = d.rhs.segment(d.Y(), 3 * d.nodes);
  rhs = (theta * rhs + (1 - theta) * (H1 * curvature_of_origin(s))).eval();
  return d;
}

CoupledSystem assembled(const Surface& s, const Material& material, Scheme scheme) {
  CoupledSystem system(*s.mesh, material, scheme);
  system.assemble(*s.mesh, s.state, *curvature_of(*s.mesh, s.state.X), some_order_force(s),
                  {origin(s), curvature_of_origin(s)}, tau, pulled);
  return system;
}

// Sums of at most some hundred numbers, in another order.
void expect_equal(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  ASSERT_EQ(a.rows(), b.rows());
  ASSERT_EQ(a.cols(), b.cols());
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 100 * epsilon * b.cwiseAbs().maxCoeff());
}

TEST(CoupledSystem, monolithic_leaves_out_nothing_of_the_element_systems) {
  const Surface s = bumpy(20);
  for (const auto& [material, multipliers] :
       {std::pair{general_material(), 7}, std::pair{frictionless(), 7}}) {
    const CoupledSystem system = assembled(s, material, Scheme::monolithic);
    const Dense d = dense_system(s, material, multipliers);
    expect_equal(Eigen::MatrixXd(system.flow().matrix), d.matrix);
    expect_equal(system.flow().rhs, d.rhs);
  }
}

// Of the displacement Y the normal part is by (Y1), the tangential one by (H1) tested tangentially, with
// the H and the normal part of the V of the flow.
void expect_motion_of(const CoupledSystem& system, const Surface& s, const Dense& d) {
  const Nodes n = node_normals(*s.mesh, s.state.X);
  const Eigen::VectorXd flow = Eigen::VectorXd::Random(system.flow().rhs.size()),
                        none = Eigen::VectorXd::Zero(2 * d.nodes);
  const Nodes V = system.velocity(flow);
  const auto normal_part = [&n](const Nodes& W) -> Nodes {
    return n * W.cwiseProduct(n).colwise().sum().asDiagonal();
  };
  const auto Y1 = d.matrix.middleRows(d.H(), d.nodes);
  const Eigen::VectorXd flux = Y1.leftCols(3 * d.nodes) * V.reshaped();  // by its normal part
  const Nodes still = system.displacement(flow, none);
  EXPECT_LT((still - normal_part(still)).norm(), 1e-13);
  Eigen::MatrixXd T(3 * d.nodes, 2 * d.nodes);
  for (int j = 0; j < 2 * d.nodes; ++j) {
    const Nodes Y = system.displacement(flow, Eigen::VectorXd::Unit(2 * d.nodes, j));
    EXPECT_LT((Y1.middleCols(d.Y(), 3 * d.nodes) * Y.reshaped() + flux).norm(), 1e-7 * flux.norm());
    T.col(j) = (Y - normal_part(Y)).reshaped();
  }
  EXPECT_LT((T.transpose() * T - Eigen::MatrixXd::Identity(2 * d.nodes, 2 * d.nodes)).norm(),
            1e-12);

  const auto Z_rows = d.matrix.middleRows(d.Y(), 3 * d.nodes);
  const Eigen::MatrixXd stiffness = Z_rows.middleCols(d.Y(), 3 * d.nodes);
  expect_equal(Eigen::MatrixXd(system.motion().matrix), T.transpose() * stiffness * T);
  expect_equal(
      system.motion_rhs(flow),
      T.transpose()
          * (d.rhs.segment(d.Y(), 3 * d.nodes) - stiffness * normal_part(tau * V).reshaped()
             - Z_rows.middleCols(d.H(), d.nodes) * system.curvature(flow)));
}

// In the split scheme the nodes are displaced along their normals in the equation (H1), by the share of
// the origin and of τV, and it is tested with Z = φ_i n_i.
TEST(CoupledSystem, split_is_the_monolithic_one_with_motion_and_tests_along_the_normals) {
  const Surface s = bumpy(20);
  const Nodes n = node_normals(*s.mesh, s.state.X);
  for (const auto& [material, multipliers] :
       {std::pair{general_material(), 7}, std::pair{frictionless(), 7}}) {
    const Dense d = dense_system(s, material, multipliers);
    const int size = d.Y() + multipliers, whole = d.border() + multipliers;
    Eigen::MatrixXd unknowns = Eigen::MatrixXd::Zero(whole, size), tests = unknowns.transpose();
    unknowns.topLeftCorner(d.Y(), d.Y()).setIdentity();
    for (int i = 0; i < d.nodes; ++i)
      unknowns.block<3, 3>(d.Y() + 3 * i, 3 * i) = tau * n.col(i) * n.col(i).transpose();
    unknowns.bottomRightCorner(multipliers, multipliers).setIdentity();
    tests.topLeftCorner(d.H(), d.H()).setIdentity();
    for (int i = 0; i < d.nodes; ++i)
      tests.block<1, 3>(d.H() + i, d.Y() + 3 * i) = n.col(i).transpose();
    tests.bottomRightCorner(multipliers, multipliers).setIdentity();

    const CoupledSystem system = assembled(s, material, Scheme::split);
    expect_equal(Eigen::MatrixXd(system.flow().matrix), tests * d.matrix * unknowns);
    const Nodes foot =
        s.state.X
        + n * n.cwiseProduct(origin(s) - s.state.X).colwise().sum().asDiagonal().toDenseMatrix();
    Eigen::VectorXd rhs_along = d.rhs;
    rhs_along.segment(d.Y(), 3 * d.nodes) =
        -d.matrix.block(d.Y(), d.Y(), 3 * d.nodes, 3 * d.nodes) * foot.reshaped();
    expect_equal(system.flow().rhs, tests * rhs_along);

    expect_motion_of(system, s, d);
  }
}

TEST(CoupledSystem, motion_is_symmetric) {
  const CoupledSystem system = assembled(bumpy(20), general_material(), Scheme::split);
  const Eigen::MatrixXd motion(system.motion().matrix);
  expect_equal(motion, motion.transpose());
}

TEST(CoupledSystem, takes_its_solution_apart_in_the_order_of_the_unknowns) {
  const Surface s = bumpy(20);
  for (const Scheme scheme : {Scheme::split, Scheme::monolithic}) {
    const CoupledSystem system = assembled(s, frictionless(), scheme);
    const int N = s.mesh->nodes, Q = s.mesh->quadratic_nodes, size = int(system.flow().rhs.size());
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(size, 0, size - 1);
    EXPECT_EQ(system.velocity(x)(2, 5), 3 * 5 + 2);
    EXPECT_EQ(system.pressure(x)[Q - 1], 3 * N + Q - 1);
    EXPECT_EQ(system.curvature(x)[4], 3 * N + Q + 4);
    EXPECT_EQ(system.lambda(x), size - 7);
    if (scheme == Scheme::split) continue;
    EXPECT_EQ(system.displacement(x, {})(1, 3), 4 * N + Q + 3 * 3 + 1);
  }
}

TEST(CoupledSystem, sets_the_volume_multiplier_to_zero_on_a_sphere) {
  const Surface s = bumpy(20);
  CoupledSystem system(*s.mesh, general_material(), Scheme::split);
  system.assemble(*s.mesh, s.state, *curvature_of(*s.mesh, s.state.X), some_order_force(s),
                  {origin(s), curvature_of_origin(s)}, tau,
                  {.area_rate = 0, .volume_rate = 5, .keep_volume = false, .area = 4 * pi});
  const Eigen::MatrixXd A(system.flow().matrix);
  const Eigen::Index lambda = A.rows() - 7;
  EXPECT_EQ(system.flow().rhs[lambda], 0);
  EXPECT_GT(A(lambda, lambda), 0);
  EXPECT_EQ(A.row(lambda).norm(), A(lambda, lambda));
  EXPECT_EQ(A.col(lambda).norm(), A(lambda, lambda));
}

// ---- rigid motions ----------------------------------------------------------------------------------

// Translations and rotations as velocities at the nodes.
std::vector<Nodes> rigid_motions(const Nodes& X) {
  std::vector<Nodes> motions;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(k);
    motions.emplace_back(axis.replicate(1, X.cols()));
    Nodes turn(3, X.cols());
    for (Eigen::Index i = 0; i < X.cols(); ++i) turn.col(i) = axis.cross(X.col(i));
    motions.push_back(turn);
  }
  return motions;
}

TEST(RigidMotions, have_no_strain) {
  const Surface s = bumpy(20);
  const Dense d = dense_system(s, frictionless(), 1);
  const auto velocity_columns = d.matrix.topLeftCorner(3 * d.nodes, 3 * d.nodes);
  for (const Nodes& R : rigid_motions(s.state.X)) {
    const Eigen::VectorXd force = velocity_columns * R.reshaped();  // (V1)
    EXPECT_LT(force.cwiseAbs().maxCoeff(), 1000 * epsilon * velocity_columns.cwiseAbs().maxCoeff());
  }
  const Nodes stretch = s.state.X;  // one that is none
  EXPECT_GT((velocity_columns * stretch.reshaped()).norm(), 0.1);
}

TEST(RigidMotions, feel_no_force_and_have_no_divergence_up_to_the_error_of_the_normals) {
  // (V5) … (V12) against R: the energy does not change; (P1) of R, in the mean over the P2 functions.
  OrderTable forces("elastic force on a rigid motion", "h"), divergence("its divergence", "h");
  for (const int triangles : {320, 1280}) {
    const Surface s = bumpy(triangles);
    const auto curvature = curvature_of(*s.mesh, s.state.X);
    CoupledSystem system(*s.mesh, general_material(), Scheme::split);
    system.assemble(*s.mesh, s.state, *curvature,
                    order_force(*s.mesh, general_material(), s.state, *curvature),
                    {s.state.X, curvature->H}, tau,
                    {.area_rate = 0, .volume_rate = 0, .keep_volume = true, .area = 4 * pi});
    const int N = s.mesh->nodes, first = 3 * N + s.mesh->quadratic_nodes;
    Eigen::VectorXd x = Eigen::VectorXd::Zero(system.flow().rhs.size());
    x.segment(first, N) = curvature->H;
    const Eigen::VectorXd force = (system.flow().matrix * x - system.flow().rhs).head(3 * N);
    double power = 0, rate = 0;
    for (const Nodes& R : rigid_motions(s.state.X)) {
      power = std::max(power, std::abs(force.dot(R.reshaped())));
      x.setZero();
      x.head(3 * N) = R.reshaped();
      rate += (system.flow().matrix * x).segment(3 * N, s.mesh->quadratic_nodes).lpNorm<1>();
    }
    forces.add(1 / std::sqrt(triangles), power);
    divergence.add(1 / std::sqrt(triangles), rate);
  }
  EXPECT_GT(forces.print(), 2);
  EXPECT_GT(divergence.print(), 2);
}

}  // namespace
}  // namespace sbeh::surface3d
