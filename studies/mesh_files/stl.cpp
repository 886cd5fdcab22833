// STL: triangles without connectivity, text or binary; binary in single precision.
#include "studies/io/errors.h"
#include "studies/io/spelling.h"
#include "studies/mesh_files/bytes.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace sbeh::studies {

namespace {

constexpr std::size_t header = 80, record = 50;  // bytes; 4 for the count in between

// Points of equal coordinates are one; the file has no numbers for them.
class Merged {
 public:
  int index(const std::array<double, 3>& x) {
    const auto [place, is_new] = indices_.try_emplace(x, int(builder_.point_count()));
    if (is_new) builder_.add_point(x[0], x[1], x[2]);
    return place->second;
  }
  void add_face(std::vector<int> corners) { builder_.add_face(std::move(corners)); }
  meshing::PolygonMesh mesh() const {
    meshing::PolygonMesh mesh = builder_.mesh();
    mesh.names.points.clear();
    return mesh;
  }

 private:
  MeshBuilder builder_;
  std::map<std::array<double, 3>, int> indices_;
};

// `facet normal …`, `outer loop`, three times `vertex x y z`, `endloop`, `endfacet`, in capitals or not;
// `end facet` is written too.
MeshFile parse_text(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  Merged merged;
  std::vector<int> corners;
  bool ended = false;
  while (lines.next()) {
    const auto& words = lines.words();
    const auto is = [&](const char* word) { return is_word(words[0], word); };
    const auto ends = [&](const char* word) {
      return is_word(words[0], std::string("end") + word)
          || (is("end") && words.size() > 1 && is_word(words[1], word));
    };
    if (is("solid") && std::ranges::any_of(words, [](auto w) { return is_word(w, "endsolid"); }))
      lines.fail("all in one line: text of STL has a line for each facet, loop and vertex");
    if (is("facet")) {
      corners.clear();
    } else if (is("vertex")) {
      const std::array<double, 3> x{lines.number(1), lines.number(2), lines.number(3)};
      if (!(x == x)) lines.fail("a coordinate is no number");
      corners.push_back(merged.index(x));
    } else if (ends("facet")) {
      if (corners.size() < 3)
        lines.fail(fmt::format("a facet with {} corners: must have three", corners.size()));
      merged.add_face(corners);
    } else if (ends("solid")) {
      ended = true;
    } else if (!is("solid") && !is("outer") && !ends("loop") && !is("color")) {
      lines.fail(fmt::format("{}: is not STL", in_quotes(words[0].substr(0, 40))));
    }
  }
  if (!ended) lines.fail("the file ends here, without endsolid");
  return {PlainFile{merged.mesh()}, {}};
}

bool is_text(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  const std::string_view beginning = text.substr(0, 1000);
  return is_word(text.substr(0, 5), "solid") && beginning.find('\0') == std::string_view::npos;
}

// How many triangles a binary file holds, and what is to be said of it.
std::size_t count_of(std::string_view text, const std::string& file,
                     std::vector<std::string>& notes) {
  if (text.size() < header + 4) throw InputError(fmt::format("{}: is too short for STL", file));
  const std::size_t count = number_from<std::uint32_t>(text.substr(header));
  const std::size_t bytes = text.size() - header - 4, wanted = record * count;
  if (bytes == wanted) return count;
  if (count > 0 && bytes > wanted) {
    notes.push_back(
        fmt::format("{} bytes after the last of its {} triangles left out", bytes - wanted, count));
    return count;
  }
  if (count == 0 && bytes % record == 0) {
    notes.push_back(
        fmt::format("says that it has no triangles, but holds {}: these are read", bytes / record));
    return bytes / record;
  }
  throw InputError(
      fmt::format("{}: has {} bytes, but {} triangles of binary STL take {}: cut off or not STL",
                  file, text.size(), count, header + 4 + wanted));
}

MeshFile parse_binary(std::string_view text, const std::string& file) {
  std::vector<std::string> notes;
  const std::size_t count = count_of(text, file, notes);
  Merged merged;
  for (std::size_t t = 0; t < count; ++t) {
    std::vector<int> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 3> x{};
      for (std::size_t i = 0; i < 3; ++i)
        x[i] = number_from<float>(text.substr(header + 4 + record * t + 12 + 12 * k + 4 * i));
      if (!(x == x))
        throw InputError(fmt::format("{}: triangle {}: a coordinate is no number", file, t));
      corners.push_back(merged.index(x));
    }
    merged.add_face(std::move(corners));
  }
  return {PlainFile{merged.mesh()}, std::move(notes)};
}

}  // namespace

MeshFile parse_stl(std::string_view text, const std::string& file) {
  return is_text(text) ? parse_text(text, file) : parse_binary(text, file);
}

std::string stl_text(const meshing::TriangleMesh& mesh) {
  std::string text = "binary STL, outward triangles";
  text.resize(header, ' ');
  append_number(text, std::uint32_t(mesh.triangle_count()));
  for (const auto c : mesh.triangles.colwise()) {
    const Eigen::Matrix3d x = mesh.points(Eigen::all, c);
    const Eigen::Vector3d n = (x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)).normalized();
    for (int i = 0; i < 3; ++i) append_number(text, float(n[i]));
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 3; ++i) append_number(text, float(x(i, k)));
    append_number(text, std::uint16_t(0));
  }
  return text;
}

}  // namespace sbeh::studies
