// The classical oblate with V_r = 0.8, L = 0.05, and in how many directions it falls over in 3D.
#include "axisym/diagnostics.h"
#include "axisym/modes/stability_3d.h"
#include "axisym/stationary/ssh_branch.h"

#include <cstdio>

int main() {
  using namespace sbeh;
  const model::Material material = model::Material{}.with_L(0.05);
  axisym::SshBranch branch(axisym::Branch::oblate, material, axisym::Numerics{});
  const auto found = branch.at(0.8);
  if (!found || found->arrival != axisym::Arrival::reached) {
    std::puts("not found");
    return 1;
  }
  const axisym::Diagnostics measures = axisym::diagnose(material, found->state);
  const auto stability =
      axisym::stability_3d(material, model::Model::SSH, found->state, /*largest_m=*/4);
  std::printf("energy %.9f, thickness at the poles %.6f, negative directions %d\n",
              measures.energy.total(), measures.thickness_pole,
              stability ? stability->negative_directions.value_or(-1) : -1);
}
