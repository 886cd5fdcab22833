// Modes as files: what they hold, how they lie on a revolved mesh, and what is no mode.
#include "studies/modes/mode_file.h"

#include "axisym/start_shapes.h"
#include "studies/io/columns.h"
#include "studies/io/errors.h"
#include "studies/mesh_files/mesh_file.h"
#include "tests/studies/parameters/input_file.h"

#include <cmath>

namespace sbeh::studies {
namespace {

using namespace test;

// Displaces the unit sphere by sin²θ cos 2φ, and changes its order by half of that.
StateMode mode_of_sphere() {
  constexpr int elements = 24;
  StateMode mode{
      {model::Model::SBEH, model::Material{}.with_L(0.03)},
      {axisym::spheroid(1., 1., elements, 0), axisym::Field::Constant(3 * elements + 1, 0.6)},
      {.m = 2, .parity = axisym::Parity::even, .number = 3},
      -0.125,
      not_known,
      {},
      {}};
  mode.u = mode.state.X.row(0).array().square().transpose();
  mode.b = mode.u / 2;
  return mode;
}

TEST(ModeFile, reads_back_as_the_same_bits) {
  const StateMode mode = mode_of_sphere();
  const auto path = path_of("mode.vtu");
  write_mode(path, mode);
  const StateMode back = read_mode(path);
  EXPECT_EQ(static_cast<const Physics&>(back), static_cast<const Physics&>(mode));
  EXPECT_EQ(stem(back.key), "m2_even_3");
  EXPECT_EQ(back.eigenvalue, -0.125);
  EXPECT_TRUE(std::isnan(back.rate));
  EXPECT_TRUE(back.state.X == mode.state.X);
  EXPECT_TRUE(back.state.beta == mode.state.beta);
  EXPECT_TRUE(back.u == mode.u);
  EXPECT_TRUE(back.b == mode.b);
}

// The profile's cubic elements are what differs from the sphere: their normals by the slope's error at an end, h³/108.
TEST(ModeFile, has_the_mode_at_the_nodes_of_its_surface) {
  const auto path = path_of("mode.vtu");
  write_mode(path, mode_of_sphere());
  const auto file = read_curved_mesh(path);
  ASSERT_TRUE(file);
  const double accuracy = std::pow(std::numbers::pi / 24, 3) / 108;
  for (Eigen::Index i = 0; i < file->mesh.nodes.cols(); ++i) {
    const Eigen::Vector3d x = file->mesh.nodes.col(i).normalized();
    const double wave = x[0] * x[0] - x[1] * x[1];  // sin²θ cos 2φ
    EXPECT_LT((file->fields.at("displacement").col(i) - wave * x).norm(), accuracy);
    EXPECT_NEAR(file->fields.at("order_change")(0, i), wave / 2, accuracy);
    EXPECT_NEAR(file->fields.at("order")(0, i), 0.6, 1e-12);
  }
}

TEST(ModeFile, has_its_largest_displacement_1_and_outward) {
  axisym::Field u(4), b(4);
  u << 0.1, -0.5, 0.2, -0.5;
  b << 0, 0.3, -1, 0;
  normalise(u, b);
  EXPECT_TRUE(u.isApprox(Eigen::Vector4d(-0.2, 1, -0.4, 1)));
  EXPECT_TRUE(b.isApprox(Eigen::Vector4d(0, -0.6, 2, 0)));
}

TEST(ModeFile, that_is_none_is_refused) {
  const auto sphere = path_of("sphere.vtu");
  write_mesh(sphere, revolved(mode_of_sphere(), {.triangles = 80}).mesh);
  const auto message = [](const std::filesystem::path& path) {
    try {
      read_mode(path);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(message(sphere),
            sphere.string() + ": is no mode of sbeh modes: it lacks the field mode");
  EXPECT_NE(message(path_of("nothing.vtu")), "accepted");
}

}  // namespace
}  // namespace sbeh::studies
