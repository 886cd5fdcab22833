// OFF: `OFF`, counts of points, faces, edges; points; faces `3 a b c`, counted from 0.
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sbeh::studies {

namespace {

// How many numbers a point has: x y z, then those which letters before OFF tell of, in any order.
std::size_t numbers_of_a_point(const TextLines& lines) {
  std::string_view letters = lines.words()[0];
  if (letters == "off") return 3;
  if (!letters.ends_with("OFF")) lines.fail("must begin with OFF");
  letters.remove_suffix(3);
  struct Part {
    std::string_view letters;
    std::size_t numbers;
  };
  // Texture; colour, with or without a fourth number; normal.
  constexpr std::array parts{Part{"ST", 2}, Part{"C", 3}, Part{"N", 3}};
  std::size_t count = 3;
  while (!letters.empty()) {
    if (letters[0] == '4' || letters[0] == 'n')
      lines.fail("points with another number of coordinates than three: must be points in space");
    const auto* part =
        std::ranges::find_if(parts, [&](const Part& p) { return letters.starts_with(p.letters); });
    if (part == parts.end()) lines.fail("must begin with OFF");
    letters.remove_prefix(part->letters.size());
    count += part->numbers;
  }
  return count;
}

void read_face(TextLines& lines, long points, const std::string& where, MeshBuilder& mesh) {
  const long count = lines.integer(0);
  if (count < 3) lines.fail(fmt::format("a face with {} corners: must have three", count));
  lines.require_words(std::size_t(std::min(count, points)) + 1, where);
  std::vector<int> corners;
  for (long k = 0; k < count; ++k) {
    const long index = lines.integer(std::size_t(k) + 1);
    if (index < 0 || index >= points)
      lines.fail(fmt::format("corner {}: must be in 0 ... {}", index, points - 1));
    corners.push_back(int(index));
  }
  mesh.add_face(std::move(corners));
}

}  // namespace

MeshFile parse_off(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  lines.require_next("the header");
  const std::size_t numbers = numbers_of_a_point(lines);
  if (lines.words().size() > 1 && is_word(lines.words()[1], "binary"))
    lines.fail("binary OFF cannot be read: save it as text, or as PLY");
  std::size_t first = 1;
  if (lines.words().size() == 1) {
    lines.require_next("the header");
    first = 0;
  }
  lines.require_words(first + 2, "the header");
  const long points = lines.integer(first), faces = lines.integer(first + 1);
  if (points < 0 || faces < 0) lines.fail("the counts of points and faces must be >= 0");
  MeshBuilder mesh;
  for (long i = 0; i < points; ++i) {
    const std::string where = fmt::format("the points: {} of {}", i, points);
    lines.require_next(where);
    lines.require_words(numbers, where);
    mesh.add_point(lines.number(0), lines.number(1), lines.number(2));
  }
  int others = 0;
  for (long t = 0; t < faces; ++t) {
    const std::string where = fmt::format("the faces: {} of {}", t, faces);
    lines.require_next(where);
    if (const long count = lines.integer(0); count == 1 || count == 2)
      ++others;
    else
      read_face(lines, points, where, mesh);
  }
  std::vector<std::string> notes = left_out(others, "points or lines");
  if (lines.next())
    notes.push_back(fmt::format("what follows the last of its {} faces left out", faces));
  return {PlainFile{mesh.mesh()}, std::move(notes)};
}

std::string off_text(const meshing::TriangleMesh& mesh) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "OFF\n{} {} 0\n", mesh.point_count(),
                 mesh.triangle_count());
  for (const auto x : mesh.points.colwise())
    fmt::format_to(std::back_inserter(text), "{} {} {}\n", x[0], x[1], x[2]);
  for (const auto c : mesh.triangles.colwise())
    fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", c[0], c[1], c[2]);
  return fmt::to_string(text);
}

}  // namespace sbeh::studies
