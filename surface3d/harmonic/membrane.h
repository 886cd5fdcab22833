// A membrane by spherical harmonics of its Cartesian coordinates and of its order, over material labels: a witness of the
// flow that has no triangles and shares nothing with the finite elements but the energy per area.
#pragma once

#include "model/energy.h"
#include "model/material.h"
#include "surface3d/harmonic/basis.h"

#include <Eigen/Core>

#include <optional>

namespace sbeh::surface3d {

/// x(ω) = Σ X_lm Y_lm(ω) and β(ω) = Σ β_lm Y_lm(ω), where the unit vector ω names a material point. Or their rates.
struct HarmonicMembrane {
  Eigen::MatrixX3d X;    // (degree + 1)² x 3
  Eigen::VectorXd beta;  // (degree + 1)²
};

/// The energy of such membranes, a sum over the points of sphere_rule, with its exact derivatives, and how they flow: the
/// velocity that balances them among fields of the same degree.
class HarmonicMechanics {
 public:
  /// Throws std::invalid_argument for what it does not have: a global constraint of the area, an area difference, an order that
  /// is conserved; and unless 4 <= degree <= 32.
  HarmonicMechanics(const model::Material& material, model::Model model, int degree);

  int degree() const { return basis_.degree; }
  const Eigen::Matrix3Xd& points() const { return basis_.omega; }

  /// The membrane through x and β at points(), 3 x n and n, by least squares, which its quadrature makes a sum.
  HarmonicMembrane through(const Eigen::Matrix3Xd& x, const Eigen::VectorXd& beta) const;

  struct Measures {
    model::Energy energy{};
    double area = 0, volume = 0;
    double order_min = 0, order_mean = 0, order_max = 0;  ///< least and largest at points()
    Eigen::MatrixX3d by_X{};                              ///< ∂U/∂X_lm
    Eigen::VectorXd by_beta{};
  };
  /// Empty where the surface has no normal at a point.
  std::optional<Measures> measure(const HarmonicMembrane& membrane) const;

  struct Rates {
    HarmonicMembrane rate;  ///< V = Ẋ and β̇, 0 where the order is not free
    model::Dissipation dissipation{};
  };
  /// Minimises the dissipation/2 + dU/dt over V and β̇ with (Div_C V, q) = 0 for all q dS = Y_lm dω, l < degree, and no change of
  /// the volume: (V1), (V2), (B1). Empty as measure().
  std::optional<Rates> rates(const HarmonicMembrane& membrane) const;

 private:
  model::Material material_;
  bool free_order_;
  HarmonicBasis basis_;
  Eigen::VectorXd weights_;  // points
};

}  // namespace sbeh::surface3d
