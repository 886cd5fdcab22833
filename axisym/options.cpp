#include "axisym/options.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sbeh::axisym {

namespace {
template <class T>
void require_range(const char* name, T value, T low, T high) {
  if (!(value >= low && value <= high))
    throw std::invalid_argument(
        fmt::format("{} = {}: must be in {} ... {}", name, value, low, high));
}
}  // namespace

void Numerics::validate() const {
  require_range("elements", elements, 8, 4096);
  require_range("grading", grading, 0.0, 4.0);
  require_range("tolerance", tolerance, 1e-12, 0.1);
  require_range("first_step", first_step, 1e-14, 10.0);
  require_range("smallest_step", smallest_step, 1e-16, 1.0);
  require_range("largest_step", largest_step, 1e-14, 1e3);
  require_range("rest_speed", rest_speed, 1e-14, 1.0);
  if (smallest_step > largest_step || first_step > largest_step)
    throw std::invalid_argument(
        fmt::format("largest_step = {}: must be >= first_step and smallest_step", largest_step));
}

}  // namespace sbeh::axisym
