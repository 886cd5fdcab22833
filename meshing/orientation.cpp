#include "meshing/orientation.h"

#include <algorithm>
#include <array>
#include <map>

namespace sbeh::meshing {

namespace {

struct Neighbour {
  int triangle;
  bool agrees;
};

std::vector<std::vector<Neighbour>> neighbours_of(const TriangleMesh& mesh) {
  struct Side {
    int triangle;
    bool upwards;
  };
  std::map<std::array<int, 2>, std::vector<Side>> at_edge;
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles(k, t), b = mesh.triangles((k + 1) % 3, t);
      at_edge[{std::min(a, b), std::max(a, b)}].push_back({t, a < b});
    }
  std::vector<std::vector<Neighbour>> neighbours(std::size_t(mesh.triangle_count()));
  for (const auto& [edge, sides] : at_edge) {
    if (sides.size() != 2) continue;
    const bool agree = sides[0].upwards != sides[1].upwards;
    neighbours[std::size_t(sides[0].triangle)].push_back({sides[1].triangle, agree});
    neighbours[std::size_t(sides[1].triangle)].push_back({sides[0].triangle, agree});
  }
  return neighbours;
}

}  // namespace

std::vector<int> turned_triangles(const TriangleMesh& mesh) {
  const auto neighbours = neighbours_of(mesh);
  enum class Side { unknown, as_first, turned };
  std::vector<Side> side(neighbours.size(), Side::unknown);
  std::vector<int> result;
  for (int first = 0; first < mesh.triangle_count(); ++first) {
    if (side[std::size_t(first)] != Side::unknown) continue;
    side[std::size_t(first)] = Side::as_first;
    std::vector<int> piece{first}, turned;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Side here = side[std::size_t(piece[i])];
      if (here == Side::turned) turned.push_back(piece[i]);
      const Side other = here == Side::turned ? Side::as_first : Side::turned;
      for (const Neighbour& n : neighbours[std::size_t(piece[i])]) {
        if (side[std::size_t(n.triangle)] != Side::unknown) continue;
        side[std::size_t(n.triangle)] = n.agrees ? here : other;
        piece.push_back(n.triangle);
      }
    }
    if (2 * turned.size() > piece.size())
      std::erase_if(piece, [&](int t) { return side[std::size_t(t)] == Side::turned; });
    else
      piece = std::move(turned);
    result.insert(result.end(), piece.begin(), piece.end());
  }
  return result;
}

}  // namespace sbeh::meshing
