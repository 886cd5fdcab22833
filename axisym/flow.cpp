#include "axisym/flow.h"

#include "axisym/curvature.h"
#include "axisym/lipids.h"
#include "axisym/shape_class.h"
#include "axisym/weak_form.h"
#include "model/order_step.h"
#include "model/relaxation.h"
#include "model/time/flow.h"
#include "model/time/step_doubling.h"

#include <stdexcept>

namespace sbeh::axisym {

namespace {

// ∫β dS
double order_of(const State& state) {
  double sum = 0;
  for_each_point(state.X, assembly_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    sum += p.dS * value_at(state.beta, e, s);
  });
  return sum;
}

// Steps, and what else model::Flow asks of a solver.
class Solver : public TimeStepper {
 public:
  using State = axisym::State;

  Solver(const model::Material& material, model::Model model, int elements)
      : TimeStepper(material, model, elements),
        material_(has_free_order(model) ? material : material.with_uniform_order()) {}

  bool restore(State& state, const Target& target) const {
    if (state.X.row(0).minCoeff() < 0 || !correct_lipids_volume(material_, target, state))
      return false;
    if (target.order) state.beta.array() += (*target.order - order_of(state)) / area(state.X);
    return true;
  }
  model::Distance distance(const State& a, const State& b) const {
    return {(b.X - a.X).cwiseProduct(node_normals(a.X)).colwise().sum().cwiseAbs().maxCoeff(),
            (b.beta - a.beta).cwiseAbs().maxCoeff()};
  }
  Energy energy(const State& state) const {
    return axisym::energy(material_, state, mean_curvature(state.X));
  }
  bool renew(State&) const { return false; }
  std::optional<model::FlowStop> obstacle(const State& state) const {
    if (crosses_itself(state.X)) return FlowStop::self_contact;
    if (diagnose(material_, state).resolution > largest_resolution) return FlowStop::unresolved;
    return {};
  }

 private:
  model::Material material_;
};
static_assert(model::FlowSolver<Solver> && model::OneStepSolver<Solver>);
static_assert(model::FlowIntegrator<model::StepDoubling<Solver>, State>);

}  // namespace

FlowResult run_flow(const model::Material& material, model::Model model, const State& start,
                    const Target& target, const Numerics& numerics, const FlowSchedule& schedule,
                    const FlowObserver& observe) {
  material.area_difference.check_start(diagnose(material, start).W2);
  Target kept = target;
  if (has_free_order(model) && material.has_lipid_density()) {
    if (is_sphere(area(start.X), volume(start.X)))
      throw std::invalid_argument(model::no_lipids_on_spheres);
    kept.area = lipid_area(material, start);
  }
  if (has_free_order(model) && material.conserves_order())
    kept.order = model::conserved_order(material, target.area, order_of(start));
  Solver solver(material, model, element_count(start.X));
  model::StepDoubling<Solver> integrator(solver, kept, numerics.extrapolate);
  const double at_rest = model::speed_at_rest(numerics.rest_speed, material, model);
  return model::Flow(solver, integrator, numerics, at_rest).run(start, {}, schedule, observe);
}

}  // namespace sbeh::axisym
