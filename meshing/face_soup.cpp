#include "meshing/face_soup.h"

#include "meshing/near_points.h"
#include "meshing/polygon_cutting.h"

#include <Eigen/Geometry>
#include <boost/pending/disjoint_sets.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace sbeh::meshing {

namespace {

using Triangle = FaceSoup::Triangle;
using Edge = std::array<int, 2>;

bool has_a_corner_twice(const Triangle& t) {
  const auto& c = t.corner;
  return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

std::array<int, 3> sorted(std::array<int, 3> corner) {
  std::sort(corner.begin(), corner.end());
  return corner;
}

std::map<Edge, std::vector<int>> triangles_at_edges(const FaceSoup& soup) {
  std::map<Edge, std::vector<int>> at;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] =
          std::minmax(soup.triangles[t].corner[k], soup.triangles[t].corner[(k + 1) % 3]);
      at[{low, high}].push_back(int(t));
    }
  return at;
}

// "triangle 80", "triangles 80, 81, 85": those of the file.
std::string numbers_of(const std::vector<Triangle>& triangles) {
  constexpr std::size_t most = 5;
  std::vector<int> numbers;
  for (const Triangle& t : triangles)
    if (t.number >= 0) numbers.push_back(t.number);
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  if (numbers.empty()) return {};
  std::string text = numbers.size() == 1 ? "triangle " : "triangles ";
  for (std::size_t i = 0; i < std::min(most, numbers.size()); ++i)
    text += fmt::format("{}{}", i == 0 ? "" : ", ", numbers[i]);
  return text + (numbers.size() > most ? ", ..." : "");
}

template <class Wanted>
void remove_unless(FaceSoup& soup, RepairLog& log, const char* what, const Wanted& wanted) {
  std::vector<Triangle> kept, removed;
  for (const Triangle& t : soup.triangles) (wanted(t) ? kept : removed).push_back(t);
  log.add(removed.size(), what, numbers_of(removed));
  soup.triangles = std::move(kept);
}

// The others must have no triangles.
void keep_points(FaceSoup& soup, const std::vector<bool>& keep) {
  std::vector<int> place(keep.size(), -1), kept;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) {
      place[i] = int(kept.size());
      kept.push_back(int(i));
    }
  for (Triangle& t : soup.triangles)
    for (int& corner : t.corner) corner = place[std::size_t(corner)];
  if (!soup.point_numbers.empty()) {
    std::vector<int> numbers;
    numbers.reserve(kept.size());
    for (const int i : kept) numbers.push_back(soup.point_numbers[std::size_t(i)]);
    soup.point_numbers = numbers;
  }
  soup.points = soup.points(Eigen::all, kept).eval();
}

}  // namespace

void RepairLog::add(std::size_t count, const std::string& what, const std::string& detail) {
  if (count > 0)
    done.push_back(fmt::format("{}: {}{}", what, count, detail.empty() ? "" : ", " + detail));
}

FaceSoup soup_of(const PolygonMesh& mesh, RepairLog& log) {
  FaceSoup soup{mesh.points, mesh.names.points, {}};
  std::size_t cut = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const std::vector<int>& face = mesh.faces[f];
    const int number = f < mesh.names.triangles.size() ? mesh.names.triangles[f] : -1;
    if (face.size() > 3) ++cut;
    for (const auto& corner : cut_into_triangles(mesh.points, face))
      soup.triangles.push_back({corner, number});
  }
  log.add(cut, "faces with more than three corners cut into triangles",
          fmt::format("which makes {} triangles", soup.triangles.size()));
  return soup;
}

TriangleMesh triangle_mesh(const FaceSoup& soup) {
  TriangleMesh mesh{soup.points, Eigen::Matrix3Xi(3, Eigen::Index(soup.triangles.size()))};
  for (int t = 0; t < mesh.triangle_count(); ++t)
    mesh.triangles.col(t) =
        Eigen::Map<const Eigen::Vector3i>(soup.triangles[std::size_t(t)].corner.data());
  return mesh;
}

Names names_of(const FaceSoup& soup) {
  Names names{soup.point_numbers, {}};
  for (const Triangle& t : soup.triangles) names.triangles.push_back(t.number);
  return names;
}

void clean(FaceSoup& soup, RepairLog& log) {
  const NearPoints near = near_points(triangle_mesh(soup));
  for (Triangle& t : soup.triangles)
    for (int& corner : t.corner) corner = near.first[std::size_t(corner)];
  log.add(std::size_t(near.joined), "points joined with others",
          near.farthest > 0 ? fmt::format("at most {:.2g} apart", near.farthest)
                            : "of the same coordinates");
  std::vector<bool> first(near.first.size());
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = near.first[i] == int(i);
  keep_points(soup, first);
  remove_unless(soup, log, "triangles with a corner twice removed",
                [](const Triangle& t) { return !has_a_corner_twice(t); });
  std::map<std::array<int, 3>, int> seen;
  remove_unless(soup, log, "repeated triangles removed",
                [&](const Triangle& t) { return ++seen[sorted(t.corner)] == 1; });
}

void remove_strays(FaceSoup& soup, RepairLog& log) {
  constexpr std::size_t few = 20;  // at most one in so many: more are a surface that is not joined
  const std::size_t all = soup.triangles.size();
  std::vector<Triangle> kept = soup.triangles, removed;
  for (bool changed = true; changed;) {
    changed = false;
    FaceSoup rest{{}, {}, kept};
    const auto at = triangles_at_edges(rest);
    boost::disjoint_sets_with_storage<> patches(kept.size());
    for (const auto& [edge, triangles] : at)
      if (triangles.size() == 2)
        patches.union_set(std::size_t(triangles[0]), std::size_t(triangles[1]));
    std::vector<std::size_t> size(kept.size(), 0);
    for (std::size_t t = 0; t < kept.size(); ++t) ++size[patches.find_set(t)];
    const auto largest = std::size_t(std::ranges::max_element(size) - size.begin());
    std::vector<bool> stray(kept.size(), false);  // by patch
    for (const auto& [edge, triangles] : at)
      if (const auto patch = patches.find_set(std::size_t(triangles[0]));
          triangles.size() == 1 && patch != largest)
        stray[patch] = true;
    std::vector<Triangle> next;
    for (std::size_t t = 0; t < kept.size(); ++t)
      (stray[patches.find_set(t)] ? removed : next).push_back(kept[t]);
    changed = next.size() < kept.size();
    kept = std::move(next);
  }
  if (few * removed.size() > all) return;
  soup.triangles = std::move(kept);
  log.add(removed.size(), "stray triangles removed", numbers_of(removed));
}

void remove_specks(FaceSoup& soup, RepairLog& log) {
  constexpr double small = 0.01;  // part of the area of the largest body
  const std::size_t all = soup.triangles.size();
  boost::disjoint_sets_with_storage<> bodies(all);
  std::vector<bool> at_odd_edge(all, false);
  for (const auto& [edge, triangles] : triangles_at_edges(soup))
    for (const int t : triangles) {
      bodies.union_set(std::size_t(triangles[0]), std::size_t(t));
      if (triangles.size() != 2) at_odd_edge[std::size_t(t)] = true;
    }
  std::vector<double> area(all, 0);
  std::vector<bool> open(all, false);  // by body, as the areas
  for (std::size_t t = 0; t < all; ++t) {
    const Eigen::Matrix3d x = soup.points(Eigen::all, soup.triangles[t].corner);
    const std::size_t body = bodies.find_set(t);
    area[body] += (x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)).norm() / 2;
    if (at_odd_edge[t]) open[body] = true;
  }
  const double largest = all == 0 ? 0 : *std::ranges::max_element(area);
  std::vector<Triangle> kept, removed;
  std::size_t specks = 0;
  for (std::size_t t = 0; t < all; ++t) {
    const std::size_t body = bodies.find_set(t);
    const bool is_speck = !open[body] && area[body] < small * largest;
    specks += is_speck && body == t;
    (is_speck ? removed : kept).push_back(soup.triangles[t]);
  }
  soup.triangles = std::move(kept);
  log.add(specks, "small closed bodies beside the surface removed",
          fmt::format("of less than {} % of its area, {}", 100 * small, numbers_of(removed)));
}

void remove_unused_points(FaceSoup& soup, RepairLog& log) {
  std::vector<bool> used(std::size_t(soup.points.cols()), false);
  for (const Triangle& t : soup.triangles)
    for (const int corner : t.corner) used[std::size_t(corner)] = true;
  log.add(std::size_t(std::ranges::count(used, false)), "unused points removed");
  keep_points(soup, used);
}

}  // namespace sbeh::meshing
