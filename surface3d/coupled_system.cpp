#include "surface3d/coupled_system.h"

#include "surface3d/element_system.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace sbeh::surface3d {

namespace {

// Which unknowns a test function meets. Of two vectors, `componentwise` only the same components.
enum class Coupling { none, componentwise, all };

struct Block {
  int first, size;  // in the numbering of the triangle
  bool vector;      // three components of ten
};
constexpr Block V_block{local::V, 30, true}, p_block{local::p, 6, false}, H_block{local::H, 10, false},
    Y_block{local::Y, 30, true};

// A system's blocks in its own local numbering, with the coupling of each pair (test, unknown).
struct Layout {
  std::vector<Block> blocks;
  std::vector<std::vector<Coupling>> couples;
};

constexpr auto no = Coupling::none, yes = Coupling::all, same = Coupling::componentwise;

Layout flow_layout(Scheme scheme) {
  if (scheme == Scheme::split)
    return {{V_block, p_block, H_block},
            {{yes, yes, yes},    // W
             {yes, no, no},      // q
             {yes, no, yes}}};   // G: (H1) along the normals, Y = τV
  return {{V_block, p_block, H_block, Y_block},
          {{yes, yes, yes, no},     // W
           {yes, no, no, no},       // q
           {yes, no, no, yes},      // G: (Y1)
           {no, no, yes, same}}};   // Z: (H1)
}

Layout motion_layout() {
  return {{H_block, Y_block},
          {{no, yes},     // G: (Y1)
           {yes, same}}}; // Z: (H1)
}

SparsePattern::Mask mask_of(const Layout& layout) {
  int size = 0;
  for (const Block& b : layout.blocks) size += b.size;
  SparsePattern::Mask mask = SparsePattern::Mask::Constant(size, size, false);
  int row = 0;
  for (std::size_t r = 0; r < layout.blocks.size(); row += layout.blocks[r++].size) {
    int column = 0;
    for (std::size_t c = 0; c < layout.blocks.size(); column += layout.blocks[c++].size)
      for (int i = 0; i < layout.blocks[r].size; ++i)
        for (int j = 0; j < layout.blocks[c].size; ++j) {
          const Coupling coupling = layout.couples[r][c];
          mask(row + i, column + j) =
              coupling == yes || (coupling == same && i / 10 == j / 10);
        }
  }
  return mask;
}

// Global numbers: V by nodes, p, H, Y by nodes; those before the first block are left out.
Eigen::MatrixXi unknowns_of(const Triangulation& mesh, const Layout& layout) {
  int size = 0;
  for (const Block& b : layout.blocks) size += b.size;
  Eigen::MatrixXi unknowns(size, mesh.count());
  int row = 0, first = 0;
  for (const Block& b : layout.blocks) {
    for (int e = 0; e < mesh.count(); ++e)
      for (int i = 0; i < b.size; ++i)
        unknowns(row + i, e) = first
                             + (b.vector         ? 3 * mesh.triangles(i % 10, e) + i / 10
                                : b.size == 6 ? mesh.quadratic(i, e)
                                                 : mesh.triangles(i, e));
    row += b.size;
    first += b.vector ? 3 * mesh.nodes : b.size == 6 ? mesh.quadratic_nodes : mesh.nodes;
  }
  return unknowns;
}

int size_of(const Triangulation& mesh, const Layout& layout) {
  int size = 0;
  for (const Block& b : layout.blocks)
    size += b.vector ? 3 * mesh.nodes : b.size == 6 ? mesh.quadratic_nodes : mesh.nodes;
  return size;
}

SparsePattern pattern_of(const Triangulation& mesh, const Layout& layout) {
  return SparsePattern(size_of(mesh, layout), unknowns_of(mesh, layout), mask_of(layout));
}

// The part of an element's system that belongs to a layout.
template <int Size>
struct Part {
  Eigen::Matrix<double, Size, Size> matrix;
  Eigen::Matrix<double, Size, 1> rhs;
};
constexpr int monolithic_size = 76, split_size = 46, motion_size = 40;

void take_monolithic(const ElementSystem& s, Part<monolithic_size>& part) {
  constexpr int pad = 4;  // of the pressure
  constexpr int head = 36, tail = 40;
  part.matrix.topLeftCorner<head, head>() = s.matrix.topLeftCorner<head, head>();
  part.matrix.topRightCorner<head, tail>() = s.matrix.block<head, tail>(0, head + pad);
  part.matrix.bottomLeftCorner<tail, head>() = s.matrix.block<tail, head>(head + pad, 0);
  part.matrix.bottomRightCorner<tail, tail>() = s.matrix.bottomRightCorner<tail, tail>();
  part.rhs << s.rhs.head<head>(), s.rhs.tail<tail>();
}

void take_motion(const ElementSystem& s, Part<motion_size>& part) {
  part.matrix = s.matrix.bottomRightCorner<motion_size, motion_size>();
  part.rhs = s.rhs.tail<motion_size>();
}

// n: node normals of the triangle. A test field Z = φ_a n_a gives the row a.
void take_split(const ElementSystem& s, const ElementNodes& n, double tau, Part<split_size>& part) {
  constexpr int head = 36;
  part.matrix.setZero();
  part.matrix.topLeftCorner<head, head>() = s.matrix.topLeftCorner<head, head>();
  part.matrix.topRightCorner<head, 10>() = s.matrix.block<head, 10>(0, local::H);
  part.rhs.setZero();
  part.rhs.head<head>() = s.rhs.head<head>();
  for (int k = 0; k < 3; ++k) {
    const auto along = n.row(k).transpose().asDiagonal();
    const int Z = local::Y + 10 * k;
    part.matrix.bottomRightCorner<10, 10>() += along * s.matrix.block<10, 10>(Z, local::H);
    part.matrix.block<10, 10>(head, 10 * k) = tau * (along * s.matrix.block<10, 10>(Z, Z));
    part.rhs.tail<10>() += along * s.rhs.segment<10>(Z);
  }
}

void set_zero(const SparsePattern& pattern, LinearSystem& system) {
  if (system.matrix.rows() == 0) system.matrix = pattern.zero();
  std::fill_n(system.matrix.valuePtr(), system.matrix.nonZeros(), 0.);
  system.rhs.setZero(pattern.size());
}

template <int Size>
void add(const SparsePattern& pattern, int e, const Part<Size>& part, LinearSystem& system) {
  pattern.add(e, part.matrix, system.matrix);
  pattern.add(e, part.rhs, system.rhs);
}

}  // namespace

CoupledSystem::CoupledSystem(const Triangulation& mesh, Scheme scheme)
    : scheme_(scheme),
      nodes_(mesh.nodes),
      quadratic_nodes_(mesh.quadratic_nodes),
      flow_pattern_(pattern_of(mesh, flow_layout(scheme))),
      motion_pattern_(scheme == Scheme::split
                          ? pattern_of(mesh, motion_layout())
                          : SparsePattern(0, Eigen::MatrixXi(0, 0), SparsePattern::Mask(0, 0))) {}

void CoupledSystem::assemble(const Triangulation& mesh, const model::Material& material,
                             const State& old, const Curvature& curvature,
                             const StepParameters& step) {
  const bool split = scheme_ == Scheme::split;
  set_zero(flow_pattern_, flow_);
  set_zero(motion_pattern_, motion_);
  normal_flux_.setZero(flow_pattern_.size());
  normal_motion_.resize(std::size_t(split ? mesh.count() : 0));

  struct Piece {
    ElementSystem whole;
    Part<monolithic_size> monolithic;
    Part<split_size> flow;
    Part<motion_size> motion;
  };
  constexpr int chunk = 64;  // in parallel; their sums then go into the matrix one after the other
  std::vector<Piece> pieces(chunk);
  for (int begin = 0; begin < mesh.count(); begin += chunk) {
    const int end = std::min(begin + chunk, mesh.count());
    tbb::parallel_for(begin, end, [&](int e) {
      Piece& piece = pieces[std::size_t(e - begin)];
      assemble_element(material,
                       {.X = on_element(mesh, e, old.X),
                        .normals = on_element(mesh, e, curvature.normals),
                        .beta = on_element(mesh, e, old.beta),
                        .H = on_element(mesh, e, curvature.H)},
                       step, piece.whole);
      if (!split) return take_monolithic(piece.whole, piece.monolithic);
      take_split(piece.whole, on_element(mesh, e, curvature.node_normals), step.tau, piece.flow);
      take_motion(piece.whole, piece.motion);
      normal_motion_[std::size_t(e)] = piece.whole.matrix.block<10, 30>(local::H, local::V);
    });
    for (int e = begin; e < end; ++e) {
      const Piece& piece = pieces[std::size_t(e - begin)];
      if (split) {
        add(flow_pattern_, e, piece.flow, flow_);
        add(motion_pattern_, e, piece.motion, motion_);
      } else {
        add(flow_pattern_, e, piece.monolithic, flow_);
      }
      for (int i = 0; i < 30; ++i)
        normal_flux_[flow_pattern_.unknown(i, e)] += piece.whole.normal_flux[i];
    }
  }
}

Eigen::VectorXd CoupledSystem::minus_normal_motion(const Nodes& V) const {
  Eigen::VectorXd flux = Eigen::VectorXd::Zero(motion_pattern_.size());
  Eigen::Matrix<double, 30, 1> local_V;
  for (int e = 0; e < motion_pattern_.elements(); ++e) {
    for (int i = 0; i < 30; ++i) local_V[i] = V.reshaped()[flow_pattern_.unknown(i, e)];
    const Eigen::Matrix<double, 10, 1> local_flux = normal_motion_[std::size_t(e)] * local_V;
    for (int a = 0; a < 10; ++a) flux[motion_pattern_.unknown(a, e)] += local_flux[a];
  }
  return flux;
}

Nodes CoupledSystem::velocity(const Eigen::VectorXd& flow) const {
  return flow.head(3 * nodes_).reshaped(3, nodes_);
}
Field CoupledSystem::pressure(const Eigen::VectorXd& flow) const {
  return flow.segment(3 * nodes_, quadratic_nodes_);
}
Field CoupledSystem::curvature(const Eigen::VectorXd& flow) const {
  return flow.segment(3 * nodes_ + quadratic_nodes_, nodes_);
}
Nodes CoupledSystem::displacement(const Eigen::VectorXd& solution) const {
  const int first = scheme_ == Scheme::split ? nodes_ : 4 * nodes_ + quadratic_nodes_;
  return solution.segment(first, 3 * nodes_).reshaped(3, nodes_);
}

}  // namespace sbeh::surface3d
