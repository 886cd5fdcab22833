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
  TimeControl::validate();
}

}  // namespace sbeh::axisym
