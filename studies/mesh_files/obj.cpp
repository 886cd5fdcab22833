// Wavefront OBJ: `v x y z`, `f a/… b/… c/…` counted from 1, or backwards from −1.
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

namespace sbeh::studies {

namespace {

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

}  // namespace

meshing::TriangleMesh parse_obj(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  MeshBuilder mesh;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "v") {
      mesh.add_point(lines.number(1), lines.number(2), lines.number(3));
    } else if (words[0] == "f") {
      if (words.size() != 4)
        lines.fail(fmt::format("a face with {} corners: must be a triangle", words.size() - 1));
      const auto at = [&](std::size_t k) { return corner(lines, words[k], mesh.point_count()); };
      mesh.add_triangle(at(1), at(2), at(3));
    }
  }
  return mesh.mesh();
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
