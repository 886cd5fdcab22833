#include "model/time/flow_record.h"

#include <cmath>

namespace sbeh::model {

std::string describe(FlowFault fault) {
  switch (fault) {
    case FlowFault::none:
      return "";
    case FlowFault::linear_solve:
      return "the linear system of a step could not be solved: it is singular, as for a shape that "
             "cannot move within its area and volume, or where nothing resists a flow along the "
             "surface "
             "(η(β) = 0 without friction_tangential), or the mesh is too coarse or degenerate";
    case FlowFault::degenerate:
      return "a step turns a triangle over or leaves the surface degenerate, however small: the "
             "mesh is too coarse for the shape; a finer mesh may help";
    case FlowFault::area_volume:
      return "area and volume could not be restored after a step: the mesh is too coarse for the "
             "shape; a finer mesh may help";
    case FlowFault::error:
      return "the error of a step stays above the tolerance, however small: the shape or the order "
             "has become sharper than the mesh resolves; a finer mesh or a larger tolerance may "
             "help";
    case FlowFault::energy_rises:
      return "the energy rises in every step, however small: the mesh does not resolve the shape "
             "or the order; a finer mesh may help";
  }
  return "";
}

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
    case FlowStop::near_rest:
      return "near rest";
  }
  return "";
}

bool rises_too_far(const FlowRecord& last) {
  constexpr double tolerance = 1e-5;
  const Energy& energy =
      last.energy;  // the thermotropic part is a constant where the order is full
  return last.rises.sum > tolerance * (std::abs(energy.distortion) + std::abs(energy.bending));
}

}  // namespace sbeh::model
