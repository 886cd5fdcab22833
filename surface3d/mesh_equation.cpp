#include "surface3d/mesh_equation.h"

#include "model/mesh_motion.h"

namespace sbeh::surface3d {

void MeshSums::add(const SurfacePoint& x, const Shapes& phi) {
  constexpr int stiffness = 30;
  for (int k = 0; k < 3; ++k)
    sums_.add_outer(0, 10 * k, decltype(sums_)::column(phi.data(), x.dS * x.nu()[k]), phi);
  for (const auto& slope : x.grad)
    sums_.add_outer(0, stiffness, decltype(sums_)::column(slope.data(), x.dS),
                    Shapes(slope.data()));
}

MeshEquation MeshSums::equation() const {
  const Eigen::Matrix<double, 10, 40> sums = sums_.dense();
  MeshEquation equation;
  for (int k = 0; k < 3; ++k) equation.normal_mass[std::size_t(k)] = sums.middleCols<10>(10 * k);
  equation.stiffness = sums.rightCols<10>();
  return equation;
}

Eigen::Matrix<double, 1, 10> MeshEquation::normal_flux(const ElementNodes& W) const {
  Eigen::Matrix<double, 1, 10> flux = decltype(flux)::Zero();
  for (int k = 0; k < 3; ++k) flux += W.row(k) * normal_mass[std::size_t(k)];
  return flux;
}

ElementNodes MeshEquation::mesh_force(const ElementField& H, const ElementNodes& Y) const {
  ElementNodes force = Y * stiffness;
  for (int k = 0; k < 3; ++k) force.row(k) += (normal_mass[std::size_t(k)] * H).transpose();
  return force;
}

ElementNodes MeshEquation::mesh_drive(const MovingTriangle& t) const {
  const double theta = model::mesh_share(t.tau);
  ElementNodes force = -theta * t.from * stiffness;  // (H1)
  for (int k = 0; k < 3; ++k)
    force.row(k) += (1 - theta) * (normal_mass[std::size_t(k)] * t.H_from).transpose();  // (H1)
  return force;
}

void MeshEquation::set_rows(const MovingTriangle& t, FlowPiece& piece) const {
  constexpr int G = FlowPiece::G, H = FlowPiece::H;
  const ElementNodes drive = mesh_drive(t);
  const Scalar normal_speed = normal_mass_along(t.node_normals).transpose();
  for (int k = 0; k < 3; ++k) {
    const int V = FlowPiece::V + 10 * k, Y = FlowPiece::Y + 10 * k, Z = FlowPiece::Z + 10 * k;
    piece.block(G, Y) = normal_mass[std::size_t(k)];  // (Y1)
    piece.block(G, V) =
        -t.tau * normal_speed * t.node_normals.row(k).transpose().asDiagonal();  // (Y1)
    piece.block(Z, H) = normal_mass[std::size_t(k)];                             // (H1)
    piece.block(Z, Y) = stiffness;                                               // (H1)
    piece.rhs.segment<10>(Z) = drive.row(k).transpose();                         // (H1)
  }
}

MeshEquation::Scalar MeshEquation::normal_mass_along(const ElementNodes& t) const {
  Scalar sum = Scalar::Zero();
  for (int k = 0; k < 3; ++k)
    sum += t.row(k).transpose().asDiagonal() * normal_mass[std::size_t(k)];
  return sum;
}

MeshEquation::Scalar MeshEquation::stiffness_between(const ElementNodes& t,
                                                     const ElementNodes& u) const {
  return stiffness.cwiseProduct(t.transpose() * u);
}

}  // namespace sbeh::surface3d
