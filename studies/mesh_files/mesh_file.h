// Meshes in files: OBJ, OFF, PLY, STL and VTK's VTU and VTP, by the suffix of the name.
//
// Digits. Texts (OBJ, OFF) are written with as many as a double needs, PLY and VTU in binary
// doubles: numbers read back are the same bits. STL is single precision by its nature, 7 digits.
// OBJ, OFF, PLY and STL hold the plain triangles between the corners; VTU holds curved ones.
#pragma once

#include "meshing/curved_mesh.h"
#include "meshing/triangle_mesh.h"

#include <filesystem>
#include <map>
#include <string>
#include <variant>

namespace sbeh::studies {

/// Values at the nodes, components x nodes, by name.
using NodeFields = std::map<std::string, Eigen::MatrixXd>;

/// Numbers that belong to the whole, by name.
using Globals = std::map<std::string, Eigen::VectorXd>;

/// A curved surface and what lives on it.
struct CurvedFile {
  meshing::CurvedMesh mesh;
  NodeFields fields;
  Globals globals;
};

/// Plain triangles as the file has them, unchecked; or curved ones (VTU with triangles of order 2
/// or 3), which are checked to be closed, of sphere topology and conforming. Points of STL with
/// equal coordinates are one point. Throws InputError that names the file and the line, triangle
/// or point.
using MeshFile = std::variant<meshing::TriangleMesh, CurvedFile>;
MeshFile read_mesh(const std::filesystem::path& path);

/// Throws InputError unless the suffix is one that `write_mesh` knows.
void require_mesh_suffix(const std::filesystem::path& path);

/// Whether the suffix is that of a format which keeps curved triangles.
bool keeps_curved(const std::filesystem::path& path);

/// In the format of the suffix; `fields` only in VTU. Throws InputError for an unknown suffix and
/// OutputError.
void write_mesh(const std::filesystem::path& path, const meshing::CurvedMesh& mesh,
                const NodeFields& fields = {});

/// The text of a VTU file: Lagrange triangles of the mesh's order, raw appended doubles.
std::string vtu_text(const meshing::CurvedMesh& mesh, const NodeFields& fields,
                     const Globals& globals = {});

}  // namespace sbeh::studies
