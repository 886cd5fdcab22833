#include "model/time/flow_record.h"

namespace sbeh::model {

std::string describe(FlowStop stop) {
  switch (stop) {
    case FlowStop::end_time:
      return "end time reached";
    case FlowStop::at_rest:
      return "at rest";
    case FlowStop::unresolved:
      return "curvature falls below the mesh scale";
    case FlowStop::self_contact:
      return "the surface touches itself";
    case FlowStop::step_too_small:
      return "time step too small";
    case FlowStop::interrupted:
      return "interrupted";
  }
  return "";
}

}  // namespace sbeh::model
