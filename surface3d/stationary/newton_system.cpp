#include "surface3d/stationary/newton_system.h"

#include "surface3d/linear/bordered.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbeh::surface3d {

double largest_change(const Increment& step) {
  return std::max(step.d.cwiseAbs().maxCoeff(), step.beta.cwiseAbs().maxCoeff());
}

bool Holds::operator==(const Holds& other) const {
  const auto same = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return a.size() == b.size() && a == b;
  };
  return same(amplitude, other.amplitude) && same(phase, other.phase);
}

void displace(const Increment& step, double scale, const Nodes& normals, StationaryState& state) {
  state.X += normals * (scale * step.d).asDiagonal();
  state.beta += scale * step.beta;
  state.Lambda += scale * step.Lambda;
  state.H += scale * step.H;
  state.tension += scale * step.tension;
  state.pressure += scale * step.pressure;
  state.moment += scale * step.moment;
  state.chemical_potential += scale * step.chemical_potential;
}

NewtonSystem::NewtonSystem(const Triangulation& mesh, const model::Material& material,
                           model::Model model)
    : layout_(mesh, model) {
  set_material(material);
}

void NewtonSystem::set_material(const model::Material& material) {
  const model::Material felt = layout_.free_order ? material : material.with_uniform_order();
  if (!(felt == material_)) seen_.reset();
  material_ = felt;
  if (material_.conserves_order() && !material_.mean_order)
    throw std::invalid_argument("a conserved order at rest: mean_order must be given");
}

bool NewtonSystem::is_linearised(const StationaryState& state, const Nodes& normals,
                                 const Holds& holds) const {
  return seen_ && seen_->state == state && seen_->normals == normals && seen_->holds == holds;
}

bool NewtonSystem::linearise(const StationaryState& state, const Nodes& normals,
                             const Holds& holds) {
  if (is_linearised(state, normals, holds)) return true;
  seen_.reset();
  const int before = borders();
  assemble(material_, layout_, state, normals, derivatives_);
  moment_ = state.moment;
  rigid_ = rigid_motions(layout_, state, normals);
  has_amplitude_ = holds.amplitude.size() > 0;
  if (holds.phase.size() > 0 && rigid_count() == 5) {
    rigid_.loads.conservativeResize(Eigen::NoChange, 6);
    rigid_.loads.col(5) = holds.phase;
  }
  if (!derivatives_.gradient.allFinite()) return false;
  if (bordered_.rows() > 0 && borders() != before) solver_ = DirectSolver(Symmetry::symmetric);
  Eigen::MatrixXd B(layout_.size(), borders());
  B.leftCols(derivatives_.multipliers()) = derivatives_.constraints;
  B.middleCols(derivatives_.multipliers(), rigid_count()) = rigid_.loads;
  if (has_amplitude_) B.rightCols<1>() = holds.amplitude;
  set_bordered(derivatives_.hessian, B, derivatives_.corner, bordered_);
  if (!solver_.factor(bordered_)) return false;
  seen_ = Seen{state, normals, holds};
  return true;
}

int NewtonSystem::negative_directions() const {
  return solver_.negative_eigenvalues() - layout_.mesh.nodes - borders();
}

void NewtonSystem::respond(Eigen::Ref<Eigen::MatrixXd> loads) const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(layout_.size() + borders(), loads.cols());
  all.topRows(layout_.size()) = loads;
  solver_.solve(all);
  loads = all.topRows(layout_.size());
}

bool NewtonSystem::newton_step(const Target& target, Increment& step) const {
  return solve(-derivatives_.gradient, derivatives_.miss(material_, target, moment_), step);
}

bool NewtonSystem::newton_step_from(const StationaryState& state, const Nodes& normals,
                                    const Target& target, Increment& step) {
  assemble(material_, layout_, state, normals, others_);
  return solve(-others_.gradient, others_.miss(material_, target, state.moment), step);
}

Eigen::VectorXd NewtonSystem::gradient_with(const model::Material& material,
                                            const StationaryState& state, const Nodes& normals) {
  assemble(material, layout_, state, normals, others_);
  return others_.gradient;
}

bool NewtonSystem::solve(Eigen::VectorXd rhs, const Eigen::VectorXd& miss, Increment& step) const {
  const int n = layout_.size();
  rhs.conservativeResizeLike(Eigen::VectorXd::Zero(n + borders()));
  rhs.segment(n, miss.size()) = miss;
  solver_.solve(rhs);
  if (!rhs.allFinite()) return false;
  step.d = rhs(layout_.all(node_d));
  step.Lambda = rhs(layout_.all(node_Lambda));
  step.H = rhs(layout_.all(node_H));
  step.beta = layout_.free_order ? Field(rhs(layout_.all(node_beta)))
                                 : Field(Field::Zero(layout_.mesh.nodes));
  set_multipliers(material_, rhs.segment(n, miss.size()), step);
  step.hold = has_amplitude_ ? rhs[n + borders() - 1] : 0;
  return true;
}

}  // namespace sbeh::surface3d
