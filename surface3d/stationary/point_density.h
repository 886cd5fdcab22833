// Densities of the Lagrangian as functions of what a triangle has at a point, with first and second derivatives: automatic
// ones by the invariants that they read, known ones of these by the point's vectors.
#pragma once

#include "model/numerics/second_order.h"
#include "surface3d/stationary/lagrangian.h"

namespace sbeh::surface3d::at_point {

using model::SecondOrder;

/// What is read of a triangle at a point, in vectors of three numbers; numbers are where their vector begins.
enum RawData {
  raw_a1 = 0,
  raw_a2 = 3,
  raw_a11 = 6,
  raw_a12 = 9,
  raw_x = 12,
  raw_Lambda = 15,
  raw_Lambda_1 = 18,
  raw_Lambda_2 = 21,
  raw_order = 24,  // β, β_1, β_2
  raw_H = 27,      // H and two that are not used
  raw_data = 30
};
using Raw = Eigen::Matrix<double, raw_data, 1>;

/// Value and gradient of a density by the raw data, and its Hessian.
struct RawGradient {
  double value = 0;
  Raw gradient = Raw::Zero();
};
struct RawDerivatives : RawGradient {
  Eigen::Matrix<double, raw_data, raw_data> hessian =
      Eigen::Matrix<double, raw_data, raw_data>::Zero();
};

/// A product of two vectors, or a component.
struct Invariant {
  int first, second;  // where the vectors begin; of a component: which, and −1
};
template <std::size_t N>
using Invariants = std::array<Invariant, N>;
inline constexpr Invariant g11{raw_a1, raw_a1}, g12{raw_a1, raw_a2}, g22{raw_a2, raw_a2},
    beta{raw_order, -1}, beta_1{raw_order + 1, -1}, beta_2{raw_order + 2, -1};
inline constexpr Invariants<energy_data> energy_invariants{g11,    g12,    g22,        beta,
                                                           beta_1, beta_2, {raw_H, -1}};
inline constexpr Invariants<divergence_data> divergence_invariants{g11,
                                                                   g12,
                                                                   g22,
                                                                   {raw_a1, raw_Lambda_1},
                                                                   {raw_a1, raw_Lambda_2},
                                                                   {raw_a2, raw_Lambda_1},
                                                                   {raw_a2, raw_Lambda_2}};
inline constexpr Invariants<gaussian_data> gaussian_invariants{g11,
                                                               g12,
                                                               g22,
                                                               beta,
                                                               beta_1,
                                                               beta_2,
                                                               {raw_a11, raw_a1},
                                                               {raw_a11, raw_a2},
                                                               {raw_a12, raw_a1},
                                                               {raw_a12, raw_a2}};
inline constexpr Invariants<rim_data> rim_invariants{g11, g12, g22, beta, beta_1, beta_2};
inline constexpr Invariants<3> metric_invariants{g11, g12, g22};
inline constexpr Invariants<lipid_data> lipid_invariants{g11, g12, g22, beta};

inline auto vector(const Raw& q, int first) { return q.segment<3>(first); }

inline double value_of(const Invariant& k, const Raw& q) {
  return k.second < 0 ? q[k.first] : vector(q, k.first).dot(vector(q, k.second));
}
template <std::size_t N>
std::array<double, N> values_of(const Invariants<N>& invariants, const Raw& q) {
  std::array<double, N> values;
  for (std::size_t k = 0; k < N; ++k) values[k] = value_of(invariants[k], q);
  return values;
}
/// As the independent variables of automatic differentiation.
template <class Number, std::size_t N>
std::array<Number, N> variables(const Invariants<N>& invariants, const Raw& q) {
  std::array<Number, N> values;
  for (std::size_t k = 0; k < N; ++k) values[k] = Number(value_of(invariants[k], q), int(k));
  return values;
}

/// ∂(invariant) by the raw data: one vector or two.
struct Slope {
  struct Part {
    int first;
    Eigen::Vector3d along;
  };
  std::array<Part, 2> parts;
  int count;
};
inline Slope slope_of(const Invariant& k, const Raw& q) {
  if (k.second < 0) return {{{{k.first - k.first % 3, Eigen::Vector3d::Unit(k.first % 3)}, {}}}, 1};
  if (k.first == k.second) return {{{{k.first, 2 * vector(q, k.first)}, {}}}, 1};
  return {{{{k.first, vector(q, k.second)}, {k.second, vector(q, k.first)}}}, 2};
}

/// out += a function of invariants.
template <std::size_t N>
void add(const SecondOrder<int(N)>& f, const Invariants<N>& invariants, const Raw& q,
         RawDerivatives& out) {
  std::array<Slope, N> slopes;
  for (std::size_t k = 0; k < N; ++k) slopes[k] = slope_of(invariants[k], q);
  out.value += f.a;
  for (std::size_t k = 0; k < N; ++k) {
    const double rate = f.g[Eigen::Index(k)];
    for (int i = 0; i < slopes[k].count; ++i) {
      const auto& [row, along] = slopes[k].parts[std::size_t(i)];
      out.gradient.segment<3>(row) += rate * along;
      for (std::size_t l = 0; l < N; ++l) {
        const Eigen::Vector3d bent = f.h(Eigen::Index(k), Eigen::Index(l)) * along;
        for (int j = 0; j < slopes[l].count; ++j) {
          const auto& [column, other] = slopes[l].parts[std::size_t(j)];
          out.hessian.block<3, 3>(row, column).noalias() += bent * other.transpose();
        }
      }
    }
    const auto [first, second] = invariants[k];
    if (second < 0) continue;
    out.hessian.block<3, 3>(first, second).diagonal().array() += rate;
    out.hessian.block<3, 3>(second, first).diagonal().array() += rate;
  }
}

/// out += a function of invariants, by its value and gradient.
template <std::size_t N>
void add(double value, const Eigen::Matrix<double, int(N), 1>& rates,
         const Invariants<N>& invariants, const Raw& q, RawGradient& out) {
  out.value += value;
  for (std::size_t k = 0; k < N; ++k) {
    const Slope slope = slope_of(invariants[k], q);
    for (int i = 0; i < slope.count; ++i) {
      const auto& [row, along] = slope.parts[std::size_t(i)];
      out.gradient.segment<3>(row) += rates[Eigen::Index(k)] * along;
    }
  }
}

/// out += c w·(a1 × a2), w the vector that begins at `first`.
void add_box_product(double c, int first, const Raw& q, RawGradient& out);
void add_box_product(double c, int first, const Raw& q, RawDerivatives& out);

/// out += H Λ·(a1 × a2).
void add_normal_part(const Raw& q, RawGradient& out);
void add_normal_part(const Raw& q, RawDerivatives& out);

}  // namespace sbeh::surface3d::at_point
