// What is wrong with a user's mesh is told in the file's numbers, and a repair is promised where it helps.
#include "studies/mesh/file_surface.h"

#include "meshing/curving.h"
#include "meshing/icosphere.h"
#include "meshing/measures.h"
#include "studies/mesh/make_mesh.h"
#include "tests/studies/mesh_files/mesh_file_fixture.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace sbeh::studies {
namespace {

namespace fs = std::filesystem;
using Points = std::vector<Eigen::Vector3d>;
using Faces = std::vector<std::vector<int>>;

struct Shape {
  Points points;
  Faces faces;
};

Shape sphere() {
  const meshing::TriangleMesh mesh = meshing::icosphere(4);
  Shape shape;
  for (const auto x : mesh.points.colwise()) shape.points.emplace_back(x);
  for (const auto c : mesh.triangles.colwise()) shape.faces.push_back({c[0], c[1], c[2]});
  return shape;
}

std::string obj(const Shape& shape) {
  std::string text;
  for (const auto& x : shape.points) text += fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
  for (const auto& face : shape.faces) {
    text += 'f';
    for (const int i : face) text += fmt::format(" {}", i + 1);
    text += '\n';
  }
  return text;
}

class FileSurfaceTest : public test::MeshFileTest {
 protected:
  /// What is said after the name of the file; empty: nothing is wrong.
  std::string said(const Shape& shape, bool repair) const {
    const fs::path file = write("a.obj", obj(shape));
    try {
      surface_of_file(file, repair);
      return {};
    } catch (const InputError& error) {
      return std::string(error.what()).substr(file.string().size());
    }
  }
};

bool ends_with_promise(const std::string& text) {
  return text.find("; --repair can mend that: sbeh mesh file ") != std::string::npos;
}

struct Wrong {
  const char* words;  ///< what is said of it begins so
  void (*change)(Shape&);
  bool mendable;
};

const std::vector<Wrong> cases{
    {": face 0 has 4 corners: must be a triangle",
     [](Shape& s) {
       s.faces[0].insert(s.faces[0].begin() + 1, int(s.points.size()));
       s.points.push_back(
           (s.points[std::size_t(s.faces[0][0])] + s.points[std::size_t(s.faces[0][2])]) / 2);
       for (auto& f : s.faces)
         for (std::size_t k = 0; k < 3 && f.size() == 3; ++k)
           if (f[k] == s.faces[0][2] && f[(k + 1) % 3] == s.faces[0][0]) {
             f.insert(f.begin() + long(k) + 1, s.faces[0][1]);
             break;
           }
     },
     true},
    {": edge ", [](Shape& s) { s.faces.pop_back(); }, true},
    {": point ", [](Shape& s) { s.faces.resize(200); }, false},
    {": edge ", [](Shape& s) { std::swap(s.faces[7][0], s.faces[7][1]); }, true},
    {": triangle 0 (points ",
     [](Shape& s) {
       for (auto& f : s.faces) std::swap(f[0], f[1]);
     },
     true},
    {": triangle 320 (points ", [](Shape& s) { s.faces.push_back(s.faces[3]); }, true},
    {": point 162: belongs to no triangle", [](Shape& s) { s.points.emplace_back(3, 3, 3); }, true},
    {": triangle 320 (points ",
     [](Shape& s) {
       const Shape other = sphere();
       const int n = int(s.points.size());
       for (const auto& x : other.points) s.points.emplace_back(x + Eigen::Vector3d(3, 0, 0));
       for (auto f : other.faces) s.faces.push_back({f[0] + n, f[1] + n, f[2] + n});
     },
     false},
    {": triangle 320 (points ",
     [](Shape& s) {
       const Shape other = sphere();
       const int n = int(s.points.size());
       for (const auto& x : other.points)
         s.points.emplace_back(0.05 * x + Eigen::Vector3d(3, 0, 0));
       for (auto f : other.faces) s.faces.push_back({f[0] + n, f[1] + n, f[2] + n});
     },
     true},
    {": triangle ", [](Shape& s) { s.points[0] = Eigen::Vector3d(0, 0, -1.5); }, false},
    {": edge ", [](Shape& s) { s.points[0] = Eigen::Vector3d(0, 0, 1.6); }, false},
    {": point 5 (inf, ", [](Shape& s) { s.points[5][0] = INFINITY; }, false},
};

TEST_F(FileSurfaceTest, promises_a_repair_where_and_only_where_it_helps) {
  EXPECT_EQ(said(sphere(), false), "");
  for (const Wrong& wrong : cases) {
    Shape shape = sphere();
    wrong.change(shape);
    const std::string plainly = said(shape, false), repaired = said(shape, true);
    EXPECT_TRUE(plainly.starts_with(wrong.words)) << plainly;
    EXPECT_EQ(ends_with_promise(plainly), wrong.mendable) << plainly;
    EXPECT_EQ(repaired.empty(), wrong.mendable) << repaired;
  }
}

// Triangles that are nearly flat can be curved no better than flat ones.
TEST_F(FileSurfaceTest, is_promised_a_repair_when_it_cannot_be_curved) {
  for (const double off : {1e-10, 1e-9, 1e-8}) {
    Shape shape = sphere();
    const int middle = int(shape.points.size());
    const std::vector<int> face = shape.faces[0];
    const Eigen::Vector3d& a = shape.points[std::size_t(face[0])];
    const Eigen::Vector3d& b = shape.points[std::size_t(face[1])];
    shape.points.emplace_back((a + b) / 2 + Eigen::Vector3d(off, off, off));
    shape.faces[0] = {face[0], middle, face[2]};
    shape.faces.push_back({middle, face[1], face[2]});
    shape.faces.push_back({face[0], face[1], middle});
    MeshRequest request{.shape = FileShape{write("a.obj", obj(shape)), false}};
    try {
      make_mesh(request);
      ADD_FAILURE() << "was not refused";
    } catch (const InputError& error) {
      EXPECT_TRUE(ends_with_promise(error.what())) << error.what();
    }
    std::get<FileShape>(request.shape).repair = true;
    EXPECT_NO_THROW(make_mesh(request));
  }
}

TEST_F(FileSurfaceTest, names_what_a_repair_leaves_by_the_numbers_of_the_file) {
  Shape shape = sphere();
  shape.faces.insert(shape.faces.begin(), {0, 0, 1});  // goes first: all numbers move by one
  shape.points[0] = Eigen::Vector3d(0, 0, -1.5);
  const std::string text = said(shape, true);
  EXPECT_TRUE(text.starts_with(": triangle 1 (points 0, ")) << text;
  EXPECT_NE(said(shape, false).find("--repair mends that, but not this: triangle 1 (points 0, "),
            std::string::npos);
}

TEST_F(FileSurfaceTest, is_said_to_be_rough_before_it_is_run) {
  const auto notes = [&](double noise, bool stairs) {
    Shape shape;
    const meshing::TriangleMesh mesh = meshing::icosphere(10);
    for (const auto& c : mesh.triangles.colwise()) shape.faces.push_back({c[0], c[1], c[2]});
    int n = 0;
    for (const Eigen::Vector3d x : mesh.points.colwise()) {
      Eigen::Vector3d y = x * (1 + noise * std::cos(2.4 * ++n));
      if (stairs)
        for (double& coordinate : y)
          coordinate = (0.7 * coordinate + 0.3 * std::round(12 * coordinate) / 12);
      shape.points.push_back(y);
    }
    return surface_of_file(write("a.obj", obj(shape)), false).notes;
  };
  EXPECT_TRUE(notes(0, false).empty());
  EXPECT_TRUE(notes(1e-4, false).empty());
  for (const auto& said : {notes(0.01, false), notes(0, true)}) {
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("a.obj: is rough: "), std::string::npos) << said[0];
  }
}

// The outer sides of the voxels of a ball; corners are shared where they are one point.
Shape voxels(int across) {
  Shape shape;
  std::map<std::array<int, 3>, int> points;
  const auto is_inside = [&](const std::array<int, 3>& voxel) {
    double distance = 0;
    for (const int x : voxel) distance += std::pow(x + 0.5, 2);
    return distance < std::pow(across / 2.0, 2);
  };
  const auto point = [&](const std::array<int, 3>& x) {
    const auto [at, is_new] = points.try_emplace(x, int(points.size()));
    if (is_new) shape.points.emplace_back(x[0], x[1], x[2]);
    return at->second;
  };
  const int n = across;
  for (int code = 0; code < 8 * n * n * n; ++code) {
    const std::array voxel{code % (2 * n) - n, code / (2 * n) % (2 * n) - n,
                           code / (4 * n * n) - n};
    if (!is_inside(voxel)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        std::array neighbour = voxel;
        neighbour[axis] += side;
        if (is_inside(neighbour)) continue;
        std::array corner = voxel;
        corner[axis] += side > 0 ? 1 : 0;
        std::vector<int> face;
        for (const auto& [u, v] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
          std::array x = corner;
          x[(axis + 1) % 3] += side > 0 ? u : v;
          x[(axis + 2) % 3] += side > 0 ? v : u;
          face.push_back(point(x));
        }
        shape.faces.push_back({face[0], face[1], face[2]});
        shape.faces.push_back({face[0], face[2], face[3]});
      }
  }
  return shape;
}

TEST_F(FileSurfaceTest, of_voxels_is_told_to_be_smoothed) {
  for (const int across : {6, 9, 14}) {
    const std::string text = said(voxels(across), false);
    EXPECT_NE(text.find("meet at 90 degrees"), std::string::npos) << text;
    EXPECT_NE(text.find("the surface of voxels, say, should be smoothed"), std::string::npos)
        << text;
    EXPECT_EQ(text.find("more triangles"), std::string::npos) << text;
  }
  Shape spike = sphere();
  spike.points[0] *= 2;
  EXPECT_NE(said(spike, false).find("more triangles there would help"), std::string::npos);
}

TEST_F(FileSurfaceTest, has_no_numbers_for_the_points_of_stl) {
  std::string text = "solid\n";
  const Shape shape = sphere();
  for (std::size_t t = 1; t < shape.faces.size(); ++t) {
    text += "facet\n";
    for (const int i : shape.faces[t]) {
      const auto& x = shape.points[std::size_t(i)];
      text += fmt::format("vertex {} {} {}\n", x[0], x[1], x[2]);
    }
    text += "endfacet\n";
  }
  const fs::path file = write("a.stl", text + "endsolid\n");
  try {
    surface_of_file(file, false);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(": the edge from ("), std::string::npos)
        << error.what();
  }
}

// A count that is too small opens the surface: the refusal says that there was more.
TEST_F(FileSurfaceTest, is_refused_with_what_was_left_out_of_it) {
  const meshing::CurvedMesh mesh = meshing::curved(
      meshing::icosphere(4), 1, meshing::Projection([](const Eigen::Vector3d& x) { return x; }));
  const std::string count = "320";
  for (const auto& [name, left_out] :
       {std::pair("a.off", "(a.off: what follows the last of its 317 faces left out)"),
        {"a.ply", "(a.ply: what follows the last of the elements of its header left out)"},
        {"a.stl", "(a.stl: 150 bytes after the last of its 317 triangles left out)"}}) {
    write_mesh(path(name), mesh, {});
    std::string text = read_file(path(name));
    if (path(name).extension() == ".stl")
      text[80] = char(text[80] - 3);  // of 320 = 0x140
    else
      text.replace(text.find(count, text.find("face") + 1), count.size(), "317");
    const fs::path file = write(name, text);
    try {
      surface_of_file(file, false);
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      const std::string told = error.what(), folder = file.parent_path().string() + '/';
      EXPECT_NE(told.find("the surface is open"), std::string::npos) << told;
      EXPECT_TRUE(told.ends_with(fmt::format("({}{}", folder, left_out + 1))) << told;
    }
  }
}

}  // namespace
}  // namespace sbeh::studies
