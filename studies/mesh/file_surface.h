// A user's mesh: read, repaired where that is wanted, and checked.
#pragma once

#include "meshing/fitted_surface.h"
#include "studies/mesh_files/mesh_file.h"

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// A closed, outward surface of the topology of a sphere: the smooth one through the points of plain
/// triangles, or curved triangles.
struct FileSurface {
  std::variant<std::shared_ptr<const meshing::FittedSurface>, CurvedFile> surface;
  meshing::Names names;            ///< of its corners and triangles, as in the file
  std::vector<std::string> notes;  ///< what was left out and repaired
};

/// Throws InputError: which triangle or point of the file is wrong, and whether `repair` would mend it.
FileSurface surface_of_file(const std::filesystem::path& file, bool repair);

/// What there is to do where that helps.
std::string advice_to_repair(const std::filesystem::path& file);

/// The triangles through whose points it goes, curved so that they lie on it.
meshing::CurvedMesh curved(const meshing::FittedSurface& surface, int order);

}  // namespace sbeh::studies
