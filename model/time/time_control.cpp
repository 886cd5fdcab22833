#include "model/time/time_control.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sbeh::model {

void TimeControl::validate() const {
  check_parameters(*this);
  if (smallest_step > largest_step || first_step > largest_step)
    throw std::invalid_argument(
        fmt::format("largest_step = {}: must be >= first_step and smallest_step", largest_step));
}

}  // namespace sbeh::model
