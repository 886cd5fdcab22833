#include "surface3d/stationary/lagrangian.h"

#include "model/numerics/contraction.h"
#include "model/numerics/lagrange.h"
#include "model/numerics/quadrature.h"
#include "model/numerics/second_order.h"
#include "surface3d/parallel.h"

#include <numbers>
#include <vector>

namespace sbeh::surface3d {

namespace {

using model::SecondOrder;

// What is read of a triangle at a point, in vectors of three numbers; numbers are where their vector begins.
enum RawData {
  raw_a1 = 0,
  raw_a2 = 3,
  raw_a11 = 6,
  raw_a12 = 9,
  raw_x = 12,
  raw_Lambda = 15,
  raw_Lambda_1 = 18,
  raw_Lambda_2 = 21,
  raw_order = 24,  // β, β_1, β_2
  raw_H = 27,      // H and two that are not used
  raw_data = 30
};
using Raw = Eigen::Matrix<double, raw_data, 1>;

// Value, gradient and Hessian of a density by the raw data.
struct RawDerivatives {
  double value = 0;
  Raw gradient = Raw::Zero();
  Eigen::Matrix<double, raw_data, raw_data> hessian =
      Eigen::Matrix<double, raw_data, raw_data>::Zero();
};

// A product of two vectors, or a component.
struct Invariant {
  int first, second;  // where the vectors begin; of a component: which, and −1
};
template <std::size_t N>
using Invariants = std::array<Invariant, N>;
constexpr Invariant g11{raw_a1, raw_a1}, g12{raw_a1, raw_a2}, g22{raw_a2, raw_a2},
    beta{raw_order, -1}, beta_1{raw_order + 1, -1}, beta_2{raw_order + 2, -1};
constexpr Invariants<energy_data> energy_invariants{g11,    g12,    g22,        beta,
                                                    beta_1, beta_2, {raw_H, -1}};
constexpr Invariants<divergence_data> divergence_invariants{g11,
                                                            g12,
                                                            g22,
                                                            {raw_a1, raw_Lambda_1},
                                                            {raw_a1, raw_Lambda_2},
                                                            {raw_a2, raw_Lambda_1},
                                                            {raw_a2, raw_Lambda_2}};
constexpr Invariants<gaussian_data> gaussian_invariants{g11,
                                                        g12,
                                                        g22,
                                                        beta,
                                                        beta_1,
                                                        beta_2,
                                                        {raw_a11, raw_a1},
                                                        {raw_a11, raw_a2},
                                                        {raw_a12, raw_a1},
                                                        {raw_a12, raw_a2}};
constexpr Invariants<rim_data> rim_invariants{g11, g12, g22, beta, beta_1, beta_2};
constexpr Invariants<3> metric_invariants{g11, g12, g22};

auto vector(const Raw& q, int first) { return q.segment<3>(first); }

double value_of(const Invariant& k, const Raw& q) {
  return k.second < 0 ? q[k.first] : vector(q, k.first).dot(vector(q, k.second));
}
template <std::size_t N>
std::array<double, N> values_of(const Invariants<N>& invariants, const Raw& q) {
  std::array<double, N> values;
  for (std::size_t k = 0; k < N; ++k) values[k] = value_of(invariants[k], q);
  return values;
}
template <std::size_t N>
std::array<SecondOrder<int(N)>, N> variables(const Invariants<N>& invariants, const Raw& q) {
  std::array<SecondOrder<int(N)>, N> values;
  for (std::size_t k = 0; k < N; ++k) values[k] = {value_of(invariants[k], q), int(k)};
  return values;
}

// ∂(invariant) by the raw data: one vector or two.
struct Slope {
  struct Part {
    int first;
    Eigen::Vector3d along;
  };
  std::array<Part, 2> parts;
  int count;
};
Slope slope_of(const Invariant& k, const Raw& q) {
  if (k.second < 0) return {{{{k.first - k.first % 3, Eigen::Vector3d::Unit(k.first % 3)}, {}}}, 1};
  if (k.first == k.second) return {{{{k.first, 2 * vector(q, k.first)}, {}}}, 1};
  return {{{{k.first, vector(q, k.second)}, {k.second, vector(q, k.first)}}}, 2};
}

// out += a function of invariants.
template <std::size_t N>
void add(const SecondOrder<int(N)>& f, const Invariants<N>& invariants, const Raw& q,
         RawDerivatives& out) {
  std::array<Slope, N> slopes;
  for (std::size_t k = 0; k < N; ++k) slopes[k] = slope_of(invariants[k], q);
  out.value += f.a;
  for (std::size_t k = 0; k < N; ++k) {
    const double rate = f.g[Eigen::Index(k)];
    for (int i = 0; i < slopes[k].count; ++i) {
      const auto& [row, along] = slopes[k].parts[std::size_t(i)];
      out.gradient.segment<3>(row) += rate * along;
      for (std::size_t l = 0; l < N; ++l) {
        const Eigen::Vector3d bent = f.h(Eigen::Index(k), Eigen::Index(l)) * along;
        for (int j = 0; j < slopes[l].count; ++j) {
          const auto& [column, other] = slopes[l].parts[std::size_t(j)];
          out.hessian.block<3, 3>(row, column).noalias() += bent * other.transpose();
        }
      }
    }
    const auto [first, second] = invariants[k];
    if (second < 0) continue;
    out.hessian.block<3, 3>(first, second).diagonal().array() += rate;
    out.hessian.block<3, 3>(second, first).diagonal().array() += rate;
  }
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d m;
  m << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return m;
}

// out += c w·(a1 × a2), w the vector that begins at `first`.
void add_box_product(double c, int first, const Raw& q, RawDerivatives& out) {
  const Eigen::Vector3d a1 = c * vector(q, raw_a1), a2 = c * vector(q, raw_a2),
                        w = vector(q, first), normal = a1.cross(vector(q, raw_a2));
  out.value += w.dot(normal);
  out.gradient.segment<3>(raw_a1) += a2.cross(w);
  out.gradient.segment<3>(raw_a2) += w.cross(a1);
  out.gradient.segment<3>(first) += normal;
  const auto add_pair = [&](int row, int column, const Eigen::Matrix3d& block) {
    out.hessian.block<3, 3>(row, column) += block;
    out.hessian.block<3, 3>(column, row) += block.transpose();
  };
  add_pair(raw_a1, raw_a2, cross_matrix(-c * w));
  add_pair(raw_a1, first, cross_matrix(a2));
  add_pair(raw_a2, first, cross_matrix(-a1));
}

// out += H Λ·(a1 × a2).
void add_normal_part(const Raw& q, RawDerivatives& out) {
  const Eigen::Vector3d a1 = vector(q, raw_a1), a2 = vector(q, raw_a2),
                        Lambda = vector(q, raw_Lambda);
  add_box_product(q[raw_H], raw_Lambda, q, out);
  out.gradient[raw_H] += Lambda.dot(a1.cross(a2));
  const auto add_pair = [&](int column, const Eigen::Vector3d& slope) {
    out.hessian.block<1, 3>(raw_H, column) += slope.transpose();
    out.hessian.block<3, 1>(column, raw_H) += slope;
  };
  add_pair(raw_Lambda, a1.cross(a2));
  add_pair(raw_a1, a2.cross(Lambda));
  add_pair(raw_a2, Lambda.cross(a1));
}

// Shape functions at a point, with second derivatives: ∂_1∂_1, ∂_1∂_2.
struct BentShapes : ShapeValues {
  std::array<std::array<double, 10>, 2> ddphi;
};
BentShapes bent_shapes(const Eigen::Vector2d& x, double weight) {
  BentShapes s{shape_values(x, weight), {}};
  const Eigen::Matrix3Xd bends = model::TriangleElement(3).second_derivatives(x);
  for (int k = 0; k < 2; ++k)
    Eigen::Map<Eigen::Matrix<double, 10, 1>>(s.ddphi[std::size_t(k)].data()) =
        bends.row(k).transpose();
  return s;
}

using Points = std::vector<BentShapes>;
const Points& inner_points() {
  static const Points points = [] {
    const model::TriangleRule rule = model::triangle_rule(8);
    Points table;
    for (int k = 0; k < rule.size(); ++k)
      table.push_back(bent_shapes(rule.points.col(k), rule.weights[k]));
    return table;
  }();
  return points;
}
// On the straight line from one point to another, weights summing to 1.
Points rim_points(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const model::IntervalRule rule = model::gauss_rule(6);
  Points table;
  for (int k = 0; k < rule.size(); ++k)
    table.push_back(bent_shapes(from + rule.points[k] * (to - from), rule.weights[k]));
  return table;
}
const Points& first_rim() {
  static const Points points = rim_points({0, 0}, {0, 1});
  return points;
}
const Points& second_rim() {
  static const Points points = rim_points({1, 0}, {0, 1});
  return points;
}

constexpr int unknown_d = 10 * node_d, unknown_Lambda = 10 * node_Lambda, unknown_H = 10 * node_H,
              unknown_beta = 10 * node_beta, element_unknowns = 10 * node_unknowns;

// The raw data as linear functions of the unknowns.
class Rows {
 public:
  Rows(const ElementNodes& normals, const BentShapes& s, bool bent) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Shape n = normals.row(Eigen::Index(k)).transpose();
      const auto along = [&](std::size_t kind, const std::array<double, 10>& shape) {
        Shape& product = along_[3 * kind + k];
        product = n.cwiseProduct(Shapes(shape.data()));
        return product.data();
      };
      const double *phi = along(0, s.phi), *phi_1 = along(1, s.dphi[0]),
                   *phi_2 = along(2, s.dphi[1]);
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
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  std::array<model::DataRow<10>, raw_data> rows;

 private:
  using Shape = Eigen::Matrix<double, 10, 1>;
  std::array<Shape, 15> along_;  // times a component of the normals
};

struct ElementState {
  ElementNodes X, normals, Lambda;
  ElementField H, beta;
};
ElementState on_element(const StationaryState& state, const Nodes& normals,
                        const Triangulation& mesh, int e) {
  ElementState local{on_element(mesh, e, state.X),
                     on_element(mesh, e, normals),
                     {},
                     on_element(mesh, e, state.H),
                     on_element(mesh, e, state.beta)};
  local.Lambda = local.normals * on_element(mesh, e, state.Lambda).asDiagonal();
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

struct ElementSums {
  model::BlockMatrix<10, 4, 4> matrix;
  Eigen::Matrix<double, element_unknowns, 1> gradient = decltype(gradient)::Zero();
  Eigen::Matrix<double, 10, 2> constraints = decltype(constraints)::Zero();
  double area = 0, volume = 0, value = 0;

  void add(const RawDerivatives& density, const Rows& rows, double weight) {
    value += weight * density.value;
    model::add_vector(rows.rows, density.gradient, weight, gradient);
    model::add_matrix(rows.rows, rows.rows, density.hessian, weight, matrix);
  }
};

void add_constraints(const Raw& q, const Rows& rows, double weight, ElementSums& sums) {
  RawDerivatives area, volume;
  add(area_density(variables(metric_invariants, q)), metric_invariants, q, area);
  add_box_product(1. / 3, raw_x, q, volume);
  sums.area += weight * area.value;
  sums.volume += weight * volume.value;
  Eigen::Matrix<double, element_unknowns, 1> gradient = decltype(gradient)::Zero();
  model::add_vector(rows.rows, area.gradient, weight, gradient);
  sums.constraints.col(0) += gradient.head<10>();
  gradient.setZero();
  model::add_vector(rows.rows, volume.gradient, weight, gradient);
  sums.constraints.col(1) -= gradient.head<10>();
}

void add_rim(const model::Material& material, const ElementState& state, ElementSums& sums) {
  for (const BentShapes& s : first_rim()) {
    const Raw q = raw_data_of(state, s);
    RawDerivatives density;
    add(first_rim_density(material, variables(rim_invariants, q)), rim_invariants, q, density);
    sums.add(density, Rows(state.normals, s, false), s.weight);
  }
  for (const BentShapes& s : second_rim()) {
    const Raw q = raw_data_of(state, s);
    RawDerivatives density;
    add(second_rim_density(material, variables(rim_invariants, q)), rim_invariants, q, density);
    sums.add(density, Rows(state.normals, s, false), s.weight);
  }
}

ElementSums sums_on(const model::Material& material, bool free_order, const StationaryState& state,
                    const ElementState& local) {
  ElementSums sums;
  sums.matrix.set_zero();
  for (const BentShapes& s : inner_points()) {
    const Raw q = raw_data_of(local, s);
    const Rows rows(local.normals, s, free_order);
    RawDerivatives density;
    add(tension_density(material, state.tension, variables(energy_invariants, q)),
        energy_invariants, q, density);
    add(divergence_density(variables(divergence_invariants, q)), divergence_invariants, q, density);
    add_normal_part(q, density);
    add_box_product(-state.pressure / 3, raw_x, q, density);
    if (free_order)
      add(connection_density(material, variables(gaussian_invariants, q)), gaussian_invariants, q,
          density);
    sums.add(density, rows, s.weight);
    add_constraints(q, rows, s.weight, sums);
  }
  if (free_order) add_rim(material, local, sums);
  return sums;
}

// 2π − (π/3) valence: the curvature of a corner where all angles are π/3; 0 at all other nodes.
Field corner_curvatures(const Triangulation& mesh) {
  Field curvatures = Field::Zero(mesh.nodes);
  std::vector<int> valence(std::size_t(mesh.nodes), 0);
  for (const int corner : mesh.triangles.topRows<3>().reshaped()) ++valence[std::size_t(corner)];
  for (int i = 0; i < mesh.nodes; ++i)
    if (const int at = valence[std::size_t(i)]; at > 0)
      curvatures[i] = (6 - at) * std::numbers::pi / 3;
  return curvatures;
}

Eigen::MatrixXi unknowns_of(const Triangulation& mesh, int per_node) {
  Eigen::MatrixXi unknowns(10 * per_node, mesh.count());
  for (int e = 0; e < mesh.count(); ++e)
    for (int c = 0; c < per_node; ++c)
      for (int a = 0; a < 10; ++a) unknowns(10 * c + a, e) = per_node * mesh.triangles(a, e) + c;
  return unknowns;
}

}  // namespace

StationaryLayout::StationaryLayout(const Triangulation& triangulation, model::Model model)
    : mesh(triangulation),
      free_order(has_free_order(model)),
      per_node(free_order ? node_unknowns : int(node_beta)),
      pattern(size(), unknowns_of(mesh, per_node),
              SparsePattern::Mask::Constant(10 * per_node, 10 * per_node, true)) {}

void assemble(const model::Material& material, const StationaryLayout& layout,
              const StationaryState& state, const Nodes& normals, LagrangianDerivatives& out) {
  const Triangulation& mesh = layout.mesh;
  if (out.hessian.rows() != layout.size()) out.hessian = layout.pattern.zero();
  std::fill_n(out.hessian.valuePtr(), out.hessian.nonZeros(), 0.);
  out.gradient.setZero(layout.size());
  out.constraints.setZero(layout.size(), 2);
  Eigen::Matrix3Xd totals(3, mesh.count());
  for_each_by_colour(mesh, [&](int e) {
    const ElementSums sums =
        sums_on(material, layout.free_order, state, on_element(state, normals, mesh, e));
    layout.pattern.add(e, sums.matrix.dense(), out.hessian);
    for (int a = 0; a < 10; ++a) {
      const int node = mesh.triangles(a, e);
      for (int c = 0; c < layout.per_node; ++c)
        out.gradient[layout.per_node * node + c] += sums.gradient[10 * c + a];
      out.constraints.row(layout.index(node, node_d)) += sums.constraints.row(a);
    }
    totals.col(e) << sums.area, sums.volume, sums.value;
  });
  const Eigen::Vector3d total = totals.rowwise().sum();
  out.area = total[0];
  out.volume = total[1];
  out.value = total[2];
  if (!layout.free_order) return;
  const Field curvatures = corner_curvatures(mesh);
  for (int i = 0; i < mesh.nodes; ++i) {
    if (curvatures[i] == 0) continue;
    const int k = layout.index(i, node_beta);
    const SecondOrder<1> energy =
        curvatures[i] * material.kappa_gauss(SecondOrder<1>(state.beta[i], 0));
    out.value += energy.a;
    out.gradient[k] += energy.g[0];
    out.hessian.coeffRef(k, k) += energy.h(0, 0);
  }
}

double gaussian_energy(const model::Material& material, const Triangulation& mesh,
                       const State& state) {
  Eigen::VectorXd parts = Eigen::VectorXd::Zero(mesh.count());
  in_parallel(mesh.count(), [&](int e) {
    const ElementState local{on_element(mesh, e, state.X),
                             {},
                             ElementNodes::Zero(),
                             ElementField::Zero(),
                             on_element(mesh, e, state.beta)};
    double& sum = parts[e];
    for (const BentShapes& s : inner_points())
      sum += s.weight
           * connection_density(material, values_of(gaussian_invariants, raw_data_of(local, s)));
    for (const BentShapes& s : first_rim())
      sum +=
          s.weight * first_rim_density(material, values_of(rim_invariants, raw_data_of(local, s)));
    for (const BentShapes& s : second_rim())
      sum +=
          s.weight * second_rim_density(material, values_of(rim_invariants, raw_data_of(local, s)));
  });
  double sum = parts.sum();
  const Field curvatures = corner_curvatures(mesh);
  for (int i = 0; i < mesh.nodes; ++i) sum += curvatures[i] * material.kappa_gauss(state.beta[i]);
  return sum;
}

model::Energy energy(const model::Material& material, const Triangulation& mesh,
                     const StationaryState& state) {
  const Eigen::Array3d sum = integrate<3>(mesh, state.X, assembly_points(), [&](int e) {
    return [&material, H = on_element(mesh, e, state.H), beta = on_element(mesh, e, state.beta)](
               const ShapeValues& s, const SurfacePoint& p) {
      const auto density = model::energy_density(
          material, value_at(beta, s), gradient_at(beta, p).squaredNorm(), value_at(H, s), 0.);
      return Eigen::Array3d(density.distortion, density.bending, density.thermotropic);
    };
  });
  return {.distortion = sum[0],
          .bending = sum[1] + gaussian_energy(material, mesh, state),
          .thermotropic = sum[2]};
}

}  // namespace sbeh::surface3d
