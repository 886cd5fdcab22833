#include "tools/commands/evolution_end.h"

#include "tools/commands/command.h"

#include <algorithm>

namespace sbeh::tools {

using model::FlowStop;

void print_end(FlowStop stop, const model::FlowRecord& last, int steps, double at_rest) {
  fmt::print("{} at t = {:.6g} after {} steps ({} rejected): energy {:.10g}\n",
             model::describe(stop), last.time, steps, last.rejected, last.energy.total());
  const double speed = last.speed();
  if (stop == FlowStop::end_time && speed >= at_rest)
    fmt::print("not at rest: it moves by {:.2g} per unit of time, at rest it is below {:.2g}\n",
               speed, at_rest);
}

bool complain_of_end(FlowStop stop, model::FlowFault fault, const model::FlowRecord& last,
                     const EndWords& words) {
  if (stop == FlowStop::step_too_small) complain(model::describe(fault));
  if (stop == FlowStop::unresolved) complain(words.unresolved);
  if (stop == FlowStop::self_contact) complain(words.self_contact);
  const bool rises = model::rises_too_far(last);
  if (rises)
    complain(fmt::format(
        "the energy by which steps are judged, which can only fall, rises by {:.2g} in sum between "
        "t = {:.6g} and {:.6g}: the mesh does not resolve what happens there, and what comes later "
        "is "
        "not to be trusted",
        last.rises.sum, last.rises.from, last.rises.to));
  return rises || stop == FlowStop::step_too_small || stop == FlowStop::unresolved
      || stop == FlowStop::self_contact;
}

}  // namespace sbeh::tools
