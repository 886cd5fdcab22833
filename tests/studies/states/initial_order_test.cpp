// The order with which evolutions begin.
#include "studies/states/initial_order.h"

#include "axisym/diagnostics.h"
#include "studies/evolution/relax.h"
#include "studies/evolution/run_start.h"
#include "surface3d/domains.h"
#include "surface3d/order_step.h"
#include "tests/studies/parameters/input_file.h"

#include <array>

namespace sbeh::studies {
namespace {

using namespace test;

const std::string material =
    "[material]\nL = 0.02\npotential = [0.0216, -0.504, 3.66, -8.4, 6]\norder = \"conserved\"\n";

RunInput run_with(const std::string& surface,
                  const std::string& of = material + "mean_order = 0.25\n") {
  return read_run(
      written("model = \"SBEH\"\ntime.end = 1\n[surface]\nshape = \"ellipsoid\"\n"
              "reduced_volume = 0.8\n"
              + surface + of));
}

TEST(InitialOrder, has_domains_of_a_fraction_of_the_area) {
  const auto start = start_of(
      run_with("triangles = 1280\ndomain_width = 0.05\ndomains = [{ fraction = 0.2, order = 0.6 }, "
               "{ axis = [0, 0, -1], fraction = 0.1, order = 0.6 }]\n"));
  const surface3d::Triangulation& mesh = *start.moment.mesh;
  const surface3d::State& state = start.moment.state;
  const double area = start.moment.target.area;
  const model::Domains domains = surface3d::domains_of(mesh, state);
  EXPECT_EQ(domains.count, 2);
  EXPECT_NEAR(domains.area / area, 0.3, 5e-3);
  EXPECT_NEAR(surface3d::total_order(mesh, state) / area, 0.25, 1e-13);
}

TEST(InitialOrder, is_the_same_on_a_surface_of_revolution) {
  const RelaxInput input = read_relax(
      written("model = \"SBEH\"\ntime.end = 1\n[start]\nshape = \"ellipsoid\"\n"
              "reduced_volume = 0.8\ndomain_width = 0.05\ndomains = [{ fraction = 0.2, order "
              "= 0.6 }]\n"
              + material + "mean_order = 0.25\n"));
  const axisym::Diagnostics d = axisym::diagnose({}, start_of(input).state);
  EXPECT_EQ(d.domains.count, 1);
  EXPECT_NEAR(d.domains.area / d.area, 0.2, 2e-3);
  EXPECT_NEAR(d.order_mean, 0.25, 1e-9);
}

TEST(InitialOrder, follows_a_formula) {
  const std::string formula = "order_formula = \"0.35 + 0.25*tanh((z - 0.3)/0.2)\"\n",
                    free = "[material]\nL = 0.02\n";
  const auto start = start_of(run_with(formula, free));
  const surface3d::State& state = start.moment.state;
  for (const int i : {0, 7, 300})
    EXPECT_NEAR(state.beta[i], 0.35 + 0.25 * std::tanh((state.X(2, i) - 0.3) / 0.2),
                1e-8);  // the centre
  const RelaxInput of_revolution =
      read_relax(written("model = \"SBEH\"\ntime.end = 1\n[start]\nshape = \"ellipsoid\"\n"
                         "reduced_volume = 0.8\norder_formula = \"theta < pi/2 ? 0.6 : r*z\"\n"
                         + free));
  const axisym::State curve = start_of(of_revolution).state;
  EXPECT_EQ(curve.beta[0], 0.6);
  const Eigen::Index near = curve.beta.size() - 4;
  EXPECT_NEAR(curve.beta[near], curve.X(0, near) * curve.X(1, near), 1e-8);
  EXPECT_EQ(read_relax(written(describe(of_revolution, "1"))).order_pattern,
            of_revolution.order_pattern);
}

TEST(InitialOrder, has_the_noise_of_its_seed) {
  const auto order = [](int seed) {
    return start_of(run_with("order_noise = { amplitude = 0.05, seed = " + std::to_string(seed)
                             + " }\n"))
        .moment.state.beta;
  };
  const surface3d::Field one = order(1), again = order(1), other = order(2);
  EXPECT_EQ(one, again);
  EXPECT_GT((one - other).cwiseAbs().maxCoeff(), 0.01);
  const double mean = one.mean();
  EXPECT_NEAR(std::sqrt((one.array() - mean).square().mean()), 0.05, 0.02);
}

TEST(InitialOrder, that_is_wrong_is_refused) {
  const auto message = [](const std::string& surface, const std::string& of) -> std::string {
    try {
      start_of(run_with(surface, of));
    } catch (const std::exception& error) {
      return error.what();
    }
    return "nothing";
  };
  const std::string mean = material + "mean_order = 0.25\n";
  const std::vector<std::array<std::string, 3>> cases{
      {"", material, "[material] order = \"conserved\": needs mean_order"},
      {"", material + "mean_order = 3\n", "[material] mean_order = 3: must be in -0.5 ... 1"},
      {"order = 0.6\n", mean,
       "[surface] order: its mean is 0.6, far from mean_order = 0.25: leave order out"},
      {"domain_width = 0.1\n", mean, "domain_width = 0.1: needs domains"},
      {"order_formula = \"0.3 +\"\n", mean, "[surface] order_formula = \"0.3 +\": Unexpected end"},
      {"order_formula = \"0.3 + w\"\n", mean, "Known: x, y, z, r, theta, phi, pi and functions"},
      {"order_formula = \"x\"\norder = 0.3\n", mean,
       "order = 0.3: must not be given together with"},
      {"order_formula = \"0.3*exp(5*x)\"\n", mean, "somewhere: must be in -1 ... 1"},
      {"domains = 3\n", mean, "domains = 3: must be a list of tables"},
      {"domains = [{ fraction = 1.5, order = 0.6 }]\n", mean, "domains.fraction = 1.5: must be"},
      {"domains = [{ fraction = 0.5, oder = 0.6 }]\n", mean, "domains.oder: unknown key"},
      {"domains = [{ fraction = 0.9, order = 0.6 }]\n", mean,
       "mean_order = 0.25 leaves the order -2.9 outside of them"},
      {"domains = [{ fraction = 0.7, order = 0.1 }, { fraction = 0.3, order = 0.6 }]\n", mean,
       "have fractions whose sum is 1: must be < 1, since what is outside of them"},
      {"", "[material]\nL = 0.02\nmean_order = 0.3\n",
       "mean_order = 0.3: has a meaning with order = \"conserved\" or \"diffusive\" only"},
  };
  for (const auto& [surface, of, expected] : cases)
    EXPECT_NE(message(surface, of).find(expected), std::string::npos) << message(surface, of);
}

}  // namespace
}  // namespace sbeh::studies
