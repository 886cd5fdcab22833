#include "surface3d/system_layout.h"

#include <utility>
#include <vector>

namespace sbeh::surface3d {

const char* name(Scheme scheme) { return scheme == Scheme::split ? "split" : "monolithic"; }

namespace {

enum class Kind { vector, tangent, quadratic, scalar, multiplier };

// A kind of unknown and its test function.
struct Block {
  Kind kind;
  int size;  // in a triangle
};
constexpr Block V_block{Kind::vector, 30}, p_block{Kind::quadratic, 6}, H_block{Kind::scalar, 10},
    Y_block{Kind::vector, 30}, tangential_block{Kind::tangent, 20};

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

Layout flow_layout(Scheme scheme, int multipliers) {
  const Block lambda{Kind::multiplier, multipliers};
  if (scheme == Scheme::split)
    return {{V_block, p_block, H_block, lambda},
            {{yes, yes, yes, yes},  // W
             {yes, no, no, no},     // q
             {yes, no, yes, no},    // G: (H1) along the normals, Y = τV
             {yes, no, no, yes}}};  // (P2)
  return {{V_block, p_block, H_block, Y_block, lambda},
          {{yes, yes, yes, no, yes},  // W
           {yes, no, no, no, no},     // q
           {yes, no, no, yes, no},    // G: (Y1)
           {no, no, yes, same, no},   // Z: (H1)
           {yes, no, no, no, yes}}};  // (P2)
}

// The speeds v along the node normals in the place of V and p; p is the last of the multipliers.
Layout normal_flow_layout(Scheme scheme) {
  const Block v{Kind::scalar, 10}, numbers{Kind::multiplier, 2};
  if (scheme == Scheme::split)
    return {{v, H_block, numbers},
            {{yes, yes, yes},   // W
             {yes, yes, no},    // G: (H1) along the normals, Y = τV
             {yes, no, yes}}};  // (P2), (P1)
  return {{v, H_block, Y_block, numbers},
          {{yes, yes, no, yes},   // W
           {yes, no, yes, no},    // G: (Y1)
           {no, yes, same, no},   // Z: (H1)
           {yes, no, no, yes}}};  // (P2), (P1)
}

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

SparsePattern pattern_of(const Triangulation& mesh, const Layout& layout) {
  Eigen::MatrixXi unknowns(layout.size(), mesh.count());
  int row = 0, first = 0;
  for (const Block& b : layout.blocks) {
    for (int e = 0; e < mesh.count(); ++e)
      for (int i = 0; i < b.size; ++i) unknowns(row + i, e) = first + global_index(mesh, b, e, i);
    row += b.size;
    first += global_size(mesh, b);
  }
  const Block& last = layout.blocks.back();
  return SparsePattern(first, std::move(unknowns), mask_of(layout),
                       last.kind == Kind::multiplier ? last.size : 0);
}

}  // namespace

SparsePattern flow_pattern(const Triangulation& mesh, Scheme scheme, int multipliers) {
  return pattern_of(mesh, flow_layout(scheme, multipliers));
}
SparsePattern normal_flow_pattern(const Triangulation& mesh, Scheme scheme) {
  return pattern_of(mesh, normal_flow_layout(scheme));
}
SparsePattern motion_pattern(const Triangulation& mesh) {
  return pattern_of(mesh, {{tangential_block}, {{yes}}});
}

}  // namespace sbeh::surface3d
