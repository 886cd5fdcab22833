// Runs that watch over their mesh: new triangles, what cannot be resolved, surfaces that touch.
#include "meshing/revolution.h"
#include "tests/surface3d/cases.h"

#include <algorithm>
#include <numbers>

namespace sbeh::surface3d {
namespace {

using namespace test;

// A flat oblate, of whose rim 180 triangles do not see enough.
Surface flat(int triangles, double reduced_volume = 0.7) {
  return surface_of(meshing::ellipsoid(reduced_volume, false, {.triangles = triangles}));
}

struct Watched {
  FlowResult run;
  std::vector<int> triangles;  // after each step
  std::vector<RemeshReport> changes;
  std::vector<std::string> refusals;
  bool resolved = false;  // at the end
};

Watched watch(const Surface& s, const Numerics& numerics, double end) {
  Watched w{.run = {}, .triangles = {}, .changes = {}, .refusals = {}};
  const Target target = s.target();
  w.run = run_flow(paper_material(0.05), Model::SSH, {s.mesh, s.state, target}, numerics,
                   {.end_time = end, .output_times = {}},
                   [&](const FlowRecord& record, const State& x, const StepView& view, bool) {
                     EXPECT_EQ(x.X.cols(), view.mesh->nodes);
                     EXPECT_NEAR(area(*view.mesh, x.X) / target.area, 1, 1e-11);
                     EXPECT_NEAR(volume(*view.mesh, x.X) / target.volume, 1, 1e-11);
                     w.triangles.push_back(view.mesh->count());
                     w.resolved = resolved(view.indicators);
                     if (view.remeshed && view.remeshed->mesh) {
                       w.changes.push_back(view.remeshed->report);
                       EXPECT_EQ(record.next_step, numerics.first_step);
                     }
                     if (view.remeshed && !view.remeshed->mesh)
                       w.refusals.push_back(view.remeshed->refusal);
                     return true;
                   });
  return w;
}

TEST(MeshWatch, makes_new_triangles_where_they_do_not_resolve_the_surface_and_goes_on) {
  Numerics numerics;
  numerics.remesh = true;
  numerics.most_triangles = 620;
  numerics.first_step = 1e-6;
  const Watched w = watch(flat(180, 0.75), numerics, 4e-5);
  EXPECT_EQ(w.run.stop, FlowStop::end_time);
  ASSERT_FALSE(w.changes.empty()) << w.refusals.front();
  EXPECT_GT(w.triangles.back(), 240);
  EXPECT_TRUE(w.resolved);
  for (const RemeshReport& change : w.changes) {
    EXPECT_LT(std::abs(change.energy_change), RemeshOptions().largest_energy_change);
    EXPECT_GT(change.min_angle_after, 25);
  }
}

TEST(MeshWatch, leaves_the_triangles_alone_unless_it_is_asked) {
  const Watched w = watch(flat(180), {}, 1e-4);
  EXPECT_EQ(w.run.stop, FlowStop::end_time);
  EXPECT_TRUE(w.changes.empty() && w.refusals.empty());
  EXPECT_EQ(std::count(w.triangles.begin(), w.triangles.end(), 180), long(w.triangles.size()));
  EXPECT_FALSE(w.resolved);
}

TEST(MeshWatch, tries_once_where_no_more_triangles_are_allowed) {
  Numerics numerics;
  numerics.remesh = true;
  numerics.most_triangles = 180;
  const Watched w = watch(flat(180), numerics, 2e-4);
  EXPECT_EQ(w.run.stop, FlowStop::end_time);
  EXPECT_GE(w.changes.size() + w.refusals.size(), 1u);
  EXPECT_LE(w.changes.size() + w.refusals.size(), 2u);
  EXPECT_NEAR(w.triangles.back(), 180, 18);
}

// A biconcave disc whose poles are `gap` apart.
Surface disc(double gap) {
  constexpr int nodes = 181;
  meshing::Profile profile{.X = Eigen::Matrix2Xd(2, nodes), .beta = {}};
  for (int i = 0; i < nodes; ++i) {
    const double theta = std::numbers::pi * i / (nodes - 1), s = std::sin(theta);
    profile.X.col(i) << (i == nodes - 1 ? 0 : 1.2 * s), (gap / 2 + 0.5 * s * s) * std::cos(theta);
  }
  return surface_of(meshing::revolved(profile, {.triangles = 320}).mesh);
}

TEST(MeshWatch, ends_a_run_whose_surface_touches_itself) {
  const Watched touching = watch(disc(0.002), {}, 1);
  EXPECT_EQ(touching.run.stop, FlowStop::self_contact);
  EXPECT_EQ(touching.run.steps, 1);
  EXPECT_EQ(touching.run.last.ends, FlowStop::self_contact);
  const Watched near = watch(disc(0.02), {}, 1);  // its poles go on towards each other
  EXPECT_EQ(near.run.stop, FlowStop::self_contact);
  EXPECT_GT(near.run.steps, 5);
}

}  // namespace
}  // namespace sbeh::surface3d
