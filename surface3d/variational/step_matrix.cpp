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
                                    const LagrangianGradient& energy) const {
  const int of_energy = energy.multipliers();
  Eigen::MatrixXd all =
      Eigen::MatrixXd::Zero(layout_.size(), of_energy + resistance.borders.cols());
  all(layout_.unknowns, Eigen::seqN(0, of_energy)) = energy.constraints;
  all.rightCols<7>() = resistance.borders;
  return all;
}

bool StepMatrix::factor(const model::Material& material, const StationaryState& state,
                        const Nodes& normals, const StepResistance& resistance) {
  assemble(material, layout_.state, state, normals, energy_);
  if (!energy_.gradient.allFinite()) return false;
  set_sum(resistance);
  set_bordered(sum_, borders(resistance, energy_), energy_.corner, bordered_);
  if (!gmres_.factor(bordered_)) return false;
  const Triangulation& mesh = layout_.state.mesh;
  const int multipliers = mesh.nodes + mesh.quadratic_nodes + energy_.multipliers()
                        + int(resistance.borders.cols()) - 1;
  minimum_ = gmres_.negative_eigenvalues() == multipliers;
  return true;
}

void StepMatrix::begin(const StepResistance& resistance) {
  resistance_ = &resistance;
  set_sum(resistance);
}

int StepMatrix::solve(const LagrangianGradient& energy, const Eigen::VectorXd& rhs,
                      Eigen::VectorXd& x) const {
  const Eigen::MatrixXd B = borders(*resistance_, energy);
  const Eigen::Index n = layout_.size(), m = B.cols();
  const auto apply = [&](const Eigen::VectorXd& v) {
    Eigen::VectorXd y(n + m);
    y.head(n) = product(sum_, v.head(n)) + B * v.tail(m);
    y.tail(m) = B.transpose() * v.head(n);
    const Eigen::Index corner = energy.corner.size();
    y.segment(n, corner) += energy.corner.cwiseProduct(v.segment(n, corner));
    return y;
  };
  return gmres_.solve(apply, rhs, x);
}

}  // namespace sbeh::surface3d
