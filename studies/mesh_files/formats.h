// The formats behind mesh_file.h. `file` is the name for messages; all throw InputError.
#pragma once

#include "studies/mesh_files/mesh_file.h"

#include <string>
#include <string_view>

namespace sbeh::studies {

MeshFile parse_obj(std::string_view text, const std::string& file);
MeshFile parse_off(std::string_view text, const std::string& file);
MeshFile parse_ply(std::string_view text, const std::string& file);
MeshFile parse_stl(std::string_view text, const std::string& file);
MeshFile parse_gmsh(std::string_view text, const std::string& file);
MeshFile parse_tsi(std::string_view text, const std::string& file);
/// XML or legacy, whatever the suffix.
MeshFile parse_vtk(std::string_view text, const std::string& file);
/// By VTK's readers, from the file itself.
MeshFile parse_vtk_xml(std::string_view text, const std::string& file);
MeshFile parse_vtk_legacy(std::string_view text, const std::string& file);

std::string gmsh_text(const meshing::CurvedMesh& mesh, const NodeFields& fields);

std::string obj_text(const meshing::TriangleMesh& mesh);
std::string off_text(const meshing::TriangleMesh& mesh);
std::string ply_text(const meshing::TriangleMesh& mesh);  ///< binary, little-endian, doubles
std::string stl_text(const meshing::TriangleMesh& mesh);  ///< binary
std::string tsi_text(const meshing::TriangleMesh& mesh);  ///< moved into a box

}  // namespace sbeh::studies
