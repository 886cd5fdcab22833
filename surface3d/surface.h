// A closed P3 surface, its fields, and its geometry at a point.
//
// With a1, a2 the derivatives of the position by the reference coordinates of a triangle, the frame of
// model/terms.h is e1 = a1/|a1|, e2 = ν × e1, ν = a1 × a2/|a1 × a2|, outward.
#pragma once

#include "meshing/curved_mesh.h"
#include "model/numerics/area_volume.h"
#include "model/terms.h"
#include "surface3d/linear/ranks.h"
#include "surface3d/linear/sparse_pattern.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <span>
#include <vector>

namespace sbeh::surface3d {

/// Positions (or vectors) at the nodes, 3 x nodes, Cartesian.
using Nodes = Eigen::Matrix3Xd;
/// A scalar in P3: one value per node.
using Field = Eigen::VectorXd;

/// Which nodes the triangles have, in P3 and in P2; fixed while the surface moves.
struct Triangulation {
  /// Of a mesh of order 3; throws std::invalid_argument for another order.
  explicit Triangulation(const meshing::CurvedMesh& mesh);
  /// The same triangles, parted among the ranks: what is computed with these is computed by all of them
  /// together, each adding up its own triangles.
  Triangulation(const Triangulation& whole, const Ranks& ranks);

  Eigen::Matrix<int, 10, Eigen::Dynamic> triangles;  // P3 nodes x triangles
  Eigen::Matrix<int, 6, Eigen::Dynamic> quadratic;   // P2 nodes x triangles: of the pressure
  int nodes;                                         ///< of P3
  int quadratic_nodes;                               ///< of P2
  SparsePattern scalars;                             ///< of matrices (P3, P3)
  Ranks ranks;                                       ///< which share the triangles
  std::vector<int> own;                              ///< triangles of this rank, ascending
  std::vector<int> place;                            ///< of each triangle among them, else −1
  /// Every triangle of this rank, in patches of neighbours; patches of one colour have no node in common.
  using Patch = std::vector<int>;
  std::vector<std::vector<Patch>> colours;
  int count() const { return int(triangles.cols()); }
};

/// The state that evolves: position and order. A value: copying it is a checkpoint.
struct State {
  Nodes X;
  Field beta;  // nodes
};

/// Shape functions at one quadrature point of the reference triangle.
struct ShapeValues {
  double weight;                               ///< summing to 1/2
  std::array<double, 10> phi;                  ///< P3
  std::array<std::array<double, 10>, 2> dphi;  ///< P3, by the two reference coordinates
  std::array<double, 10> quadratic;            ///< P2, padded with zeros
};

/// At a point of the reference triangle.
ShapeValues shape_values(const Eigen::Vector2d& x, double weight);

/// Quadrature points of the assembly (degree 10, with the symmetry of the triangle) and of the diagnostics (degree 12).
std::span<const ShapeValues> assembly_points();
std::span<const ShapeValues> diagnostic_points();
/// The ten nodes as points, weight 0.
std::span<const ShapeValues> node_points();

/// Geometry of the surface at a point of a triangle.
struct SurfacePoint {
  Eigen::Vector3d x;
  Eigen::Matrix3d frame;                       ///< columns e1, e2, ν
  std::array<std::array<double, 10>, 2> grad;  ///< ∇φ_a along e1, e2
  double dS;                                   ///< the area this quadrature point stands for
  Eigen::Vector3d nu() const { return frame.col(2); }
};

/// Nodal values on one triangle, in its order.
using ElementNodes = Eigen::Matrix<double, 3, 10>;
using ElementField = Eigen::Matrix<double, 10, 1>;
template <class Values>  // 3 x nodes
ElementNodes on_element(const Triangulation& mesh, int e, const Values& W) {
  ElementNodes local;
  for (int a = 0; a < 10; ++a) local.col(a) = W.col(mesh.triangles(a, e));
  return local;
}
inline ElementField on_element(const Triangulation& mesh, int e, const Field& f) {
  ElementField local;
  for (int a = 0; a < 10; ++a) local[a] = f[mesh.triangles(a, e)];
  return local;
}

SurfacePoint surface_point(const ElementNodes& X, const ShapeValues& s);

using Shapes = Eigen::Map<const Eigen::Matrix<double, 10, 1>>;
/// Value of a field, gradient along (e1, e2), and ∇_C in Cartesian components (3 x 2).
inline double value_at(const ElementField& f, const ShapeValues& s) {
  return f.dot(Shapes(s.phi.data()));
}
inline Eigen::Vector3d value_at(const ElementNodes& W, const ShapeValues& s) {
  return W * Shapes(s.phi.data());
}
inline model::Tangent<double> gradient_at(const ElementField& f, const SurfacePoint& p) {
  return {f.dot(Shapes(p.grad[0].data())), f.dot(Shapes(p.grad[1].data()))};
}
inline Eigen::Matrix<double, 3, 2> gradient_at(const ElementNodes& W, const SurfacePoint& p) {
  Eigen::Matrix<double, 3, 2> gradient;
  gradient << W * Shapes(p.grad[0].data()), W * Shapes(p.grad[1].data());
  return gradient;
}

/// Calls visit(e, shape values, surface point) at every quadrature point, in order.
template <class Visit>
void for_each_point(const Triangulation& mesh, const Nodes& X, std::span<const ShapeValues> points,
                    Visit&& visit) {
  for (int e = 0; e < mesh.count(); ++e) {
    const ElementNodes local = on_element(mesh, e, X);
    for (const ShapeValues& s : points) visit(e, s, surface_point(local, s));
  }
}

using model::Target;
/// Total area A and enclosed volume V = ∫ x·ν/3 dS.
Target area_and_volume(const Triangulation& mesh, const Nodes& X);
double area(const Triangulation& mesh, const Nodes& X);
double volume(const Triangulation& mesh, const Nodes& X);
using model::reduced_volume;
/// So near the sphere that area and volume are one constraint: V_r > 1 − 1e-7 − 32/triangles³. A mesh
/// whose nodes lie on the sphere has V_r = 1 − 16/triangles³.
bool is_sphere(const Triangulation& mesh, double area, double volume);

/// Two unit vectors at each node, orthogonal to its normal and to each other, 3 x nodes each; smooth but where the normal points
/// away from a fixed direction.
std::array<Nodes, 2> node_tangents(const Nodes& normals);

/// Unit normals at the nodes: the normalised mean of the triangles' normals, weighted by their areas;
/// 3 x nodes.
Nodes node_normals(const Triangulation& mesh, const Nodes& X);

}  // namespace sbeh::surface3d
