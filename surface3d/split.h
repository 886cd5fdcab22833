// The split scheme: the mesh equations one after the other, most of them apart from the flow.
//
// The nodes move along their normals by the normal part of τV. With this displacement in (H1), tested along
// the node normals, V, p, H, λ stand alone; the tangential part of Y follows from (H1), tested tangentially,
// with these V and H, and then the normal part, but little different from that of τV, from (Y1).
#pragma once

#include "surface3d/mesh_equation.h"

#include <array>
#include <vector>

namespace sbeh::surface3d {

class Split {
 public:
  explicit Split(const Triangulation& mesh) : pattern_(motion_pattern(mesh)) {}

  /// Whether Y is an unknown of the flow.
  static constexpr bool has_displacement = false;
  /// Before the triangles are added; normals: of the nodes of the old surface.
  void begin(const Triangulation& mesh, const Nodes& normals, double tau);
  /// What a triangle adds to the rows G and Z of the flow, and to the motion of the mesh.
  void add(const Triangulation& mesh, const MovingTriangle& t, const MeshEquation& equation,
           FlowPiece& piece);
  /// After all have been added.
  void end(const Triangulation& mesh);

  /// Where Y is not one of the flow: its tangential part, two components for each node, symmetric and
  /// positive definite. The right-hand side lacks what depends on the flow, see motion_rhs.
  const LinearSystem& motion() const { return motion_; }
  Eigen::VectorXd motion_rhs(const Nodes& V, const Field& H) const;
  /// Y, 3 x nodes, by its unknowns in the flow, or by a solution of `motion`; NaN where the surface is too
  /// degenerate for (Y1).
  Nodes displacement(const Nodes& V, const Eigen::VectorXd& Y, const Eigen::VectorXd& motion) const;

 private:
  struct Triangle {
    Eigen::Matrix<int, 10, 1> nodes;
    MeshEquation equation;
  };
  void add_to_flow(const MovingTriangle& t, const MeshEquation& equation, FlowPiece& piece) const;
  void add_to_motion(const Triangulation& mesh, const MovingTriangle& t,
                     const MeshEquation& equation);
  Nodes along_normals(const Nodes& V) const;

  SparsePattern pattern_;
  LinearSystem motion_;
  double tau_ = 0;
  Nodes node_normals_;               // 3 x nodes, of the old surface
  std::array<Nodes, 2> tangents_;    // 3 x nodes, unit, orthogonal to each other and to the normals
  SparseMatrix normal_flux_;         // of (Y1) along the node normals: (n_b·ν φ_b, φ_a)
  std::vector<Triangle> triangles_;  // of this rank
  Ranks ranks_;
};

}  // namespace sbeh::surface3d
