#include "surface3d/coupled_system.h"

#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <array>

namespace sbeh::surface3d {

const char* name(Scheme scheme) { return scheme == Scheme::split ? "split" : "monolithic"; }

namespace {

enum class Kind { vector, quadratic, scalar, multiplier };

// A kind of unknown and its test function; `first` in the numbering of the triangle.
struct Block {
  Kind kind;
  int first, size;
};
constexpr Block V_block{Kind::vector, local::V, 30}, p_block{Kind::quadratic, local::p, 6},
    H_block{Kind::scalar, local::H, 10}, Y_block{Kind::vector, local::Y, 30};

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
  const Block lambda{Kind::multiplier, 0, multipliers};
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
  const Block v{Kind::scalar, 0, 10}, numbers{Kind::multiplier, 0, 2};
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

Layout motion_layout() {
  return {{H_block, Y_block},
          {{no, yes},      // G: (Y1)
           {yes, same}}};  // Z: (H1)
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
  return SparsePattern(first, std::move(unknowns), mask_of(layout));
}

SparsePattern no_pattern() {
  return SparsePattern(0, Eigen::MatrixXi(0, 0), SparsePattern::Mask(0, 0));
}

void set_zero(const SparsePattern& pattern, LinearSystem& system) {
  if (system.matrix.rows() == 0) system.matrix = pattern.zero();
  std::fill_n(system.matrix.valuePtr(), system.matrix.nonZeros(), 0.);
  system.rhs.setZero(pattern.size());
}

// V, p: the unknowns before the padding of the pressure.
constexpr int head = 36, motion_size = 40;

// T: unknowns of the whole flow of an element by those of the flow along the normals n,
// V = Σ v_a φ_a n_a and p a number; the rest, of which λ is the last, stays as it is.
Eigen::MatrixXd normal_motion(const ElementNodes& n, int whole) {
  constexpr int speeds = 10;
  const int rest = whole - head;
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(whole, speeds + rest + 1);
  for (int k = 0; k < 3; ++k) T.block<10, 10>(10 * k, 0) = n.row(k).asDiagonal();
  T.block(head, speeds, rest, rest).setIdentity();
  T.block<head - local::p, 1>(local::p, speeds + rest).setOnes();
  return T;
}

// The mesh goes to its equilibrium at a finite rate: of the residual of (H1) on the old surface, which is
// zero along the normals, the share θ only.
void slow_down_mesh(const ElementField& H, double tau, ElementSystem& s) {
  const double theta = tau / (tau + mesh_relaxation_time);
  s.rhs.tail<30>() =
      theta * s.rhs.tail<30>() + (1 - theta) * s.matrix.block<30, 10>(local::Y, local::H) * H;
}

// Where the normals of the old surface X are met by a displacement from X to `from` along them.
ElementNodes foot_points(const ElementNodes& X, const ElementNodes& from, const ElementNodes& n) {
  return X + n * n.cwiseProduct(from - X).colwise().sum().asDiagonal();
}

// Computes the pieces of all elements in parallel, and adds them one after the other in their order.
template <class Piece, class Compute, class Add>
void add_in_order(int elements, Compute&& compute, Add&& add) {
  constexpr int chunk = 16, in_flight = 8;
  const int chunks = (elements + chunk - 1) / chunk;
  std::vector<std::array<Piece, chunk>> pieces(in_flight);  // of chunk k at k mod in_flight
  const auto visit = [&](int k, auto&& work) {
    auto& places = pieces[std::size_t(k % in_flight)];
    for (int e = k * chunk; e < std::min((k + 1) * chunk, elements); ++e)
      work(e, places[std::size_t(e % chunk)]);
  };
  int next = 0;
  using tbb::filter_mode;
  tbb::parallel_pipeline(
      in_flight,
      tbb::make_filter<void, int>(filter_mode::serial_in_order, [&](tbb::flow_control& control) {
        if (next == chunks) control.stop();
        return next < chunks ? next++ : next;
      }) & tbb::make_filter<int, int>(filter_mode::parallel, [&](int k) {
        return visit(k, compute), k;
      }) & tbb::make_filter<int, void>(filter_mode::serial_in_order, [&](int k) {
        visit(k, add);
      }));
}

}  // namespace

// What of an element's system goes into the global ones.
struct CoupledSystem::Piece {
  Eigen::MatrixXd flow;
  Eigen::VectorXd flow_rhs;
  Eigen::Matrix<double, motion_size, motion_size> motion;
  Eigen::Matrix<double, motion_size, 1> motion_rhs;
};

CoupledSystem::CoupledSystem(const Triangulation& mesh, const model::Material& material,
                             Scheme scheme, model::AreaConstraint area)
    : material_(material),
      scheme_(scheme),
      area_(area),
      nodes_(mesh.nodes),
      quadratic_nodes_(mesh.quadratic_nodes),
      multipliers_(material.friction_tangential == 0 && material.friction_normal == 0 ? 7 : 1),
      flow_pattern_(pattern_of(
          mesh, along_normals() ? normal_flow_layout(scheme) : flow_layout(scheme, multipliers_))),
      motion_pattern_(scheme == Scheme::split ? pattern_of(mesh, motion_layout()) : no_pattern()) {}

// n: node normals of the triangle. A test field Z = φ_a n_a gives the row a of G.
void CoupledSystem::cut(const ElementNodes& n, const ElementNodes& foot, double tau,
                        bool keep_volume, const ElementSystem& element, Piece& piece) const {
  const auto& [A, rhs, constraints] = element;
  const int size = head + (scheme_ == Scheme::split ? 10 : motion_size);
  piece.flow.setZero(size + multipliers_, size + multipliers_);
  piece.flow_rhs.setZero(size + multipliers_);
  piece.flow.topLeftCorner<head, head>() = A.topLeftCorner<head, head>();
  piece.flow_rhs.head<head>() = rhs.head<head>();

  piece.flow.topRightCorner(30, multipliers_) = constraints.leftCols(multipliers_);
  piece.flow.bottomLeftCorner(multipliers_, 30) = constraints.leftCols(multipliers_).transpose();
  if (!keep_volume) {  // λ = 0, once for each triangle
    piece.flow.col(size).setZero();
    piece.flow.row(size).setZero();
    piece.flow(size, size) = 1;
  }
  if (scheme_ == Scheme::monolithic) {
    piece.flow.block<head, motion_size>(0, head) = A.block<head, motion_size>(0, local::H);
    piece.flow.block<motion_size, head>(head, 0) = A.block<motion_size, head>(local::H, 0);
    piece.flow.block<motion_size, motion_size>(head, head) =
        A.bottomRightCorner<motion_size, motion_size>();
    piece.flow_rhs.segment<motion_size>(head) = rhs.tail<motion_size>();
    return;
  }
  piece.flow.block<head, 10>(0, head) = A.block<head, 10>(0, local::H);
  Eigen::Matrix<double, 10, 10> stiffness = Eigen::Matrix<double, 10, 10>::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto along = n.row(k).transpose().asDiagonal();
    const int Z = local::Y + 10 * k;
    piece.flow.block<10, 10>(head, head) += along * A.block<10, 10>(Z, local::H);
    stiffness += along * A.block<10, 10>(Z, Z) * along;
    piece.flow_rhs.segment<10>(head) -= along * A.block<10, 10>(Z, Z) * foot.row(k).transpose();
  }
  for (int k = 0; k < 3; ++k)
    piece.flow.block<10, 10>(head, 10 * k) = tau * stiffness * n.row(k).transpose().asDiagonal();
  piece.motion = A.bottomRightCorner<motion_size, motion_size>();
  piece.motion_rhs = rhs.tail<motion_size>();
}

void CoupledSystem::assemble(const Triangulation& mesh, const State& old,
                             const Curvature& curvature, const Origin& from, double tau,
                             const Constraints& constraints) {
  const bool split = scheme_ == Scheme::split;
  set_zero(flow_pattern_, flow_);
  set_zero(motion_pattern_, motion_);
  normal_motion_.resize(std::size_t(split ? mesh.count() : 0));
  normals_ = curvature.node_normals;
  const StepParameters step{.tau = tau, .area_rate = constraints.area_rate, .area = area_};

  const auto compute = [&](int e, Piece& piece) {
    static thread_local ElementSystem element;
    const ElementNodes old_X = on_element(mesh, e, old.X), origin = on_element(mesh, e, from.X);
    assemble_element(material_,
                     {.X = old_X,
                      .from = origin,
                      .normals = on_element(mesh, e, curvature.normals),
                      .beta = on_element(mesh, e, old.beta),
                      .H = on_element(mesh, e, curvature.H)},
                     step, element);
    slow_down_mesh(on_element(mesh, e, from.H), tau, element);
    const ElementNodes n = on_element(mesh, e, normals_);
    cut(n, foot_points(old_X, origin, n), tau, constraints.keep_volume, element, piece);
    if (along_normals()) {
      const Eigen::MatrixXd T = normal_motion(n, int(piece.flow.rows()));
      piece.flow = (T.transpose() * piece.flow * T).eval();
      piece.flow_rhs = (T.transpose() * piece.flow_rhs).eval();
    }
    if (split) normal_motion_[std::size_t(e)] = -element.matrix.block<10, 30>(local::H, local::V);
  };
  const auto add = [&](int e, const Piece& piece) {
    flow_pattern_.add(e, piece.flow, flow_.matrix);
    flow_pattern_.add(e, piece.flow_rhs, flow_.rhs);
    if (!split) return;
    motion_pattern_.add(e, piece.motion, motion_.matrix);
    motion_pattern_.add(e, piece.motion_rhs, motion_.rhs);
  };
  add_in_order<Piece>(mesh.count(), compute, add);
  flow_.rhs[first_multiplier()] = constraints.keep_volume ? constraints.volume_rate : 0;
}

void CoupledSystem::add_normal_motion(const Nodes& V, Eigen::VectorXd& rhs) const {
  Eigen::Matrix<double, 30, 1> local_V;
  for (int e = 0; e < motion_pattern_.elements(); ++e) {
    for (int i = 0; i < 30; ++i) local_V[i] = V(i / 10, motion_pattern_.unknown(i % 10, e));
    const Eigen::Matrix<double, 10, 1> flux = normal_motion_[std::size_t(e)] * local_V;
    for (int a = 0; a < 10; ++a) rhs[motion_pattern_.unknown(a, e)] += flux[a];
  }
}

int CoupledSystem::first_curvature() const {
  return along_normals() ? nodes_ : 3 * nodes_ + quadratic_nodes_;
}
int CoupledSystem::first_displacement() const {
  return scheme_ == Scheme::split ? nodes_ : first_curvature() + nodes_;
}
int CoupledSystem::first_multiplier() const {
  return flow_pattern_.size() - (along_normals() ? 2 : multipliers_);
}
Nodes CoupledSystem::velocity(const Eigen::VectorXd& flow) const {
  if (along_normals()) return normals_ * flow.head(nodes_).asDiagonal();
  return flow.head(3 * nodes_).reshaped(3, nodes_);
}
Field CoupledSystem::pressure(const Eigen::VectorXd& flow) const {
  if (along_normals()) return Field::Constant(quadratic_nodes_, flow[flow.size() - 1]);
  return flow.segment(3 * nodes_, quadratic_nodes_);
}
Field CoupledSystem::curvature(const Eigen::VectorXd& flow) const {
  return flow.segment(first_curvature(), nodes_);
}
Nodes CoupledSystem::displacement(const Eigen::VectorXd& solution) const {
  return solution.segment(first_displacement(), 3 * nodes_).reshaped(3, nodes_);
}
void CoupledSystem::scale_displacements(double factor, Eigen::VectorXd& flow,
                                        Eigen::VectorXd& motion) const {
  (scheme_ == Scheme::split ? motion : flow).segment(first_displacement(), 3 * nodes_) *= factor;
}

}  // namespace sbeh::surface3d
