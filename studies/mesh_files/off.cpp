// OFF: `OFF`, counts of points, faces, edges; points; faces `3 a b c`, counted from 0.
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

namespace sbeh::studies {

meshing::TriangleMesh parse_off(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  lines.require_next("the header");
  std::size_t first = 0;
  if (lines.words()[0] == "OFF" || lines.words()[0] == "COFF") {
    first = 1;
    if (lines.words().size() == 1) {
      lines.require_next("the header");
      first = 0;
    }
  } else {
    lines.fail("must begin with OFF");
  }
  const long points = lines.integer(first), faces = lines.integer(first + 1);
  if (points < 0 || faces < 0) lines.fail("the counts of points and faces must be >= 0");
  MeshBuilder mesh;
  for (long i = 0; i < points; ++i) {
    lines.require_next(fmt::format("the points: {} of {}", i, points));
    mesh.add_point(lines.number(0), lines.number(1), lines.number(2));
  }
  for (long t = 0; t < faces; ++t) {
    lines.require_next(fmt::format("the faces: {} of {}", t, faces));
    if (lines.integer(0) != 3)
      lines.fail(fmt::format("a face with {} corners: must be a triangle", lines.integer(0)));
    std::array<int, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      const long index = lines.integer(k + 1);
      if (index < 0 || index >= points)
        lines.fail(fmt::format("corner {}: must be in 0 ... {}", index, points - 1));
      corner[k] = int(index);
    }
    mesh.add_triangle(corner[0], corner[1], corner[2]);
  }
  return mesh.mesh();
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
