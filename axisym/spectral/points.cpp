// The five special points of the classical diagram, on two resolutions.
#include "axisym/spectral/classical.h"
#include "axisym/spectral/minimiser.h"
#include "axisym/spectral/special.h"
#include "model/numerics/root.h"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace sbeh::axisym {
namespace {

using namespace spectral;
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

double odd_stiffness_of(const ClassicalMinimum& symmetric) {
  return odd_stiffness(symmetric.problem, symmetric.state);
}

SpecialPoint largest_volume(Sweep& stomatocyte) {
  const ClassicalMinimum before = stomatocyte.at(0.65), after = stomatocyte.at(0.654);
  const auto found = fold(after.problem, before.state, after.state);
  if (!found) lost("stomatocyte fold");
  return {found->reduced_volume, found->state.energy / (8 * pi), 0};
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
  points.oblate_symmetry_loss = zero(odd_stiffness_of);
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
