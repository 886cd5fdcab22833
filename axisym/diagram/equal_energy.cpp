#include "axisym/diagram/equal_energy.h"

#include "axisym/diagnostics.h"
#include "axisym/stationary/accuracy.h"
#include "model/numerics/root.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sbeh::axisym {

namespace {

// The energies of a piece as a function of μ.
class EnergyCurve {
 public:
  EnergyCurve(const Line& line, std::span<const PathState> states) : states_(states) {
    for (const PathState& s : states) {
      mu_.push_back(s.mu);
      energy_.push_back(energy(line.material_at(s.mu), s, s.H).total());
      slope_.push_back(s.pressure * line.volume_rate());
    }
  }
  double low() const { return mu_.front(); }
  double high() const { return mu_.back(); }
  const std::vector<double>& places() const { return mu_; }
  double operator()(double mu) const {
    const std::size_t k = piece(mu);
    const double h = mu_[k + 1] - mu_[k], t = (mu - mu_[k]) / h, s = 1 - t;
    return s * s * (1 + 2 * t) * energy_[k] + t * t * (1 + 2 * s) * energy_[k + 1]
         + s * t * h * (s * slope_[k] - t * slope_[k + 1]);
  }
  const PathState& nearest(double mu) const {
    const std::size_t k = piece(mu);
    return states_[mu - mu_[k] < mu_[k + 1] - mu ? k : k + 1];
  }

 private:
  std::size_t piece(double mu) const {
    const auto after = std::ranges::upper_bound(mu_, mu);
    return std::size_t(
        std::clamp<std::ptrdiff_t>(after - mu_.begin() - 1, 0, std::ptrdiff_t(mu_.size()) - 2));
  }
  std::span<const PathState> states_;
  std::vector<double> mu_, energy_, slope_;
};

std::optional<BranchState> at(const Line& line, double mu, const StationaryState& near) {
  return solve_at(line.material_at(mu), line.model, line.at(mu), near,
                  {.most_iterations = 9, .far = 0.3, .symmetric = line.symmetric});
}

double energy_of(const Line& line, double mu, const BranchState& s) {
  return energy(line.material_at(mu), s, s.H).total();
}

// Newton's method on μ, from the cubics' zero.
std::optional<EqualEnergy> polished(const Line& line, double mu, const PathState& near_first,
                                    const PathState& near_second, const Numerics& numerics) {
  constexpr int most_iterations = 8;
  constexpr double tolerance = 1e-11;
  std::optional<BranchState> a = at(line, mu, near_first), b = at(line, mu, near_second);
  double step = 1, slope = 0;
  for (int k = 0; a && b && k < most_iterations && std::abs(step) > tolerance; ++k) {
    slope = (a->pressure - b->pressure) * line.volume_rate();
    step = -(energy_of(line, mu, *a) - energy_of(line, mu, *b)) / slope;
    if (!(std::abs(step) < 0.1)) return {};
    mu += step;
    a = at(line, mu, *a);
    b = at(line, mu, *b);
  }
  if (!a || !b || !(std::abs(step) <= tolerance * 100)) return {};
  const model::Material material = line.material_at(mu);
  const ResolvedState fine_a = resolved(material, line.model, *a, numerics),
                      fine_b = resolved(material, line.model, *b, numerics);
  const double missed =
      fine_a.diagnostics.energy.total() - fine_b.diagnostics.energy.total();  // what is left
  const double off = std::abs(missed) + fine_a.error.energy + fine_b.error.energy;
  const double volumes = line.at(1).reduced_volume - line.at(0).reduced_volume;
  return EqualEnergy{fine_a.state, fine_b.state, fine_a.diagnostics.energy.total(),
                     std::abs(off / slope * volumes)};
}

}  // namespace

std::vector<EqualEnergy> equal_energies(const Line& line, std::span<const PathState> first,
                                        std::span<const PathState> second,
                                        const Numerics& numerics) {
  if (first.size() < 2 || second.size() < 2) return {};
  const EnergyCurve a(line, first), b(line, second);
  const double low = std::max(a.low(), b.low()), high = std::min(a.high(), b.high());
  if (!(low < high)) return {};
  std::vector<double> places{low, high};
  for (const EnergyCurve* curve : {&a, &b})
    for (const double mu : curve->places())
      if (mu > low && mu < high) places.push_back(mu);
  std::ranges::sort(places);
  const auto difference = [&](double mu) { return a(mu) - b(mu); };
  std::vector<EqualEnergy> found;
  for (std::size_t k = 1; k < places.size(); ++k) {
    if (places[k] <= places[k - 1] || difference(places[k - 1]) * difference(places[k]) >= 0)
      continue;
    const double mu = model::root_between(difference, places[k - 1], places[k]).middle();
    if (auto both = polished(line, mu, a.nearest(mu), b.nearest(mu), numerics))
      found.push_back(std::move(*both));
  }
  return found;
}

}  // namespace sbeh::axisym
