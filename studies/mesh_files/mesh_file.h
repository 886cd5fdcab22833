// Meshes in files: OBJ, OFF, PLY, STL, Gmsh's, those of FreeDTS (TSI) and VTK's XML (VTU, VTP) and legacy ones, by the suffix
// of the name.
//
// Digits. Texts (OBJ, OFF, MSH, TSI) are written with as many as a double needs, PLY and VTU in binary
// doubles: numbers read back are the same bits. STL is single precision by its nature, 7 digits.
// OBJ, OFF, PLY, STL and TSI hold the plain triangles between the corners; VTU and MSH hold curved ones.
#pragma once

#include "meshing/curved_cells.h"
#include "meshing/polygon_mesh.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// Values at the nodes, components x nodes, by name.
using NodeFields = std::map<std::string, Eigen::MatrixXd>;

/// Numbers that belong to the whole, by name.
using Globals = std::map<std::string, Eigen::VectorXd>;

/// Plain faces.
struct PlainFile {
  meshing::PolygonMesh mesh;
};
/// Curved triangles of order 2 or 3 and what lives on their points.
struct CurvedCellsFile {
  meshing::CurvedCells cells;
  NodeFields fields;   ///< components x points
  NodeFields globals;  ///< components x tuples
};

/// What a file has: corners are in range, the rest is unchecked. Points of STL with equal coordinates
/// are one point.
struct MeshFile {
  std::variant<PlainFile, CurvedCellsFile> mesh;
  std::vector<std::string> notes;  ///< what was left out of it

  int face_count() const;
};
/// Throws InputError that names the file and the line, face or point.
MeshFile read_mesh(const std::filesystem::path& path);

/// The note of so many things that make no surface; none for 0.
std::vector<std::string> left_out(int count, std::string_view what);

/// A curved surface and what lives on it.
struct CurvedFile {
  meshing::CurvedMesh mesh;
  NodeFields fields;
  Globals globals;
};
/// With its nodes numbered as CurvedMesh says. Throws std::invalid_argument as `meshing::joined` does.
CurvedFile joined(const CurvedCellsFile& file);
/// Curved triangles of a file that are a surface as they are; none: they are plain. Throws InputError.
std::optional<CurvedFile> read_curved_mesh(const std::filesystem::path& path);

/// Whether the suffix is one that `read_mesh` knows.
bool is_mesh_name(const std::filesystem::path& path);

/// Throws InputError unless the suffix is one that `write_mesh` knows.
void require_mesh_suffix(const std::filesystem::path& path);

/// Whether the suffix is that of a format which keeps curved triangles.
bool keeps_curved(const std::filesystem::path& path);

/// In the format of the suffix; `fields` only in VTU and MSH. Throws InputError for an unknown suffix and
/// OutputError.
void write_mesh(const std::filesystem::path& path, const meshing::CurvedMesh& mesh,
                const NodeFields& fields = {});

/// The text of a VTU file: Lagrange triangles of the mesh's order, raw appended doubles.
std::string vtu_text(const meshing::CurvedMesh& mesh, const NodeFields& fields,
                     const Globals& globals = {});

}  // namespace sbeh::studies
