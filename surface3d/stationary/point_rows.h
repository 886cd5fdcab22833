// What a triangle has at a point, as linear functions of the unknowns at its nodes; sums of the derivatives of densities by these.
#pragma once

#include "surface3d/bent_shapes.h"
#include "surface3d/stationary/point_density.h"

#include <array>

namespace sbeh::surface3d::at_point {

inline constexpr int unknown_d = 10 * node_d, unknown_Lambda = 10 * node_Lambda,
                     unknown_H = 10 * node_H, unknown_beta = 10 * node_beta,
                     element_unknowns = 10 * node_unknowns;

struct ElementState {
  ElementNodes X, normals, Lambda;
  ElementField H, beta;
};
ElementState on_element(const StationaryState& state, const Nodes& normals,
                        const Triangulation& mesh, int e);
Raw raw_data_of(const ElementState& state, const BentShapes& s);

/// What a density's rates by the raw data are by the positions and Λ of a triangle's nodes, in space, and by H and β there.
struct NodeRates {
  using Vectors = Eigen::Matrix<double, 10, 3>;
  Vectors X = Vectors::Zero(), Lambda = Vectors::Zero();
  ElementField H = ElementField::Zero(), beta = ElementField::Zero();

  /// += weight times the rates by the data of these vectors.
  template <RawData... vectors>
  void add(const Raw& rates, const BentShapes& s, double weight) {
    (add_one<vectors>(weight * vector(rates, vectors), s), ...);
  }
  /// By the unknowns.
  Eigen::Matrix<double, element_unknowns, 1> along(const ElementNodes& normals) const;

 private:
  template <RawData first>
  void add_one(const Eigen::Vector3d& rate, const BentShapes& s) {
    const auto& shape = first == raw_a1 || first == raw_Lambda_1 ? s.dphi[0]
                      : first == raw_a2 || first == raw_Lambda_2 ? s.dphi[1]
                      : first == raw_a11                         ? s.ddphi[0]
                      : first == raw_a12                         ? s.ddphi[1]
                                                                 : s.phi;
    Vectors& of = first >= raw_Lambda ? Lambda : X;
    for (std::size_t a = 0; a < 10; ++a) {
      const auto i = Eigen::Index(a);
      if constexpr (first == raw_order)
        beta[i] += rate[0] * s.phi[a] + rate[1] * s.dphi[0][a] + rate[2] * s.dphi[1][a];
      else if constexpr (first == raw_H)
        H[i] += rate[0] * s.phi[a];
      else
        for (int k = 0; k < 3; ++k) of(i, k) += rate[k] * shape[a];
    }
  }
};

/// A sum of Hessians of densities, by the unknowns of a triangle: ΣTᵀ D T, T the raw data by the unknowns. Blocks that are 0 whatever the
/// density are left out: Λ enters linearly, and meets no order; x meets nothing but a_1, a_2.
class HessianSums {
 public:
  explicit HessianSums(const ElementNodes& normals);

  /// At an inner point; `bent`: the density reads a_11, a_12.
  void add_inner(const RawDerivatives& density, const BentShapes& s, double weight, bool bent);
  /// Of a density that reads a_1, a_2 and the order.
  void add_rim(const RawDerivatives& density, const BentShapes& s, double weight);
  Eigen::Matrix<double, element_unknowns, element_unknowns> symmetric() const;

 private:
  static constexpr int padded = 16;  // rows of ten, filled up to whole vector registers
  using Block = Eigen::Matrix<double, 10, padded, Eigen::RowMajor>;
  struct Place {
    int row, column;
  };
  enum BlockName { d_d, d_Lambda, d_H, d_beta, Lambda_H, H_H, H_beta, beta_beta, blocks };
  static constexpr std::array<Place, blocks> places{{{unknown_d, unknown_d},
                                                     {unknown_d, unknown_Lambda},
                                                     {unknown_d, unknown_H},
                                                     {unknown_d, unknown_beta},
                                                     {unknown_Lambda, unknown_H},
                                                     {unknown_H, unknown_H},
                                                     {unknown_H, unknown_beta},
                                                     {unknown_beta, unknown_beta}}};

  void set_rows(const BentShapes& s, bool bent);
  template <int test, int tests, int trial, int trials>
  void add(const RawDerivatives& density, double weight, BlockName name);
  template <int moved>
  void add_moved(const RawDerivatives& density, double weight);

  ElementNodes normals_;
  Eigen::Matrix<double, raw_data, padded, Eigen::RowMajor> rows_ = decltype(rows_)::Zero();  // T
  std::array<Block, blocks> sums_;
};

}  // namespace sbeh::surface3d::at_point
