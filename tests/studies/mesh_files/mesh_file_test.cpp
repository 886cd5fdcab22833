// Meshes in files: what is written is read back, and what is no mesh is refused where it is wrong.
#include "meshing/curving.h"
#include "meshing/shapes.h"
#include "studies/io/errors.h"
#include "studies/io/output.h"
#include "studies/mesh_files/formats.h"
#include "tests/studies/mesh_files/mesh_file_fixture.h"

#include <gtest/gtest.h>

#include <cstring>

namespace sbeh::studies {
namespace {

using meshing::CurvedMesh;
using meshing::TriangleMesh;
namespace fs = std::filesystem;
using test::MeshFileTest;

TriangleMesh plain_mesh(const fs::path& file) {
  return triangle_mesh(std::get<PlainFile>(read_mesh(file).mesh).mesh);
}

CurvedMesh example(int order = 3) {
  return meshing::ellipsoid({1, 1.3, 0.7}, {.triangles = 320, .order = order});
}

TEST_F(MeshFileTest, keeps_every_bit_in_all_formats_but_stl) {
  const CurvedMesh mesh = example();
  const TriangleMesh plain = meshing::corners(mesh);
  for (const char* name : {"m.obj", "m.off", "m.ply", "M.OBJ"}) {
    write_mesh(path(name), mesh);
    const auto back = plain_mesh(path(name));
    EXPECT_EQ(back.points, plain.points) << name;
    EXPECT_EQ(back.triangles, plain.triangles) << name;
  }
}

TEST_F(MeshFileTest, keeps_seven_digits_in_stl) {
  const TriangleMesh plain = meshing::corners(example());
  write_mesh(path("m.stl"), example());
  const auto back = plain_mesh(path("m.stl"));
  ASSERT_EQ(back.point_count(), plain.point_count());
  for (int t = 0; t < plain.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d x = plain.points.col(plain.triangles(k, t));
      EXPECT_EQ(back.points.col(back.triangles(k, t)), x.cast<float>().cast<double>());
    }
}

TEST_F(MeshFileTest, keeps_curved_triangles_and_fields_in_vtu) {
  for (const int order : {2, 3}) {
    const CurvedMesh mesh = example(order);
    const NodeFields fields{
        {"order", Eigen::MatrixXd::Random(1, mesh.node_count())},
        {"velocity & <\"more\">", Eigen::MatrixXd::Random(3, mesh.node_count())}};
    write_mesh(path("m.vtu"), mesh, fields);
    const auto back = *read_curved_mesh(path("m.vtu"));
    EXPECT_EQ(back.mesh.order, order);
    EXPECT_EQ(back.mesh.triangles, mesh.triangles);
    EXPECT_EQ(back.mesh.nodes, mesh.nodes);
    EXPECT_EQ(back.fields, fields);
  }
  write_mesh(path("m.vtu"), example(1));
  EXPECT_EQ(plain_mesh(path("m.vtu")).points, example(1).nodes);
}

TEST_F(MeshFileTest, numbers_the_nodes_of_foreign_curved_triangles_anew) {
  const CurvedMesh mesh = example();
  CurvedMesh foreign = mesh;  // nodes in the opposite order
  const int last = mesh.node_count() - 1;
  foreign.nodes = mesh.nodes.rowwise().reverse().eval();
  foreign.triangles = last - mesh.triangles.array();
  write_mesh(path("m.vtu"), foreign);
  const auto back = *read_curved_mesh(path("m.vtu"));
  EXPECT_LT(back.mesh.triangles.topRows(3).maxCoeff(), mesh.vertex_count());
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 10; ++k)
      EXPECT_EQ(back.mesh.nodes.col(back.mesh.triangles(k, t)),
                mesh.nodes.col(mesh.triangles(k, t)));
}

TEST_F(MeshFileTest, reads_what_other_programs_write) {
  const auto obj = plain_mesh(
      write("a.obj",
            "# comment\r\nmtllib x.mtl\r\nv 0 0 0 1\r\nv +1 0 0\r\nv 0 1e0 0\r\nvn 0 0 1\r\n"
            "g part\r\nf 1/1/1 2//1 -1\r\n"));
  EXPECT_EQ(obj.triangles, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(obj.points(0, 1), 1);
  const auto off =
      plain_mesh(write("a.off", "OFF 3 1 0\n0 0 0\n1 0 0\n# here\n\n0 1 0\n3 0 1 2 255 0 0\n"));
  EXPECT_EQ(off.triangles, Eigen::Vector3i(0, 1, 2));
  const auto ply =
      plain_mesh(write("a.ply",
                       "ply\nformat ascii 1.0\ncomment x\nelement vertex 3\nproperty float x\n"
                       "property float y\nproperty float z\nproperty uchar red\nelement face 1\n"
                       "property list uchar uint vertex_index\nproperty float quality\nend_header\n"
                       "0 0 0 9\n1 0 0 9\n0 1 0.1 9\n3 0 1 2 0.5\n"));
  EXPECT_EQ(ply.triangles, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(ply.points(2, 2), 0.1);
  const auto stl =
      plain_mesh(write("a.stl",
                       "solid a b\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                       "vertex 0 1 0.1\nendloop\nendfacet\nendsolid a b\n"));
  EXPECT_EQ(stl.triangles, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(stl.points(2, 2), 0.1);  // text keeps its digits
}

TEST_F(MeshFileTest, reads_ply_of_either_byte_order) {
  std::string big =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty double x\n"
      "property double y\nproperty double z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const auto add = [&](auto value) {
    std::string bytes(sizeof(value), ' ');
    std::memcpy(bytes.data(), &value, sizeof(value));
    big.append(bytes.rbegin(), bytes.rend());
  };
  for (const double x : {0., 0., 0., 1., 0., 0., 0., 1., 1. / 3}) add(x);
  big += char(3);
  for (const int corner : {0, 1, 2}) add(corner);
  const auto ply = plain_mesh(write("b.ply", big));
  EXPECT_EQ(ply.points(2, 2), 1. / 3);
  EXPECT_EQ(ply.triangles, Eigen::Vector3i(0, 1, 2));
}

TEST_F(MeshFileTest, refuses_what_is_none_where_it_is_wrong) {
  const std::vector<std::array<std::string, 3>> wrong{
      {"a.obj", "", ": is empty"},
      {"a.obj", "v 0 0 0\n", ": has no triangles"},
      {"a.obj", "v 0 0\n", ":1: has 3 words, too few"},
      {"a.obj", "v 0 0 x\n", ":1: \"x\": must be a number"},
      {"a.obj", "v 0 0 0\nf 1 2 0\n", ":2: corner \"0\": must be an index, counted from 1"},
      {"a.obj", "v 0 0 0\nf 1 -2 1\n", ":2: corner -2: there are only 1 points before it"},
      {"a.obj", "v 0 0 0\nf 1 1\n", ":2: a face with 2 corners: must have three"},
      {"a.obj", "v 0 0 0\nf 1 2 3\n", ": face 0: corner 2: there are only 1 points"},
      {"a.off", "3 1 0\n", ":1: must begin with OFF"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n",
       ":3: the file ends here, in the middle of the points: 1 of 3"},
      {"a.off", "OFF\n1 1 0\n0 0 0\n3 0 0 1\n", ":4: corner 1: must be in 0 ... 0"},
      {"a.off", "OFF\n-1 1 0\n", ":2: the counts of points and faces must be >= 0"},
      {"a.ply", "solid\n", ":1: must begin with ply"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty vec x\n",
       ":4: \"vec\": unknown type"},
      {"a.stl", "hello", ": is too short for STL"},
      {"a.stl", std::string(200, 'x'), ": has 200 bytes, but 2021161080 triangles of binary STL"},
      {"a.stl", "solid\nfacet\nvertex 0 0 0\nendfacet\n",
       ":4: a facet with 1 corners: must have three"},
      {"a.stl", "solid\n", ":1: the file ends here, without endsolid"},
      {"a.vtu", "hello", ": is no file of VTK: neither XML nor a legacy one"},
      {"a.vtu", "<VTKFile type=\"UnstructuredGrid\">",
       ": is cut off: does not end with </VTKFile>"},
      {"a.vtp", "<VTKFile type=\"Nonsense\"></VTKFile>",
       ": holds \"Nonsense\", not PolyData or UnstructuredGrid"},
      {"a.vtu", "<VTKFile type=\"PolyData\"></VTKFile>", ": is damaged or cut off"},
      {"a.txt", "hello", ": unknown suffix \".txt\"; meshes can be read from .obj, .off, .ply"},
  };
  for (const auto& [name, text, message] : wrong) {
    const std::string said = refusal(name, text);
    EXPECT_TRUE(said.starts_with(message)) << said;
  }
  EXPECT_THROW(read_mesh(path("missing.obj")), InputError);
  EXPECT_THROW(read_mesh("/dev/zero"), InputError);
  EXPECT_THROW(write_mesh(path("a.txt"), example()), InputError);
}

TEST_F(MeshFileTest, refuses_files_that_are_cut_off_anywhere) {
  for (const char* name : {"m.obj", "m.off", "m.ply", "m.stl", "m.vtu"}) {
    write_mesh(path(name), example(),
               {{"order", Eigen::MatrixXd::Ones(1, example().node_count())}});
    const std::string whole = read_file(path(name));
    const bool is_obj = std::string(name) == "m.obj";  // has no count: see the defects
    for (int part = 1; part < 40 && !is_obj; ++part) {
      const std::string said =
          refusal(name, std::string_view(whole).substr(0, whole.size() * part / 40));
      EXPECT_NE(said, "was not refused") << name << ' ' << part;
    }
  }
}

TEST_F(MeshFileTest, refuses_a_million_triangles) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int t = 0; t < 1'000'000; ++t) text += "f 1 2 3\n";
  EXPECT_TRUE(refusal("a.obj", text).starts_with(": has 1000000 triangles, more than 200000"));
}

TEST_F(MeshFileTest, says_when_neighbours_have_different_nodes_on_their_edge) {
  CurvedMesh mesh = example();
  mesh.triangles(4, 7) = mesh.triangles(9, 7);
  const std::string said = refusal("m.vtu", vtu_text(mesh, {}));
  EXPECT_NE(said.find("on an edge is not that of the neighbour"), std::string::npos) << said;
}

}  // namespace
}  // namespace sbeh::studies
