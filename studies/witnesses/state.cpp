#include "studies/witnesses/state.h"

#include "axisym/curvature.h"
#include "axisym/shooting/seifert_shooting.h"
#include "axisym/spectral/minimiser.h"
#include "studies/io/interrupt.h"
#include "studies/scan/branch_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

namespace sbeh::studies {

using axisym::ClassicalShape;
using axisym::StationaryCase;
using model::Model;
using std::numbers::pi;

namespace {

// Takes the curve as the method's, from the pole where H is larger on.
void take_curve(WitnessState& found, const Meridian& curve, const std::array<double, 2>& H_poles) {
  found.meridian = (H_poles[1] > H_poles[0] ? curve.reversed() : curve).centred();
  found.points = found.meridian->points();
  found.order = found.meridian->order();
  found.measures.H_pole = std::max(H_poles[0], H_poles[1]);
}

WitnessState classical_state(const model::Material& material, Witness witness,
                             const ClassicalShape& shape, const Meridian& curve) {
  WitnessState found{.witness = witness};
  found.measures = classical_measures(material, shape.energy, shape.pressure, shape.tension);
  take_curve(found, curve, {shape.H_pole, shape.H_pole});
  return found;
}

Eigen::VectorXd full_order_on(const Eigen::Matrix2Xd& points) {
  return Eigen::VectorXd::Constant(points.cols(), model::full_order);
}

WitnessState failed(Witness witness, std::string reason) {
  return {.witness = witness, .failure = std::move(reason)};
}

}  // namespace

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      {"energy", &Measures::energy, true},
      {"energy_distortion", &Measures::energy_distortion, true},
      {"energy_bending", &Measures::energy_bending, true},
      {"energy_thermotropic", &Measures::energy_thermotropic, true},
      {"pressure", &Measures::pressure, false},
      {"tension", &Measures::tension, false},
      {"order_min", &Measures::order_min, false},
      {"order_mean", &Measures::order_mean, false},
      {"order_max", &Measures::order_max, false},
      {"H_pole", &Measures::H_pole, false},
  };
  return all;
}

Measures classical_measures(const model::Material& m, double energy, double pressure,
                            double tension) {
  const double beta = model::full_order, kappa = m.kappa(beta), u = m.potential.value(beta);
  Measures of;
  of.energy_distortion = 0;
  of.energy_bending = 8 * pi * kappa * energy + 4 * pi * m.kappa_gauss(beta);
  of.energy_thermotropic = 4 * pi * u;
  of.energy = of.energy_bending + of.energy_thermotropic;
  of.pressure = kappa * pressure;
  of.tension = kappa * tension - u;
  of.order_min = of.order_mean = of.order_max = beta;
  return of;
}

WitnessState newton_state(const StationaryCase& of) {
  const PointOutcome point = branch_point(of);
  if (point.row.status != PointStatus::stationary) {
    const std::string& reason = point.row.stop_reason;  // of a row, whose values are not taken here
    return failed(Witness::newton, reason.substr(0, reason.find("; the values")));
  }
  const axisym::StationaryState& s = *point.state;
  WitnessState found{.witness = Witness::newton,
                     .remark = fmt::format("{} elements", axisym::element_count(s.X)),
                     .measures = measures_of(axisym::energy(of.material, s, s.H),
                                             *point.row.diagnostics, s.pressure),
                     .profile = s};
  found.measures.tension = s.tension;
  take_curve(found, Meridian(s), axisym::pole_curvatures(s.X, s.H));
  return found;
}

WitnessState flow_state(const StationaryCase& of, const std::vector<double>& times) {
  WitnessState found{.witness = Witness::flow};
  const axisym::FlowResult run =
      flow_from_spheroid(of, {.end_time = 200, .output_times = times},
                         [&](const axisym::FlowRecord& record, const axisym::State&, bool exact) {
                           if (exact) found.history.push_back({record.time, record.energy.total()});
                           return interrupt_signal() == 0;
                         });
  if (run.stop == axisym::FlowStop::interrupted) throw Interrupted("interrupted");
  found.remark = fmt::format("{} elements, {} at t = {:.4g} after {} steps", of.numerics.elements,
                             axisym::describe(run.stop), run.last.time, run.steps);
  if (run.stop != axisym::FlowStop::at_rest) {
    found.failure = found.remark;
    return found;
  }
  const axisym::Diagnostics d = axisym::diagnose(of.material, run.state);
  found.measures = measures_of_flow(of.material, d, run.last.lambda);
  take_curve(found, Meridian(run.state),
             axisym::pole_curvatures(run.state.X, axisym::mean_curvature(run.state.X)));
  return found;
}

WitnessState shooting_state(const StationaryCase& of) {
  try {
    const std::array<double, 1> at{of.reduced_volume};
    const ClassicalShape shape = axisym::shoot_branch(of.branch, at).front();
    // Equal steps of arc length from either pole to the equator.
    const int equator = int(shape.profile.cols() - 1) / 2;
    return classical_state(of.material, Witness::shooting, shape,
                           Meridian(shape.profile, full_order_on(shape.profile), {equator}));
  } catch (const std::runtime_error& error) {
    return failed(Witness::shooting, error.what());
  } catch (const std::logic_error& error) {  // not on the branch, or out of reach
    return failed(Witness::shooting, error.what());
  }
}

WitnessState minimiser_state(const StationaryCase& of) {
  const auto minimum = axisym::minimise_energy(of.material, of.model, of.reduced_volume, of.branch);
  if (!minimum)
    return failed(Witness::minimiser,
                  "there is no smooth minimum of this branch, or it is not resolved");
  const Meridian curve(minimum->profile.X, minimum->profile.beta);
  WitnessState found{
      .witness = Witness::minimiser,
      .measures = {.energy = minimum->energy,
                   .energy_distortion = minimum->parts.distortion,
                   .energy_bending = minimum->parts.bending + minimum->parts.gaussian,
                   .energy_thermotropic = minimum->parts.thermotropic,
                   .pressure = minimum->pressure,
                   .tension = minimum->tension,
                   .order_min = minimum->order_min,
                   .order_mean = curve.mean_order(),
                   .order_max = curve.largest_order()}};
  take_curve(found, curve, minimum->H_poles);
  return found;
}

}  // namespace sbeh::studies
