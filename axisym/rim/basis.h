// Elements of high degree along half of a symmetric curve, shrinking towards its rim.
//
// An alternative to the trigonometric bases of spectral/curve.h for rims of any sharpness. Near a rim the
// one-constant energy per length is (3L/4)|∂_s w|² with w = β exp(i√3ψ): the straight way from above to
// below leads past w = 0 where the tangent turns by less than π/√3, and through it otherwise. In the
// first case β and ψ are smooth at a scale β_rim that may be tiny. In the second β vanishes at the rim
// and ψ jumps; under the pressure it creeps with the logarithm of the distance ("Sharp rims" in
// model/equations.md), which the shrinking elements follow over many decades.
#pragma once

#include "axisym/spectral/curve.h"

namespace sbeh::axisym::spectral {

enum class Rim {
  smooth,  ///< ψ = π/2 there
  sharp,   ///< β = 0 there, and ψ takes the value that costs least
  free     ///< nothing is prescribed: for variations
};

/// Where the elements are on 0 <= σ <= 1/2, from pole to rim: two of a fifth of it, then each a `ratio` of
/// what is left.
struct RimMesh {
  int elements = 12;    ///< >= 4
  int degree = 10;      ///< of the polynomials, >= 2
  double ratio = 0.25;  ///< of what is left, the share beyond the next joint; 0 < ratio < 1
};

/// Continuous piecewise polynomials: ψ = πσ + Σ b_k S_k, β = Σ c_k C_k with the values at the elements'
/// Gauss–Lobatto nodes as coefficients, pole first. Only what knows no wave numbers can be done with
/// such a basis: angles, expansion, Hessian, minimisation.
std::shared_ptr<const Basis> rim_basis(Rim rim, const RimMesh& mesh = {});

/// σ at the nodes, 0 at the pole first, 1/2 at the rim last; elements x degree + 1.
Eigen::VectorXd rim_nodes(const RimMesh& mesh);

}  // namespace sbeh::axisym::spectral
