// A moment of a 3D run: all that its files are made of.
#pragma once

#include "surface3d/flow.h"

#include <filesystem>
#include <memory>

namespace sbeh::studies {

struct Moment {
  surface3d::FlowRecord record;
  surface3d::State state;
  std::shared_ptr<const surface3d::Triangulation> mesh;
  surface3d::Target target;
  surface3d::StepFields fields;  ///< of the last solve; empty at the start and on a new mesh
  surface3d::FlowMemory memory;
};

/// As a frame, from which a run can go on. Throws OutputError.
void write_frame(const std::filesystem::path& path, const Moment& moment);

}  // namespace sbeh::studies
