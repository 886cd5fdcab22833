#include "surface3d/split.h"

#include "surface3d/parallel.h"

#include <Eigen/IterativeLinearSolvers>

#include <limits>

namespace sbeh::surface3d {

namespace {

// Where the normals of the old surface X are met by a displacement from X to `from` along them.
ElementNodes foot_points(const ElementNodes& X, const ElementNodes& from, const ElementNodes& n) {
  return X + n * n.cwiseProduct(from - X).colwise().sum().asDiagonal();
}

}  // namespace

void Split::begin(const Triangulation& mesh, const Nodes& normals, double tau) {
  pattern_.set_zero(motion_);
  tau_ = tau;
  node_normals_ = normals;
  tangents_ = node_tangents(normals);
  normal_flux_ = mesh.scalars.zero();
  triangles_.resize(mesh.own.size());
  ranks_ = mesh.ranks;
}

void Split::end(const Triangulation& mesh) {
  sum_over_ranks(mesh, motion_.rhs);
  sum_over_ranks(mesh, normal_flux_);
}

void Split::add(const Triangulation& mesh, const MovingTriangle& t, const MeshEquation& equation,
                FlowPiece& piece) {
  add_to_flow(t, equation, piece);
  add_to_motion(mesh, t, equation);
  mesh.scalars.add(t.e, equation.normal_mass_along(t.node_normals).transpose(),
                   normal_flux_);  // (Y1)
  triangles_[std::size_t(mesh.place[std::size_t(t.e)])] = {mesh.triangles.col(t.e), equation};
}

// (H1) along the normals, with the displacement τ(V·n) n from the foot points: a test field Z = φ_a n_a
// gives the row a of G. θ drops out: tested so, (Ĥ ν, Z) is −(∇_C x̂, ∇_C Z).
void Split::add_to_flow(const MovingTriangle& t, const MeshEquation& equation,
                        FlowPiece& piece) const {
  const ElementNodes &n = t.node_normals, foot = foot_points(t.X, t.from, n);
  piece.block(FlowPiece::G, FlowPiece::H) = equation.normal_mass_along(n);  // (H1)
  const MeshEquation::Scalar stiffness = equation.stiffness_between(n, n);
  for (int k = 0; k < 3; ++k) {
    piece.block(FlowPiece::G, FlowPiece::V + 10 * k) =
        t.tau * stiffness * n.row(k).transpose().asDiagonal();  // (H1)
    piece.rhs.segment<10>(FlowPiece::G) -=
        (n.row(k).transpose().asDiagonal() * equation.stiffness) * foot.row(k).transpose();  // (H1)
  }
}

// (H1) with Z = φ_a t_a, t the tangents, and unknowns w: Y = Σ w_b φ_b t_b and what the flow gives.
void Split::add_to_motion(const Triangulation& mesh, const MovingTriangle& t,
                          const MeshEquation& equation) {
  const ElementNodes force = equation.mesh_drive(t);
  const std::array tangents{on_element(mesh, t.e, tangents_[0]),
                            on_element(mesh, t.e, tangents_[1])};
  Eigen::Matrix<double, 20, 20> matrix;
  Eigen::Matrix<double, 20, 1> rhs;
  for (int i = 0; i < 2; ++i) {
    const ElementNodes& test = tangents[std::size_t(i)];
    for (int j = 0; j < 2; ++j)
      matrix.block<10, 10>(10 * i, 10 * j) =
          equation.stiffness_between(test, tangents[std::size_t(j)]);                // (H1)
    rhs.segment<10>(10 * i) = test.cwiseProduct(force).colwise().sum().transpose();  // (H1)
  }
  pattern_.add(t.e, matrix, motion_.matrix);
  pattern_.add(t.e, rhs, motion_.rhs);
}

// The displacement by the normal part of the velocity.
Nodes Split::along_normals(const Nodes& V) const {
  const Field speed = V.cwiseProduct(node_normals_).colwise().sum();
  return node_normals_ * (tau_ * speed).asDiagonal();
}

Eigen::VectorXd Split::motion_rhs(const Nodes& V, const Field& H) const {
  const Nodes Y = along_normals(V);
  Nodes force = Nodes::Zero(3, V.cols());
  for (const auto& [nodes, equation] : triangles_)
    force(Eigen::all, nodes) += equation.mesh_force(H(nodes), Y(Eigen::all, nodes));  // (H1)
  ranks_.sum({force.data(), std::size_t(force.size())});
  Eigen::VectorXd rhs = motion_.rhs;
  for (int k = 0; k < 2; ++k)
    rhs.reshaped(2, V.cols()).row(k) -=
        tangents_[std::size_t(k)].cwiseProduct(force).colwise().sum();
  return rhs;
}

Nodes Split::displacement(const Nodes& V, const Eigen::VectorXd&,
                          const Eigen::VectorXd& motion) const {
  Nodes Y = along_normals(V);
  const auto w = motion.reshaped(2, V.cols());
  for (int k = 0; k < 2; ++k) Y += tangents_[std::size_t(k)] * w.row(k).asDiagonal();

  const Nodes missing = along_normals(V) - Y;
  Eigen::RowVectorXd flux = Eigen::RowVectorXd::Zero(V.cols());
  for (const auto& [nodes, equation] : triangles_)
    flux(nodes) += equation.normal_flux(missing(Eigen::all, nodes));  // (Y1)
  ranks_.sum({flux.data(), std::size_t(flux.size())});
  Eigen::BiCGSTAB<SparseMatrix> solver(normal_flux_);  // nearly a mass matrix
  solver.setTolerance(1e-8);  // of the flux, which is of higher order in the mesh size
  const Field correction = solver.solve(flux.transpose());
  if (solver.info() != Eigen::Success) Y.setConstant(std::numeric_limits<double>::quiet_NaN());
  return Y + node_normals_ * correction.asDiagonal();
}

}  // namespace sbeh::surface3d
