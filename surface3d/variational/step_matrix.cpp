#include "surface3d/variational/step_matrix.h"

#include "surface3d/linear/bordered.h"

namespace sbeh::surface3d {

namespace {

// Of the linear systems: what is left of a correction is met by the next one.
constexpr double roughly = 0.03;

}  // namespace

StepMatrix::StepMatrix(const StepLayout& layout, const Numerics& numerics)
    : layout_(layout),
      gmres_(Symmetry::symmetric,
             numerics.factorisation == Factorisation::every_step ? Gmres::exact : roughly) {}

// The matrix without its borders.
void StepMatrix::set_sum(const StepResistance& resistance) {
  sum_ = resistance.matrix;
  const double* entry = energy_.hessian.valuePtr();
  for (const int place : layout_.places) sum_.valuePtr()[place] += *entry++;
}

Eigen::MatrixXd StepMatrix::borders(const StepResistance& resistance,
                                    const Eigen::MatrixX2d& constraints) const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(layout_.size(), 9);
  all(layout_.unknowns, {0, 1}) = constraints;
  all.rightCols<7>() = resistance.borders;
  return all;
}

bool StepMatrix::factor(const model::Material& material, const StationaryState& state,
                        const Nodes& normals, const StepResistance& resistance) {
  assemble(material, layout_.state, state, normals, energy_);
  if (!energy_.gradient.allFinite()) return false;
  set_sum(resistance);
  set_bordered(sum_, borders(resistance, energy_.constraints), bordered_);
  if (!gmres_.factor(bordered_)) return false;
  const Triangulation& mesh = layout_.state.mesh;
  const int multipliers = mesh.nodes + mesh.quadratic_nodes + 8;
  minimum_ = gmres_.negative_eigenvalues() == multipliers;
  return true;
}

void StepMatrix::begin(const StepResistance& resistance) {
  resistance_ = &resistance;
  set_sum(resistance);
}

int StepMatrix::solve(const Eigen::MatrixX2d& constraints, const Eigen::VectorXd& rhs,
                      Eigen::VectorXd& x) const {
  const Eigen::MatrixXd B = borders(*resistance_, constraints);
  const Eigen::Index n = layout_.size();
  const auto apply = [&](const Eigen::VectorXd& v) {
    Eigen::VectorXd y(n + 9);
    y.head(n) = product(sum_, v.head(n)) + B * v.tail<9>();
    y.tail<9>() = B.transpose() * v.head(n);
    return y;
  };
  return gmres_.solve(apply, rhs, x);
}

}  // namespace sbeh::surface3d
