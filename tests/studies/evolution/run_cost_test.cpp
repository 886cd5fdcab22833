// What a 3D run is said to cost.
#include "meshing/shapes.h"
#include "studies/evolution/run_start.h"
#include "surface3d/coupled_system.h"

#include <gtest/gtest.h>

#include <numbers>

namespace sbeh::studies {
namespace {

using model::Model;

TEST(RunCost, counts_the_unknowns_of_the_solver) {
  const meshing::CurvedMesh nodes = meshing::sphere({.triangles = 20});
  const surface3d::Triangulation mesh(nodes);
  const surface3d::State sphere{nodes.nodes,
                                surface3d::Field::Constant(mesh.nodes, model::full_order)};
  for (const Model model : {Model::SBEH, Model::SSH, Model::HelfrichLocal, Model::HelfrichGlobal})
    for (const surface3d::Scheme scheme : {surface3d::Scheme::split, surface3d::Scheme::monolithic})
      for (const double friction : {0.0, 0.1}) {
        RunInput input;
        input.model = model;
        input.numerics.scheme = scheme;
        input.material.friction_tangential = input.material.friction_normal = friction;
        const model::Material m = effective(input.material, model);
        const model::AreaConstraint area = area_constraint(model);
        surface3d::CoupledSystem system(mesh, m, scheme, area);
        const surface3d::Curvature curvature = *curvature_of(mesh, sphere.X);
        system.assemble(
            mesh, sphere, curvature, sphere.beta, {sphere.X, curvature.H}, 1e-3,
            {.area_rate = 0, .volume_rate = 0, .keep_volume = true, .area = 4 * std::numbers::pi});
        EXPECT_EQ(cost_of(input, 20).unknowns, system.flow().matrix.rows()) << name(model);
      }
}

TEST(RunCost, is_near_what_was_measured) {
  struct Measured {
    int triangles;
    surface3d::Scheme scheme;
    double seconds, megabytes;
  };
  using enum surface3d::Scheme;
  for (const Measured& run :
       {Measured{80, split, 0.0075, 48}, Measured{320, split, 0.0325, 110},
        Measured{1280, split, 0.156, 312}, Measured{1280, monolithic, 0.29, 470},
        Measured{5120, split, 0.84, 1207}}) {
    RunInput input;
    input.numerics.scheme = run.scheme;
    const RunCost cost = cost_of(input, run.triangles);
    EXPECT_NEAR(cost.seconds_per_step / run.seconds, 1, 0.25);
    EXPECT_NEAR(cost.megabytes / run.megabytes, 1, 0.25);
  }
}

TEST(RunCost, of_other_methods_is_within_a_factor_of_two_of_what_was_measured) {
  using enum surface3d::Integrator;
  using enum surface3d::Factorisation;
  struct Measured {
    int triangles;
    Model model;
    surface3d::Integrator integrator;
    surface3d::Factorisation factorisation;
    double seconds;
  };
  for (const Measured& run : {Measured{80, Model::SBEH, step_doubling, lagged, 0.0212},
                              Measured{320, Model::SBEH, step_doubling, lagged, 0.088},
                              Measured{1280, Model::SBEH, step_doubling, lagged, 0.429},
                              Measured{80, Model::SBEH, two_step, every_step, 0.0147},
                              Measured{320, Model::SBEH, two_step, every_step, 0.0761},
                              Measured{1280, Model::SBEH, two_step, every_step, 0.412},
                              Measured{80, Model::HelfrichGlobal, two_step, lagged, 0.0060},
                              Measured{320, Model::HelfrichGlobal, two_step, lagged, 0.0225},
                              Measured{1280, Model::HelfrichGlobal, two_step, lagged, 0.104},
                              Measured{320, Model::HelfrichGlobal, step_doubling, lagged, 0.0632},
                              Measured{320, Model::HelfrichLocal, two_step, lagged, 0.0311},
                              Measured{720, Model::SSH, two_step, lagged, 0.0838}}) {
    RunInput input;
    input.model = run.model;
    input.numerics.integrator = run.integrator;
    input.numerics.factorisation = run.factorisation;
    const double ratio = cost_of(input, run.triangles).seconds_per_step / run.seconds;
    EXPECT_GT(ratio, 0.5) << run.triangles << name(run.model);
    EXPECT_LT(ratio, 2) << run.triangles << name(run.model);
  }
}

}  // namespace
}  // namespace sbeh::studies
