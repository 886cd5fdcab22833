// Wavefront OBJ: `v x y z`, `f a/… b/… c/…` counted from 1, or backwards from −1.
#include "studies/io/errors.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

namespace sbeh::studies {

namespace {

// An index >= 0, which may be that of a point to come.
int corner(const TextLines& lines, std::string_view word, long points) {
  const std::string_view digits = word.substr(0, word.find('/'));
  long index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error != std::errc() || end != digits.data() + digits.size() || index == 0)
    lines.fail(fmt::format("corner \"{}\": must be an index, counted from 1", word.substr(0, 40)));
  const long point = index > 0 ? index - 1 : points + index;
  if (point < 0 || point > std::numeric_limits<int>::max())
    lines.fail(fmt::format("corner {}: there are only {} points before it", index, points));
  return int(point);
}

// The words of a line; a last word \ makes the next line part of it.
std::vector<std::string_view> whole_line(TextLines& lines) {
  std::vector<std::string_view> words = lines.words();
  while (words.back() == "\\") {
    lines.require_next("a line");
    words.pop_back();
    words.insert(words.end(), lines.words().begin(), lines.words().end());
  }
  return words;
}

void require_points(const MeshBuilder& mesh, const std::string& file) {
  for (std::size_t f = 0; f < mesh.faces().size(); ++f)
    for (const int point : mesh.faces()[f])
      if (point >= mesh.point_count())
        throw InputError(fmt::format("{}: face {}: corner {}: there are only {} points", file, f,
                                     point + 1L, mesh.point_count()));
}

}  // namespace

MeshFile parse_obj(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  MeshBuilder mesh;
  int others = 0;
  while (lines.next()) {
    const std::string_view first = lines.words()[0];
    if (first == "v") {
      mesh.add_point(lines.number(1), lines.number(2), lines.number(3));
    } else if (first == "f") {
      const auto words = whole_line(lines);
      if (words.size() < 4)
        lines.fail(fmt::format("a face with {} corners: must have three", words.size() - 1));
      std::vector<int> corners;
      for (std::size_t k = 1; k < words.size(); ++k)
        corners.push_back(corner(lines, words[k], mesh.point_count()));
      mesh.add_face(std::move(corners));
    } else if (first == "l" || first == "p") {
      ++others;
    }
  }
  require_points(mesh, file);
  return {PlainFile{mesh.mesh()}, left_out(others, "points or lines")};
}

std::string obj_text(const meshing::TriangleMesh& mesh) {
  fmt::memory_buffer text;
  for (const auto x : mesh.points.colwise())
    fmt::format_to(std::back_inserter(text), "v {} {} {}\n", x[0], x[1], x[2]);
  for (const auto c : mesh.triangles.colwise())
    fmt::format_to(std::back_inserter(text), "f {} {} {}\n", c[0] + 1, c[1] + 1, c[2] + 1);
  return fmt::to_string(text);
}

}  // namespace sbeh::studies
