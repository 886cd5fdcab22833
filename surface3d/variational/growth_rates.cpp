#include "surface3d/variational/growth_rates.h"

#include "model/numerics/block_lanczos.h"
#include "surface3d/linear/bordered.h"
#include "surface3d/linear/direct_solver.h"
#include "surface3d/stationary/rigid_motions.h"
#include "surface3d/variational/step_functional.h"

#include <algorithm>
#include <random>

namespace sbeh::surface3d {

namespace {

constexpr int holds = 7;  // of StepResistance

// (sR + Hessian) x = loads on normal motion and order, factored for a rate s above all others: 1/(s − σ) are the eigenvalues
// of loads = R x. Vectors are the unknowns of a step and the multipliers of its borders.
class ShiftedFlow {
 public:
  ShiftedFlow(const model::Material& material, const StepLayout& layout,
              const StationaryState& state, const Curvature& curvature)
      : layout_(layout),
        loaded_(layout.state.free_order ? std::vector{node_d, node_beta} : std::vector{node_d}),
        tangents_(node_tangents(curvature.node_normals)),
        mass_(perturbation_mass(layout.state, state, curvature.node_normals)) {
    const Nodes still = Nodes::Zero(3, layout.state.mesh.nodes);
    assemble(material, layout, {state, curvature, tangents_, still, 1}, resistance_);
    assemble(material, layout.state, state, curvature.node_normals, energy_);
    rigid_ = rigid_motions(layout.state, state, curvature.node_normals).loads;
  }

  // False where there is no such rate.
  bool factor() {
    constexpr double first = 1, growth = 4, most = 1e12;
    if (!find_rigid_motions()) return false;
    const int multipliers =
        layout_.state.mesh.nodes + layout_.state.mesh.quadratic_nodes + constraints() + holds - 1;
    for (shift_ = first; shift_ < most; shift_ *= growth)
      if (factor_with(energy_.hessian) && solver_.negative_eigenvalues() == multipliers) {
        rigid_.bottomRows(holds) *= shift_;  // found with 1
        return true;
      }
    return false;
  }

  double shift() const { return shift_; }
  const SparseMatrix& mass() const { return mass_; }
  const std::array<Nodes, 2>& tangents() const { return tangents_; }

  Eigen::MatrixXd respond(const Eigen::MatrixXd& loads) const {
    Eigen::MatrixXd x = solution(loads);
    return x - rigid_ * (rigid_loads_.transpose() * x);
  }
  // To normal motion and change of order, the motion along the surface being in balance.
  Eigen::MatrixXd resistance(const Eigen::MatrixXd& x) const {
    const Eigen::MatrixXd all = resistance_.matrix * x.topRows(layout_.size())
                              + resistance_.borders * x.bottomRows(holds) / shift_;
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(size(), x.cols());
    for (const NodeUnknown c : loaded_)
      loads(layout_.all(c), Eigen::all) = all(layout_.all(c), Eigen::all);
    return loads;
  }
  // In as many columns as an eigenvalue may have vectors about an axis, and one more.
  Eigen::MatrixXd any_loads() const {
    constexpr int block = 3;
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(size(), block);
    for (int k = 0; k < block; ++k)
      for (const NodeUnknown c : loaded_)
        loads(layout_.all(c), k) = Eigen::VectorXd::NullaryExpr(layout_.state.mesh.nodes,
                                                                [&] { return uniform(generator); });
    return loads;
  }

 private:
  int constraints() const { return energy_.multipliers(); }
  int size() const { return layout_.size() + constraints() + holds; }
  Eigen::MatrixXd solution(Eigen::MatrixXd loads) const {
    solver_.solve(loads);
    return loads;
  }

  // With the motion along the surface that resists least; orthonormal in the resistance.
  bool find_rigid_motions() {
    constexpr double stiffness = 1e8;  // holds normal motion and order at those given
    shift_ = 1;
    const SparseMatrix held = energy_.hessian + stiffness * mass_;
    if (!factor_with(held)) return false;
    Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(size(), rigid_.cols());
    loads(layout_.unknowns, Eigen::all) = stiffness * rigid_;
    rigid_ = solution(loads);
    const Eigen::MatrixXd gram = rigid_.transpose() * resistance(rigid_);
    const Eigen::LLT<Eigen::MatrixXd> root((gram + gram.transpose()) / 2);
    if (root.info() != Eigen::Success) return false;
    rigid_ = root.matrixL().solve(rigid_.transpose()).transpose();
    rigid_loads_ = resistance(rigid_);
    return true;
  }

  // The Hessian or a matrix of its structure.
  bool factor_with(const SparseMatrix& hessian) {
    SparseMatrix matrix = shift_ * resistance_.matrix;
    const double* entry = hessian.valuePtr();
    for (const int place : layout_.places) matrix.valuePtr()[place] += *entry++;
    Eigen::MatrixXd borders = Eigen::MatrixXd::Zero(layout_.size(), constraints() + holds);
    borders(layout_.unknowns, Eigen::seqN(0, constraints())) = energy_.constraints;
    borders.rightCols<holds>() = resistance_.borders;
    SparseMatrix bordered;
    set_bordered(matrix, borders, energy_.corner, bordered);
    return solver_.factor(bordered);
  }

  const StepLayout& layout_;
  std::vector<NodeUnknown> loaded_;
  std::array<Nodes, 2> tangents_;
  SparseMatrix mass_;
  StepResistance resistance_{};
  LagrangianDerivatives energy_{};
  Eigen::MatrixXd rigid_, rigid_loads_;  // and their resistance
  double shift_ = 1;
  DirectSolver solver_{Symmetry::symmetric};
};

GrowthMode mode_of(const StepLayout& layout, const SparseMatrix& mass, const Nodes& normals,
                   const std::array<Nodes, 2>& tangents, double rate, const Eigen::VectorXd& x) {
  const Field u = x(layout.all(node_d));
  Eigen::VectorXd perturbation = Eigen::VectorXd::Zero(layout.state.size());
  perturbation(layout.state.all(node_d)) = u;
  Field b = Field::Zero(u.size());
  if (layout.state.free_order) {
    b = x(layout.all(node_beta));
    perturbation(layout.state.all(node_beta)) = b;
  }
  Nodes V = normals * u.asDiagonal();
  for (int k = 0; k < 2; ++k)
    V += tangents[std::size_t(k)] * x(layout.all(layout.state.per_node + k)).asDiagonal();
  const Field& seen = u.isZero(0) ? b : u;
  Eigen::Index largest = 0;
  seen.cwiseAbs().maxCoeff(&largest);
  const double length = std::sqrt(perturbation.dot(mass * perturbation)),
               factor = (seen[largest] < 0 ? -1 : 1) / length;
  return {rate, factor * u, factor * b, factor * V};
}

}  // namespace

std::optional<std::vector<GrowthMode>> growth_rates(const model::Material& material,
                                                    const Triangulation& mesh, model::Model model,
                                                    const StationaryState& state, int count) {
  if (effective(material, model).order == model::OrderDynamics::diffusive) return {};
  const auto curvature = curvature_of(mesh, state.X);
  if (!curvature) return {};
  const StepLayout layout(mesh, effective(material, model), model);
  ShiftedFlow flow(effective(material, model), layout, state, *curvature);
  if (!flow.factor()) return {};
  constexpr int most = 200;
  const auto found = model::largest_by_block_lanczos(
      [&](const Eigen::MatrixXd& loads) { return flow.respond(loads); },
      [&](const Eigen::MatrixXd& x) { return flow.resistance(x); }, flow.respond(flow.any_loads()),
      count, most + 4 * count);
  if (!found) return {};
  std::vector<GrowthMode> modes;
  for (Eigen::Index k = 0; k < found->values.size(); ++k)
    modes.push_back(mode_of(layout, flow.mass(), curvature->node_normals, flow.tangents(),
                            flow.shift() - 1 / found->values[k], found->vectors.col(k)));
  std::ranges::sort(modes, std::greater{}, &GrowthMode::rate);
  return modes;
}

}  // namespace sbeh::surface3d
