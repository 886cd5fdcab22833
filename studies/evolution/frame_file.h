// A frame of a 3D run: the surface with what lives on it, for ParaView and to go on from.
#pragma once

#include "studies/parameters/physics.h"
#include "surface3d/flow.h"

#include <filesystem>
#include <optional>

namespace sbeh::studies {

using surface3d::FlowMoment;

/// The surface alone.
meshing::CurvedMesh curved_mesh(const FlowMoment& moment);

/// VTU with P3 Lagrange triangles and raw doubles; point data `order`, `mean_curvature`, `normal`,
/// `velocity`; field data `TimeValue` and the rest of the moment, `model` (its place in the list of models) and
/// `material.NAME` for each parameter. Written to a temporary name first. Throws OutputError.
void write_frame(const std::filesystem::path& path, const FlowMoment& moment,
                 const Physics& physics);

/// The moment with the velocity alone of its fields, and without the energy of its record. Throws InputError when the file is damaged or
/// is no frame.
FlowMoment read_frame(const std::filesystem::path& path);

/// With what the frame was computed: of one without model and material, as version 0.1.0 wrote them, by the
/// run.toml of the run in whose folder it lies; empty where there is none. Throws InputError when the file is
/// damaged, or has parameters that this version does not know.
std::optional<Physics> physics_of_frame(const std::filesystem::path& path);

}  // namespace sbeh::studies
