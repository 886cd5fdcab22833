// One tetrahedron in the many ways in which programs write it.
#pragma once

#include "meshing/defects.h"
#include "meshing/measures.h"
#include "tests/studies/mesh_files/mesh_file_fixture.h"

#include <string>
#include <string_view>
#include <variant>

namespace sbeh::studies::test {

// Four points and four faces in one way of writing or another.
inline void expect_a_tetrahedron(const fs::path& file) {
  const MeshFile read = read_mesh(file);
  const auto* plain = std::get_if<PlainFile>(&read.mesh);
  ASSERT_TRUE(plain) << file;
  EXPECT_EQ(plain->mesh.point_count(), 4) << file;
  EXPECT_EQ(first_polygon(plain->mesh), -1) << file;
  const meshing::TriangleMesh mesh = triangle_mesh(plain->mesh);
  EXPECT_FALSE(meshing::find_defect(mesh)) << file << meshing::find_defect(mesh)->text;
  EXPECT_NEAR(meshing::volume(mesh), 1. / 6, 1e-15) << file;
}

inline std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result;
  for (std::size_t at = 0; (at = text.find(from)) != std::string_view::npos;) {
    result.append(text.substr(0, at)).append(to);
    text.remove_prefix(at + from.size());
  }
  return result.append(text);
}

}  // namespace sbeh::studies::test
