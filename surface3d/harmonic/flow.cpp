#include "surface3d/harmonic/flow.h"

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace sbeh::surface3d {

namespace odeint = boost::numeric::odeint;
using Eigen::Index;

namespace {

using Numbers = std::vector<double>;  // X, one component after the other; β; the dissipated energy
struct Degenerate {};
struct Interrupted {};

Numbers pack(const HarmonicMembrane& membrane, double dissipated) {
  Numbers x(std::size_t(4 * membrane.beta.size() + 1));
  Eigen::Map<Eigen::VectorXd> all(x.data(), Index(x.size()));
  all << membrane.X.reshaped(), membrane.beta, dissipated;
  return x;
}

HarmonicMembrane unpack(const Numbers& x) {
  const Eigen::Map<const Eigen::VectorXd> all(x.data(), Index(x.size()));
  const Index count = all.size() / 4;
  return {all.head(3 * count).reshaped(count, 3), all.segment(3 * count, count)};
}

void validate(const HarmonicSchedule& schedule) {
  const auto& [times, tolerance, goes_on] = schedule;
  if (!(tolerance >= 1e-12 && tolerance <= 1e-3))
    throw std::invalid_argument(
        fmt::format("flow of harmonics: tolerance = {} must be in [1e-12, 1e-3]", tolerance));
  if (times.empty() || !(times.front() > 0)
      || std::ranges::adjacent_find(times, std::ranges::greater_equal()) != times.end())
    throw std::invalid_argument("flow of harmonics: its times must be > 0 and ascend");
}

// A solution under way.
class Integration {
 public:
  Integration(const HarmonicMechanics& mechanics, const HarmonicMembrane& start,
              const HarmonicSchedule& schedule)
      : mechanics_(mechanics),
        goes_on_(schedule.goes_on),
        stepper_(odeint::make_controlled(schedule.tolerance, schedule.tolerance,
                                         odeint::runge_kutta_dopri5<Numbers>())),
        x_(pack(start, 0)) {}

  // Throws Degenerate and Interrupted.
  void advance_to(double time) {
    constexpr double shortest = 1e-9;  // of the way
    const double resolution = shortest * (time - time_);
    const auto rates = [this](const Numbers& x, Numbers& rate, double) {
      const auto at = mechanics_.rates(unpack(x));
      if (!at || !at->rate.X.allFinite()) throw Degenerate();
      ++evaluations_;
      rate = pack(at->rate, at->dissipation.total());
    };
    while (time - time_ > resolution) {
      const bool last = time_ + step_ >= time;
      double step = last ? time - time_ : step_;
      const bool accepted = stepper_.try_step(rates, x_, time_, step) == odeint::success;
      if (!(last && accepted)) step_ = step;
      if (step < resolution) throw Degenerate();
      if (!goes_on_(time_)) throw Interrupted();
    }
    time_ = time;
  }

  HarmonicMoment moment() const {
    HarmonicMoment at{.time = time_, .membrane = unpack(x_), .evaluations = evaluations_};
    const auto measures = mechanics_.measure(at.membrane);
    if (!measures) throw Degenerate();
    at.measures = *measures;
    at.energy_before = measures->energy.total() + x_.back();
    return at;
  }

 private:
  const HarmonicMechanics& mechanics_;
  const std::function<bool(double)>& goes_on_;
  odeint::controlled_runge_kutta<odeint::runge_kutta_dopri5<Numbers>> stepper_;
  Numbers x_;
  double time_ = 0, step_ = 1e-4;
  int evaluations_ = 0;
};

}  // namespace

HarmonicFlowStop flow_harmonics(const HarmonicMechanics& mechanics, const HarmonicMembrane& start,
                                const HarmonicSchedule& schedule,
                                const std::function<void(const HarmonicMoment&)>& observe) {
  validate(schedule);
  try {
    Integration flow(mechanics, start, schedule);
    observe(flow.moment());
    for (const double time : schedule.times) {
      flow.advance_to(time);
      observe(flow.moment());
    }
  } catch (const Degenerate&) {
    return HarmonicFlowStop::degenerate;
  } catch (const Interrupted&) {
    return HarmonicFlowStop::interrupted;
  }
  return HarmonicFlowStop::end;
}

}  // namespace sbeh::surface3d
