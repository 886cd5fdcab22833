// How stationary states converge under refinement, and what the default resolution is good for.
#include "tests/axisym/cases.h"

namespace sbeh::axisym {
namespace {

using namespace test;

// ∫ H² dS/16π: the bending energy without its Gaussian part in units of the sphere's, F/8πκ.
double bending_in_units_of_the_sphere(const StationaryState& s) {
  double sum = 0;
  for_each_point(s.X, diagnostic_points(), [&](int e, const ShapeValues& q, const CurvePoint& p) {
    const double h = value_at(s.H, e, q);
    sum += p.dS * h * h;
  });
  return sum / (16 * pi);
}

struct Case {
  Model model;
  PlanePoint at;
};

// Differences from one mesh to the next: their ratio shows the order without an exact solution.
// The observed order still carries the next power of h: a quarter of an order at 24 elements.
constexpr double slack = 0.25;

TEST(StationaryState,
     converges_at_order_6_in_the_energy_and_at_order_4_and_more_in_shape_and_order) {
  for (const Case& c : {Case{Model::SSH, {0.8, 0.05}}, Case{Model::SBEH, {0.7, 0.05}},
                        Case{Model::SBEH, {0.6, 0.069}}}) {
    char title[80];
    std::snprintf(title, sizeof title, "%s at (%g, %g): ", name(c.model), c.at.reduced_volume,
                  c.at.L);
    OrderTable U(std::string(title) + "energy, relative", "h"), r("  r_equator", "h"),
        z("  thickness", "h"), rim("  order at the rim", "h"), pole("  order at the pole", "h");
    BranchState b = oblate(c.model, c.at, 24);
    double energy_before = 0;
    Diagnostics before{};
    double pole_before = 0;
    for (const int elements : {24, 48, 96, 192}) {
      b = refined(c.model, b, elements);
      const Material material = paper_material(c.at.L);
      const double energy = energy_of(material, b).total();
      const Diagnostics d = diagnose(material, b);
      const double at_pole = b.beta[0];
      if (elements > 24) {
        const double h = 2. / elements;
        U.add(h, energy / energy_before - 1);
        r.add(h, d.radius_equator - before.radius_equator);
        z.add(h, d.thickness_pole - before.thickness_pole);
        rim.add(h, d.order_min - before.order_min);
        pole.add(h, at_pole - pole_before);
      }
      energy_before = energy;
      before = d;
      pole_before = at_pole;
    }
    EXPECT_GT(U.print(), 6 - slack);
    EXPECT_GT(r.print(), 4 - slack);
    EXPECT_GT(z.print(), 4 - slack);
    if (c.model == Model::SSH) continue;
    EXPECT_GT(rim.print(), 4 - slack);
    EXPECT_GT(pole.print(), 4 - slack);
  }
}

TEST(StationaryState, of_SSH_at_08_has_the_known_bending_energy_at_the_default_resolution) {
  const BranchState b = oblate(Model::SSH, {0.8, 0.05}, Numerics{}.elements);
  // The reference has 8 digits: from the shape equation by shooting.
  EXPECT_NEAR(bending_in_units_of_the_sphere(b), 1.4525386, 1e-7);
}

TEST(StationaryState, keeps_its_energy_to_1e_7_when_the_default_elements_are_doubled) {
  const int elements = Numerics{}.elements;
  for (const Model model : {Model::SBEH, Model::SSH}) {
    BranchState row = first_oblate(model);
    std::printf("%s: relative change of the energy from %d to %d elements\n", name(model), elements,
                2 * elements);
    for (const double v : {0.8, 0.7, 0.6}) {
      row = reach(model, row, {v, 0.05});
      for (const double L : {0.01, 0.03, 0.05, 0.07}) {
        const BranchState b = refined(model, reach(model, row, {v, L}), elements);
        const BranchState fine = refined(model, b, 2 * elements);
        const Material material = paper_material(L);
        const double change =
            energy_of(material, b).total() / energy_of(material, fine).total() - 1;
        std::printf("  V_r %.1f L %.2f: %.1e\n", v, L, change);
        EXPECT_LT(std::abs(change), 1e-7) << name(model) << " at V_r = " << v << ", L = " << L;
      }
    }
  }
}

TEST(StationaryState, has_the_energy_of_the_flow_at_rest_to_1e_7) {
  const PlanePoint at{0.7, 0.05};
  const Material material = paper_material(at.L);
  for (const Model model : {Model::SBEH, Model::SSH}) {
    const BranchState b = oblate(model, at, Numerics{}.elements);
    const double expected = energy_of(material, b).total();
    Numerics halved;
    halved.tolerance /= 2;
    halved.largest_step /= 2;
    for (const Numerics& numerics : {Numerics{}, halved}) {
      const FlowResult run =
          run_flow(material, model, ordered_spheroid(at.reduced_volume, numerics.elements),
                   target_of(at.reduced_volume), numerics, {.end_time = 100, .output_times = {}});
      EXPECT_EQ(run.stop, FlowStop::at_rest);
      const double change = run.last.energy.total() / expected - 1;
      std::printf("%s, tolerance %.1e: flow against Newton %.1e, at rest at t = %.2f\n",
                  name(model), numerics.tolerance, change, run.last.time);
      EXPECT_LT(std::abs(change), 1e-7);
    }
  }
}

}  // namespace
}  // namespace sbeh::axisym
