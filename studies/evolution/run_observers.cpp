#include "studies/evolution/run_observers.h"

#include "studies/io/interrupt.h"

namespace sbeh::studies {

RunObservers::RunObservers(const RunInput& input, const OutputFolder& folder, Moment start,
                           double until)
    : input_(input),
      now_(std::move(start)),
      progress_(line_, input.times.end),
      series_(folder, input.times, until),
      frames_(folder, input.times.states, until),
      events_(folder, input.numerics.remesh, until, line_),
      checkpoint_(folder / checkpoint_name, input.checkpoint_minutes, line_) {}

bool RunObservers::see(const surface3d::FlowRecord& record, const surface3d::State& state,
                       const surface3d::StepView& view, bool exact) {
  progress_.see(record);
  events_.see(record, view);
  now_ = {record, state, view.mesh, now_.target, view.fields, view.memory};
  if (record.ends) return true;  // what remains is for finish()
  series_.see(record, exact, [&] { return diagnostics(); });
  if (frames_.see(now_, exact)) checkpoint_.put_off();
  if (interrupt_signal() == 0) return checkpoint_.see(now_), true;
  checkpoint_.write(now_);
  return false;
}

void RunObservers::finish(const surface3d::FlowResult& run) {
  line_.end();
  if (run.stop == surface3d::FlowStop::interrupted) return;
  now_.record = run.last;
  now_.state = run.state;
  series_.finish(run.last, [&] { return diagnostics(); });
  frames_.finish(now_);
  checkpoint_.remove();
}

surface3d::Diagnostics RunObservers::diagnostics() const {
  return surface3d::diagnose(*now_.mesh, input_.material, now_.state);
}

}  // namespace sbeh::studies
