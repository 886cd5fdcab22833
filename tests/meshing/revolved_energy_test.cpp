// A stationary state of the axisymmetric solver, revolved: what lives on it and its energy.
#include "meshing/revolution.h"
#include "model/energy_density.h"
#include "tests/axisym/cases.h"
#include "tests/meshing/cases.h"

#include <gtest/gtest.h>

namespace sbeh::meshing {
namespace {

using model::Model;

/// Energy of a curved mesh with an order, by quadrature of H and K.
double energy_of(const model::Material& material, const RevolvedMesh& r) {
  double sum = 0;
  for_each_point(r.mesh, 12, [&](const SurfacePoint& p) {
    Eigen::VectorXd beta(p.phi.size());
    for (Eigen::Index k = 0; k < p.phi.size(); ++k)
      beta[k] = r.beta[r.mesh.triangles(k, p.triangle)];
    const double gradient = (p.surface_grad * beta).squaredNorm();
    sum += p.dS * model::energy_density(material, beta.dot(p.phi), gradient, p.H(), p.K()).total();
  });
  return sum;
}

const axisym::StationaryState& state_of(Model model) {
  static const auto sbeh = axisym::test::first_oblate(Model::SBEH, 96);
  static const auto ssh = axisym::test::first_oblate(Model::SSH, 96);
  return model == Model::SBEH ? sbeh : ssh;
}

TEST(RevolvedState, has_its_one_dimensional_energy_to_the_fourth_order) {
  const model::Material material = axisym::test::paper_material(0.05);
  for (const Model m : {Model::SBEH, Model::SSH}) {
    const axisym::StationaryState& s = state_of(m);
    const double exact = axisym::test::energy_of(material, s).total();
    sbeh::test::OrderTable table(std::string("energy of the revolved state, ") + name(m), "h");
    for (const int count : {320, 1280, 5120}) {
      const RevolvedMesh r = revolved(s, {.triangles = count});
      table.add(std::sqrt(20. / count), energy_of(material, r) - exact);
    }
    EXPECT_GT(table.print(), 3.5);
  }
}

TEST(RevolvedState, lies_on_the_profile_with_the_order_of_the_profile) {
  const axisym::State& state = state_of(Model::SBEH);
  const RevolvedMesh r = revolved(state, {.triangles = 320});
  const ProfileCurve curve(state);
  for (int i = 0; i < r.mesh.node_count(); ++i) {
    const Eigen::Vector3d x = r.mesh.nodes.col(i);
    const Eigen::Vector2d rz(std::hypot(x[0], x[1]), x[2]);
    const double t = curve.nearest(rz);
    EXPECT_LT((curve.at(t) - rz).norm(), 1e-14);
    EXPECT_NEAR(curve.beta_at(t), r.beta[i], 1e-13);
  }
  EXPECT_LT(r.mesh.nodes.col(0).head<2>().norm(), 1e-14);  // a vertex at the pole
  EXPECT_NEAR(r.beta[0], state.beta[0], 1e-14);
}

TEST(RevolvedState, has_the_area_and_volume_of_the_profile_or_those_asked_for) {
  const axisym::State& state = state_of(Model::SBEH);
  CurvedMesh mesh = revolved(state, {.triangles = 5120}).mesh;
  EXPECT_NEAR(area(mesh) / axisym::area(state.X), 1, 3e-6);
  EXPECT_NEAR(volume(mesh) / axisym::volume(state.X), 1, 3e-6);
  ASSERT_TRUE(correct_area_volume(mesh, 4 * test::pi, 0.8));
  EXPECT_NEAR(area(mesh) / (4 * test::pi), 1, 1e-12);
  EXPECT_NEAR(reduced_volume(mesh) / 0.8, 1, 1e-12);
}

TEST(RevolvedState, is_outward_whichever_way_the_profile_runs) {
  const Profile down = state_of(Model::SBEH);
  const Profile up{.X = down.X.rowwise().reverse(), .beta = down.beta.reverse()};
  const RevolvedMesh a = revolved(down, {.triangles = 320}), b = revolved(up, {.triangles = 320});
  EXPECT_GT(volume(b.mesh), 0);
  EXPECT_LT((a.mesh.nodes - b.mesh.nodes).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((a.beta - b.beta).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Profile, that_is_none_is_refused) {
  const Profile good = state_of(Model::SBEH);
  const auto refused = [&](auto&& change) {
    Profile bad = good;
    change(bad);
    EXPECT_THROW(revolved(bad, {.triangles = 80}), std::invalid_argument);
  };
  refused([](Profile& p) { p.X.conservativeResize(2, p.X.cols() - 1); });
  refused([](Profile& p) { p.beta.conservativeResize(3); });
  refused([](Profile& p) { p.X(0, 5) = -0.1; });
  refused([](Profile& p) { p.X(0, 0) = 0.1; });
  refused([](Profile& p) { p.X(1, 7) = std::nan(""); });
  refused([](Profile& p) { p.beta[7] = std::nan(""); });
}

}  // namespace
}  // namespace sbeh::meshing
