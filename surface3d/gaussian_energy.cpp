#include "surface3d/gaussian_energy.h"

#include "surface3d/bent_shapes.h"
#include "surface3d/gaussian_density.h"
#include "surface3d/parallel.h"

#include <algorithm>
#include <numbers>
#include <vector>

namespace sbeh::surface3d {

namespace {

GaussianFields<double> fields_of(const ElementNodes& X, const ElementField& beta,
                                 const BentShapes& s) {
  const Shapes phi(s.phi.data()), phi_1(s.dphi[0].data()), phi_2(s.dphi[1].data());
  const Eigen::Vector3d a1 = X * phi_1, a2 = X * phi_2, a11 = X * Shapes(s.ddphi[0].data()),
                        a12 = X * Shapes(s.ddphi[1].data());
  return {a1.dot(a1),      a1.dot(a2),  a2.dot(a2),  beta.dot(phi), beta.dot(phi_1),
          beta.dot(phi_2), a11.dot(a1), a11.dot(a2), a12.dot(a1),   a12.dot(a2)};
}

RimFields<double> on_rim(const GaussianFields<double>& all) {
  RimFields<double> fields;
  std::copy_n(all.begin(), fields.size(), fields.begin());
  return fields;
}

}  // namespace

double gaussian_energy(const model::Material& material, const Triangulation& mesh,
                       const State& state) {
  const auto on_triangle = [&](int e) {
    const ElementNodes X = on_element(mesh, e, state.X);
    const ElementField beta = on_element(mesh, e, state.beta);
    double sum = 0;
    for (const BentShapes& s : inner_points())
      sum += s.weight * connection_density(material, fields_of(X, beta, s));
    for (const BentShapes& s : first_rim())
      sum += s.weight * first_rim_density(material, on_rim(fields_of(X, beta, s)));
    for (const BentShapes& s : second_rim())
      sum += s.weight * second_rim_density(material, on_rim(fields_of(X, beta, s)));
    return Eigen::Array<double, 1, 1>(sum);
  };
  double sum = sum_over_triangles<1>(mesh, on_triangle)[0];
  const Field curvatures = corner_curvatures(mesh);
  for (int i = 0; i < mesh.nodes; ++i) sum += curvatures[i] * material.kappa_gauss(state.beta[i]);
  return sum;
}

Field corner_curvatures(const Triangulation& mesh) {
  Field curvatures = Field::Zero(mesh.nodes);
  std::vector<int> valence(std::size_t(mesh.nodes), 0);
  for (const int corner : mesh.triangles.topRows<3>().reshaped()) ++valence[std::size_t(corner)];
  for (int i = 0; i < mesh.nodes; ++i)
    if (const int at = valence[std::size_t(i)]; at > 0)
      curvatures[i] = (6 - at) * std::numbers::pi / 3;
  return curvatures;
}

}  // namespace sbeh::surface3d
