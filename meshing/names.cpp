#include "meshing/names.h"

#include <fmt/format.h>

#include <numeric>

namespace sbeh::meshing {

namespace {

constexpr int none = -1;

int number(const std::vector<int>& numbers, int index) {
  return std::size_t(index) < numbers.size() ? numbers[std::size_t(index)] : none;
}

std::string place(const Eigen::Vector3d& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", x[0], x[1], x[2]);
}

std::string middle_of(const TriangleMesh& mesh, int triangle) {
  return place(mesh.points(Eigen::all, mesh.triangles.col(triangle)).rowwise().mean());
}

}  // namespace

std::vector<int> counted(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

Names own_numbers(const TriangleMesh& mesh) {
  return {counted(mesh.point_count()), counted(mesh.triangle_count())};
}

std::string point_name(const TriangleMesh& mesh, int point, const Names& names) {
  const int known = number(names.points, point);
  return known == none ? "the point " + place(mesh.points.col(point))
                       : fmt::format("point {}", known);
}

std::string edge_name(const TriangleMesh& mesh, int from, int to, const Names& names) {
  const int a = number(names.points, from), b = number(names.points, to);
  if (a != none && b != none) return fmt::format("edge {}-{}", a, b);
  return fmt::format("the edge from {} to {}", place(mesh.points.col(from)),
                     place(mesh.points.col(to)));
}

std::string triangle_name(const TriangleMesh& mesh, int triangle, const Names& names) {
  const int known = number(names.triangles, triangle);
  return known == none ? "the triangle at " + middle_of(mesh, triangle)
                       : fmt::format("triangle {}", known);
}

std::string whole_triangle_name(const TriangleMesh& mesh, int triangle, const Names& names) {
  std::string name = triangle_name(mesh, triangle, names);
  const auto c = mesh.triangles.col(triangle);
  const int a = number(names.points, c[0]), b = number(names.points, c[1]),
            d = number(names.points, c[2]);
  if (number(names.triangles, triangle) == none) return name;
  if (a == none || b == none || d == none)
    return fmt::format("{} at {}", name, middle_of(mesh, triangle));
  return fmt::format("{} (points {}, {}, {})", name, a, b, d);
}

}  // namespace sbeh::meshing
