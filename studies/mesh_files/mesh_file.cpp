#include "studies/mesh_files/mesh_file.h"

#include "meshing/curving.h"
#include "meshing/resolution.h"
#include "studies/io/errors.h"
#include "studies/io/output.h"
#include "studies/mesh_files/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <functional>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

std::string suffix_of(const fs::path& path) {
  std::string suffix = path.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return suffix;
}

std::string text_of(const fs::path& path) {
  constexpr std::uintmax_t largest = std::uintmax_t(1) << 30;
  std::error_code unreadable;
  if (fs::exists(path, unreadable) && !fs::is_directory(path, unreadable)
      && !fs::is_regular_file(path, unreadable))
    throw InputError(fmt::format("{}: is not a file that can be read as a mesh", path.string()));
  if (fs::file_size(path, unreadable) > largest && !unreadable)
    throw InputError(fmt::format("{}: has more than {} bytes", path.string(), largest));
  try {
    return read_file(path);
  } catch (const OutputError& error) {
    throw InputError(error.what());
  }
}

// How a kind of file is read, and written: the plain triangles, or curved ones with what lives on them.
struct Format {
  std::string_view suffix;
  MeshFile (*parse)(std::string_view text, const std::string& file);
  std::string (*plain)(const meshing::TriangleMesh& mesh) = nullptr;
  std::string (*curved)(const meshing::CurvedMesh& mesh, const NodeFields& fields) = nullptr;
};
std::string vtu_without_globals(const meshing::CurvedMesh& mesh, const NodeFields& fields) {
  return vtu_text(mesh, fields);
}
constexpr Format formats[] = {{".obj", parse_obj, obj_text},
                              {".off", parse_off, off_text},
                              {".ply", parse_ply, ply_text},
                              {".stl", parse_stl, stl_text},
                              {".tsi", parse_tsi, tsi_text},
                              {".msh", parse_gmsh, nullptr, gmsh_text},
                              {".vtk", parse_vtk},
                              {".vtp", parse_vtk},
                              {".vtu", parse_vtk, nullptr, vtu_without_globals}};

const Format* format_of(std::string_view suffix) {
  const auto* found = std::ranges::find(formats, suffix, &Format::suffix);
  return found == std::end(formats) ? nullptr : found;
}

// The suffixes of the formats of which that holds.
std::string suffixes(const std::function<bool(const Format&)>& holds) {
  std::string list;
  for (const Format& format : formats)
    if (holds(format)) list.append(list.empty() ? "" : ", ").append(format.suffix);
  return list;
}

// What another file is for, where that can be told.
std::string_view advice_for(std::string_view suffix) {
  if (suffix == ".toml") return ", and this is an input: sbeh check tells of which command";
  if (suffix == ".csv") return ", and this is a table: sbeh mesh revolve takes profiles";
  return {};
}

// What is no mesh whatever its name says, by its first bytes.
void refuse_other_content(std::string_view text, const std::string& file) {
  using namespace std::string_view_literals;
  struct Content {
    std::string_view beginning;
    const char* what;
  };
  constexpr const char* packed = "is packed: unpack it first";
  constexpr const char* wide =
      "is text of two or four bytes a letter (UTF-16, UTF-32): save it as UTF-8 or ASCII";
  for (const Content& content :
       {Content{"\xff\xfe"sv, wide}, Content{"\xfe\xff"sv, wide}, Content{"\0\0\xfe\xff"sv, wide},
        Content{"\x1f\x8b"sv, packed}, Content{"PK\x03\x04"sv, packed}, Content{"BZh"sv, packed},
        Content{"\xfd"
                "7zXZ"sv,
                packed},
        Content{"7z\xbc\xaf"sv, packed}, Content{"\x28\xb5\x2f\xfd"sv, packed},
        Content{"version https://git-lfs"sv,
                "is a pointer of Git LFS, not the file itself: git lfs pull "
                "fetches it"}})
    if (text.starts_with(content.beginning))
      throw InputError(fmt::format("{}: {}", file, content.what));
}

}  // namespace

bool is_mesh_name(const fs::path& path) { return format_of(suffix_of(path)) != nullptr; }

MeshFile read_mesh(const fs::path& path) {
  const std::string suffix = suffix_of(path), file = path.string();
  const Format* format = format_of(suffix);
  std::error_code ignored;
  if (!format && fs::is_directory(path, ignored))
    throw InputError(fmt::format("{}: is a directory, not a file", file));
  if (!format)
    throw InputError(fmt::format("{}: unknown suffix \"{}\"; meshes can be read from {}{}", file,
                                 suffix, suffixes([](const Format&) { return true; }),
                                 advice_for(suffix)));
  const std::string text = text_of(path);
  if (text.empty()) throw InputError(fmt::format("{}: is empty", file));
  refuse_other_content(text, file);
  MeshFile mesh = format->parse(text, file);
  const int faces = mesh.face_count();
  if (faces == 0) throw InputError(fmt::format("{}: has no triangles", file));
  if (faces > meshing::most_triangles)
    throw InputError(
        fmt::format("{}: has {} triangles, more than {}: make it coarser with the program it comes "
                    "from",
                    file, faces, meshing::most_triangles));
  for (std::string& note : mesh.notes) note = fmt::format("{}: {}", file, note);
  return mesh;
}

std::vector<std::string> left_out(int count, std::string_view what) {
  if (count == 0) return {};
  return {fmt::format("{} {} left out: only faces make a surface", count, what)};
}

int MeshFile::face_count() const {
  if (const auto* plain = std::get_if<PlainFile>(&mesh)) return plain->mesh.face_count();
  return int(std::get<CurvedCellsFile>(mesh).cells.cells.cols());
}

CurvedFile joined(const CurvedCellsFile& file) {
  const meshing::JoinedCells cells = meshing::joined(file.cells);
  CurvedFile result{cells.mesh, {}, {}};
  for (const auto& [name, values] : file.fields)
    result.fields[name] = values(Eigen::all, cells.points);
  for (const auto& [name, values] : file.globals) result.globals[name] = values.reshaped();
  return result;
}

std::optional<CurvedFile> read_curved_mesh(const fs::path& path) {
  const MeshFile file = read_mesh(path);
  const auto* cells = std::get_if<CurvedCellsFile>(&file.mesh);
  if (!cells) return {};
  try {
    return joined(*cells);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", path.string(), error.what()));
  }
}

void require_mesh_suffix(const fs::path& path) {
  const std::string suffix = suffix_of(path);
  const Format* format = format_of(suffix);
  if (format && (format->plain || format->curved)) return;
  throw InputError(
      fmt::format("{}: unknown suffix \"{}\"; meshes can be written to {} (curved), {}",
                  path.string(), suffix, suffixes([](const Format& f) { return f.curved; }),
                  suffixes([](const Format& f) { return f.plain; })));
}

bool keeps_curved(const fs::path& path) {
  const Format* format = format_of(suffix_of(path));
  return format && format->curved;
}

void write_mesh(const fs::path& path, const meshing::CurvedMesh& mesh, const NodeFields& fields) {
  require_mesh_suffix(path);
  const Format& format = *format_of(suffix_of(path));
  write_file(path, format.curved ? format.curved(mesh, fields) : format.plain(corners(mesh)));
}

}  // namespace sbeh::studies
