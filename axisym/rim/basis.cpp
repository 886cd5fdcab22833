#include "axisym/rim/basis.h"

#include <Eigen/Dense>

#include <cmath>
#include <stdexcept>

namespace sbeh::axisym::spectral {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

// Zeros in [0, 1] of the orthogonal polynomials with these squared recurrence coefficients (Golub and
// Welsch), and the weights of their quadrature, summing to 1.
struct Quadrature {
  VectorXd x, weight;
};
template <class Coefficient>
Quadrature golub_welsch(int n, Coefficient&& squared) {
  MatrixXd J = MatrixXd::Zero(n, n);
  for (int i = 1; i < n; ++i) J(i, i - 1) = J(i - 1, i) = std::sqrt(squared(double(i)));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(J);
  return {(eigen.eigenvalues().array() + 1) / 2,
          eigen.eigenvectors().row(0).transpose().cwiseAbs2()};
}

Quadrature gauss(int n) {
  return golub_welsch(n, [](double i) { return i * i / (4 * i * i - 1); });
}

VectorXd lobatto(int degree) {
  VectorXd x(degree + 1);
  x[0] = 0, x[degree] = 1;
  x.segment(1, degree - 1) = golub_welsch(degree - 1, [](double i) {
                               return i * (i + 2) / ((2 * i + 1) * (2 * i + 3));
                             }).x;
  return x;
}

// Legendre polynomials of 2x − 1 up to this degree and their derivatives, a row per point.
struct Legendre {
  MatrixXd value, slope;
  Legendre(int degree, const VectorXd& x) : value(x.size(), degree + 1), slope(value) {
    const Eigen::ArrayXd t = 2 * x.array() - 1;
    value.col(0).setOnes();
    slope.col(0).setZero();
    for (int k = 1; k <= degree; ++k) {
      value.col(k) = t * value.col(k - 1).array() * (2 * k - 1) / k;
      slope.col(k) = 2. * (2 * k - 1) * value.col(k - 1);
      if (k == 1) continue;
      value.col(k) -= value.col(k - 2) * (k - 1.) / k;
      slope.col(k) += slope.col(k - 2);
    }
  }
};

// The polynomials that are 1 at one of the nodes and 0 at the others, at the points x, a row each.
struct Lagrange {
  MatrixXd value, slope;
  Lagrange(const VectorXd& nodes, const VectorXd& x) {
    const int degree = int(nodes.size()) - 1;
    const MatrixXd to_legendre = Legendre(degree, nodes).value.inverse();
    const Legendre at(degree, x);
    value = at.value * to_legendre;
    slope = at.slope * to_legendre;
  }
};

// σ at the joints, elements + 1.
VectorXd joints(const RimMesh& mesh) {
  constexpr double inner = 0.2;  // of the half, the first two elements
  VectorXd at(mesh.elements + 1);
  at[0] = 0;
  for (int e = 1; e <= mesh.elements; ++e)
    at[e] = e <= 2 ? e * inner / 2 : 0.5 - (0.5 - inner) * std::pow(mesh.ratio, e - 2);
  at[mesh.elements] = 0.5;
  return at;
}

// The antiderivatives at the Gauss points of the polynomials that are 1 at one of them, for length 1.
MatrixXd antiderivatives(const Quadrature& points) {
  const Index q = points.x.size();
  MatrixXd I(q, q);
  for (Index i = 0; i < q; ++i)
    I.row(i) =
        points.x[i] * points.weight.transpose() * Lagrange(points.x, points.x * points.x[i]).value;
  return I;
}

}  // namespace

VectorXd rim_nodes(const RimMesh& mesh) {
  const VectorXd at = joints(mesh), inside = lobatto(mesh.degree);
  VectorXd sigma(mesh.elements * mesh.degree + 1);
  for (int e = 0; e < mesh.elements; ++e)
    sigma.segment(e * mesh.degree, mesh.degree + 1) = at[e] + (at[e + 1] - at[e]) * inside.array();
  return sigma;
}

std::shared_ptr<const Basis> rim_basis(Rim rim, const RimMesh& mesh) {
  if (mesh.elements < 4 || mesh.degree < 2 || !(mesh.ratio > 0 && mesh.ratio < 1))
    throw std::invalid_argument("rim mesh: needs elements >= 4, degree >= 2 and 0 < ratio < 1");
  const Quadrature points = gauss(mesh.degree + 3);
  const Lagrange shape(lobatto(mesh.degree), points.x);
  const MatrixXd integral = antiderivatives(points);
  const VectorXd at = joints(mesh);
  const Index q = points.x.size(), N = mesh.elements * q, nodes = mesh.elements * mesh.degree + 1;

  auto B = std::make_shared<Basis>();
  B->symmetry = Symmetry::top_bottom;
  B->cutoff = 0;
  B->x.resize(N), B->even.resize(N);
  B->dx = VectorXd::Ones(N);
  B->M = MatrixXd::Zero(N, N);
  MatrixXd value = MatrixXd::Zero(N, nodes), slope = value;
  for (int e = 0; e < mesh.elements; ++e) {
    const double h = at[e + 1] - at[e];
    value.block(e * q, e * mesh.degree, q, mesh.degree + 1) = shape.value;
    slope.block(e * q, e * mesh.degree, q, mesh.degree + 1) = shape.slope / h;
    B->x.segment(e * q, q) = at[e] + h * points.x.array();
    B->even.segment(e * q, q) = 2 * h * points.weight;  // both halves
    B->M.block(e * q, e * q, q, q) = h * integral;
    B->M.block((e + 1) * q, e * q, N - (e + 1) * q, q).rowwise() =
        Eigen::RowVectorXd(h * points.weight.transpose());
  }
  B->odd = B->even;
  const Index angles = rim == Rim::smooth ? nodes - 2 : nodes - 1;  // ψ = 0 at the pole
  const Index orders = rim == Rim::sharp ? nodes - 1 : nodes;
  B->S = value.middleCols(1, angles), B->dS = slope.middleCols(1, angles);
  B->C = value.leftCols(orders), B->dC = slope.leftCols(orders);
  return B;
}

}  // namespace sbeh::axisym::spectral
