#include "axisym/modes/eigenmodes.h"

#include "axisym/stationary/newton_system.h"
#include "axisym/stationary/symmetry.h"
#include "model/numerics/lanczos.h"

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace sbeh::axisym {

namespace {

Eigen::MatrixXd independent_columns(const Eigen::MatrixXd& columns) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns.colwise().normalized());
  qr.setThreshold(1e-6);
  return (columns * qr.colsPermutation()).leftCols(qr.rank());
}

// (A − σ M)⁻¹ of one m; for m = 0 area and volume stay to first order.
class Inverse {
 public:
  Inverse(const SecondVariation& second, int m, double shift) : matrix_(second.shifted(m, shift)) {
    usable_ = matrix_.factor();
    if (!usable_ || m > 0) return;
    // On the sphere area and volume change together.
    constraints_ = independent_columns(second.constraints);
    solved_ = constraints_;
    matrix_.solve(solved_);
    schur_.compute(constraints_.transpose() * solved_);
  }
  bool usable() const { return usable_; }
  Eigen::VectorXd operator()(Eigen::VectorXd x) const {
    matrix_.solve(x);
    if (constraints_.cols() > 0) x -= solved_ * schur_.solve(constraints_.transpose() * x);
    return x;
  }

 private:
  model::BandMatrix matrix_;
  Eigen::MatrixXd constraints_, solved_;  // in columns, and (A − σ M)⁻¹ of them
  Eigen::FullPivLU<Eigen::MatrixXd> schur_;
  bool usable_;
};

Eigen::VectorXd with_parity(const Eigen::VectorXd& x, Parity parity) {
  if (parity == Parity::none) return x;
  const Eigen::Index nodes = x.size() / node_unknowns;
  const double sign = parity == Parity::even ? 1 : -1;
  Eigen::VectorXd part(x.size());
  for (Eigen::Index i = 0; i < nodes; ++i)
    part.segment<node_unknowns>(node_unknowns * i) =
        (x.segment<node_unknowns>(node_unknowns * i)
         + sign * x.segment<node_unknowns>(node_unknowns * (nodes - 1 - i)))
        / 2;
  return part;
}

// The same for every run.
Eigen::VectorXd any_vector(Eigen::Index size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::VectorXd x(size);
  for (double& value : x) value = uniform(random);
  return x;
}

Field component(const Eigen::VectorXd& x, NodeUnknown c) {
  return x(Eigen::seqN(Eigen::Index(c), x.size() / node_unknowns, Eigen::Index(node_unknowns)));
}

// β' by arc length at the nodes, at joints the mean of both elements.
Field order_slope(const State& state) {
  static const std::array at_nodes = {shape_values(0), shape_values((1 - std::sqrt(0.2)) / 2),
                                      shape_values((1 + std::sqrt(0.2)) / 2), shape_values(1)};
  const Eigen::Index nodes = state.beta.size();
  Field slope = Field::Zero(nodes);
  for (int e = 0; e < element_count(state.X); ++e)
    for (int a = 0; a < 4; ++a) {
      const ShapeValues& s = at_nodes[std::size_t(a)];
      const Eigen::Index i = 3 * e + a;
      const bool is_shared = a % 3 == 0 && i > 0 && i + 1 < nodes;
      slope[i] +=
          (is_shared ? 0.5 : 1) * slope_at(state.beta, e, s) / curve_point(state.X, e, s).stretch;
    }
  return slope;
}

// The rigid motions that go with cos mφ: their normal part, and the order that stays behind.
std::vector<Eigen::VectorXd> rigid_motions(const StationaryState& state, int m) {
  const Nodes n = node_normals(state.X);
  const Field slope = order_slope(state);
  const Eigen::Index nodes = state.beta.size();
  const auto motion = [&](auto&& velocity) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(node_unknowns * nodes);
    for (Eigen::Index i = 0; i < nodes; ++i) {
      const Eigen::Vector2d v = velocity(state.X.col(i)), nu = n.col(i), t(nu[1], -nu[0]);
      x[index(i, node_d)] = v.dot(nu);
      x[index(i, node_beta)] = -v.dot(t) * slope[i];
    }
    return x;
  };
  const double middle = (state.X(1, 0) + state.X(1, nodes - 1)) / 2;
  using Vector = Eigen::Vector2d;
  if (m == 0) return {motion([](const Vector&) { return Vector(0, 1); })};
  if (m > 1) return {};
  return {motion([](const Vector&) { return Vector(1, 0); }),
          motion([middle](const Vector& x) { return Vector(x[1] - middle, -x[0]); })};
}

// One m: its mass, and its rigid motions, orthonormal in it.
struct Problem {
  const SecondVariation& second;
  int m;
  model::BandMatrix free_mass;
  std::vector<Eigen::VectorXd> rigid;

  Problem(const SecondVariation& of, int number)
      : second(of), m(number), free_mass(of.mass_of(number)) {
    constexpr double none = 1e-6;  // a sphere's rotation moves nothing
    for (Eigen::VectorXd& motion : rigid_motions(of.state, number)) {
      // Without up-down symmetry a translation across and the rotation are not orthogonal.
      for (const Eigen::VectorXd& other : rigid) motion -= other.dot(mass(motion)) * other;
      if (const double square = motion.dot(mass(motion)); square > none)
        rigid.emplace_back(motion / std::sqrt(square));
    }
  }
  Eigen::VectorXd mass(const Eigen::VectorXd& x) const { return free_mass.times(x); }
  int rigid_of(Parity parity) const {
    return int(std::ranges::count_if(rigid, [&](const Eigen::VectorXd& motion) {
      return with_parity(motion, parity).norm() > 0.5 * motion.norm();
    }));
  }
  bool is_rigid(const Eigen::VectorXd& mode) const {
    const Eigen::VectorXd loaded = mass(mode);
    double share = 0;
    for (const Eigen::VectorXd& motion : rigid) share += std::pow(motion.dot(loaded), 2);
    return share > 0.5;
  }
};

// The modes of one parity, rigid motions among them; those of the smallest (λ − shift)⁻¹ come last. Empty where
// Lanczos' iteration fails.
std::optional<model::RitzPairs> modes_of(const Problem& problem, Parity parity,
                                         const Inverse& inverse, int count) {
  constexpr int most_steps = 120;
  const auto mass = [&](const Eigen::VectorXd& x) { return problem.mass(x); };
  const auto apply = [&](const Eigen::VectorXd& load) {
    return with_parity(inverse(load), parity);
  };
  const Eigen::VectorXd start = apply(mass(any_vector(problem.free_mass.size())));
  return model::largest_by_lanczos(apply, mass, start, count + problem.rigid_of(parity),
                                   most_steps);
}

}  // namespace

std::optional<ModeSpectrum> lowest_modes(const SecondVariation& second, int m, int count) {
  constexpr double first_shift = -10, lowest_shift = -1e9, growth = 4;  // stiffnesses
  constexpr double rounding = 1e-9;
  const auto parities = is_symmetric(second.state.X) ? std::vector{Parity::even, Parity::odd}
                                                     : std::vector{Parity::none};
  const Problem problem(second, m);
  for (double shift = first_shift; shift > lowest_shift; shift *= growth) {
    const double sigma = shift * second.stiffness;
    const Inverse inverse(second, m, sigma);
    if (!inverse.usable()) return {};
    ModeSpectrum spectrum;
    std::size_t recognised = 0;
    bool is_below = true;
    for (const Parity parity : parities) {
      const auto pairs = modes_of(problem, parity, inverse, count);
      if (!pairs) return {};
      is_below = is_below && pairs->least > -rounding * std::abs(pairs->values[0]);
      int kept = 0;
      for (Eigen::Index k = 0; k < pairs->values.size(); ++k) {
        const Eigen::VectorXd x = pairs->vectors.col(k);
        const double eigenvalue = sigma + 1 / pairs->values[k];
        if (problem.is_rigid(x)) {
          spectrum.rigid_residual = std::max(spectrum.rigid_residual, std::abs(eigenvalue));
          ++recognised;
        } else if (kept++ < count) {
          spectrum.modes.push_back(
              {m, parity, eigenvalue, component(x, node_d), component(x, node_beta)});
        }
      }
    }
    if (!is_below) continue;
    if (recognised < problem.rigid.size())
      spectrum.rigid_residual = std::numeric_limits<double>::infinity();
    std::ranges::sort(spectrum.modes, {}, &Eigenmode::eigenvalue);
    return spectrum;
  }
  return {};
}

}  // namespace sbeh::axisym
