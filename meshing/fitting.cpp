#include "meshing/fitting.h"

#include "meshing/curvature.h"
#include "meshing/measures.h"

#include <Eigen/SparseCholesky>

#include <numbers>
#include <utility>
#include <vector>

namespace sbeh::meshing {

namespace {

// The d of the mesh as it is: its nodes are nearly where they belong. Empty where a normal misses the surface.
std::optional<Eigen::VectorXd> best_distance(const CurvedMesh& mesh, const HitByLine& surface) {
  constexpr int degree = 8;
  const double per_square = 4 * std::numbers::pi / area(mesh);  // 1/R²
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(mesh.node_count());
  bool missed = false;
  for_each_point(mesh, degree, [&](const SurfacePoint& p) {
    const auto hit = surface(p.x, p.n);
    const double slope = hit ? hit->normal.dot(p.n) : 0;
    missed = missed || !(slope > 0);
    if (missed) return;
    const Eigen::Vector3d gradient = p.n - hit->normal / slope;  // of δ along the surface
    const auto nodes = mesh.triangles.col(p.triangle);
    const Eigen::MatrixXd form =
        p.dS
        * (p.surface_grad.transpose() * p.surface_grad + per_square * p.phi * p.phi.transpose());
    rhs(nodes) +=
        p.dS * (p.surface_grad.transpose() * gradient + per_square * hit->distance * p.phi);
    for (Eigen::Index a = 0; a < nodes.size(); ++a)
      for (Eigen::Index b = 0; b <= a; ++b)
        entries.emplace_back(std::max(nodes[a], nodes[b]), std::min(nodes[a], nodes[b]),
                             form(a, b));
  });
  if (missed) return {};
  Eigen::SparseMatrix<double> matrix(mesh.node_count(), mesh.node_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(rhs);
}

}  // namespace

bool fit(CurvedMesh& mesh, const HitByLine& surface) {
  constexpr int iterations = 2;  // the third changes the seventh digit of what the first did
  CurvedMesh fitted = mesh;
  for (int i = 0; i < iterations; ++i) {
    const auto d = best_distance(fitted, surface);
    if (!d) return false;
    fitted.nodes += node_normals(fitted) * d->asDiagonal();
  }
  mesh = std::move(fitted);
  return true;
}

}  // namespace sbeh::meshing
