// A soft cap that buds: the order that is conserved, with an interface of finite width, against two domains with a sharp one.
#include "axisym/shape_class.h"
#include "axisym/stationary/accuracy.h"
#include "tests/axisym/cases.h"
#include "tests/axisym/shooting/two_domains.h"
#include "tests/model/two_phases.h"

#include <vector>

namespace sbeh::axisym::test {
namespace {

using model::test::poor, model::test::rich;

constexpr double gap = rich - poor, fraction = 0.2, kappa_soft = 0.2, tension = 2.6;
constexpr double open_volume = 0.82;  // with an open neck
constexpr double widths[] = {0.08, 0.04, 0.02};

shooting::TwoDomains sharp(double gauss_jump, double reduced_volume) {
  return {.fraction = fraction,
          .kappa_a = kappa_soft,
          .gauss_jump = gauss_jump,
          .line_tension = tension,
          .reduced_volume = reduced_volume};
}

// The poor phase is soft, κ = 1 in the rich one. At a plane interface β goes with tanh(s/width).
Material diffuse(double gauss_jump, double width) {
  const double L = 2 * tension * width / (gap * gap),
               c = 6 * tension / (width * gap * gap * gap * gap);
  Material material =
      model::test::two_phases(L, c, rich - gap * fraction, model::OrderDynamics::conserved);
  EXPECT_NEAR(model::test::line_tension(L, c), tension, 1e-12);
  const double slope = (1 - kappa_soft) / gap, gauss_slope = -gauss_jump / gap;
  material.kappa_powers = model::Polynomial({1 - slope * rich, slope});
  // About −0.2, where −2κ <= κ_G <= 0 in both.
  material.kappa_gauss_powers =
      model::Polynomial({-0.2 - gauss_slope * (poor + rich) / 2, gauss_slope});
  return material;
}
// What the energy of the diffuse vesicle has more than that of the sharp one: 4πκ_G of the rich phase.
double gaussian_constant(const Material& material) { return 4 * pi * material.kappa_gauss(rich); }

// A prolate whose northern cap is poor, on its way to rest.
State prolate_with_a_cap(const Material& material, double width, int elements) {
  State s{.X = spheroid(0.95, true, elements, Numerics{}.grading), .beta = Field(3 * elements + 1)};
  const double height = s.X(1, 0) - 2 * fraction;  // about where the cap ends
  for (Eigen::Index i = 0; i < s.beta.size(); ++i)
    s.beta[i] = (poor + rich) / 2 - gap / 2 * std::tanh((s.X(1, i) - height) / width);
  s.beta.array() += *material.mean_order - diagnose(material, s).order_mean;
  Numerics numerics = with_elements(elements);
  numerics.tolerance = 1e-3;
  return run_flow(material, Model::SBEH, s, target_of(0.95), numerics,
                  {.end_time = 0.02, .output_times = {}})
      .state;
}

// Rest at V_r = open_volume for each of the widths, on elements of half a width.
std::vector<BranchState> open_states(double gauss_jump) {
  int elements = 96;
  double width = widths[0];
  Material material = diffuse(gauss_jump, width);
  const auto first =
      solve_at(material, Model::SBEH, {0.95, material.L1},
               guess_from(material, Model::SBEH, prolate_with_a_cap(material, width, elements)));
  if (!first) throw std::runtime_error("no vesicle with a soft cap");
  FollowResult way =
      follow(material, Model::SBEH, *first, {open_volume, material.L1}, with_elements(elements));
  std::vector<BranchState> states;
  for (const double next : widths) {
    if (next < width) {
      elements *= 2;
      static_cast<StationaryState&>(way.state) =
          redistribute(way.state, Numerics{}.grading, elements);
    }
    while (next < width) {
      width = std::max(next, 0.8 * width);
      material = diffuse(gauss_jump, width);
      const auto thinner = solve_at(material, Model::SBEH, {open_volume, material.L1}, way.state);
      if (!thinner) throw std::runtime_error("no vesicle with a thinner interface");
      way.state = *thinner;
    }
    EXPECT_EQ(way.state.at.reduced_volume, open_volume);
    states.push_back(way.state);
  }
  return states;
}

// To zero width by those with the widths w, w/2, w/4, whose errors go with the first power and those after it; and what another
// width has changed of it.
struct Extrapolated {
  double value, change;
};
Extrapolated extrapolated(const double (&at)[3]) {
  const double coarse = 2 * at[1] - at[0], fine = 2 * at[2] - at[1];
  return {(4 * fine - coarse) / 3, std::abs(fine - coarse)};
}

void expect_linear_in_the_width(const char* quantity, const double (&at)[3], double sharp) {
  OrderTable table(quantity, "width");
  for (int k = 0; k < 3; ++k) table.add(widths[k], at[k] - sharp);
  EXPECT_NEAR(table.print(), 1, 0.25) << quantity;  // not 1/2, nor 3/2
  const Extrapolated limit = extrapolated(at);
  std::printf("  %.6f extrapolated, %.6f sharp\n", limit.value, sharp);
  EXPECT_NEAR(limit.value, sharp, limit.change) << quantity;
}

TEST(Budding, of_a_soft_cap_is_where_the_sharp_interface_has_it_and_costs_as_much) {
  const auto open = shooting::open_vesicle(sharp(0, open_volume)),
             fold = shooting::open_vesicle(sharp(0, 0.79));
  ASSERT_TRUE(fold.is_fold);
  double energies[3], volumes[3], at_fold[3];
  const auto states = open_states(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const Material material = diffuse(0, widths[k]);
    const Numerics numerics = with_elements(element_count(states[k].X));
    energies[k] = energy_of(material, states[k]).total() - gaussian_constant(material);
    const FollowResult found =
        follow(material, Model::SBEH, states[k], {0.79, material.L1}, numerics);
    ASSERT_EQ(found.arrival, Arrival::fold);
    if (k == 0) {
      const ResolvedState resolved = resolved_fold(found, numerics);
      EXPECT_TRUE(resolved.is_resolved);
      EXPECT_LT(resolved.place_error, 1e-6);
    }
    volumes[k] = found.state.at.reduced_volume;
    at_fold[k] = energy_of(material, found.state).total() - gaussian_constant(material);
  }
  expect_linear_in_the_width("energy at V_r = 0.82", energies, open.energy);
  expect_linear_in_the_width("V_r of the fold", volumes, fold.reduced_volume);
  expect_linear_in_the_width("energy at the fold", at_fold, fold.energy);
}

// Arc length from the neck to the circle of mean order, > 0 where that lies towards the south.
double neck_offset(const State& s) {
  constexpr int pieces = 16;
  double length = 0, interface = 0, neck = 0, least = std::numeric_limits<double>::infinity();
  Eigen::Vector3d r = Eigen::Vector3d::Zero();  // of the last points
  Eigen::Vector2d last = s.X.col(0);
  double order = s.beta[0], step = 0;
  for (int e = 0; e < element_count(s.X); ++e)
    for (int k = 1; k <= pieces; ++k) {
      const ShapeValues& at = even_points<pieces>()[std::size_t(k)];
      const Eigen::Vector2d x = curve_point(s.X, e, at).x;
      const double beta = value_at(s.beta, e, at), middle = (poor + rich) / 2;
      const double next = (x - last).norm();
      if ((order - middle) * (beta - middle) < 0)
        interface = length + next * (middle - order) / (beta - order);
      r = {r[1], r[2], x[0]};
      if (r[1] < r[0] && r[1] <= r[2] && r[1] < least) {
        least = r[1];
        neck = length - (step + next) / 4 * (r[2] - r[0]) / (r[2] - 2 * r[1] + r[0]);
      }
      length += next;
      step = next;
      last = x;
      order = beta;
    }
  return interface - neck;
}

// Where the soft phase has the larger κ_G the neck moves into it, and the reverse.
TEST(Budding, has_its_neck_where_the_Gaussian_moduli_move_it) {
  for (const double jump : {-0.3, 0.3}) {
    const auto open = shooting::open_vesicle(sharp(jump, open_volume));
    EXPECT_GT(open.neck_offset * jump, 0);
    double offsets[3], radii[3], energies[3];
    const auto states = open_states(jump);
    for (std::size_t k = 0; k < 3; ++k) {
      const Material material = diffuse(jump, widths[k]);
      offsets[k] = neck_offset(states[k]);
      radii[k] = thinnest_neck(states[k].X);
      energies[k] = energy_of(material, states[k]).total() - gaussian_constant(material);
    }
    std::printf("kappa_G of the soft phase less that of the other: %g\n", jump);
    expect_linear_in_the_width("arc length from the neck to the interface", offsets,
                               open.neck_offset);
    expect_linear_in_the_width("radius of the neck", radii, open.neck_radius);
    expect_linear_in_the_width("energy", energies, open.energy);
  }
}

}  // namespace
}  // namespace sbeh::axisym::test
