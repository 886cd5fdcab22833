#include "surface3d/system_layout.h"

#include <utility>
#include <vector>

namespace sbeh::surface3d {

namespace {

// A kind of unknown and its test function; none where the size is 0.
struct Block {
  int size;                // in a triangle
  int components;          // at each node; 0: multipliers, the same in all triangles
  bool quadratic = false;  // at the nodes of P2, not P3
};

// Which entries of a block (test, unknown) there are; of two vectors, `same` those of equal component.
enum class Coupling { none, same, all };
constexpr auto no = Coupling::none, same = Coupling::same, yes = Coupling::all;

struct Layout {
  std::vector<Block> blocks;
  std::vector<std::vector<Coupling>> couples;
  int size() const {
    int sum = 0;
    for (const Block& b : blocks) sum += b.size;
    return sum;
  }
};

SparsePattern::Mask mask_of(const Layout& layout) {
  SparsePattern::Mask mask = SparsePattern::Mask::Constant(layout.size(), layout.size(), false);
  int row = 0;
  for (std::size_t r = 0; r < layout.blocks.size(); row += layout.blocks[r++].size) {
    int column = 0;
    for (std::size_t c = 0; c < layout.blocks.size(); column += layout.blocks[c++].size)
      for (int i = 0; i < layout.blocks[r].size; ++i)
        for (int j = 0; j < layout.blocks[c].size; ++j)
          mask(row + i, column + j) =
              layout.couples[r][c] == yes || (layout.couples[r][c] == same && i / 10 == j / 10);
  }
  return mask;
}

int global_size(const Triangulation& mesh, const Block& block) {
  if (block.size == 0 || block.components == 0) return block.size;
  return block.components * (block.quadratic ? mesh.quadratic_nodes : mesh.nodes);
}

// Local by components, global by nodes.
int global_index(const Triangulation& mesh, const Block& block, int e, int i) {
  if (block.components == 0) return i;
  if (block.quadratic) return mesh.quadratic(i, e);
  return block.components * mesh.triangles(i % 10, e) + i / 10;
}

// The pattern, and where each block begins.
struct Numbering {
  SparsePattern pattern;
  std::vector<int> first;
};
Numbering number(const Triangulation& mesh, const Layout& layout) {
  const int elements = int(mesh.own.size());
  Eigen::MatrixXi unknowns(layout.size(), elements);
  std::vector<int> first{0};
  int row = 0;
  for (const Block& b : layout.blocks) {
    for (int k = 0; k < elements; ++k)
      for (int i = 0; i < b.size; ++i)
        unknowns(row + i, k) = first.back() + global_index(mesh, b, mesh.own[std::size_t(k)], i);
    row += b.size;
    first.push_back(first.back() + global_size(mesh, b));
  }
  const Block& last = layout.blocks.back();
  return {SparsePattern(first.back(), std::move(unknowns), mask_of(layout),
                        last.components == 0 ? last.size : 0, mesh.place),
          std::move(first)};
}

}  // namespace

FlowLayout flow_layout(const Triangulation& mesh, model::AreaConstraint area, bool has_displacement,
                       int multipliers) {
  const bool local = area == model::AreaConstraint::local;
  // Where the displacement is no unknown, G is the test function of (H1) along the normals.
  const Coupling G_H = has_displacement ? no : yes;
  Numbering numbering = number(mesh, {{local ? Block{30, 3} : Block{10, 1},  // V
                                       {local ? 6 : 0, 1, true},             // p
                                       {10, 1},                              // H
                                       {has_displacement ? 30 : 0, 3},       // Y
                                       {multipliers, 0}},
                                      {{yes, yes, yes, no, yes},   // W
                                       {yes, no, no, no, no},      // q
                                       {yes, no, G_H, yes, no},    // G: (Y1)
                                       {no, no, yes, same, no},    // Z: (H1)
                                       {yes, no, no, no, yes}}});  // (P2) and the like
  const std::vector<int>& first = numbering.first;
  return {.pattern = std::move(numbering.pattern),
          .p = first[1],
          .H = first[2],
          .Y = first[3],
          .lambda = first[4]};
}

SparsePattern motion_pattern(const Triangulation& mesh) {
  return number(mesh, {{{20, 2}}, {{yes}}}).pattern;
}

}  // namespace sbeh::surface3d
