// The monolithic scheme: Y is an unknown of the flow, with the mesh equations as they stand.
#pragma once

#include "surface3d/mesh_equation.h"

namespace sbeh::surface3d {

/// See Split, which has the same members.
class Monolithic {
 public:
  static constexpr bool has_displacement = true;
  void begin(const Triangulation&, const Nodes&, double) {}
  void add(const Triangulation&, const MovingTriangle& t, const MeshEquation& equation,
           FlowPiece& piece) const {
    equation.set_rows(t, piece);
  }
  void end(const Triangulation&) {}
  const LinearSystem& motion() const { return none_; }
  Eigen::VectorXd motion_rhs(const Nodes&, const Field&) const { return {}; }
  Nodes displacement(const Nodes&, const Eigen::VectorXd& Y, const Eigen::VectorXd&) const {
    return Y.reshaped(3, Y.size() / 3);
  }

 private:
  LinearSystem none_;
};

}  // namespace sbeh::surface3d
