#include "surface3d/stationary/point_rows.h"

namespace sbeh::surface3d::at_point {

ElementState on_element(const StationaryState& state, const Nodes& normals,
                        const Triangulation& mesh, int e) {
  ElementState local{surface3d::on_element(mesh, e, state.X),
                     surface3d::on_element(mesh, e, normals),
                     {},
                     surface3d::on_element(mesh, e, state.H),
                     surface3d::on_element(mesh, e, state.beta)};
  local.Lambda = local.normals * surface3d::on_element(mesh, e, state.Lambda).asDiagonal();
  return local;
}

Raw raw_data_of(const ElementState& state, const BentShapes& s) {
  Raw q = Raw::Zero();
  const Shapes phi(s.phi.data()), phi_1(s.dphi[0].data()), phi_2(s.dphi[1].data());
  q.segment<3>(raw_a1) = state.X * phi_1;
  q.segment<3>(raw_a2) = state.X * phi_2;
  q.segment<3>(raw_a11) = state.X * Shapes(s.ddphi[0].data());
  q.segment<3>(raw_a12) = state.X * Shapes(s.ddphi[1].data());
  q.segment<3>(raw_x) = state.X * phi;
  q.segment<3>(raw_Lambda) = state.Lambda * phi;
  q.segment<3>(raw_Lambda_1) = state.Lambda * phi_1;
  q.segment<3>(raw_Lambda_2) = state.Lambda * phi_2;
  q.segment<3>(raw_order) << state.beta.dot(phi), state.beta.dot(phi_1), state.beta.dot(phi_2);
  q[raw_H] = state.H.dot(phi);
  return q;
}

Eigen::Matrix<double, element_unknowns, 1> NodeRates::along(const ElementNodes& normals) const {
  Eigen::Matrix<double, element_unknowns, 1> rates;
  rates.segment<10>(unknown_d) = X.cwiseProduct(normals.transpose()).rowwise().sum();
  rates.segment<10>(unknown_Lambda) = Lambda.cwiseProduct(normals.transpose()).rowwise().sum();
  rates.segment<10>(unknown_H) = H;
  rates.segment<10>(unknown_beta) = beta;
  return rates;
}

HessianSums::HessianSums(const ElementNodes& normals) : normals_(normals) {
  for (Block& block : sums_) block.setZero();
}

void HessianSums::set_rows(const BentShapes& s, bool bent) {
  const auto set = [&](int row, const std::array<double, 10>& shape) {
    for (std::size_t a = 0; a < 10; ++a) rows_(row, Eigen::Index(a)) = shape[a];
  };
  const auto set_vector = [&](int first, const std::array<double, 10>& shape) {
    for (int k = 0; k < 3; ++k)
      for (std::size_t a = 0; a < 10; ++a)
        rows_(first + k, Eigen::Index(a)) = normals_(k, Eigen::Index(a)) * shape[a];
  };
  set_vector(raw_a1, s.dphi[0]);
  set_vector(raw_a2, s.dphi[1]);
  if (bent) set_vector(raw_a11, s.ddphi[0]);
  if (bent) set_vector(raw_a12, s.ddphi[1]);
  set_vector(raw_x, s.phi);
  set_vector(raw_Lambda, s.phi);
  for (int k = 0; k < 3; ++k) rows_.row(raw_Lambda_1 + k) = rows_.row(raw_a1 + k);
  for (int k = 0; k < 3; ++k) rows_.row(raw_Lambda_2 + k) = rows_.row(raw_a2 + k);
  set(raw_order, s.phi);
  set(raw_order + 1, s.dphi[0]);
  set(raw_order + 2, s.dphi[1]);
  set(raw_H, s.phi);
}

// Data test … test + tests − 1 against trial … trial + trials − 1.
template <int test, int tests, int trial, int trials>
void HessianSums::add(const RawDerivatives& density, double weight, BlockName name) {
  using Row = Eigen::Array<double, 1, padded>;
  std::array<Row, std::size_t(tests)> met;  // D T
  for (int i = 0; i < tests; ++i) {
    Row row = Row::Zero();
    for (int j = 0; j < trials; ++j)
      row += weight * density.hessian(trial + j, test + i) * rows_.row(trial + j).array();
    met[std::size_t(i)] = row;
  }
  Block& block = sums_[name];
  for (int a = 0; a < 10; ++a) {
    Row row = block.row(a).array();
    for (int i = 0; i < tests; ++i) row += rows_(test + i, a) * met[std::size_t(i)];
    block.row(a) = row.matrix();
  }
}

// By the first so many data of position, and the order.
template <int moved>
void HessianSums::add_moved(const RawDerivatives& density, double weight) {
  add<raw_a1, moved, raw_a1, moved>(density, weight, d_d);
  add<raw_a1, moved, raw_order, 3>(density, weight, d_beta);
  add<raw_order, 3, raw_order, 3>(density, weight, beta_beta);
}

void HessianSums::add_inner(const RawDerivatives& density, const BentShapes& s, double weight,
                            bool bent) {
  set_rows(s, bent);
  if (bent)
    add_moved<12>(density, weight);
  else
    add_moved<6>(density, weight);
  add<raw_a1, 6, raw_x, 3>(density, weight, d_d);
  add<raw_x, 3, raw_a1, 6>(density, weight, d_d);
  add<raw_a1, 6, raw_Lambda, 9>(density, weight, d_Lambda);
  add<raw_a1, 6, raw_H, 1>(density, weight, d_H);
  add<raw_Lambda, 3, raw_H, 1>(density, weight, Lambda_H);
  add<raw_H, 1, raw_H, 1>(density, weight, H_H);
  add<raw_H, 1, raw_order, 3>(density, weight, H_beta);
}

void HessianSums::add_rim(const RawDerivatives& density, const BentShapes& s, double weight) {
  set_rows(s, false);
  add_moved<6>(density, weight);
}

Eigen::Matrix<double, element_unknowns, element_unknowns> HessianSums::symmetric() const {
  Eigen::Matrix<double, element_unknowns, element_unknowns> all;
  all.setZero();
  for (std::size_t k = 0; k < blocks; ++k) {
    const auto [row, column] = places[k];
    all.block<10, 10>(row, column) = sums_[k].leftCols<10>();
    if (row != column) all.block<10, 10>(column, row) = sums_[k].leftCols<10>().transpose();
  }
  return all;
}

}  // namespace sbeh::surface3d::at_point
