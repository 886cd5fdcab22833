#include "model/numerics/constrained_newton.h"

#include <Eigen/Eigenvalues>

namespace sbeh::model {

using Eigen::MatrixXd, Eigen::VectorXd;

TangentSplit::TangentSplit(const MatrixXd& gradients)
    : normal_(gradients.cols()), tangential_(gradients.rows() - gradients.cols()), qr_(gradients) {}

MatrixXd TangentSplit::rotated(MatrixXd H) const {
  H.applyOnTheLeft(qr_.householderQ().adjoint());
  H.applyOnTheRight(qr_.householderQ());
  return H;
}

VectorXd TangentSplit::tangential(const VectorXd& v) const {
  return VectorXd(qr_.householderQ().adjoint() * v).tail(tangential_);
}

VectorXd TangentSplit::tangential_eigenvalues(const MatrixXd& H) const {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(H.bottomRightCorner(tangential_, tangential_),
                                                 Eigen::EigenvaluesOnly)
      .eigenvalues();
}

VectorXd TangentSplit::newton_step(const MatrixXd& H, const VectorXd& gradient,
                                   const VectorXd& miss, const Solve& solve) const {
  VectorXd step(normal_ + tangential_);
  step.head(normal_) = qr_.matrixQR()
                           .topLeftCorner(normal_, normal_)
                           .triangularView<Eigen::Upper>()
                           .transpose()
                           .solve(-miss);
  step.tail(tangential_) =
      solve(H.bottomRightCorner(tangential_, tangential_),
            -tangential(gradient) - H.bottomLeftCorner(tangential_, normal_) * step.head(normal_));
  return qr_.householderQ() * step;
}

}  // namespace sbeh::model
