// Membranes whose order is conserved: two phases, their states of rest, the line tension between them, the energy law.
#include "axisym/modes/eigenmodes.h"
#include "axisym/modes/growth_rates.h"
#include "axisym/order_step.h"
#include "axisym/stationary/stability.h"
#include "tests/axisym/cases.h"
#include "tests/model/two_phases.h"

namespace sbeh::axisym {
namespace {

using namespace test;
using model::OrderDynamics;
using model::test::two_phases;

constexpr double pi = std::numbers::pi;

// Rich around the north pole.
State with_a_cap(double V_r, int elements, double height, double width) {
  State s = ordered_spheroid(V_r, elements);
  for (Eigen::Index i = 0; i < s.beta.size(); ++i)
    s.beta[i] = 0.35 + 0.25 * std::tanh((s.X(1, i) - height) / width);
  return s;
}
double total_order(const State& s) { return diagnose({}, s).order_mean * area(s.X); }
double mean_order(const State& s) { return total_order(s) / area(s.X); }

TEST(ConservedOrder, comes_to_rest_where_newtons_method_does) {
  const State start = with_a_cap(0.9, 48, 0.3, 0.2);
  double energies[2];
  for (const OrderDynamics dynamics : {OrderDynamics::conserved, OrderDynamics::diffusive}) {
    const Material material = two_phases(0.02, 6, mean_order(start), dynamics);
    const FlowResult run = run_flow(material, Model::SBEH, start, target_of(0.9), {},
                                    {.end_time = 400, .output_times = {}});
    ASSERT_EQ(run.stop, FlowStop::at_rest);
    EXPECT_NEAR(total_order(run.state) / total_order(start), 1, 1e-12);
    const NewtonResult found = solve_stationary(material, Model::SBEH, target_of(0.9),
                                                guess_from(material, Model::SBEH, run.state));
    ASSERT_EQ(found.status, NewtonStatus::converged);
    EXPECT_NEAR(mean_order(found.state), *material.mean_order, 1e-12);
    EXPECT_LT(residual_of(material, Model::SBEH, found.state), 1e-8);
    const double U = energies[int(dynamics) - 1] = energy_of(material, found.state).total();
    std::printf("%s: mu = %.6f, U = %.9f, of the flow %.2e more, %d negative directions\n",
                name(dynamics), found.state.chemical_potential, U,
                energy_of(material, run.state).total() - U,
                negative_directions(material, Model::SBEH, found.state));
    EXPECT_NEAR(energy_of(material, run.state).total(), U, 1e-6);
    EXPECT_EQ(negative_directions(material, Model::SBEH, found.state), 0);
    // Two phases, and not one.
    EXPECT_GT(found.state.beta.maxCoeff() - found.state.beta.minCoeff(), 0.45);
  }
  EXPECT_NEAR(energies[0], energies[1], 1e-8);
}

// μ_β is what more order costs.
TEST(ConservedOrder, costs_the_chemical_potential) {
  const State start = with_a_cap(0.9, 48, 0.3, 0.2);
  const Material material = two_phases(0.02, 6, mean_order(start), OrderDynamics::conserved);
  StationaryState state = guess_from(material, Model::SBEH,
                                     run_flow(material, Model::SBEH, start, target_of(0.9), {},
                                              {.end_time = 400, .output_times = {}})
                                         .state);
  const auto at_mean = [&](double mean) {
    Material other = material;
    other.mean_order = mean;
    const NewtonResult found = solve_stationary(other, Model::SBEH, target_of(0.9), state);
    EXPECT_EQ(found.status, NewtonStatus::converged);
    return found.state;
  };
  constexpr double h = 1e-3;
  const double mean = *material.mean_order;
  const double more = energy_of(material, at_mean(mean + h)).total(),
               less = energy_of(material, at_mean(mean - h)).total();
  EXPECT_NEAR((more - less) / (2 * h * 4 * pi), at_mean(mean).chemical_potential, 1e-6);
}

TEST(ConservedOrder, has_its_energy_law_to_first_order_in_tau) {
  const State start = with_a_cap(0.9, 48, 0.3, 0.3);
  for (const OrderDynamics dynamics : {OrderDynamics::conserved, OrderDynamics::diffusive}) {
    const Material material = two_phases(0.02, 6, mean_order(start), dynamics);
    Target target = target_of(0.9);
    target.order = total_order(start);
    OrderTable table(
        std::string(name(dynamics)) + ": energy lost against the sum of tau D, relative", "tau");
    for (const int steps : {16, 32, 64, 128})
      table.add(0.02 / steps,
                energy_balance_of(material, Model::SBEH, start, target, 0.02, steps).excess);
    EXPECT_GT(table.print(), 0.9) << name(dynamics);
  }
}

// On a sphere of uniform stiffness nothing but the interface costs anything: σ times its length, which goes with the width where σ
// stays. The sphere is held.
TEST(OrderStep, has_the_line_tension_of_its_interface) {
  OrderTable table("energy of an interface against sigma times its length", "width");
  for (const double factor : {1., 0.5, 0.25}) {
    const double L = 0.04 * factor, c = 12 / factor, width = std::sqrt(1.5 * L * 2 / c) / 0.5;
    State s = with_a_cap(1, 96, 0.5, width);
    const double mean = mean_order(s), total = total_order(s);
    Material material = two_phases(L, c, mean, OrderDynamics::diffusive);
    material.kappa_powers = model::Polynomial({0.1});
    material.kappa_gauss_powers = model::Polynomial({0});
    const Field H = Field::Constant(s.beta.size(), -2);
    const Nodes still = Nodes::Zero(2, s.beta.size());
    const Field no_pressure = Field::Zero(2 * 96 + 1);
    OrderStep step(material, 96);
    double tau = 1e-3, change = 1;
    for (int k = 0; k < 200 && change > 1e-12; ++k, tau *= 1.2) {
      const Field next = step.solve(
          s, {.H = H, .slip = still, .next = s.X, .p = no_pressure, .tau = tau, .total = total});
      ASSERT_GT(next.size(), 0);
      change = (next - s.beta).cwiseAbs().maxCoeff();
      s.beta = next;
    }
    EXPECT_LT(change, 1e-12);
    EXPECT_NEAR(total_order(s), total, 1e-11);
    const Energy U = energy_of(material, s);
    // Where the cap of pure phases with this mean ends.
    using model::test::poor, model::test::rich;
    const double z = 1 - 2 * (mean - poor) / (rich - poor), length = 2 * pi * std::sqrt(1 - z * z);
    table.add(width,
              (U.distortion + U.thermotropic) / (length * model::test::line_tension(L, c)) - 1);
  }
  EXPECT_GT(table.print(), 0.9);
}

TEST(ConservedOrder, decays_with_the_rate_of_its_modes) {
  const State start = with_a_cap(0.9, 48, 0.3, 0.2);
  const Material material = two_phases(0.02, 6, mean_order(start), OrderDynamics::conserved);
  const FlowResult run = run_flow(material, Model::SBEH, start, target_of(0.9), {},
                                  {.end_time = 400, .output_times = {}});
  const NewtonResult rest = solve_stationary(material, Model::SBEH, target_of(0.9),
                                             guess_from(material, Model::SBEH, run.state));
  ASSERT_EQ(rest.status, NewtonStatus::converged);
  const SecondVariation second = second_variation(material, Model::SBEH, rest.state);
  const auto rates = growth_rates(LinearFlow(second, material, Model::SBEH), 0, 2);
  ASSERT_TRUE(rates);
  const GrowthMode& slowest = rates->front();
  State s = rest.state;
  s.X += node_normals(s.X) * Field(1e-3 * slowest.u).asDiagonal();
  s.beta += 1e-3 * slowest.b;
  Target target = target_of(0.9);
  target.order = total_order(rest.state);
  ASSERT_TRUE(correct_area_volume(s.X, target.area, target.volume));
  const double rest_energy = energy_of(material, rest.state).total();
  TimeStepper stepper(material, Model::SBEH, 48);
  const auto excess_after = [&](int steps, double time) {
    State now = s;
    for (int k = 0; k < steps; ++k) now = stepper.step(now, target, time / steps).state;
    return energy_of(material, now).total() - rest_energy;
  };
  const double time = 0.3 / std::abs(slowest.rate);
  const auto rate = [&](int steps) {
    return std::log(excess_after(2 * steps, 2 * time) / excess_after(steps, time)) / (2 * time);
  };
  const double measured = 2 * rate(40) - rate(20);
  std::printf("rate %.6f, measured %.6f\n", slowest.rate, measured);
  EXPECT_NEAR(measured, slowest.rate, 0.02 * std::abs(slowest.rate));
}

// SSH has no free order, and takes no notice of what is said of one.
TEST(ConservedOrder, is_nothing_to_a_uniform_one) {
  const BranchState rest = first_oblate(Model::SSH);
  Material conserved = paper_material(0.05);
  conserved.order = OrderDynamics::conserved;
  conserved.mean_order = 0.3;
  EXPECT_EQ(second_variation(conserved, Model::SSH, rest).constraints.cols(), 2);
  EXPECT_EQ(negative_directions(conserved, Model::SSH, rest),
            negative_directions(paper_material(0.05), Model::SSH, rest));
}

// Their drag is not that of an order which relaxes.
TEST(ConservedOrder, has_no_rates_known_where_it_diffuses) {
  const BranchState rest = first_oblate(Model::SBEH);
  const Material material = two_phases(0.02, 6, 0.3, OrderDynamics::diffusive);
  const SecondVariation second = second_variation(material, Model::SBEH, rest);
  EXPECT_FALSE(growth_rates(LinearFlow(second, material, Model::SBEH), 0, 1));
}

TEST(ConservedOrder, must_be_that_of_the_start) {
  const State start = with_a_cap(0.9, 48, 0.3, 0.2);
  const Material material = two_phases(0.02, 6, 0.2, OrderDynamics::conserved);
  EXPECT_THROW(run_flow(material, Model::SBEH, start, target_of(0.9), {},
                        {.end_time = 1, .output_times = {}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace sbeh::axisym
