#include "surface3d/monolithic.h"

namespace sbeh::surface3d {

void Monolithic::add(const Triangulation&, const MovingTriangle& t, const MeshEquation& equation,
                     FlowPiece& piece) const {
  const ElementNodes rhs = equation.rhs(t.tau, t.from, t.H_from);
  for (int k = 0; k < 3; ++k) {
    const MeshEquation::Scalar& normal_mass = equation.normal_mass[std::size_t(k)];
    const int V = FlowPiece::V + 10 * k, Y = FlowPiece::Y + 10 * k, Z = FlowPiece::Z + 10 * k;
    piece.block(FlowPiece::G, V) = -t.tau * normal_mass;  // (Y1)
    piece.block(FlowPiece::G, Y) = normal_mass;           // (Y1)
    piece.block(Z, FlowPiece::H) = normal_mass;           // (H1)
    piece.block(Z, Y) = equation.stiffness;               // (H1)
    piece.rhs.segment<10>(Z) = rhs.row(k).transpose();    // (H1)
  }
}

}  // namespace sbeh::surface3d
