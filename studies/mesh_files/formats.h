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
/// By VTK's readers; `poly_data` for VTP.
MeshFile read_vtk(const std::string& file, bool poly_data);

std::string obj_text(const meshing::TriangleMesh& mesh);
std::string off_text(const meshing::TriangleMesh& mesh);
std::string ply_text(const meshing::TriangleMesh& mesh);  ///< binary, little-endian, doubles
std::string stl_text(const meshing::TriangleMesh& mesh);  ///< binary

}  // namespace sbeh::studies
