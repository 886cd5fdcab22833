// The five special points of the classical diagram, on two resolutions.
#include "axisym/spectral/classical.h"
#include "axisym/spectral/minimiser.h"
#include "model/numerics/constrained_newton.h"
#include "model/numerics/root.h"

#include <Eigen/LU>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sbeh::axisym {
namespace {

using namespace spectral;
using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using std::numbers::pi;

// Bounds what rounding does to the five volumes: beyond 40 modes they change by at most 2e-13.
constexpr double rounding = 5e-12;
constexpr double last_change = 1e-14;  // of the secants

[[noreturn]] void lost(const char* point) {
  throw std::runtime_error(std::string("special point not found: ") + point);
}

// A branch on bases of one cutoff, continued from the last minimum.
class Sweep {
 public:
  Sweep(Branch branch, int cutoff, double first) : branch_(branch) {
    const auto found = minimum(branch, first);
    if (!found) lost(name(branch));
    last_ = on_basis(found->curve(), basis_for(branch, first, cutoff));
  }
  ClassicalMinimum at(double reduced_volume) {
    const auto found = sharpen(branch_, reduced_volume, last_);
    if (!found) lost(name(branch_));
    last_ = found->curve();
    return *found;
  }

 private:
  Branch branch_;
  Curve last_;
};

SpecialPoint equal_energies(Sweep& one, Sweep& other, double guess) {
  double v = guess, energy = 0;
  for (int i = 0; i < 10; ++i) {
    const ClassicalMinimum a = one.at(v), b = other.at(v);
    energy = a.reduced_energy();
    const double step = -(energy - b.reduced_energy()) * 6 / (a.pressure() - b.pressure());
    v += step;
    energy += step * a.pressure() / 6;
    if (std::abs(step) < 1e-13) break;
  }
  return {v, energy, 0};
}

// Smallest eigenvalue of the second variation against shapes which are odd under reflection. The
// multiplier of the closure vanishes on symmetric shapes, its derivative against odd ones does not.
double odd_stiffness(const ClassicalMinimum& symmetric) {
  const Basis& half = *symmetric.problem.basis;
  const Problem whole = Problem::classical(basis(Symmetry::none, half.cutoff, half.grading));
  const VectorXd y = pack(on_basis(symmetric.curve(), whole.basis));
  const VectorXd multipliers = Eigen::Vector3d(symmetric.tension(), -symmetric.pressure(), 0);
  const auto odd = Eigen::seq(1, Eigen::last, 2);  // y[k] is b_k
  const VectorXd closure = expand(whole, y)->jacobian.row(2);
  const VectorXd odd_closure = closure(odd);
  const model::TangentSplit split(odd_closure);
  return split.tangential_eigenvalues(split.rotated(hessian(whole, y, multipliers)(odd, odd)))[0];
}

// A critical point of the Lagrangian where it crosses the plane direction·y = t: volume is an unknown
// there, and the branch goes on through its fold.
struct Crossing {
  VectorXd y, multipliers;
  double volume, energy;
  double slope;  // of the volume along the branch, by t
};
void cross(const Problem& problem, const VectorXd& direction, double t, Crossing& at) {
  const Index U = at.y.size();
  for (int i = 0; i < 20; ++i) {
    const std::optional<Expansion> e = expand(problem, at.y);
    if (!e) lost("stomatocyte fold");
    MatrixXd bordered(U + 3, U + 3);
    bordered.setZero();
    bordered.topLeftCorner(U, U) = hessian(problem, at.y, at.multipliers);
    bordered.topRightCorner(U, 3) = e->jacobian.transpose();
    bordered.bottomLeftCorner(3, U) = e->jacobian;
    bordered.block(U + 1, 0, 1, U) = direction.transpose();  // in place of the volume
    VectorXd residual(U + 3);
    residual << e->gradient + e->jacobian.transpose() * at.multipliers, e->measures[0] - 4 * pi,
        direction.dot(at.y) - t, e->measures[2];
    const Eigen::PartialPivLU<MatrixXd> lu(bordered);
    const VectorXd step = lu.solve(-residual);
    const VectorXd tangent = lu.solve(VectorXd::Unit(U + 3, U + 1));
    at.volume = e->measures[1], at.energy = e->energy;
    at.slope = e->jacobian.row(1).dot(tangent.head(U));
    if (step.head(U).norm() < 1e-12) return;
    at.y += step.head(U), at.multipliers += step.tail(3);
  }
  lost("stomatocyte fold");
}

SpecialPoint largest_volume(Sweep& stomatocyte) {
  const ClassicalMinimum before = stomatocyte.at(0.65), after = stomatocyte.at(0.654);
  VectorXd direction = after.state.y - before.state.y;
  const double step = direction.norm() / 2;
  direction.normalize();
  Crossing at{.y = after.state.y,
              .multipliers = after.state.multipliers,
              .volume = 0,
              .energy = 0,
              .slope = 0};
  const double t = direction.dot(at.y);
  const auto slope = [&](double plane) {
    cross(after.problem, direction, plane, at);
    return at.slope;
  };
  model::root_near(t + step, t + 2 * step, slope, last_change);
  return {at.volume / (4 * pi / 3), at.energy / (8 * pi), 0};
}

SpecialPoints points_with(int symmetric_cutoff, int stomatocyte_cutoff) {
  Sweep oblate(Branch::oblate, symmetric_cutoff, 0.62);
  Sweep prolate(Branch::prolate, symmetric_cutoff, 0.65);
  Sweep stomatocyte(Branch::stomatocyte, stomatocyte_cutoff, 0.6);
  SpecialPoints points{};
  points.prolate_oblate = equal_energies(prolate, oblate, 0.65);
  points.oblate_stomatocyte = equal_energies(oblate, stomatocyte, 0.59);
  points.stomatocyte_fold = largest_volume(stomatocyte);

  const auto zero = [&](auto&& quantity) {
    double energy = 0;
    const auto at = [&](double v) {
      const ClassicalMinimum shape = oblate.at(v);
      energy = shape.reduced_energy();
      return quantity(shape);
    };
    const double v = model::root_near(0.52, 0.515, at, last_change);
    return SpecialPoint{v, energy, 0};
  };
  points.oblate_symmetry_loss = zero(odd_stiffness);
  points.oblate_self_contact =
      zero([](const ClassicalMinimum& shape) { return pole_distance(shape.curve()); });
  return points;
}

}  // namespace

SpecialPoints minimise_special_points() {
  const SpecialPoints coarse = points_with(48, 72);
  SpecialPoints fine = points_with(64, 96);
  for (SpecialPoint SpecialPoints::*point :
       {&SpecialPoints::prolate_oblate, &SpecialPoints::oblate_stomatocyte,
        &SpecialPoints::stomatocyte_fold, &SpecialPoints::oblate_symmetry_loss,
        &SpecialPoints::oblate_self_contact})
    (fine.*point).error =
        rounding + std::abs((fine.*point).reduced_volume - (coarse.*point).reduced_volume);
  return fine;
}

}  // namespace sbeh::axisym
