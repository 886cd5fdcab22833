#include "surface3d/linear/conjugate_gradient.h"

#include <limits>

namespace sbeh::surface3d {

namespace {

constexpr double tolerance = 1e-14;  // of the residual, relative to the right-hand side
constexpr int most_iterations = 300;
constexpr double accepted = 1e-11;  // rounding may keep the residual above the tolerance

// Right-hand sides and solutions are the rows.
template <int Rows>
using Packed = Eigen::Matrix<double, Rows, Eigen::Dynamic>;
template <int Rows>
using Numbers = Eigen::Array<double, Rows, 1>;

template <int Rows>
Numbers<Rows> dot(const Packed<Rows>& a, const Packed<Rows>& b) {
  Numbers<Rows> sum = Numbers<Rows>::Zero();
  for (Eigen::Index i = 0; i < a.cols(); ++i) sum += a.col(i).array() * b.col(i).array();
  return sum;
}

template <int Rows>
void multiply(const SparseMatrix& A, const Packed<Rows>& x, Packed<Rows>& product) {
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    Eigen::Matrix<double, Rows, 1> sum = Eigen::Matrix<double, Rows, 1>::Zero();
    for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
      sum += entry.value() * x.col(entry.index());
    product.col(i) = sum;
  }
}

template <int Rows>
void solve(const SparseMatrix& A, const Packed<Rows>& rhs, Packed<Rows>& x) {
  const Eigen::VectorXd inverse_diagonal = A.diagonal().cwiseInverse();
  Packed<Rows> image(Rows, x.cols());
  multiply(A, x, image);
  Packed<Rows> residual = rhs - image, direction = residual * inverse_diagonal.asDiagonal();
  Numbers<Rows> slope = dot(residual, direction), square = dot(residual, residual);
  const Numbers<Rows> size = dot(rhs, rhs), wanted = tolerance * tolerance * size;
  for (int k = 0; k < most_iterations && !(square <= wanted).all(); ++k) {
    multiply(A, direction, image);
    // Rows that are solved stay as they are.
    const Numbers<Rows> step =
        (square > wanted).select(slope / dot(direction, image), Numbers<Rows>::Zero());
    Numbers<Rows> next = Numbers<Rows>::Zero();
    square.setZero();
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      x.col(i).array() += step * direction.col(i).array();
      residual.col(i).array() -= step * image.col(i).array();
      const Numbers<Rows> squares = residual.col(i).array().square();
      square += squares;
      next += inverse_diagonal[i] * squares;
    }
    const Numbers<Rows> turn = (slope > 0).select(next / slope, Numbers<Rows>::Zero());
    slope = next;
    for (Eigen::Index i = 0; i < x.cols(); ++i)
      direction.col(i).array() =
          inverse_diagonal[i] * residual.col(i).array() + turn * direction.col(i).array();
  }
  if (!(square <= accepted * accepted * size).all())
    x.setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

Eigen::VectorXd solve_mass(const SparseMatrix& mass, const Eigen::VectorXd& rhs,
                           const Eigen::VectorXd& guess) {
  Packed<1> x = guess.transpose();
  solve<1>(mass, rhs.transpose(), x);
  return x.transpose();
}

// A fourth row, of zeros, fills the vector registers.
Eigen::Matrix3Xd solve_mass(const SparseMatrix& mass, const Eigen::Matrix3Xd& rhs,
                            const Eigen::Matrix3Xd& guess) {
  Packed<4> b = Packed<4>::Zero(4, rhs.cols()), x = b;
  b.topRows<3>() = rhs;
  x.topRows<3>() = guess;
  solve<4>(mass, b, x);
  return x.topRows<3>();
}

}  // namespace sbeh::surface3d
