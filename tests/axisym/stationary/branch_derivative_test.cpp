// Derivatives along branches of stationary states: the tangent, and the energy by L, V and A.
#include "axisym/stationary/newton_system.h"
#include "tests/axisym/cases.h"
#include "tests/model/densely.h"

namespace sbeh::axisym {
namespace {

using namespace test;

// What a branch is followed in: L, or the volume; and steps at which differences of order 4 along it
// are good to 1e-8 (the branch bends on the scale of its distance in L to the fold, 0.04, or of the
// volume itself).
struct Direction {
  const char* name;
  double L, volume, step;
};
constexpr Direction by_L{"L", 1, 0, 2e-4}, by_volume{"volume", 0, 1, 1e-2};

// The state near b at other parameters, on the same nodes.
StationaryState neighbour(const Material& material, Model model, const BranchState& b,
                          const Target& target) {
  const NewtonResult r =
      solve_stationary(material, model, target, b, {.most_iterations = 20, .tolerance = 1e-11});
  EXPECT_EQ(r.status, NewtonStatus::converged);
  return r.state;
}
StationaryState neighbour(const BranchState& b, const Direction& direction, double step) {
  Target target = target_of(b.at.reduced_volume);
  target.volume += step * direction.volume;
  return neighbour(paper_material(b.at.L + step * direction.L), Model::SBEH, b, target);
}

// df/dμ at 0 by central differences of order 4, h and 2h.
template <class F>
auto rate_of(const F& f, double h) {
  using Value = decltype(f(h));
  const Value near = (f(h) - f(-h)) / (2 * h), far = (f(2 * h) - f(-2 * h)) / (4 * h);
  return Value((4 * near - far) / 3);
}

Eigen::VectorXd gradient_rate(const BranchState& b, const Direction& direction) {
  return direction.L
       * gradient_difference(paper_material(1), paper_material(0), b, node_normals(b.X));
}

Increment tangent_of(const BranchState& b, const Direction& direction) {
  NewtonSystem system(paper_material(b.at.L), Model::SBEH, {element_count(b.X), false});
  EXPECT_TRUE(system.linearise(b));
  Increment t;
  EXPECT_TRUE(system.tangent(gradient_rate(b, direction), direction.volume, 0, t));
  EXPECT_EQ(t.mu, 1);
  return t;
}

// The rates of all unknowns, from neighbouring solutions: (d, Λ, H, β, tension, pressure) per column
// group as in Increment.
Increment differenced(const BranchState& b, const Direction& direction) {
  const Nodes n = node_normals(b.X);
  std::vector<StationaryState> s;  // at −2, −1, 1, 2 steps
  for (const int k : {-2, -1, 1, 2}) s.push_back(neighbour(b, direction, k * direction.step));
  const auto rate = [&](const auto& of) {
    return rate_of(
        [&](double step) {
          const int k = int(std::lround(step / direction.step));
          return of(s[std::size_t(k < 0 ? k + 2 : k + 1)]);
        },
        direction.step);
  };
  Increment t;
  t.d = rate([&](const StationaryState& x) -> Field {
    return x.X.cwiseProduct(n).colwise().sum().transpose();
  });
  t.Lambda = rate([](const StationaryState& x) { return x.Lambda; });
  t.H = rate([](const StationaryState& x) { return x.H; });
  t.beta = rate([](const StationaryState& x) { return x.beta; });
  t.tension = rate([](const StationaryState& x) { return x.tension; });
  t.pressure = rate([](const StationaryState& x) { return x.pressure; });
  return t;
}

TEST(Tangent, solves_the_assembled_equations) {
  const BranchState b = oblate(Model::SBEH, {0.7, 0.05}, 24);
  const Eigen::Index nodes = b.H.size();
  LagrangianDerivatives L({int(nodes) / 3, false});
  assemble(paper_material(b.at.L), b, node_normals(b.X), L);
  for (const Direction& direction : {by_L, by_volume}) {
    const Increment t = tangent_of(b, direction);
    Eigen::VectorXd v(node_unknowns * nodes);
    for (Eigen::Index i = 0; i < nodes; ++i)
      v.segment<node_unknowns>(node_unknowns * i) << t.d[i], t.Lambda[i], t.H[i], t.beta[i];
    const Eigen::MatrixXd K = densely(L.hessian);
    Eigen::VectorXd miss = K * v + L.constraints * Eigen::Vector2d(t.tension, t.pressure)
                         + gradient_rate(b, direction);
    miss[node_d] = 0;  // the north pole is held
    // Rounding of the products: 1e-16 times the largest term of a row.
    const double largest = (K * v.asDiagonal()).cwiseAbs().maxCoeff();
    EXPECT_LT(miss.cwiseAbs().maxCoeff(), 1e-13 * largest) << direction.name;
    EXPECT_NEAR(L.constraints.col(0).dot(v), 0, 1e-11) << direction.name;
    EXPECT_NEAR(L.constraints.col(1).dot(v), -direction.volume, 1e-11) << direction.name;
    EXPECT_NEAR(t.d[0], 0, 1e-14);  // solved for like the rest: rounding
  }
}

TEST(Tangent, is_the_difference_of_neighbouring_solutions_to_the_error_of_the_curvature) {
  // The matrix holds the node normals fixed; from one solution to the next they turn, and the
  // discrete balance along the tangent is met only to the error of H, of order 3.
  for (const Direction& direction : {by_L, by_volume}) {
    OrderTable d(std::string("tangent by ") + direction.name + ": d", "h"), beta("  beta", "h"),
        H("  H", "h"), Lambda("  Lambda", "h"), multipliers("  tension and pressure", "h");
    for (const int elements : {12, 24, 48}) {
      const BranchState b = oblate(Model::SBEH, {0.7, 0.05}, elements);
      const Increment t = tangent_of(b, direction), s = differenced(b, direction);
      const auto miss = [](const Field& a, const Field& c) {
        return (a - c).cwiseAbs().maxCoeff() / c.cwiseAbs().maxCoeff();
      };
      d.add(1. / elements, miss(s.d, t.d));
      beta.add(1. / elements, miss(s.beta, t.beta));
      H.add(1. / elements, miss(s.H, t.H));
      Lambda.add(1. / elements, miss(s.Lambda, t.Lambda));
      multipliers.add(1. / elements,
                      std::abs(s.tension / t.tension - 1) + std::abs(s.pressure / t.pressure - 1));
    }
    for (const OrderTable* table : {&d, &beta, &H, &Lambda, &multipliers}) table->print();
    // From 12 to 48 elements: two halvings.
    for (const OrderTable* table : {&d, &beta, &H, &Lambda, &multipliers}) {
      const auto p = table->orders();
      EXPECT_GT((p[0] + p[1]) / 2, 2.7);
    }
  }
}

// Relative miss of a rate of the energy, at 12, 24 and 48 elements.
template <class Miss>
void expect_exact_to_the_order_of_the_energy(const std::string& what, Model model,
                                             const Miss& miss) {
  OrderTable table(std::string(name(model)) + ": " + what, "h");
  double last = 0;
  for (const int elements : {12, 24, 48}) {
    last = miss(oblate(model, {0.7, 0.05}, elements));
    table.add(1. / elements, last);
  }
  table.print();
  const auto p = table.orders();
  EXPECT_GT((p[0] + p[1]) / 2, 5.5) << what;
  EXPECT_LT(std::abs(last), 1e-8) << what;  // of the difference: rounding 1e-14/h, and (h/scale)⁴
}

double energy_at(const BranchState& b, Model model, double dL, double dA, double dV) {
  const Material material = paper_material(b.at.L + dL);
  Target target = target_of(b.at.reduced_volume);
  target.area += dA;
  target.volume += dV;
  return energy_of(material, neighbour(material, model, b, target)).total();
}

TEST(EnergyAlongTheBranch, changes_with_L_by_its_elastic_part_over_L) {
  expect_exact_to_the_order_of_the_energy(
      "dU/dL against U_EL/L", Model::SBEH, [](const BranchState& b) {
        const double slope =
            rate_of([&](double dL) { return energy_at(b, Model::SBEH, dL, 0, 0); }, by_L.step);
        return slope * b.at.L / elastic(energy_of(paper_material(b.at.L), b)) - 1;
      });
}

TEST(EnergyAlongTheBranch, changes_with_volume_by_the_pressure) {
  for (const Model model : {Model::SBEH, Model::SSH})
    expect_exact_to_the_order_of_the_energy("dU/dV against P", model, [&](const BranchState& b) {
      const double slope =
          rate_of([&](double dV) { return energy_at(b, model, 0, 0, dV); }, by_volume.step);
      return slope / b.pressure - 1;
    });
}

TEST(EnergyAlongTheBranch, changes_with_area_by_minus_the_tension) {
  for (const Model model : {Model::SBEH, Model::SSH})
    expect_exact_to_the_order_of_the_energy(
        "dU/dA against -Sigma", model, [&](const BranchState& b) {
          const double slope =
              rate_of([&](double dA) { return energy_at(b, model, 0, dA, 0); }, 2 * by_volume.step);
          return slope / b.tension + 1;
        });
}

TEST(Virial, of_a_stationary_state_closes_at_the_order_of_the_energy) {
  // Scaling by s leaves distortion and bending alone and multiplies A by s², V by s³:
  //   (3/2) P V = Σ A + U_TH, with U_TH = u(2/3) A for SSH.
  // On the mesh scaling moves nodes along the tangent too, in which the energy is stationary only to
  // the error of the discretisation.
  for (const Model model : {Model::SSH, Model::SBEH}) {
    OrderTable table(std::string(name(model)) + ": (3/2)PV - Sigma A - U_TH, relative", "h");
    for (const int count : {12, 24, 48}) {
      const BranchState b = oblate(model, {0.7, 0.05}, count);
      const Target t = target_of(b.at.reduced_volume);
      const Material material = paper_material(b.at.L);
      const double u = model == Model::SSH ? material.potential.value(model::full_order) * t.area
                                           : energy_of(material, b).thermotropic;
      const double lhs = 1.5 * b.pressure * t.volume;
      table.add(1. / count, (b.tension * t.area + u) / lhs - 1);
    }
    EXPECT_GT(table.print(), 4);
  }
}

}  // namespace
}  // namespace sbeh::axisym
