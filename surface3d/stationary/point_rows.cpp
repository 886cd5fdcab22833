#include "surface3d/stationary/point_rows.h"

namespace sbeh::surface3d::at_point {

Rows::Rows(const ElementNodes& normals, const BentShapes& s, bool bent) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Shape n = normals.row(Eigen::Index(k)).transpose();
    const auto along = [&](std::size_t kind, const std::array<double, 10>& shape) {
      Shape& product = along_[3 * kind + k];
      product = n.cwiseProduct(Shapes(shape.data()));
      return product.data();
    };
    const double *phi = along(0, s.phi), *phi_1 = along(1, s.dphi[0]), *phi_2 = along(2, s.dphi[1]);
    rows[raw_x + k] = {unknown_d, phi};
    rows[raw_a1 + k] = {unknown_d, phi_1};
    rows[raw_a2 + k] = {unknown_d, phi_2};
    rows[raw_Lambda + k] = {unknown_Lambda, phi};
    rows[raw_Lambda_1 + k] = {unknown_Lambda, phi_1};
    rows[raw_Lambda_2 + k] = {unknown_Lambda, phi_2};
    rows[raw_a11 + k] = {unknown_d, bent ? along(3, s.ddphi[0]) : phi};
    rows[raw_a12 + k] = {unknown_d, bent ? along(4, s.ddphi[1]) : phi};
    rows[raw_H + k] = {unknown_H, s.phi.data()};
  }
  rows[raw_order] = {unknown_beta, s.phi.data()};
  rows[raw_order + 1] = {unknown_beta, s.dphi[0].data()};
  rows[raw_order + 2] = {unknown_beta, s.dphi[1].data()};
}

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

}  // namespace sbeh::surface3d::at_point
