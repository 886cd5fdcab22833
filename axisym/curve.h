// The generating curve of an axisymmetric surface and its P3 elements.
//
// The curve runs from the north pole (r = 0) to the south pole (r = 0). With the unit tangent t and
// ν = (−z', r')/|X'| outward, the frame of model/terms.h is (e1, e2, ν) = (t, e_φ, ν).
#pragma once

#include "model/numerics/area_volume.h"
#include "model/numerics/profile.h"

#include <Eigen/Core>

#include <array>
#include <span>

namespace sbeh::axisym {

/// Positions of the nodes, row 0: r >= 0, row 1: z; 3 elements + 1 columns, in order along the curve.
/// Element e owns the nodes 3e … 3e + 3.
using Nodes = Eigen::Matrix2Xd;
/// A scalar in P3: one value per node.
using Field = Eigen::VectorXd;

using model::element_count;

/// The state that evolves: position and order at the nodes. A value: copying it is a checkpoint.
using State = model::Profile;

/// A state at rest with what holds it there: a critical point of the Lagrangian of stationary/stationary.h (or a guess of one).
struct StationaryState : State {
  Field H{};  // nodes, mean curvature
  Field Lambda{};  // nodes, multiplier of the curvature equation, about −(κ(H − H₀) + κ_G B_φφ)
  double tension = 0;   ///< Σ = −∂U/∂A
  double pressure = 0;  ///< P = ∂U/∂V
  double moment = 0;    ///< c = −∂U/∂W₂⁰ of the area difference (model/material.h)
  double chemical_potential = 0;  ///< μ_β = ∂U/∂∫β dS of an order that is conserved
};

/// Shape functions of one element at one quadrature point; derivatives by the element's own
/// coordinate in [0, 1].
struct ShapeValues {
  double x;                    ///< where in [0, 1]
  double weight;               ///< quadrature weight, summing to 1
  std::array<double, 4> phi;   ///< P3
  std::array<double, 4> dphi;  ///< P3, derivative
  std::array<double, 4> phi2;  ///< P2, padded with a zero
};

/// Gauss points of the assembly (6 per element) and of the diagnostics (10 per element).
std::span<const ShapeValues> assembly_points();
std::span<const ShapeValues> diagnostic_points();

/// Shape functions at x in [0, 1], weight 0.
ShapeValues shape_values(double x);

/// Shape functions at 0, 1/pieces, …, 1 of an element, weight 0.
template <int pieces>
const std::array<ShapeValues, pieces + 1>& even_points() {
  static const auto points = [] {
    std::array<ShapeValues, pieces + 1> at{};
    for (int k = 0; k <= pieces; ++k) at[std::size_t(k)] = shape_values(double(k) / pieces);
    return at;
  }();
  return points;
}

/// Value and derivative of a P3 field on element e at a point.
inline double value_at(const Field& f, int e, const ShapeValues& s) {
  double sum = 0;
  for (int a = 0; a < 4; ++a) sum += s.phi[a] * f[3 * e + a];
  return sum;
}
inline double slope_at(const Field& f, int e, const ShapeValues& s) {
  double sum = 0;
  for (int a = 0; a < 4; ++a) sum += s.dphi[a] * f[3 * e + a];
  return sum;
}

/// Geometry of the curve at a point of an element.
struct CurvePoint {
  Eigen::Vector2d x;   ///< (r, z)
  Eigen::Vector2d dx;  ///< derivative by the element's coordinate
  double stretch;      ///< |dx|
  Eigen::Vector2d t;   ///< unit tangent, northpole → southpole
  Eigen::Vector2d nu;  ///< outward unit normal (−t_z, t_r)
  double B_phi;        ///< B_φφ = −ν_r/r, −1 on the unit sphere; r > 0 needed
  double dS;           ///< 2π r |dx| weight: the area this quadrature point stands for
};
CurvePoint curve_point(const Nodes& X, int e, const ShapeValues& s);

/// Unit normals at the nodes: element normals inside, the normalised mean of both at the joints,
/// ±e_z at the poles; 2 x nodes.
Nodes node_normals(const Nodes& X);

/// Calls visit(e, shape values, curve point) at every quadrature point.
template <class Visit>
void for_each_point(const Nodes& X, std::span<const ShapeValues> points, Visit&& visit) {
  for (int e = 0; e < element_count(X); ++e)
    for (const ShapeValues& s : points) visit(e, s, curve_point(X, e, s));
}

/// Total area A = ∫ dS and enclosed volume V = −∫ π r² dz.
double area(const Nodes& X);
double volume(const Nodes& X);
using model::reduced_volume;
/// So near the sphere that area and volume are one constraint: V_r > 1 − 1e-7.
inline bool is_sphere(double area, double volume) {
  return reduced_volume(area, volume) > 1 - 1e-7;
}

/// Length of every element, by quadrature.
Eigen::VectorXd element_lengths(const Nodes& X);

}  // namespace sbeh::axisym
