// Files of Gmsh, and of FreeDTS and TS2CG.
#include "meshing/curving.h"
#include "meshing/shapes.h"
#include "tests/studies/mesh_files/tetrahedron.h"

#include <cmath>

namespace sbeh::studies::test {
namespace {

using meshing::CurvedMesh;

CurvedMesh example(int order) {
  return meshing::ellipsoid({1, 1.3, 0.7}, {.triangles = 80, .order = order});
}

constexpr std::string_view tetrahedron_2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n7 0 0 "
    "1\n$EndNodes\n"
    "$Elements\n5\n1 15 2 0 1 1\n2 2 2 0 1 1 3 2\n3 2 2 0 1 1 2 7\n4 2 2 0 1 2 3 7\n5 2 2 0 1 3 1 "
    "7\n"
    "$EndElements\n";
constexpr std::string_view tetrahedron_4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 1 0\n1 0 0 0 1 1 1 0 0\n$EndEntities\n"
    "$Nodes\n2 4 1 7\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n0 1 0\n2 2 0 1\n7\n0 0 1\n$EndNodes\n"
    "$Elements\n2 5 1 5\n0 1 15 1\n1 1\n2 1 2 4\n2 1 3 2\n3 1 2 7\n4 2 3 7\n5 3 1 "
    "7\n$EndElements\n";

TEST_F(MeshFileTest, of_gmsh_are_read_in_both_versions) {
  expect_a_tetrahedron(write("a.msh", tetrahedron_2));
  expect_a_tetrahedron(write("b.msh", tetrahedron_4));
  expect_a_tetrahedron(write("c.msh", replaced(tetrahedron_4, "\n", "\r\n")));
  EXPECT_EQ(read_mesh(path("a.msh")).notes,
            std::vector{path("a.msh").string()
                        + ": 1 points, lines or solids left out: only faces make a surface"});
}

TEST_F(MeshFileTest, of_gmsh_keep_every_bit_of_curved_triangles) {
  for (const int order : {1, 2, 3}) {
    const CurvedMesh mesh = example(order);
    write_mesh(path("m.msh"), mesh, {{"order", Eigen::MatrixXd::Random(1, mesh.node_count())}});
    if (order == 1) {
      EXPECT_EQ(triangle_mesh(std::get<PlainFile>(read_mesh(path("m.msh")).mesh).mesh).points,
                mesh.nodes);
      continue;
    }
    const auto back = read_curved_mesh(path("m.msh"));
    ASSERT_TRUE(back);
    EXPECT_EQ(back->mesh.nodes, mesh.nodes);
    EXPECT_EQ(back->mesh.triangles, mesh.triangles);
  }
}

TEST_F(MeshFileTest, of_gmsh_that_are_none_are_refused_where_they_are_wrong) {
  const std::vector<std::pair<std::string, std::string_view>> cases{
      {"hello\n", ":1: is no mesh of Gmsh"},
      {replaced(tetrahedron_4, "4.1 0", "4 0"),
       ":2: version 4: must be text of version 2.2 or 4.1"},
      {replaced(tetrahedron_4, "4.1 0", "4.1 1"), ":2: version 4.1, binary: must be text"},
      {replaced(tetrahedron_2, "3 1 7\n$", "3 1 8\n$"), ":17: node 8: is not there"},
      {replaced(tetrahedron_2, "7 0 0 1", "1 0 0 1"), ":9: node 1 is there twice"},
      {replaced(tetrahedron_2, "$Elements\n5", "$Elements\n-5"),
       ": the count of elements must be >= 0"},
      {std::string(tetrahedron_2.substr(0, 60)),
       ": the file ends here, in the middle of the nodes: 2 of 4"},
      {replaced(tetrahedron_2, "5 2 2 0 1 3 1 7", "5 9 2 0 1 3 1 7 1 2 3"),
       ": has faces of several orders"},
      {std::string(tetrahedron_2.substr(0, tetrahedron_2.find("$Elements"))), ": has no triangles"},
  };
  for (const auto& [text, what] : cases)
    EXPECT_NE(refusal("m.msh", text).find(what), std::string::npos) << refusal("m.msh", text);
}

constexpr std::string_view tetrahedron_tsi =
    "version 1.1\nbox   5 5 5\nvertex 4\n0 1 1 1 0\n1 2 1 1 0\n2 1 2 1 0\n3 1 1 2 0\n"
    "triangle 4\n0 0 2 1\n1 0 1 3 1\n2 1 2 3\n3 2 0 3\ninclusion 1\n0 1 2 0 1\n";

TEST_F(MeshFileTest, of_freedts_are_read_and_written) {
  expect_a_tetrahedron(write("a.tsi", tetrahedron_tsi));
  EXPECT_EQ(read_mesh(path("a.tsi")).notes,
            std::vector{path("a.tsi").string() + ": 1 inclusions or exclusions left out"});
  const meshing::TriangleMesh plain = meshing::corners(example(3));
  write_mesh(path("m.tsi"), example(3));
  const auto back = triangle_mesh(std::get<PlainFile>(read_mesh(path("m.tsi")).mesh).mesh);
  EXPECT_EQ(back.triangles, plain.triangles);
  EXPECT_GT(back.points.minCoeff(), 0);  // in its box
  const Eigen::Vector3d shift = back.points.col(0) - plain.points.col(0);
  EXPECT_LT(((back.points - plain.points).colwise() - shift).cwiseAbs().maxCoeff(), 1e-14);
}

TEST_F(MeshFileTest, of_freedts_are_put_together_across_their_box) {
  std::string across = replaced(tetrahedron_tsi, "1 2 1 1 0", "1 0.5 1 1 0");  // 5.5
  for (const char* point : {"0 1 1 1 0", "2 1 2 1 0", "3 1 1 2 0"})
    across = replaced(across, point, std::string(point).replace(2, 1, "4.5"));
  expect_a_tetrahedron(write("a.tsi", across));
  EXPECT_NE(read_mesh(path("a.tsi")).notes.back().find("across the borders of its box"),
            std::string::npos);
}

TEST_F(MeshFileTest, of_freedts_that_are_none_are_refused_where_they_are_wrong) {
  const std::vector<std::pair<std::string, std::string_view>> cases{
      {"hello\n", ":1: \"hello\": must be version, box, vertex"},
      {replaced(tetrahedron_tsi, "box   5 5 5", "box 5 0 5"), ":2: box: its lengths must be > 0"},
      {replaced(tetrahedron_tsi, "3 2 0 3", "3 2 0 4"), ":12: corner 4: there is no such vertex"},
      {replaced(tetrahedron_tsi, "3 1 1 2 0", "2 1 1 2 0"), ":7: vertex 2 is there twice"},
      {replaced(tetrahedron_tsi, "vertex 4", "vertex 40"), ":8: "},
      {replaced(tetrahedron_tsi, "inclusion 1", "inclusion 3"),
       ": the file ends here, in the middle of inclusions"},
      {"version 1.1\n", ": has no triangles"},
  };
  for (const auto& [text, what] : cases)
    EXPECT_NE(refusal("m.tsi", text).find(what), std::string::npos) << refusal("m.tsi", text);
}

}  // namespace
}  // namespace sbeh::studies::test
