// STL: triangles without connectivity, text or binary; binary in single precision.
#include "studies/io/errors.h"
#include "studies/mesh_files/bytes.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cstdint>
#include <map>

namespace sbeh::studies {

namespace {

constexpr std::size_t header = 80, record = 50;  // bytes; 4 for the count in between

// Points of equal coordinates are one.
class Merged {
 public:
  int index(const std::array<double, 3>& x) {
    const auto [place, is_new] = indices_.try_emplace(x, int(mesh.point_count()));
    if (is_new) mesh.add_point(x[0], x[1], x[2]);
    return place->second;
  }
  MeshBuilder mesh;

 private:
  std::map<std::array<double, 3>, int> indices_;
};

meshing::TriangleMesh parse_text(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  Merged merged;
  std::vector<int> corners;
  bool ended = false;
  while (lines.next()) {
    const std::string_view word = lines.words()[0];
    if (word == "facet") {
      corners.clear();
    } else if (word == "vertex") {
      const std::array<double, 3> x{lines.number(1), lines.number(2), lines.number(3)};
      if (!(x == x)) lines.fail("a coordinate is no number");
      corners.push_back(merged.index(x));
    } else if (word == "endfacet") {
      if (corners.size() != 3)
        lines.fail(fmt::format("a facet with {} corners: must be a triangle", corners.size()));
      merged.mesh.add_triangle(corners[0], corners[1], corners[2]);
    } else if (word == "endsolid") {
      ended = true;
    } else if (word != "solid" && word != "outer" && word != "endloop") {
      lines.fail(fmt::format("\"{}\": is not STL", word.substr(0, 40)));
    }
  }
  if (!ended) lines.fail("the file ends here, without endsolid");
  return merged.mesh.mesh();
}

}  // namespace

meshing::TriangleMesh parse_stl(std::string_view text, const std::string& file) {
  const bool has_count = text.size() >= header + 4;
  const std::size_t count = has_count ? number_from<std::uint32_t>(text.substr(header)) : 0;
  const bool fits = has_count && text.size() == header + 4 + record * count;
  if (!fits && text.starts_with("solid")) return parse_text(text, file);
  if (!fits)
    throw InputError(
        has_count ? fmt::format("{}: has {} bytes, but {} triangles of binary STL take {}: cut off "
                                "or not STL",
                                file, text.size(), count, header + 4 + record * count)
                  : fmt::format("{}: is too short for STL", file));
  Merged merged;
  for (std::size_t t = 0; t < count; ++t) {
    std::array<int, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<double, 3> x{};
      for (std::size_t i = 0; i < 3; ++i)
        x[i] = number_from<float>(text.substr(header + 4 + record * t + 12 + 12 * k + 4 * i));
      if (!(x == x))
        throw InputError(fmt::format("{}: triangle {}: a coordinate is no number", file, t));
      corner[k] = merged.index(x);
    }
    merged.mesh.add_triangle(corner[0], corner[1], corner[2]);
  }
  return merged.mesh.mesh();
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
