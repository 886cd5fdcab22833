// Where a mesh that was made goes: into a file, a report, or both.
#pragma once

#include "studies/mesh/make_mesh.h"

#include <CLI/CLI.hpp>

#include <string>

namespace sbeh::tools {

struct MeshOutput {
  std::string file;  ///< empty: none
  bool report = false, overwrite = false;
};

/// -o, --report and --overwrite.
void add_mesh_output(CLI::App& app, MeshOutput& output);

/// Throws InputError where there is nothing to do, the file's suffix is not known, or the file is there.
void require_place(const MeshOutput& output, const char* command);

/// Writes and prints what was asked for; complains of what the user should know of the mesh.
void put(const studies::MadeMesh& made, const studies::MeshRequest& request,
         const MeshOutput& output);

}  // namespace sbeh::tools
