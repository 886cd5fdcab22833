#include "surface3d/order_step.h"

#include "model/order_step.h"
#include "surface3d/linear/conjugate_gradient.h"
#include "surface3d/linear/direct_solver.h"
#include "surface3d/parallel.h"

#include <Eigen/IterativeLinearSolvers>

#include <limits>

namespace sbeh::surface3d {

namespace {

// Where the mass matrix dominates, a dozen iterations lead to rounding; where the material passes several
// triangles in a step they may lead nowhere, and the matrix is factored.
Field solve(const SparseMatrix& matrix, const Field& rhs, const Field& guess) {
  Eigen::BiCGSTAB<SparseMatrix> iteration(matrix);
  iteration.setTolerance(1e-13);
  iteration.setMaxIterations(200);
  Field x = iteration.solveWithGuess(rhs, guess);
  if (x.allFinite() && iteration.error() < 1e-10) return x;
  DirectSolver direct(Symmetry::general);
  if (!direct.factor(matrix)) return {};
  x = rhs;
  direct.solve(x);
  return x.allFinite() ? x : Field();
}

// The equation of the order over a time τ.
LinearSystem equation_of_order(const Triangulation& mesh, const model::Material& material,
                               const State& at, const Field& from, const Curvature& curvature,
                               const Nodes& slip, double tau) {
  LinearSystem system{mesh.scalars.zero(), Field::Zero(mesh.nodes)};
  for_each_by_colour(mesh, [&](int e) {
    const ElementNodes X = on_element(mesh, e, at.X),
                       normals = on_element(mesh, e, curvature.normals),
                       local_slip = on_element(mesh, e, slip);
    const ElementField beta = on_element(mesh, e, at.beta), beta_from = on_element(mesh, e, from),
                       H = on_element(mesh, e, curvature.H);
    Eigen::Matrix<double, 10, 10> local = decltype(local)::Zero();
    ElementField vector = ElementField::Zero();
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint x = surface_point(X, s);
      const double h = value_at(H, s);
      const model::ShapeOperator<double> B = shape_operator(x, normals, h);
      const model::OrderData d = model::order_step_point(
          material,
          {.beta = value_at(beta, s),
           .beta_from = value_at(beta_from, s),
           .H = h,
           .K = model::gauss_curvature(B),
           .slip = x.frame.leftCols<2>().transpose() * value_at(local_slip, s)},
          tau);
      const Shapes phi(s.phi.data()), grad_1(x.grad[0].data()), grad_2(x.grad[1].data());
      const ElementField value =
          d.reaction * phi + d.advection[0] * grad_1 + d.advection[1] * grad_2;
      local += (x.dS * phi) * value.transpose();
      local += (x.dS * d.diffusion * grad_1) * grad_1.transpose();
      local += (x.dS * d.diffusion * grad_2) * grad_2.transpose();
      vector += x.dS * d.rhs * phi;
    }
    mesh.scalars.add(e, local, system.matrix);
    for (int a = 0; a < 10; ++a) system.rhs[mesh.triangles(a, e)] += vector[a];
  });
  return system;
}

}  // namespace

Field order_step(const Triangulation& mesh, const model::Material& material, const State& at,
                 const Field& from, const Curvature& curvature, const Nodes& slip, double tau) {
  const LinearSystem system = equation_of_order(mesh, material, at, from, curvature, slip, tau);
  return solve(system.matrix, system.rhs, at.beta);
}

Field order_force(const Triangulation& mesh, const model::Material& material, const State& at,
                  const Curvature& curvature) {
  Field force = Field::Zero(mesh.nodes);
  for_each_by_colour(mesh, [&](int e) {
    const ElementNodes X = on_element(mesh, e, at.X),
                       normals = on_element(mesh, e, curvature.normals);
    const ElementField beta = on_element(mesh, e, at.beta), H = on_element(mesh, e, curvature.H);
    ElementField local = ElementField::Zero();
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint x = surface_point(X, s);
      const double h = value_at(H, s), K = model::gauss_curvature(shape_operator(x, normals, h));
      const model::Tangent<double> distortion = material.l1() * gradient_at(beta, x);  // (B2)
      const double reaction = model::order_force(material, value_at(beta, s), h, K);  // (B3) … (B5)
      local += x.dS * reaction * Shapes(s.phi.data());
      for (int i = 0; i < 2; ++i)
        local += x.dS * distortion[i] * Shapes(x.grad[std::size_t(i)].data());
    }
    for (int a = 0; a < 10; ++a) force[mesh.triangles(a, e)] += local[a];
  });
  const Field h = solve_mass(curvature.mass, force, Field::Zero(mesh.nodes));
  return h.allFinite() ? h : Field();
}

}  // namespace sbeh::surface3d
