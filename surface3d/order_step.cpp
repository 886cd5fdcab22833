#include "surface3d/order_step.h"

#include "model/order_step.h"
#include "surface3d/linear/conjugate_gradient.h"
#include "surface3d/linear/direct_solver.h"
#include "surface3d/linear/sparse_pattern.h"
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

using PressureElement = Eigen::Matrix<double, 6, 1>;

// What a triangle has of the equation.
struct OrderElement {
  const ElementNodes X, normals, slip;
  const ElementField beta, from, H;
  const PressureElement p;

  model::OrderPoint at(const ShapeValues& s, const SurfacePoint& x) const {
    const double h = value_at(H, s);
    return {.beta = value_at(beta, s),
            .beta_from = value_at(from, s),
            .H = h,
            .K = model::gauss_curvature(shape_operator(x, normals, h)),
            .slip = x.frame.leftCols<2>().transpose() * value_at(slip, s),
            .pressure = p.dot(Shapes(s.quadratic.data()).head<6>())};
  }
};
OrderElement order_element(const Triangulation& mesh, const State& at, const OrderStepData& step,
                           int e) {
  return {
      .X = on_element(mesh, e, at.X),
      .normals = on_element(mesh, e, step.curvature.normals),
      .slip = on_element(mesh, e, step.slip),
      .beta = on_element(mesh, e, at.beta),
      .from = on_element(mesh, e, step.from),
      .H = on_element(mesh, e, step.curvature.H),
      .p = step.p ? PressureElement((*step.p)(mesh.quadratic.col(e))) : PressureElement::Zero()};
}

using ScalarMatrix = Eigen::Matrix<double, 10, 10>;

// (∇φ_b, ∇φ_a) dS at a point.
ScalarMatrix stiffness_at(const SurfacePoint& x) {
  const Shapes grad_1(x.grad[0].data()), grad_2(x.grad[1].data());
  return x.dS * (grad_1 * grad_1.transpose() + grad_2 * grad_2.transpose());
}

// d(β, ψ) of an equation of the order.
ScalarMatrix matrix_at(const model::OrderData& d, const ShapeValues& s, const SurfacePoint& x) {
  const Shapes phi(s.phi.data()), grad_1(x.grad[0].data()), grad_2(x.grad[1].data());
  const ElementField value = d.reaction * phi + d.advection[0] * grad_1 + d.advection[1] * grad_2;
  return (x.dS * phi) * value.transpose() + d.diffusion * stiffness_at(x);
}

// The equation of the order over a time τ.
LinearSystem equation_of_order(const Triangulation& mesh, const model::Material& material,
                               const State& at, const OrderStepData& step) {
  LinearSystem system{mesh.scalars.zero(), Field::Zero(mesh.nodes)};
  for_each_by_colour(mesh, [&](int e) {
    const OrderElement element = order_element(mesh, at, step, e);
    ScalarMatrix local = ScalarMatrix::Zero();
    ElementField vector = ElementField::Zero();
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint x = surface_point(element.X, s);
      const model::OrderData d = model::order_step_point(material, element.at(s, x), step.tau);
      local += matrix_at(d, s, x);
      vector += x.dS * d.rhs * Shapes(s.phi.data());
    }
    mesh.scalars.add(e, local, system.matrix);
    for (int a = 0; a < 10; ++a) system.rhs[mesh.triangles(a, e)] += vector[a];
  });
  sum_over_ranks(mesh, system.matrix);
  sum_over_ranks(mesh, system.rhs);
  return system;
}

// ∫φ_i dS
Field weights_of(const Triangulation& mesh, const Nodes& X) {
  Field weights = Field::Zero(mesh.nodes);
  for_each_point(mesh, X, assembly_points(),
                 [&](int e, const ShapeValues& s, const SurfacePoint& x) {
                   for (int a = 0; a < 10; ++a)
                     weights[mesh.triangles(a, e)] += x.dS * s.phi[std::size_t(a)];
                 });
  return weights;
}

// With the chemical potential (B7) that keeps ∫β dS.
Field relaxed(const Triangulation& mesh, const model::Material& material, const State& at,
              const OrderStepData& step) {
  const LinearSystem system = equation_of_order(mesh, material, at, step);
  Field beta = solve(system.matrix, system.rhs, at.beta);
  if (!material.conserves_order() || beta.size() == 0) return beta;
  const Field weights = weights_of(mesh, at.X), next = weights_of(mesh, step.next);
  const Field response = solve(system.matrix, weights, Field::Zero(mesh.nodes));  // (B7)
  if (response.size() == 0) return {};
  const double total = step.total ? *step.total : weights.dot(at.beta);
  return beta + (total - next.dot(beta)) / next.dot(response) * response;
}

// Of two fields, node by node: the four blocks have the structure of a scalar one.
struct PairsSystem {
  SparseMatrix block[2][2];
  Eigen::VectorXd rhs;

  explicit PairsSystem(const Triangulation& mesh)
      : block{{mesh.scalars.zero(), mesh.scalars.zero()},
              {mesh.scalars.zero(), mesh.scalars.zero()}},
        rhs(Eigen::VectorXd::Zero(2 * mesh.nodes)) {}

  SparseMatrix matrix() const {
    const SparseMatrix& scalar = block[0][0];
    SparseMatrix pairs(2 * scalar.rows(), 2 * scalar.cols());
    pairs.resizeNonZeros(4 * scalar.nonZeros());
    int *start = pairs.outerIndexPtr(), *column = pairs.innerIndexPtr();
    double* value = pairs.valuePtr();
    *start = 0;
    for (Eigen::Index row = 0; row < pairs.rows(); ++row, ++start) {
      const auto& blocks = block[row % 2];
      const int begin = scalar.outerIndexPtr()[row / 2], end = scalar.outerIndexPtr()[row / 2 + 1];
      for (int k = begin; k < end; ++k)
        for (int other = 0; other < 2; ++other) {
          *column++ = 2 * scalar.innerIndexPtr()[k] + other;
          *value++ = blocks[other].valuePtr()[k];
        }
      start[1] = *start + 2 * (end - begin);
    }
    return pairs;
  }
};

// (β̇, ψ) + (M_β ∇μ, ∇ψ) = 0 and (μ, χ) = (δU/δβ, χ): unknowns β, μ, node by node.
OrderStepResult diffused(const Triangulation& mesh, const model::Material& material,
                         const State& at, const OrderStepData& step) {
  const double mobility = material.order_mobility.value_or(1);
  PairsSystem system(mesh);
  for_each_by_colour(mesh, [&](int e) {
    const OrderElement element = order_element(mesh, at, step, e);
    ScalarMatrix local[2][2];
    for (auto& row : local)
      for (ScalarMatrix& block : row) block.setZero();
    ElementField vector[2] = {ElementField::Zero(), ElementField::Zero()};
    for (const ShapeValues& s : assembly_points()) {
      const SurfacePoint p = surface_point(element.X, s);
      const model::OrderPoint point = element.at(s, p);
      const model::OrderData force = model::order_force_point(material, point);
      const model::OrderData rate{.reaction = 1 / step.tau,
                                  .advection = point.slip,
                                  .diffusion = 0,
                                  .rhs = point.beta_from / step.tau};
      const Shapes phi(s.phi.data());
      local[0][0] += matrix_at(rate, s, p);       // (B8)
      local[0][1] += mobility * stiffness_at(p);  // (B8)
      local[1][0] += matrix_at(force, s, p);
      local[1][1] -= p.dS * phi * phi.transpose();
      vector[0] += p.dS * rate.rhs * phi;
      vector[1] += p.dS * force.rhs * phi;
    }
    for (int i = 0; i < 2; ++i) {
      for (int j = 0; j < 2; ++j) mesh.scalars.add(e, local[i][j], system.block[i][j]);
      for (int a = 0; a < 10; ++a) system.rhs[2 * mesh.triangles(a, e) + i] += vector[i][a];
    }
  });
  for (auto& row : system.block)
    for (SparseMatrix& block : row) sum_over_ranks(mesh, block);
  sum_over_ranks(mesh, system.rhs);
  DirectSolver direct(Symmetry::general);
  if (!direct.factor(system.matrix())) return {};
  Eigen::VectorXd x = system.rhs;
  direct.solve(x);
  if (!x.allFinite()) return {};
  OrderStepResult result{.beta = x(Eigen::seqN(0, mesh.nodes, 2))};
  const Field mu = x(Eigen::seqN(1, mesh.nodes, 2));
  for_each_point(
      mesh, at.X, assembly_points(), [&](int e, const ShapeValues&, const SurfacePoint& p) {
        result.diffusion += p.dS * mobility * gradient_at(on_element(mesh, e, mu), p).squaredNorm();
      });
  return result;
}

}  // namespace

OrderStepResult order_step(const Triangulation& mesh, const model::Material& material,
                           const State& at, const OrderStepData& step) {
  if (material.order == model::OrderDynamics::diffusive) return diffused(mesh, material, at, step);
  return {.beta = relaxed(mesh, material, at, step)};
}

double total_order(const Triangulation& mesh, const State& state) {
  return weights_of(mesh, state.X).dot(state.beta);
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
  sum_over_ranks(mesh, force);
  const Field h = solve_mass(curvature.mass, force, Field::Zero(mesh.nodes));
  return h.allFinite() ? h : Field();
}

}  // namespace sbeh::surface3d
