#include "studies/evolution/moment.h"

#include "studies/evolution/frame_file.h"

#include <stdexcept>

namespace sbeh::studies {

void write_frame(const std::filesystem::path& path, const Moment& m) {
  const auto curvature = surface3d::curvature_of(*m.mesh, m.state.X);
  if (!curvature) throw std::runtime_error("the surface is degenerate");
  write_frame(path,
              {.mesh = {.order = 3, .triangles = m.mesh->triangles, .nodes = m.state.X},
               .beta = m.state.beta,
               .record = m.record,
               .target = m.target,
               .memory = m.memory},
              {curvature->H, curvature->node_normals, m.fields.V});
}

}  // namespace sbeh::studies
