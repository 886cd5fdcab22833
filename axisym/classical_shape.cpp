#include "axisym/classical_shape.h"

namespace sbeh::axisym {

const char* name(Branch branch) {
  switch (branch) {
    case Branch::oblate:
      return "oblate";
    case Branch::prolate:
      return "prolate";
    case Branch::stomatocyte:
      return "stomatocyte";
  }
  return "";
}

}  // namespace sbeh::axisym
