#include "surface3d/stationary/lagrangian.h"

#include "surface3d/gaussian_energy.h"
#include "surface3d/parallel.h"
#include "surface3d/stationary/point_rows.h"

#include <ceres/jet.h>

#include <utility>

namespace sbeh::surface3d {

using namespace at_point;

namespace {

// What a triangle adds to the gradient; numbers that carry a gradient.
struct GradientSums {
  using Density = RawGradient;
  template <std::size_t N>
  using Number = ceres::Jet<double, int(N)>;

  NodeRates by_nodes{}, of_area{}, of_volume{}, of_W2{}, of_order{};
  double area = 0, volume = 0, W2 = 0, order = 0, value = 0;

  explicit GradientSums(const ElementNodes& /*normals*/) {}
  void add_inner(const RawGradient& density, const BentShapes& s, bool bent) {
    value += s.weight * density.value;
    by_nodes.add<raw_a1, raw_a2, raw_x, raw_Lambda, raw_Lambda_1, raw_Lambda_2, raw_order, raw_H>(
        density.gradient, s, s.weight);
    if (bent) by_nodes.add<raw_a11, raw_a12>(density.gradient, s, s.weight);
  }
  void add_rim(const RawGradient& density, const BentShapes& s) {
    value += s.weight * density.value;
    by_nodes.add<raw_a1, raw_a2, raw_order>(density.gradient, s, s.weight);
  }
};
// And to the Hessian.
struct ElementSums : GradientSums {
  using Density = RawDerivatives;
  template <std::size_t N>
  using Number = SecondOrder<int(N)>;

  HessianSums hessian;

  explicit ElementSums(const ElementNodes& normals) : GradientSums(normals), hessian(normals) {}
  void add_inner(const RawDerivatives& density, const BentShapes& s, bool bent) {
    GradientSums::add_inner(density, s, bent);
    hessian.add_inner(density, s, s.weight, bent);
  }
  void add_rim(const RawDerivatives& density, const BentShapes& s) {
    GradientSums::add_rim(density, s);
    hessian.add_rim(density, s, s.weight);
  }
};

template <std::size_t N>
void add(const ceres::Jet<double, int(N)>& f, const Invariants<N>& invariants, const Raw& q,
         RawGradient& out) {
  at_point::add(f.a, f.v, invariants, q, out);
}

void add_constraints(const model::Material& material, const Raw& q, const BentShapes& s,
                     GradientSums& sums) {
  using Number = GradientSums::Number<metric_invariants.size()>;
  const double weight = s.weight;
  RawGradient area, volume;
  add(area_density(variables<Number>(metric_invariants, q)), metric_invariants, q, area);
  add_box_product(1. / 3, raw_x, q, volume);
  sums.volume += weight * volume.value;
  sums.of_volume.add<raw_a1, raw_a2, raw_x>(volume.gradient, s, weight);
  if (material.has_lipid_density()) {
    RawGradient lipids;
    add(lipid_density(material, variables<GradientSums::Number<lipid_data>>(lipid_invariants, q)),
        lipid_invariants, q, lipids);
    sums.area += weight * lipids.value;
    sums.of_area.add<raw_a1, raw_a2, raw_order>(lipids.gradient, s, weight);
    return;  // nothing else is kept then
  }
  sums.area += weight * area.value;
  sums.of_area.add<raw_a1, raw_a2>(area.gradient, s, weight);
  // ∫ q dS of a number q of the data.
  const auto add_integral = [&]<RawData at>(double& sum, NodeRates& by_nodes) {
    Raw by_data = q[at] * area.gradient;
    by_data[at] += area.value;
    sum += weight * area.value * q[at];
    by_nodes.add<raw_a1, raw_a2, at>(by_data, s, weight);
  };
  if (material.area_difference.is_there())
    add_integral.template operator()<raw_H>(sums.W2, sums.of_W2);
  if (material.conserves_order())
    add_integral.template operator()<raw_order>(sums.order, sums.of_order);
}

template <class Sums>
void add_rim(const model::Material& material, const ElementState& state, Sums& sums) {
  using Number = typename Sums::template Number<rim_invariants.size()>;
  const auto add_side = [&](const BentPoints& points, auto density_of) {
    for (const BentShapes& s : points) {
      const Raw q = raw_data_of(state, s);
      typename Sums::Density density;
      add(density_of(material, variables<Number>(rim_invariants, q)), rim_invariants, q, density);
      sums.add_rim(density, s);
    }
  };
  add_side(first_rim(), first_rim_density<Number>);
  add_side(second_rim(), second_rim_density<Number>);
}

template <class Sums>
Sums sums_on(const model::Material& material, bool free_order, const StationaryState& state,
             const ElementState& local) {
  Sums sums(local.normals);
  const auto variables_of = [](const auto& invariants, const Raw& q) {
    constexpr std::size_t count = std::tuple_size_v<std::decay_t<decltype(invariants)>>;
    return variables<typename Sums::template Number<count>>(invariants, q);
  };
  for (const BentShapes& s : inner_points()) {
    const Raw q = raw_data_of(local, s);
    typename Sums::Density density;
    add(tension_density(material, state.tension, variables_of(energy_invariants, q)),
        energy_invariants, q, density);
    add(divergence_density(variables_of(divergence_invariants, q)), divergence_invariants, q,
        density);
    add_normal_part(q, density);
    add_box_product(-state.pressure / 3, raw_x, q, density);
    if (free_order)
      add(connection_density(material, variables_of(gaussian_invariants, q)), gaussian_invariants,
          q, density);
    sums.add_inner(density, s, free_order);
    add_constraints(material, q, s, sums);
  }
  if (free_order) add_rim(material, local, sums);
  return sums;
}

Eigen::MatrixXi unknowns_of(const Triangulation& mesh, int per_node) {
  Eigen::MatrixXi unknowns(10 * per_node, mesh.count());
  for (int e = 0; e < mesh.count(); ++e)
    for (int c = 0; c < per_node; ++c)
      for (int a = 0; a < 10; ++a) unknowns(10 * c + a, e) = per_node * mesh.triangles(a, e) + c;
  return unknowns;
}

// Clears `out`, adds what the triangles do, and what `add_matrix` does with their sums.
template <class Sums>
void assemble_triangles(const model::Material& whole, const StationaryLayout& layout,
                        const StationaryState& state, const Nodes& normals, LagrangianGradient& out,
                        const auto& add_matrix) {
  const Triangulation& mesh = layout.mesh;
  const model::AreaDifference& ad = whole.area_difference;
  const double moment = state.moment, compliance = ad.is_there() ? ad.compliance() : 0;
  const model::Material material =
      whole.at_moment(moment).at_chemical_potential(state.chemical_potential);
  const bool has_order = layout.free_order && whole.conserves_order();
  const int last = multiplier_count(whole) - 1;
  StationaryState felt_by = state;
  felt_by.tension -= moment * moment * compliance / 2;
  out.gradient.setZero(layout.size());
  out.constraints.setZero(layout.size(), last + 1);
  Eigen::Matrix<double, 5, Eigen::Dynamic> totals(5, mesh.count());
  for_each_by_colour(mesh, [&](int e) {
    const ElementState local = on_element(state, normals, mesh, e);
    const Sums sums = sums_on<Sums>(material, layout.free_order, felt_by, local);
    add_matrix(e, sums);
    const auto add_to = [&](auto&& vector, const NodeRates& by_nodes, double sign) {
      const auto rates = by_nodes.along(local.normals);
      for (int a = 0; a < 10; ++a)
        for (int c = 0; c < layout.per_node; ++c)
          vector[layout.per_node * mesh.triangles(a, e) + c] += sign * rates[10 * c + a];
    };
    add_to(out.gradient, sums.by_nodes, 1);
    add_to(out.constraints.col(0), sums.of_area, 1);
    add_to(out.constraints.col(1), sums.of_volume, -1);
    if (ad.is_there()) add_to(out.constraints.col(2), sums.of_W2, 1);
    if (has_order) add_to(out.constraints.col(last), sums.of_order, -1);
    totals.col(e) << sums.area, sums.volume, sums.value, sums.W2, sums.order;
  });
  const Eigen::Matrix<double, 5, 1> total = totals.rowwise().sum();
  out.area = total[0];
  out.volume = total[1];
  out.value = total[2];
  out.W2 = total[3];
  out.order = total[4];
  out.corner.resize(0);
  if (has_order) out.constraints.col(last) += *whole.mean_order * out.constraints.col(0);
  if (!ad.is_there()) return;
  out.constraints.col(2) -= moment * compliance * out.constraints.col(0);
  out.corner = Eigen::VectorXd::Zero(last + 1);
  out.corner[2] = -out.area * compliance;
}

// Of the corners: where, and the energy by β.
std::vector<std::pair<int, SecondOrder<1>>> corner_energies(const model::Material& material,
                                                            const StationaryLayout& layout,
                                                            const StationaryState& state) {
  if (!layout.free_order) return {};
  const Field curvatures = corner_curvatures(layout.mesh);
  std::vector<std::pair<int, SecondOrder<1>>> energies;
  for (int i = 0; i < layout.mesh.nodes; ++i)
    if (curvatures[i] != 0)
      energies.emplace_back(layout.index(i, node_beta),
                            curvatures[i] * material.kappa_gauss(SecondOrder<1>(state.beta[i], 0)));
  return energies;
}

}  // namespace

bool operator==(const StationaryState& a, const StationaryState& b) {
  return a.X == b.X && a.beta == b.beta && a.H == b.H && a.Lambda == b.Lambda
      && a.tension == b.tension && a.pressure == b.pressure && a.moment == b.moment
      && a.chemical_potential == b.chemical_potential;
}

StationaryLayout::StationaryLayout(const Triangulation& triangulation, model::Model model)
    : mesh(triangulation),
      free_order(has_free_order(model)),
      per_node(free_order ? node_unknowns : int(node_beta)),
      pattern(size(), unknowns_of(mesh, per_node),
              SparsePattern::Mask::Constant(10 * per_node, 10 * per_node, true)) {}

void assemble(const model::Material& material, const StationaryLayout& layout,
              const StationaryState& state, const Nodes& normals, LagrangianGradient& out) {
  assemble_triangles<GradientSums>(material, layout, state, normals, out,
                                   [](int, const GradientSums&) {});
  for (const auto& [k, energy] : corner_energies(material, layout, state)) {
    out.value += energy.a;
    out.gradient[k] += energy.g[0];
  }
}

void assemble(const model::Material& material, const StationaryLayout& layout,
              const StationaryState& state, const Nodes& normals, LagrangianDerivatives& out) {
  if (out.hessian.rows() != layout.size()) out.hessian = layout.pattern.zero();
  std::fill_n(out.hessian.valuePtr(), out.hessian.nonZeros(), 0.);
  assemble_triangles<ElementSums>(material, layout, state, normals, out,
                                  [&](int e, const ElementSums& sums) {
                                    layout.pattern.add(e, sums.hessian.symmetric(), out.hessian);
                                  });
  for (const auto& [k, energy] : corner_energies(material, layout, state)) {
    out.value += energy.a;
    out.gradient[k] += energy.g[0];
    out.hessian.coeffRef(k, k) += energy.h(0, 0);
  }
}

Eigen::VectorXd LagrangianGradient::miss(const model::Material& material, const Target& target,
                                         double moment) const {
  const model::AreaDifference& ad = material.area_difference;
  Eigen::VectorXd misses(multipliers());
  misses.head<2>() << target.area - area, volume - target.volume;
  if (ad.is_there()) misses[2] = ad.W2 + moment * ad.compliance() * area - W2;
  if (material.conserves_order()) misses[misses.size() - 1] = order - *material.mean_order * area;
  return misses;
}

model::Energy energy(const model::Material& material, const Triangulation& mesh,
                     const StationaryState& state) {
  const Eigen::Array<double, 5, 1> sum = integrate<5>(mesh, state.X, assembly_points(), [&](int e) {
    return [&material, H = on_element(mesh, e, state.H), beta = on_element(mesh, e, state.beta)](
               const ShapeValues& s, const SurfacePoint& p) {
      const auto density = model::energy_density(
          material, value_at(beta, s), gradient_at(beta, p).squaredNorm(), value_at(H, s), 0.);
      return Eigen::Array<double, 5, 1>{density.distortion, density.bending, density.thermotropic,
                                        1, value_at(H, s)};
    };
  });
  return {.distortion = sum[0],
          .bending = sum[1] + gaussian_energy(material, mesh, state),
          .thermotropic = sum[2],
          .area_difference = material.area_difference.energy(sum[3], sum[4])};
}

}  // namespace sbeh::surface3d
