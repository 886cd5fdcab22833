// The L² flows of the Helfrich energy: other ways to the states of rest of SSH.
#include "tests/axisym/cases.h"
#include "tests/model/finite_difference.h"

#include <algorithm>

namespace sbeh::axisym {
namespace {

using namespace test;

constexpr int elements = 48;

// What an observer sees of a run from the spheroid to rest.
struct Way {
  FlowResult run;
  std::vector<double> energies;                               // at the output times
  double largest_rise = 0, area_drift = 0, volume_drift = 0;  // relative
};

Way way_to_rest(Model model, double reduced_volume, const std::vector<double>& times) {
  const Material material = paper_material(0.05);
  const Target target = target_of(reduced_volume);
  Way way{.run = {}, .energies = {}};
  double before = std::numeric_limits<double>::infinity();
  way.run = run_flow(material, model, ordered_spheroid(reduced_volume, elements), target, {},
                     {.end_time = 300, .output_times = times},
                     [&](const FlowRecord& record, const State& state, bool exact) {
                       const double U = record.energy.total();
                       way.largest_rise = std::max(way.largest_rise, (U - before) / std::abs(U));
                       before = U;
                       way.area_drift =
                           std::max(way.area_drift, std::abs(area(state.X) / target.area - 1));
                       way.volume_drift = std::max(way.volume_drift,
                                                   std::abs(volume(state.X) / target.volume - 1));
                       if (exact) way.energies.push_back(U);
                       return true;
                     });
  std::printf(
      "%-15s V_r %.1f: U = %.10f, %s at t = %.2f, %d steps, %d rejected; drift of A %.0e, V %.0e\n",
      name(model), reduced_volume, way.run.last.energy.total(), describe(way.run.stop).c_str(),
      way.run.last.time, way.run.steps, way.run.last.rejected, way.area_drift, way.volume_drift);
  return way;
}

TEST(HelfrichFlow, rests_where_SSH_rests_and_gets_there_in_another_way) {
  const std::vector<double> times{0.001, 0.01};
  for (const double v : {0.6, 0.8}) {
    const double at_rest =
        energy_of(paper_material(0.05), oblate(Model::SSH, {v, 0.05}, elements)).total();
    std::vector<Way> ways;
    for (const Model model : {Model::SSH, Model::HelfrichLocal, Model::HelfrichGlobal}) {
      const Way way = way_to_rest(model, v, times);
      EXPECT_EQ(way.run.stop, FlowStop::at_rest);
      EXPECT_NEAR(way.run.last.energy.total(), at_rest, 1e-8 * std::abs(at_rest));
      EXPECT_LT(way.largest_rise, 1e-10);  // rounding of the sums
      EXPECT_LT(way.area_drift, 2e-12);    // Newton's method restores them to 1e-12
      EXPECT_LT(way.volume_drift, 2e-12);
      EXPECT_EQ(way.run.state.beta, Field::Constant(way.run.state.beta.size(), model::full_order));
      ASSERT_EQ(way.energies.size(), times.size());
      // A history is good to 1e-6: a thousand times that is another way.
      for (const Way& other : ways)
        for (std::size_t k = 0; k < times.size(); ++k)
          EXPECT_GT(std::abs(way.energies[k] - other.energies[k]), 1e-3) << "t = " << times[k];
      ways.push_back(way);
    }
  }
}

// ---- one step under a global area constraint ----------------------------------------------------

// ∫ f(values at a point) over the curve.
template <class Integrand>
double integral(const Nodes& X, Integrand&& f) {
  double sum = 0;
  for_each_point(X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    sum += p.dS * f(e, s, p);
  });
  return sum;
}

// W·ν at a point.
double normal_part(const Nodes& W, int e, const ShapeValues& s, const CurvePoint& p) {
  return value_at(W.row(0).transpose(), e, s) * p.nu[0]
       + value_at(W.row(1).transpose(), e, s) * p.nu[1];
}

// Exact for the discrete equations: (H1) defines H by ∫ H W·ν = −∫ Div_C W for all W along the normals.
TEST(GlobalFlow, moves_along_the_normals_and_changes_area_and_volume_as_asked) {
  const State s = ordered_spheroid(0.7, elements);
  const Nodes n = node_normals(s.X);
  const Field H = mean_curvature(s.X);
  const double tau = 1e-4, A = area(s.X), V = volume(s.X);
  TimeStepper stepper(paper_material(0.05), Model::HelfrichGlobal, elements);
  for (const double excess : {0., 1e-3}) {
    const Target target{A * (1 + excess), V * (1 - 2 * excess)};
    const FlowStep r = stepper.step(s, target, tau);
    ASSERT_TRUE(r.ok());
    const Nodes& v = stepper.fields().V;
    const double speed = v.colwise().norm().maxCoeff(), rounding = 1e-9 * speed * A;
    const Nodes along = n * v.cwiseProduct(n).colwise().sum().asDiagonal();
    EXPECT_LT((v - along).cwiseAbs().maxCoeff(), 1e-14 * speed);
    EXPECT_EQ(stepper.fields().p.minCoeff(), stepper.fields().p.maxCoeff());
    const double growth = -integral(s.X, [&](int e, const ShapeValues& at, const CurvePoint& p) {
      return value_at(H, e, at) * normal_part(v, e, at, p);
    });
    const double flux = integral(s.X, [&](int e, const ShapeValues& at, const CurvePoint& p) {
      return normal_part(v, e, at, p);
    });
    EXPECT_NEAR(growth, (target.area - A) / tau, rounding);
    EXPECT_NEAR(flux, (target.volume - V) / tau, rounding);
    const double friction = integral(s.X, [&](int e, const ShapeValues& at, const CurvePoint& p) {
      return std::pow(normal_part(v, e, at, p), 2);
    });
    EXPECT_NEAR(r.dissipation.friction, friction, 1e-12 * friction);
    EXPECT_EQ(r.dissipation.viscous, 0);
  }
}

// v_n + pH + λ = f_B, tested with w = cos kϑ (ϑ the normal's angle to the axis) along the normals. The
// bending force is that of the displaced surface's energy; the step takes H at its end, O(τ) later.
TEST(GlobalFlow, has_the_speed_of_the_bending_force_less_the_multipliers) {
  Material material = paper_material(0.05);
  material.spontaneous_curvature = -0.7;
  const State s = ordered_spheroid(0.7, elements);
  const Nodes n = node_normals(s.X);
  const Field H = mean_curvature(s.X);
  TimeStepper stepper(material, Model::HelfrichGlobal, elements);
  for (const int k : {0, 2, 4}) {
    Nodes W = n;
    for (Eigen::Index i = 0; i < W.cols(); ++i)
      W.col(i) *= std::cos(k * std::atan2(n(0, i), n(1, i)));
    const double force = -model::test::derivative_at_zero(
        [&](double shift) {
          return energy_of(material, State{s.X + shift * W, s.beta}).bending;
        },
        1e-3);
    OrderTable miss("cos " + std::to_string(k) + "theta: force off " + std::to_string(force),
                    "tau");
    for (const double tau : {1e-7, 5e-8, 2.5e-8, 1.25e-8}) {
      const FlowStep r = stepper.step(s, {}, tau);
      ASSERT_TRUE(r.ok());
      const double left = integral(s.X, [&](int e, const ShapeValues& at, const CurvePoint& p) {
        return (normal_part(stepper.fields().V, e, at, p)
                + stepper.fields().p[0] * value_at(H, e, at) + stepper.fields().lambda)
             * normal_part(W, e, at, p);
      });
      miss.add(tau, left - force);
    }
    EXPECT_NEAR(miss.print(), 1, 0.1);
  }
}

}  // namespace
}  // namespace sbeh::axisym
