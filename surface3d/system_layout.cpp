#include "surface3d/system_layout.h"

#include <utility>
#include <vector>

namespace sbeh::surface3d {

namespace {

enum class Kind { vector, tangent, quadratic, scalar, multiplier };

// A kind of unknown and its test function; none where the size is 0.
struct Block {
  Kind kind;
  int size;  // in a triangle
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
  if (block.size == 0) return 0;
  switch (block.kind) {
    case Kind::vector:
      return 3 * mesh.nodes;
    case Kind::tangent:
      return 2 * mesh.nodes;
    case Kind::quadratic:
      return mesh.quadratic_nodes;
    case Kind::scalar:
      return mesh.nodes;
    case Kind::multiplier:
      return block.size;
  }
  return 0;
}

int global_index(const Triangulation& mesh, const Block& block, int e, int i) {
  switch (block.kind) {
    case Kind::vector:  // local by components, global by nodes
      return 3 * mesh.triangles(i % 10, e) + i / 10;
    case Kind::tangent:
      return 2 * mesh.triangles(i % 10, e) + i / 10;
    case Kind::quadratic:
      return mesh.quadratic(i, e);
    case Kind::scalar:
      return mesh.triangles(i, e);
    case Kind::multiplier:
      return i;
  }
  return 0;
}

// The pattern, and where each block begins.
struct Numbering {
  SparsePattern pattern;
  std::vector<int> first;
};
Numbering number(const Triangulation& mesh, const Layout& layout) {
  Eigen::MatrixXi unknowns(layout.size(), mesh.count());
  std::vector<int> first{0};
  int row = 0;
  for (const Block& b : layout.blocks) {
    for (int e = 0; e < mesh.count(); ++e)
      for (int i = 0; i < b.size; ++i)
        unknowns(row + i, e) = first.back() + global_index(mesh, b, e, i);
    row += b.size;
    first.push_back(first.back() + global_size(mesh, b));
  }
  const Block& last = layout.blocks.back();
  return {SparsePattern(first.back(), std::move(unknowns), mask_of(layout),
                        last.kind == Kind::multiplier ? last.size : 0),
          std::move(first)};
}

}  // namespace

FlowLayout flow_layout(const Triangulation& mesh, model::AreaConstraint area, bool has_displacement,
                       int multipliers) {
  const bool local = area == model::AreaConstraint::local;
  // Where the displacement is no unknown, G is the test function of (H1) along the normals.
  const Coupling G_H = has_displacement ? no : yes;
  Numbering numbering =
      number(mesh, {{local ? Block{Kind::vector, 30} : Block{Kind::scalar, 10},  // V
                     {Kind::quadratic, local ? 6 : 0},                           // p
                     {Kind::scalar, 10},                                         // H
                     {Kind::vector, has_displacement ? 30 : 0},                  // Y
                     {Kind::multiplier, multipliers}},
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
  return number(mesh, {{{Kind::tangent, 20}}, {{yes}}}).pattern;
}

}  // namespace sbeh::surface3d
