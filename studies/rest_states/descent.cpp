#include "studies/rest_states/descent.h"

#include "studies/evolution/event_log.h"
#include "studies/io/interrupt.h"
#include "surface3d/lipids.h"
#include "surface3d/stationary/rest_ahead.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace sbeh::studies {

using surface3d::FlowStop;
using surface3d::State;

namespace {

constexpr double end_of_flow = 1e5;  // in time: next to a branching point all is slow
constexpr int most_steps = 400;

// It is not the way that counts: long steps, in which the energy falls. Tenths of a radius in one step would turn triangles over.
surface3d::Numerics numerics_of(const Membrane& membrane, int triangles) {
  constexpr int most_refined = 5;
  surface3d::Numerics numerics;
  numerics.remesh = true;
  numerics.most_triangles = std::min(most_refined * triangles, meshing::most_triangles);
  if (membrane.material.order == model::OrderDynamics::diffusive) return numerics;
  numerics.integrator = surface3d::Integrator::variational;
  numerics.tolerance = 3e-3;
  numerics.first_step = 1e-2;
  numerics.largest_step = 1e3;
  numerics.smallest_step = 1e-6;  // shorter ones are of a rim that sharpens
  return numerics;
}

// From one mesh to the next one that has to be made by other means than the flow's own.
class Flow {
 public:
  Flow(const Membrane& membrane, Descent& descent, const DescentObserver& observe)
      : membrane_(membrane),
        descent_(descent),
        observe_(observe),
        numerics_(numerics_of(membrane, descent.mesh->count())) {}

  /// Until it rests, or can go no further on its triangles, whose new ones were refused.
  void run() {
    const auto& [material, model, target] = membrane_;
    surface3d::RestWatch rest(material, model, target);
    const double before = descent_.time;
    descent_.reason.clear();
    unresolved_ = false;
    const auto see = [&](const surface3d::FlowRecord& record, const State& state,
                         const surface3d::StepView& view, bool) {
      take(record, state, view, before);
      unresolved_ = view.memory.remeshing_over && !surface3d::resolved(view.indicators);
      if (unresolved_) descent_.reason = why_unresolved(view);
      if (++descent_.steps > most_steps)
        descent_.reason = fmt::format("it still moves after {} steps", most_steps);
      if (interrupt_signal() || !descent_.reason.empty()) return false;
      descent_.rests = rest.near(record, *descent_.mesh, state);
      return !descent_.rests;
    };
    const surface3d::FlowResult end =
        surface3d::run_flow(material, model, {descent_.mesh, descent_.state, target}, numerics_,
                            {.end_time = end_of_flow}, see);
    descent_.rests = descent_.rests || end.stop == FlowStop::at_rest;
    if (!descent_.rests && descent_.reason.empty()) descent_.reason = describe(end.stop);
  }

  /// On triangles that may change the energy more than those of a flow: it is not the way that counts. False where there are none.
  bool renew() {
    const int count = descent_.mesh->count();
    if (!unresolved_ || interrupt_signal() || descent_.steps > most_steps) return false;
    const RestStart on = remeshed_start(*descent_.mesh, descent_.state, membrane_.material,
                                        std::min(count * 3 / 2, numerics_.most_triangles));
    if (!on.mesh) return false;
    descent_.mesh = on.mesh;
    descent_.state = on.state;
    return true;
  }

 private:
  void take(const surface3d::FlowRecord& record, const State& state,
            const surface3d::StepView& view, double before) {
    descent_.mesh = view.mesh;
    descent_.state = state;
    descent_.time = before + record.time;
    descent_.energy = record.energy.total();
    if (observe_) observe_(record);
  }
  static std::string why_unresolved(const surface3d::StepView& view) {
    return fmt::format("{} triangles do not resolve the surface: {}", view.mesh->count(),
                       passed_limits(view.indicators));
  }

  const Membrane& membrane_;
  Descent& descent_;
  const DescentObserver& observe_;
  surface3d::Numerics numerics_;
  bool unresolved_ = false;
};

}  // namespace

State displaced(const Membrane& membrane, const FoundShape& from, const surface3d::Eigenmode& mode,
                double by) {
  const double largest = std::max(mode.u.cwiseAbs().maxCoeff(), mode.b.cwiseAbs().maxCoeff()),
               scale = by / largest;
  State start = from.state;
  start.X += from.normals * (scale * mode.u).asDiagonal();
  start.beta += scale * mode.b;
  surface3d::correct_lipids_volume(from.mesh, effective(membrane.material, membrane.model),
                                   from.state.H, membrane.target, start);
  return start;
}

Descent descend(const Membrane& membrane, std::shared_ptr<const surface3d::Triangulation> mesh,
                const State& start, const DescentObserver& observe) {
  constexpr int most_renewed = 4;
  Descent descent{.mesh = std::move(mesh), .state = start};
  Flow flow(membrane, descent, observe);
  flow.run();
  for (int renewed = 0; renewed < most_renewed && flow.renew(); ++renewed) flow.run();
  return descent;
}

}  // namespace sbeh::studies
