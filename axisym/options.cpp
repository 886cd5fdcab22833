#include "axisym/options.h"

namespace sbeh::axisym {

void Numerics::validate() const {
  model::check_parameters(*this);
  TimeControl::validate();
}

}  // namespace sbeh::axisym
