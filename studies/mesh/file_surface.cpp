#include "studies/mesh/file_surface.h"

#include "meshing/curving.h"
#include "meshing/defects.h"
#include "meshing/repair.h"
#include "studies/io/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <optional>
#include <stdexcept>

namespace sbeh::studies {

namespace fs = std::filesystem;
using meshing::Defect;
using meshing::DefectKind;

namespace {

std::optional<Defect> defect_of(const meshing::TriangleMesh& mesh, const meshing::Names& names) {
  if (auto defect = meshing::find_defect(mesh, names)) return defect;
  try {
    meshing::require_smooth(mesh, names);
    return {};
  } catch (const std::invalid_argument& error) {
    return Defect{DefectKind::sharp, error.what()};
  }
}

std::optional<Defect> defect_of(const meshing::PolygonMesh& mesh) {
  const int polygon = first_polygon(mesh);
  if (polygon < 0) return defect_of(triangle_mesh(mesh), mesh.names);
  return Defect{mesh.points.allFinite() ? DefectKind::polygon : DefectKind::not_finite,
                fmt::format("face {} has {} corners: must be a triangle",
                            mesh.names.triangles[std::size_t(polygon)],
                            mesh.faces[std::size_t(polygon)].size())};
}

std::optional<Defect> defect_of(const meshing::Repair& repair) {
  return defect_of(repair.mesh, repair.names);
}

std::optional<Defect> defect_of(const meshing::CurvedCells& cells) {
  if (!cells.points.allFinite())
    return Defect{DefectKind::not_finite, "a coordinate of a node is no finite number"};
  const meshing::CellCorners corner = corners(cells);
  if (auto defect = meshing::find_defect(corner.mesh, corner.names)) return defect;
  try {
    meshing::joined(cells);
    return {};
  } catch (const std::invalid_argument& error) {
    return Defect{DefectKind::open, error.what()};
  }
}

std::optional<Defect> defect_of(const meshing::CellRepair& repair) {
  return defect_of(repair.cells);
}

// Not with numbers that leave nothing to repair with.
bool can_be_repaired(const std::optional<Defect>& defect) {
  return !defect || defect->kind > DefectKind::no_such_point;
}

// What a repair would do about it.
template <class Mesh>
std::string advice(const fs::path& file, const Defect& defect, const Mesh& mesh) {
  if (!can_be_repaired(defect)) return {};
  const auto left = defect_of(meshing::repaired(mesh));
  if (!left) return "; " + advice_to_repair(file);
  if (left->kind == defect.kind) return "; --repair cannot mend that";
  return "; --repair mends that, but not this: " + left->text;
}

// What was left out and repaired before, for a refusal.
std::string told(const std::vector<std::string>& notes) {
  return notes.empty() ? "" : fmt::format(" ({})", fmt::join(notes, "; "));
}

// The repair, if it is wanted. Throws InputError for what is no surface then.
template <class Mesh>
auto checked(const fs::path& file, const Mesh& mesh, bool repair, std::vector<std::string>& notes)
    -> std::optional<decltype(meshing::repaired(mesh))> {
  const auto defect = defect_of(mesh);
  if (!repair || !can_be_repaired(defect)) {
    if (defect)
      throw InputError(fmt::format("{}: {}{}{}", file.string(), defect->text,
                                   advice(file, *defect, mesh), told(notes)));
    return {};
  }
  const auto result = meshing::repaired(mesh);
  for (const std::string& what : result.done) notes.push_back("repaired: " + what);
  if (const auto left = defect_of(result))
    throw InputError(fmt::format("{}: {}; --repair does not help there{}", file.string(),
                                 left->text, told(notes)));
  return result;
}

std::optional<std::string> note_on_roughness(const meshing::FittedSurface& surface,
                                             const fs::path& file) {
  if (surface.mesh().triangle_count() < meshing::fewest_for_roughness
      || surface.roughness() < meshing::largest_roughness)
    return {};
  return fmt::format(
      "{}: is rough: its points scatter about a smooth surface by waves that are bent {:.2g} times "
      "as much as that is. The surface of voxels, say, should be smoothed in the program it comes "
      "from",
      file.string(), surface.roughness());
}

}  // namespace

std::string advice_to_repair(const fs::path& file) {
  return fmt::format("--repair can mend that: sbeh mesh file {} --repair -o FILE", file.string());
}

FileSurface surface_of_file(const fs::path& file, bool repair) {
  MeshFile read = read_mesh(file);
  FileSurface result{{}, {}, std::move(read.notes)};
  if (const auto* plain = std::get_if<PlainFile>(&read.mesh)) {
    const auto mended = checked(file, plain->mesh, repair, result.notes);
    result.names = mended ? mended->names : plain->mesh.names;
    const auto surface = std::make_shared<const meshing::FittedSurface>(
        mended ? mended->mesh : triangle_mesh(plain->mesh), result.names);
    if (const auto note = note_on_roughness(*surface, file)) result.notes.push_back(*note);
    result.surface = surface;
    return result;
  }
  auto& curved = std::get<CurvedCellsFile>(read.mesh);
  if (auto mended = checked(file, curved.cells, repair, result.notes))
    curved.cells = std::move(mended->cells);
  result.names = corners(curved.cells).names;
  result.surface = joined(curved);
  return result;
}

meshing::CurvedMesh curved(const meshing::FittedSurface& surface, int order) {
  return meshing::curved(surface.mesh(), order,
                         meshing::Placement([&](int t, const Eigen::Vector3d& barycentric) {
                           return surface.at(t, barycentric);
                         }));
}

}  // namespace sbeh::studies
