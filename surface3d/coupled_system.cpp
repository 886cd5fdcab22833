#include "surface3d/coupled_system.h"

#include "surface3d/parallel.h"

#include <Eigen/IterativeLinearSolvers>

#include <algorithm>
#include <limits>

namespace sbeh::surface3d {

namespace {

SparsePattern no_pattern() {
  return SparsePattern(0, Eigen::MatrixXi(0, 0), SparsePattern::Mask(0, 0));
}

void set_zero(const SparsePattern& pattern, LinearSystem& system) {
  if (system.matrix.rows() == 0) system.matrix = pattern.zero();
  std::fill_n(system.matrix.valuePtr(), system.matrix.nonZeros(), 0.);
  system.rhs.setZero(pattern.size());
}

// V, p: the unknowns before the padding of the pressure; then H and Y.
constexpr int head = 36, displaced = head + 10;

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

// Two unit vectors orthogonal to n and to each other: those of a fixed direction, turned with it to n.
// They change smoothly with n but opposite to that direction, which is no axis of anything.
std::array<Eigen::Vector3d, 2> tangents_at(const Eigen::Vector3d& n) {
  static const Eigen::Vector3d from = Eigen::Vector3d(0.36, 0.48, 0.8),
                               first = Eigen::Vector3d(0.8, -0.6, 0);
  const auto turn = Eigen::Quaterniond::FromTwoVectors(from, n);
  return {turn * first, turn * from.cross(first)};
}

// Where the normals of the old surface X are met by a displacement from X to `from` along them.
ElementNodes foot_points(const ElementNodes& X, const ElementNodes& from, const ElementNodes& n) {
  return X + n * n.cwiseProduct(from - X).colwise().sum().asDiagonal();
}

using Scalar = ElementSystem::Scalar;

// a·A·b, summed over x, y, z, for vectors a, b at the nodes: an A for each component, or the same for all.
Scalar between(const ElementNodes& a, const Scalar& A, const ElementNodes& b) {
  return A.cwiseProduct(a.transpose() * b);
}
Scalar along(const ElementNodes& a, const std::array<Scalar, 3>& A) {
  Scalar sum = Scalar::Zero();
  for (int k = 0; k < 3; ++k) sum += a.row(k).transpose().asDiagonal() * A[std::size_t(k)];
  return sum;
}

}  // namespace

// What moves of a triangle, and how (H1) sees it.
struct CoupledSystem::ElementMesh {
  double tau;
  ElementNodes normals, foot;
  std::array<ElementNodes, 2> tangents;  // when split
  ElementNodes force;                    // the right-hand side of (H1), by the nodes of Z

  // The mesh goes to its equilibrium at a finite rate: of the residual of (H1) on the old surface, which
  // is zero along the normals, the share θ only.
  void set_force(const ElementSystem& s, const ElementNodes& from, const ElementField& H) {
    const double theta = tau / (tau + mesh_relaxation_time);
    force = -theta * from * s.stiffness;
    for (int k = 0; k < 3; ++k)
      force.row(k) += (1 - theta) * (s.normal_mass[std::size_t(k)] * H).transpose();
  }
};

// What of an element's system goes into that of the flow.
struct CoupledSystem::Piece {
  Eigen::MatrixXd flow;
  Eigen::VectorXd rhs;
};

CoupledSystem::CoupledSystem(const Triangulation& mesh, const model::Material& material,
                             Scheme scheme, model::AreaConstraint area)
    : material_(material),
      scheme_(scheme),
      area_(area),
      nodes_(mesh.nodes),
      quadratic_nodes_(mesh.quadratic_nodes),
      multipliers_(material.friction_tangential == 0 && material.friction_normal == 0 ? 7 : 1),
      flow_pattern_(along_normals() ? normal_flow_pattern(mesh, scheme)
                                    : flow_pattern(mesh, scheme, multipliers_)),
      motion_pattern_(scheme == Scheme::split ? motion_pattern(mesh) : no_pattern()) {}

void CoupledSystem::cut_flow(const ElementMesh& mesh, bool keep_volume,
                             const ElementSystem& element, Piece& piece) const {
  const bool split = scheme_ == Scheme::split;
  const int size = split ? displaced : displaced + 30;
  piece.flow.setZero(size + multipliers_, size + multipliers_);
  piece.rhs.setZero(size + multipliers_);
  piece.flow.topLeftCorner<head, head>() = element.flow.topLeftCorner<head, head>();
  piece.flow.block<head, 10>(0, head) = element.flow.block<head, 10>(0, local::H);
  piece.rhs.head<head>() = element.rhs.head<head>();
  piece.flow.topRightCorner(30, multipliers_) = element.constraints.leftCols(multipliers_);
  piece.flow.bottomLeftCorner(multipliers_, 30) =
      element.constraints.leftCols(multipliers_).transpose();
  if (!keep_volume) {
    piece.flow.col(size).setZero();
    piece.flow.row(size).setZero();
  }
  if (split)
    cut_split(mesh, element, piece);
  else
    cut_monolithic(mesh, element, piece);
}

// (Y1) and (H1).
void CoupledSystem::cut_monolithic(const ElementMesh& mesh, const ElementSystem& element,
                                   Piece& piece) const {
  for (int k = 0; k < 3; ++k) {
    const Scalar& normal_mass = element.normal_mass[std::size_t(k)];
    const int V = 10 * k, Y = displaced + 10 * k;
    piece.flow.block<10, 10>(head, V) = -mesh.tau * normal_mass;
    piece.flow.block<10, 10>(head, Y) = normal_mass;
    piece.flow.block<10, 10>(Y, head) = normal_mass;
    piece.flow.block<10, 10>(Y, Y) = element.stiffness;
    piece.rhs.segment<10>(Y) = mesh.force.row(k).transpose();
  }
}

// (H1) along the normals, with the displacement τ(V·n) n from the foot points: a test field Z = φ_a n_a
// gives the row a of G.
void CoupledSystem::cut_split(const ElementMesh& mesh, const ElementSystem& element,
                              Piece& piece) const {
  const ElementNodes& n = mesh.normals;
  piece.flow.block<10, 10>(head, head) = along(n, element.normal_mass);
  const Scalar stiffness = between(n, element.stiffness, n);
  for (int k = 0; k < 3; ++k) {
    piece.flow.block<10, 10>(head, 10 * k) =
        mesh.tau * stiffness * n.row(k).transpose().asDiagonal();
    piece.rhs.segment<10>(head) -=
        (n.row(k).transpose().asDiagonal() * element.stiffness) * mesh.foot.row(k).transpose();
  }
}

void CoupledSystem::add_flow(int e, const ElementMesh& mesh, Piece& piece) {
  if (along_normals()) {
    const Eigen::MatrixXd T = normal_motion(mesh.normals, int(piece.flow.rows()));
    piece.flow = (T.transpose() * piece.flow * T).eval();
    piece.rhs = (T.transpose() * piece.rhs).eval();
    total_area_rate_[e] = piece.rhs[piece.rhs.size() - 1];
  }
  flow_pattern_.add(e, piece.flow, flow_.matrix);
  flow_pattern_.add(e, piece.rhs, flow_.rhs);
}

// (H1) with Z = φ_a t_a, t the tangents, and unknowns w: Y = Σ w_b φ_b t_b and what the flow gives.
void CoupledSystem::add_motion(int e, const ElementMesh& mesh, const ElementSystem& element) {
  Eigen::Matrix<double, 20, 20> matrix;
  Eigen::Matrix<double, 20, 1> rhs;
  for (int i = 0; i < 2; ++i) {
    const ElementNodes& t = mesh.tangents[std::size_t(i)];
    for (int j = 0; j < 2; ++j)
      matrix.block<10, 10>(10 * i, 10 * j) =
          between(t, element.stiffness, mesh.tangents[std::size_t(j)]);
    rhs.segment<10>(10 * i) = t.cwiseProduct(mesh.force).colwise().sum().transpose();
  }
  motion_pattern_.add(e, matrix, motion_.matrix);
  motion_pattern_.add(e, rhs, motion_.rhs);
  mesh_matrices_[std::size_t(e)] = element;
}

void CoupledSystem::assemble(const Triangulation& mesh, const State& old,
                             const Curvature& curvature, const Origin& from, double tau,
                             const Constraints& constraints) {
  const bool split = scheme_ == Scheme::split;
  set_zero(flow_pattern_, flow_);
  set_zero(motion_pattern_, motion_);
  set_frames(curvature.node_normals);
  tau_ = tau;
  mesh_matrices_.resize(std::size_t(split ? mesh.count() : 0));
  if (split) normal_flux_ = mesh.scalars.zero();
  total_area_rate_.setZero(along_normals() ? mesh.count() : 0);
  const StepParameters step{.area_rate = constraints.area_rate, .area = area_};

  for_each_by_colour(mesh, [&](int e) {
    static thread_local ElementSystem element;
    static thread_local Piece piece;
    const ElementNodes X = on_element(mesh, e, old.X), origin = on_element(mesh, e, from.X);
    assemble_element(material_,
                     {.X = X,
                      .normals = on_element(mesh, e, curvature.normals),
                      .beta = on_element(mesh, e, old.beta),
                      .H = on_element(mesh, e, curvature.H)},
                     step, element);
    ElementMesh moving{.tau = tau,
                       .normals = on_element(mesh, e, normals_),
                       .foot = {},
                       .tangents = {},
                       .force = {}};
    moving.foot = foot_points(X, origin, moving.normals);
    moving.set_force(element, origin, on_element(mesh, e, from.H));
    cut_flow(moving, constraints.keep_volume, element, piece);
    add_flow(e, moving, piece);
    if (!split) return;
    for (std::size_t i = 0; i < 2; ++i) moving.tangents[i] = on_element(mesh, e, tangents_[i]);
    add_motion(e, moving, element);
    mesh.scalars.add(e, along(moving.normals, element.normal_mass).transpose(), normal_flux_);
  });
  const int lambda = first_multiplier();
  if (along_normals()) flow_.rhs[lambda + 1] = total_area_rate_.sum();
  flow_.rhs[lambda] = constraints.keep_volume ? constraints.volume_rate : 0;
  if (!constraints.keep_volume) flow_.matrix.coeffRef(lambda, lambda) = 1;
}

// n: 3 x nodes.
void CoupledSystem::set_frames(const Nodes& n) {
  normals_ = n;
  if (scheme_ == Scheme::monolithic) return;
  tangents_.fill(Nodes(3, n.cols()));
  for (Eigen::Index i = 0; i < n.cols(); ++i) {
    const auto tangents = tangents_at(n.col(i));
    for (std::size_t k = 0; k < 2; ++k) tangents_[k].col(i) = tangents[k];
  }
}

template <class Sum, class Visit>
void CoupledSystem::add_up(Sum& sum, Visit&& visit) const {
  for (int e = 0; e < motion_pattern_.elements(); ++e) {
    Eigen::Matrix<int, 10, 1> nodes;
    for (int a = 0; a < 10; ++a) nodes[a] = motion_pattern_.unknown(a, e) / 2;
    sum(Eigen::all, nodes) += visit(nodes, mesh_matrices_[std::size_t(e)]);
  }
}

// At the nodes.
Field CoupledSystem::normal_speed(const Eigen::VectorXd& flow) const {
  return velocity(flow).cwiseProduct(normals_).colwise().sum();
}

Eigen::VectorXd CoupledSystem::motion_rhs(const Eigen::VectorXd& flow) const {
  const Field H = curvature(flow);
  const Nodes Y = normals_ * (tau_ * normal_speed(flow)).asDiagonal();
  Nodes force = Nodes::Zero(3, nodes_);  // of (H1), by the nodes of Z
  add_up(force, [&](const auto& nodes, const MeshMatrices& matrices) {
    ElementNodes part = Y(Eigen::all, nodes) * matrices.stiffness;
    for (int k = 0; k < 3; ++k)
      part.row(k) += (matrices.normal_mass[std::size_t(k)] * H(nodes)).transpose();
    return part;
  });
  Eigen::VectorXd rhs = motion_.rhs;
  for (int k = 0; k < 2; ++k)
    rhs.reshaped(2, nodes_).row(k) -= tangents_[std::size_t(k)].cwiseProduct(force).colwise().sum();
  return rhs;
}

int CoupledSystem::first_curvature() const {
  return along_normals() ? nodes_ : 3 * nodes_ + quadratic_nodes_;
}
int CoupledSystem::first_displacement() const { return first_curvature() + nodes_; }
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
Nodes CoupledSystem::displacement(const Eigen::VectorXd& flow,
                                  const Eigen::VectorXd& motion) const {
  if (scheme_ == Scheme::monolithic)
    return flow.segment(first_displacement(), 3 * nodes_).reshaped(3, nodes_);
  Nodes Y = normals_ * (tau_ * normal_speed(flow)).asDiagonal();
  const auto w = motion.reshaped(2, nodes_);
  for (int k = 0; k < 2; ++k) Y += tangents_[std::size_t(k)] * w.row(k).asDiagonal();

  const Nodes missing = tau_ * velocity(flow) - Y;
  Eigen::RowVectorXd flux = Eigen::RowVectorXd::Zero(nodes_);  // (missing·ν, G)
  add_up(flux, [&](const auto& nodes, const MeshMatrices& matrices) {
    Eigen::Matrix<double, 1, 10> part = decltype(part)::Zero();
    for (int k = 0; k < 3; ++k) part += missing(k, nodes) * matrices.normal_mass[std::size_t(k)];
    return part;
  });
  Eigen::BiCGSTAB<SparseMatrix> solver(normal_flux_);  // nearly a mass matrix
  solver.setTolerance(1e-8);  // of the flux, which is of higher order in the mesh size
  const Field correction = solver.solve(flux.transpose());
  if (solver.info() != Eigen::Success) Y.setConstant(std::numeric_limits<double>::quiet_NaN());
  return Y + normals_ * correction.asDiagonal();
}
void CoupledSystem::scale_displacements(double factor, Eigen::VectorXd& flow,
                                        Eigen::VectorXd& motion) const {
  if (scheme_ == Scheme::monolithic)
    flow.segment(first_displacement(), 3 * nodes_) *= factor;
  else
    motion *= factor;
}

}  // namespace sbeh::surface3d
