// A frame of a 3D run: the surface with what lives on it, for ParaView and to go on from.
#pragma once

#include "surface3d/flow.h"

#include <filesystem>
#include <memory>

namespace sbeh::studies {

/// All that a run needs to go on, bit for bit.
struct Frame {
  meshing::CurvedMesh mesh;      ///< its nodes are X of the state
  surface3d::Field beta;         // nodes
  surface3d::FlowRecord record;  ///< read from a file: without its energy
  surface3d::Target target;
  surface3d::FlowMemory memory;
};

/// A moment of a 3D run: all that its files are made of.
struct Moment {
  surface3d::FlowRecord record;
  surface3d::State state;
  std::shared_ptr<const surface3d::Triangulation> mesh;
  surface3d::Target target;
  surface3d::StepFields fields;  ///< of the last solve; empty at the start and on a new mesh
  surface3d::FlowMemory memory;
};

/// VTU with P3 Lagrange triangles and raw doubles; point data `order`, `mean_curvature`, `normal`,
/// `velocity`; field data `TimeValue` and the rest of the moment. Written to a temporary name first.
/// Throws OutputError.
void write_frame(const std::filesystem::path& path, const Moment& moment);

/// Throws InputError when the file is damaged or is no frame.
Frame read_frame(const std::filesystem::path& path);

}  // namespace sbeh::studies
