// Axisymmetric curves by the Fourier series of their tangent angle.
//
// On the whole curve, x ∈ [0, 1] from pole to pole, s = ℓσ(x) the arc length:
//   ψ(x) = πx + Σ b_k sin(kπx),  dr/ds = cos ψ,  dz/ds = −sin ψ,  outward normal (sin ψ, cos ψ),
//   β(x) = Σ c_k cos(kπx).
// σ(x) = x, or a fixed function which gathers the points at a narrow rim. The poles are smooth by
// construction. All functions are even or odd about both poles and periodic: interpolation by sines
// and cosines, and the quadratures which follow from it, converge geometrically. Shapes symmetric top
// to bottom have even k alone.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace sbeh::axisym::spectral {

/// Whether curves are symmetric top to bottom.
enum class Symmetry { none, top_bottom };

/// dσ/dx ∝ (1 − a cos π(x − x₀)) (1 − a cos π(x + x₀)): the points gather at x₀. x₀ = 1/2 for symmetric
/// curves.
struct Grading {
  double a = 0;  ///< 0: none, < 1
  double x0 = 0.5;
  auto operator<=>(const Grading&) const = default;

  double sigma(double x) const;  ///< σ(x), 0 and 1 at the poles
  double slope(double x) const;  ///< dσ/dx
  double inverse(double sigma) const;
};

/// Collocation points and the trigonometric functions on them, or those of rim/basis.h. Symmetric bases
/// hold half the curve.
struct Basis {
  Symmetry symmetry;
  Grading grading;
  int cutoff;             // largest k, 0 for those of rim/basis.h
  std::vector<int> k;     // n wave numbers of the angle: 1, 2, 3 … or 2, 4, 6 …, or none
  Eigen::VectorXd x;      // N points
  Eigen::VectorXd dx;     // N: dx/dσ
  Eigen::VectorXd even;   // N weights of ∫ dσ over the whole curve for even functions
  Eigen::VectorXd odd;    // N weights for odd functions
  Eigen::MatrixXd S, dS;  // N x n: sin(kπx) and its derivative by σ
  Eigen::MatrixXd C, dC;  // N x (n + 1): cos(kπx), k = 0 first, and its derivative by σ
  Eigen::MatrixXd M;  // N x N: f ↦ ∫₀ˣ f dσ for f even and periodic; a mean of f dσ/dx is left out

  int modes() const { return int(S.cols()); }
  int points() const { return int(x.size()); }
};

/// Throws std::invalid_argument for cutoff < 2, and for symmetric bases with another x₀ than 1/2.
std::shared_ptr<const Basis> basis(Symmetry symmetry, int cutoff, const Grading& grading = {});

/// A curve. Coefficients beyond the cutoff of the basis are 0.
struct Curve {
  std::shared_ptr<const Basis> basis;
  double length = 0;  ///< ℓ
  Eigen::VectorXd b;  // n
};

/// The same curve on another basis; what that one cannot hold is dropped.
Curve on_basis(const Curve& curve, std::shared_ptr<const Basis> basis);
/// ψ at σ.
double angle(const Curve& curve, double sigma);

/// What the points of a curve know. r is divided by ℓ; the closure ∫cos ψ is taken out of it, so that
/// it is periodic also where the curve is not closed yet.
struct Angles {
  Eigen::VectorXd psi, dpsi, r;  // N: ψ, dψ/dσ, r/ℓ
};
Angles angles(const Curve& curve);
/// ∂(r/ℓ)/∂b, N x n.
Eigen::MatrixXd radius_jacobian(const Basis& basis, const Angles& at);

/// Points r, z of the whole curve at equal x, poles included; z = 0 halfway between the poles.
Eigen::Matrix2Xd profile(const Curve& curve, int intervals);
/// z of the first pole minus z of the last: 0 where the poles touch.
double pole_distance(const Curve& curve);

/// Curve of a polygon from pole to pole, to about the square of its spacing. Throws
/// std::invalid_argument for fewer than 4 points.
Curve curve_through(const Eigen::Matrix2Xd& profile, std::shared_ptr<const Basis> basis);
/// Spheroid of this reduced volume in (0, 1).
Curve spheroid(double reduced_volume, bool prolate, std::shared_ptr<const Basis> basis);
/// A sphere with a spherical invagination at the first pole, about this reduced volume in (0, 1).
Curve invaginated_sphere(double reduced_volume, std::shared_ptr<const Basis> basis);

}  // namespace sbeh::axisym::spectral
