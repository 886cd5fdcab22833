#include "tools/commands/mesh_output.h"

#include "studies/io/errors.h"
#include "tools/commands/command.h"

#include <filesystem>

namespace sbeh::tools {

namespace fs = std::filesystem;
using studies::InputError;

namespace {

void refuse_to_overwrite(const MeshOutput& output) {
  std::error_code ignored;
  if (!output.overwrite && fs::exists(output.file, ignored))
    throw InputError(fmt::format("{}: is there already; --overwrite replaces it", output.file));
}

}  // namespace

void add_mesh_output(CLI::App& app, MeshOutput& output) {
  app.add_option("-o,--output", output.file,
                 "file to write: .vtu, .msh (curved), or .obj, .off, .ply, .stl, .tsi (plain)");
  app.add_flag("--report", output.report, "print quality and measures");
  app.add_flag("--overwrite", output.overwrite, "replace the file if it is there");
}

void require_place(const MeshOutput& output, const char* command) {
  if (output.file.empty() && !output.report)
    throw InputError(
        fmt::format("{}: nothing to do: give a file with -o, or --report, or both", command));
  if (output.file.empty()) return;
  studies::require_mesh_suffix(output.file);
  refuse_to_overwrite(output);
}

void put(const studies::MadeMesh& made, const studies::MeshRequest& request,
         const MeshOutput& output) {
  for (const std::string& note : made.notes) complain(note);
  if (!output.file.empty()) {
    refuse_to_overwrite(output);
    studies::write_mesh(output.file, made.mesh, made.fields);
    if (made.mesh.order > 1 && !studies::keeps_curved(output.file))
      complain(
          fmt::format("{} holds the plain triangles between the corners; .vtu would hold the "
                      "curved ones",
                      output.file));
  }
  if (output.report)
    fmt::print("{}", studies::report(made, request));
  else
    fmt::print("{}: {} triangles of order {}, area {:.8g}, volume {:.8g}, reduced volume {:.8g}\n",
               output.file, made.quality.triangles, made.mesh.order, made.quality.area,
               made.quality.volume, made.quality.reduced_volume);
}

}  // namespace sbeh::tools
