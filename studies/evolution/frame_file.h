// A frame of a 3D run: the surface with what lives on it, for ParaView and to go on from.
#pragma once

#include "surface3d/flow.h"

#include <filesystem>

namespace sbeh::studies {

using surface3d::FlowMoment;

/// The surface alone.
meshing::CurvedMesh curved_mesh(const FlowMoment& moment);

/// VTU with P3 Lagrange triangles and raw doubles; point data `order`, `mean_curvature`, `normal`,
/// `velocity`; field data `TimeValue` and the rest of the moment. Written to a temporary name first.
/// Throws OutputError.
void write_frame(const std::filesystem::path& path, const FlowMoment& moment);

/// The moment without its fields and the energy of its record. Throws InputError when the file is damaged or
/// is no frame.
FlowMoment read_frame(const std::filesystem::path& path);

}  // namespace sbeh::studies
