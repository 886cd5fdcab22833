// A frame of a 3D run: the surface with what lives on it, for ParaView and to go on from.
#pragma once

#include "studies/io/columns.h"
#include "surface3d/flow.h"

#include <filesystem>

namespace sbeh::studies {

/// All that a run needs to go on, bit for bit.
struct Frame {
  meshing::CurvedMesh mesh;      ///< its nodes are X of the state
  surface3d::Field beta;         // nodes
  surface3d::FlowRecord record;  ///< read from a file: without its energy
  surface3d::Target target;
  surface3d::FlowMemory memory;
};

/// Fields for the eye only.
struct FrameFields {
  surface3d::Field H;         // nodes
  surface3d::Nodes normals;   // 3 x nodes
  surface3d::Nodes velocity;  // 3 x nodes; empty at the start
};

/// VTU with P3 Lagrange triangles and raw doubles; point data `order`, `mean_curvature`, `normal`,
/// `velocity`; field data `TimeValue` and the rest of the frame. Written to a temporary name first.
/// Throws OutputError.
void write_frame(const std::filesystem::path& path, const Frame& frame, const FrameFields& fields);

/// Throws InputError when the file is damaged or is no frame.
Frame read_frame(const std::filesystem::path& path);

/// A row of frames.csv, or of profiles.csv of an axisymmetric run.
struct FrameEntry {
  double time;
  std::string file;  ///< relative to the folder
  int index = 0;
};
const Columns<FrameEntry>& frame_columns();

/// The index of frames for ParaView.
std::string pvd_text(const std::vector<FrameEntry>& frames);

}  // namespace sbeh::studies
