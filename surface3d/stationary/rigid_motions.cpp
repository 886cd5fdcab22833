#include "surface3d/stationary/rigid_motions.h"

#include "surface3d/curvature.h"
#include "surface3d/moments.h"
#include "surface3d/parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace sbeh::surface3d {

namespace {

// A motion of a size below so many times what normals are off is what errors leave of none: on surfaces of revolution of 80 to
// 1280 triangles the turn about the axis has 0.1 to 2.1 times that.
constexpr double errors = 4;

using Motion = Eigen::Matrix<double, 6, 1>;  // of each: three translations, three turns
struct MotionPoint {
  Motion u, b;
};
MotionPoint motions_at(const Eigen::Vector3d& x, const Eigen::Vector3d& nu,
                       const Eigen::Vector3d& grad_beta) {
  MotionPoint at;
  at.u << nu, x.cross(nu);
  at.b << -grad_beta, -x.cross(grad_beta);
  return at;
}

struct MotionSums {
  Eigen::Matrix<double, 10, 6> d = decltype(d)::Zero(), beta = decltype(beta)::Zero();
  Eigen::Matrix<double, 6, 6> squares = decltype(squares)::Zero();
  double noise = 0;  // ∫ |δν|²|x|² dS, δν how far normals are off those between the nodes
};

}  // namespace

SparseMatrix perturbation_mass(const StationaryLayout& layout, const StationaryState& state,
                               const Nodes& normals) {
  const Triangulation& mesh = layout.mesh;
  SparseMatrix mass = layout.pattern.zero();
  for_each_by_colour(mesh, [&](int e) {
    Eigen::Matrix<double, 40, 40> local = decltype(local)::Zero();
    const ElementNodes X = on_element(mesh, e, state.X), n = on_element(mesh, e, normals);
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(X, s);
      const Shapes phi(s.phi.data());
      const ElementField along = phi.cwiseProduct(n.transpose() * p.nu());
      local.block<10, 10>(10 * node_d, 10 * node_d).noalias() += p.dS * along * along.transpose();
      local.block<10, 10>(10 * node_beta, 10 * node_beta).noalias() += p.dS * phi * phi.transpose();
    }
    layout.pattern.add(e, local, mass);
  });
  mass.prune(0., 0.);
  return mass;
}

RigidMotions rigid_motions(const StationaryLayout& layout, const StationaryState& state,
                           const Nodes& normals) {
  const Triangulation& mesh = layout.mesh;
  const Eigen::Vector3d centre = moments_of(samples_of(mesh, state.X)).centre;
  const Nodes own_normals = node_normals(mesh, state.X);
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(layout.size(), 6);
  std::vector<Eigen::Matrix<double, 6, 6>> squares(std::size_t(mesh.count()));
  Eigen::VectorXd noises(mesh.count());
  for_each_by_colour(mesh, [&](int e) {
    const ElementNodes X = on_element(mesh, e, state.X), n = on_element(mesh, e, normals);
    const ElementNodes own = on_element(mesh, e, own_normals);
    const ElementField beta = on_element(mesh, e, state.beta);
    MotionSums sums;
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(X, s);
      const Shapes phi(s.phi.data());
      const Eigen::Vector3d slope = p.frame.leftCols<2>() * gradient_at(beta, p);
      const MotionPoint at = motions_at(p.x - centre, p.nu(), slope);
      sums.d += p.dS * phi.cwiseProduct(n.transpose() * p.nu()) * at.u.transpose();
      sums.beta += p.dS * phi * at.b.transpose();
      sums.squares += p.dS * at.u * at.u.transpose();
      if (layout.free_order) sums.squares += p.dS * at.b * at.b.transpose();
      sums.noise += p.dS * (p.x - centre).squaredNorm()
                  * (value_at(own, s).normalized() - p.nu()).squaredNorm();
    }
    squares[std::size_t(e)] = sums.squares;
    noises[e] = sums.noise;
    for (int a = 0; a < 10; ++a) {
      const int node = mesh.triangles(a, e);
      loads.row(layout.index(node, node_d)) += sums.d.row(a);
      if (layout.free_order) loads.row(layout.index(node, node_beta)) += sums.beta.row(a);
    }
  });
  Eigen::Matrix<double, 6, 6> total = decltype(total)::Zero();
  for (const auto& part : squares) total += part;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(total);
  const double largest = eigen.eigenvalues()[5];
  const Motion sizes = (eigen.eigenvalues() / largest).cwiseMax(0).cwiseSqrt();
  const double nothing = errors * std::sqrt(noises.sum() / largest);
  const int none = int((sizes.array() < nothing).count());
  return {.loads = loads * eigen.eigenvectors().rightCols(6 - none),
          .least = none < 6 ? sizes[none] : 0,
          .dropped = none > 0 ? sizes[none - 1] : 0,
          .nothing = nothing};
}

}  // namespace sbeh::surface3d
