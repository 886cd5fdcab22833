// One tetrahedron in the many ways in which programs write it.
#include "tests/studies/mesh_files/tetrahedron.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace sbeh::studies {
namespace {

namespace fs = std::filesystem;
using test::expect_a_tetrahedron;
using test::replaced;
using MeshDialects = test::MeshFileTest;

TEST_F(MeshDialects, reads_off_with_whatever_a_point_has_besides) {
  const std::string faces = "3 0 2 1\n3 0 1 3 0.5 0 0\n3 0 3 2\n3 1 2 3\n";
  const auto points = [](std::string_view besides) {
    std::string text;
    for (const char* x : {"0 0 0", "1 0 0", "0 1 0", "0 0 1"})
      text += x + std::string(besides) + '\n';
    return text;
  };
  for (const auto& [header, besides] :
       std::vector<std::pair<std::string, std::string>>{{"OFF", ""},
                                                        {"off", ""},
                                                        {"OFF", " 9 9 9"},
                                                        {"NOFF", " 0 0 1"},
                                                        {"COFF", " 255 0 0"},
                                                        {"COFF", " 1 0 0 1"},
                                                        {"STOFF", " 0.5 0.5"},
                                                        {"CNOFF", " 0 0 1 1 0 0 1"},
                                                        {"STCNOFF", " 0 0 1 1 0 0 1 0.5 0.5"},
                                                        {"NCSTOFF", " 0 0 1 1 0 0 1 0.5 0.5"}}) {
    const std::string body = points(besides) + faces;
    expect_a_tetrahedron(write("a.off", fmt::format("{}\n4 4 6\n{}", header, body)));
    expect_a_tetrahedron(write("b.off", fmt::format("# by\n{} 4 4 6 # counts\n{}", header, body)));
    expect_a_tetrahedron(write("c.off", fmt::format("{}\n4\n4 6\n\n{}", header, body)));
    if (header == "OFF" || besides.ends_with(" 1") || besides.ends_with("0 1 0.5 0.5")) continue;
    // Every word on a line of its own: where the header tells how many there are.
    expect_a_tetrahedron(write("d.off", header + "\n4 4 6\n"
                                            + replaced(points(besides), " ", "\n  ")
                                            + "3 0 2 1\n3\n0 1\n3\n3 0 3\n2\n3 1 2 3\n"));
  }
  const std::string whole = "OFF\n4 4 6\n" + points("") + faces;
  EXPECT_TRUE(read_mesh(write("a.off", whole + "# the end\n")).notes.empty());
  EXPECT_NE(read_mesh(write("a.off", whole + "3 0 1 2\n"))
                .notes.at(0)
                .find("what follows the last of its 4 faces left out"),
            std::string::npos);
  for (const char* header : {"4OFF", "nOFF", "ST4OFF"})
    EXPECT_TRUE(refusal("a.off", std::string(header) + "\n4 4 6\n")
                    .starts_with(":1: points with another number of coordinates than three"));
  EXPECT_TRUE(refusal("a.off", "OFF BINARY\n").starts_with(":1: binary OFF cannot be read"));
  EXPECT_TRUE(refusal("a.off", "XOFF\n").starts_with(":1: must begin with OFF"));
}

TEST_F(MeshDialects, reads_ply_with_its_elements_in_any_order) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n",
                    faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n", edges = "0 1 255\n1 2 0\n",
                    point =
                        "element vertex 4\nproperty double x\nproperty double y\n"
                        "property double z\n",
                    face = "element face 4\nproperty list uchar int vertex_indices\n",
                    edge =
                        "element edge 2\nproperty int vertex1\nproperty int vertex2\n"
                        "property uchar red\n",
                    empty = "element mesh_edge 7\n";
  const auto ply = [&](const std::string& header, const std::string& body) {
    return write("a.ply", "ply\nformat ascii 1.0\ncomment #1\n" + header + "end_header\n" + body);
  };
  EXPECT_NE(read_mesh(ply(point + face, points + faces + "3 0 1 2\n"))
                .notes.at(0)
                .find("what follows the last of the elements of its header left out"),
            std::string::npos);
  EXPECT_TRUE(read_mesh(ply(point + face, points + faces + "\n")).notes.empty());
  expect_a_tetrahedron(ply(point + face, points + faces));
  expect_a_tetrahedron(ply(face + point, faces + points));
  expect_a_tetrahedron(ply(edge + face + empty + point, edges + faces + points));
  expect_a_tetrahedron(ply(point + empty + edge + face, points + edges + faces));
  expect_a_tetrahedron(ply(replaced(point + face, "vertex_indices", "corners"), points + faces));
  expect_a_tetrahedron(
      ply(replaced(point, "vertex", "vertices") + replaced(face, "face", "faces"), points + faces));
  expect_a_tetrahedron(
      ply("element vertex 4\nproperty float nx\nproperty double X\nproperty double Y\n"
          "property double Z\nproperty list uchar int more\nelement face 4\nproperty uchar flags\n"
          "property list uchar int vertex_index\nproperty list uchar float uv\n",
          "9 0 0 0 2 5 6\n9 1 0 0 0\n9 0 1 0 1 3\n9 0 0 1 2 1 1\n"
          "7 3 0 2 1 0\n7 3 0 1 3 2 .5 .5\n7 3 0 3 2 1 .5\n7 3 1 2 3 0\n"));
  expect_a_tetrahedron(ply(point + "element tristrips 1\nproperty list int int vertex_indices\n",
                           points + "9 0 2 1 3 0 2 -1 -1 -1\n"));
  EXPECT_TRUE(refusal("a.ply",
                      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
                      "property double y\nend_header\n"
                          + points)
                  .starts_with(":6: the points must have one property z"));
  EXPECT_TRUE(refusal("a.ply", "ply\nformat ascii 1.0\n" + point
                                   + "element face 1\nproperty int material\nend_header\n" + points
                                   + "0\n")
                  .starts_with(":9: face: must have a list vertex_indices"));
}

TEST_F(MeshDialects, reads_the_dialects_of_stl) {
  std::string text = "solid part #1\n";
  std::string binary(80, ' ');
  const auto add = [&](auto value) {
    binary.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  add(std::uint32_t(4));
  const std::array<std::array<int, 3>, 4> points{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    text += "  facet normal nan nan nan\n    outer loop\n";
    for (int k = 0; k < 3; ++k) add(0.f);
    for (const int i : face) {
      const auto& x = points[std::size_t(i)];
      text += fmt::format("      vertex {} {} {}\n", x[0], x[1], x[2]);
      for (const int c : x) add(float(c));
    }
    text += "    endloop\n  endfacet\n";
    add(std::uint16_t(7));
  }
  text += "endsolid part #1\n";
  std::string capitals = text;
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return char(std::toupper(c)); });
  for (const std::string& dialect :
       {text, capitals, "\n  " + text, replaced(text, "end", "end "), replaced(text, "\n", "\r\n"),
        replaced(text, "\n", "\r"), "\xef\xbb\xbf" + text, text + "\n\n", text + "\x1a"})
    expect_a_tetrahedron(write("a.stl", dialect));
  std::string named = binary, uncounted = binary;
  named.replace(0, 10, "solid part");
  uncounted.replace(80, 4, std::string(4, '\0'));
  for (const std::string& dialect : {binary, named, binary + "trailing", uncounted})
    expect_a_tetrahedron(write("a.stl", dialect));
  EXPECT_TRUE(read_mesh(write("a.stl", binary)).notes.empty());
  EXPECT_NE(read_mesh(write("a.stl", binary + "trailing")).notes.at(0).find("8 bytes"),
            std::string::npos);
  EXPECT_NE(read_mesh(write("a.stl", uncounted)).notes.at(0).find("holds 4"), std::string::npos);
  EXPECT_TRUE(refusal("a.stl", named.substr(0, 200)).starts_with(": has 200 bytes, but 4 tri"));
  EXPECT_TRUE(refusal("a.stl", replaced(text, "endsolid", "")).starts_with(":"));
  EXPECT_TRUE(refusal("a.stl", replaced(replaced(text, " #1", ""), "\n", " "))
                  .starts_with(":1: all in one line: "));
}

TEST_F(MeshDialects, says_what_else_a_file_of_that_name_holds) {
  using namespace std::string_view_literals;
  for (const char* name : {"a.obj", "a.off", "a.ply", "a.stl", "a.vtk", "a.vtp", "a.vtu"}) {
    for (const std::string_view wide :
         {"\xff\xfev\0 \0"sv, "\xfe\xff\0v\0 "sv, "\xff\xfe\0\0v\0\0\0"sv, "\0\0\xfe\xff\0\0\0v"sv})
      EXPECT_TRUE(refusal(name, wide).starts_with(": is text of two or four bytes a letter"));
    for (const std::string_view packed : {"\x1f\x8b\x08\0abc"sv, "PK\x03\x04\x14"sv, "BZh91AY"sv,
                                          "\xfd"
                                          "7zXZ\0"sv,
                                          "7z\xbc\xaf\x27\x1c"sv, "\x28\xb5\x2f\xfd\x24"sv})
      EXPECT_EQ(refusal(name, packed), ": is packed: unpack it first");
    EXPECT_TRUE(refusal(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n")
                    .starts_with(": is a pointer of Git LFS, not the file itself"));
  }
}

TEST_F(MeshDialects, reads_texts_of_all_systems) {
  const std::string
      off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3",
      obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4";
  for (const auto& [name, text] : {std::pair("a.off", off), {"a.obj", obj}})
    for (const std::string& variant :
         {text, text + "\n", replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"),
          "\xef\xbb\xbf" + text, replaced(text, " ", "\t "), replaced(text, "\n", " # x\n\n"),
          text + "\n\x1a"})
      expect_a_tetrahedron(write(name, variant));
  // A line that goes on, faces before their points, points and lines beside.
  expect_a_tetrahedron(write("b.obj", replaced(obj, "f 1 3 2", "f 1 \\\n3 2\nl 1 2\np 3")));
  expect_a_tetrahedron(
      write("b.obj", obj.substr(obj.find('f')) + '\n' + obj.substr(0, obj.find('f'))));
  EXPECT_NE(read_mesh(write("b.obj", obj + "\nl 1 2\np 3\n")).notes.at(0).find("2 points or lines"),
            std::string::npos);
}

}  // namespace
}  // namespace sbeh::studies
