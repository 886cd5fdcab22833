#include "studies/witnesses/witness.h"

namespace sbeh::studies {

const char* name(Witness witness) {
  constexpr std::array names{"newton", "shooting", "minimiser", "flow", "surface3d", "harmonics"};
  return names[std::size_t(witness)];
}

SurfaceMethod::SurfaceMethod() {
  numerics.tolerance = 1e-3;
  numerics.rest_speed = 1e-5;
}

}  // namespace sbeh::studies
