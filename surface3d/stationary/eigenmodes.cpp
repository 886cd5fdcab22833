#include "surface3d/stationary/eigenmodes.h"

#include "model/numerics/block_lanczos.h"

#include <algorithm>
#include <random>

namespace sbeh::surface3d {

namespace {

// As many as an eigenvalue has vectors where a group of symmetries has so many: five on a sphere of triangles.
constexpr int block = 6;

Eigen::MatrixXd any_loads(const StationaryLayout& layout) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Eigen::MatrixXd loads = Eigen::MatrixXd::Zero(layout.size(), block);
  for (int k = 0; k < block; ++k)
    for (int i = 0; i < layout.mesh.nodes; ++i) {
      loads(layout.index(i, node_d), k) = uniform(generator);
      if (layout.free_order) loads(layout.index(i, node_beta), k) = uniform(generator);
    }
  return loads;
}

Eigenmode mode_of(const StationaryLayout& layout, double inverse, const Eigen::VectorXd& x) {
  Eigenmode mode{
      1 / inverse, x(layout.all(node_d)),
      layout.free_order ? Field(x(layout.all(node_beta))) : Field(Field::Zero(layout.mesh.nodes))};
  Eigen::Index k = 0;
  mode.u.cwiseAbs().maxCoeff(&k);
  if (mode.u[k] < 0) {
    mode.u *= -1;
    mode.b *= -1;
  }
  return mode;
}

}  // namespace

std::optional<std::vector<Eigenmode>> lowest_modes(const NewtonSystem& system,
                                                   const StationaryState& state,
                                                   const Nodes& normals, int count) {
  const StationaryLayout& layout = system.layout();
  const SparseMatrix mass = perturbation_mass(layout, state, normals);
  const auto respond = [&](Eigen::MatrixXd loads) {
    system.respond(loads);
    return loads;
  };
  const Eigen::MatrixXd start = respond(any_loads(layout));
  const int negative = std::max(0, system.negative_directions());
  // Those next to 0 come first, on both sides of it.
  for (int asked = std::max(count, negative); asked <= 8 * (count + negative); asked *= 2) {
    const auto found = model::largest_by_block_lanczos(
        respond, [&](const Eigen::MatrixXd& x) -> Eigen::MatrixXd { return mass * x; }, start,
        asked, 20 * block + 4 * asked);
    if (!found) return {};
    if (int((found->values.array() < 0).count()) < negative) continue;
    std::vector<Eigenmode> modes;
    for (Eigen::Index k = 0; k < found->values.size(); ++k)
      modes.push_back(mode_of(layout, found->values[k], found->vectors.col(k)));
    std::ranges::sort(modes, {}, &Eigenmode::eigenvalue);
    modes.resize(std::min(modes.size(), std::size_t(std::max(count, negative))));
    return modes;
  }
  return {};
}

}  // namespace sbeh::surface3d
