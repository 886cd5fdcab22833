#include "surface3d/variational/step_functional.h"

#include "surface3d/element_system.h"
#include "surface3d/parallel.h"

#include <algorithm>

namespace sbeh::surface3d {

namespace {

constexpr int pressures = 6;

// Those of a triangle: by kinds, ten numbers each, then p.
Eigen::MatrixXi unknowns_of(const Triangulation& mesh, int per_node) {
  Eigen::MatrixXi unknowns(10 * per_node + pressures, mesh.count());
  for (int e = 0; e < mesh.count(); ++e) {
    for (int c = 0; c < per_node; ++c)
      for (int a = 0; a < 10; ++a) unknowns(10 * c + a, e) = per_node * mesh.triangles(a, e) + c;
    for (int a = 0; a < pressures; ++a)
      unknowns(10 * per_node + a, e) = per_node * mesh.nodes + mesh.quadratic(a, e);
  }
  return unknowns;
}

// Of which kinds the entries of a triangle's matrix are.
SparsePattern::Mask couplings(const StationaryLayout& state, bool order_meets_pressure) {
  const int tangential = 10 * state.per_node, p = tangential + 20, size = p + pressures;
  SparsePattern::Mask couples = SparsePattern::Mask::Constant(size, size, false);
  couples.topLeftCorner(tangential, tangential).setConstant(true);
  std::vector<int> motion{10 * node_d, tangential, tangential + 10};
  std::vector<int> meet_tangents = motion;
  if (state.free_order) meet_tangents.push_back(10 * node_beta);
  for (const int i : {tangential, tangential + 10})
    for (const int j : meet_tangents) {
      couples.block(i, j, 10, 10).setConstant(true);
      couples.block(j, i, 10, 10).setConstant(true);
    }
  std::vector<int> meet_pressure = motion;
  if (order_meets_pressure) meet_pressure.push_back(10 * node_beta);
  for (const int i : meet_pressure) {
    couples.block(i, p, 10, pressures).setConstant(true);
    couples.block(p, i, pressures, 10).setConstant(true);
  }
  return couples;
}

std::vector<int> places_of(const StationaryLayout& state, const std::vector<int>& unknowns,
                           const SparsePattern& pattern) {
  const SparseMatrix small = state.pattern.zero(), large = pattern.zero();
  std::vector<int> places;
  places.reserve(std::size_t(small.nonZeros()));
  for (int row = 0; row < small.outerSize(); ++row)
    for (SparseMatrix::InnerIterator it(small, row); it; ++it) {
      const int r = unknowns[std::size_t(row)], c = unknowns[std::size_t(it.col())];
      const int *begin = large.innerIndexPtr() + large.outerIndexPtr()[r],
                *end = large.innerIndexPtr() + large.outerIndexPtr()[r + 1];
      places.push_back(int(std::lower_bound(begin, end, c) - large.innerIndexPtr()));
    }
  return places;
}

// Along which a triangle's nodes move: node normals and the two tangents.
using Directions = std::array<ElementNodes, 3>;
using Square = Eigen::Matrix<double, 30, 30>;  // of three kinds of numbers, ten each

// The components of u on a triangle, by d, s, s'.
Square displacements(const Directions& directions) {
  Square T = Square::Zero();
  for (int c = 0; c < 3; ++c)
    for (int k = 0; k < 3; ++k)
      T.block<10, 10>(10 * k, 10 * c) = directions[std::size_t(c)].row(k).asDiagonal();
  return T;
}

// M/(2τ) ∫ (β⁺ − β + (u − Y)_t·∇β)² dS, by β, s, s'; and n'/n(2/3) times what is squared there against p.
struct OrderSums {
  Square matrix = Square::Zero();
  Eigen::Matrix<double, 30, 1> linear = decltype(linear)::Zero();
  Eigen::Matrix<double, pressures, 30> lipids = decltype(lipids)::Zero();
  Eigen::Matrix<double, pressures, 1> known_lipids = decltype(known_lipids)::Zero();
};
OrderSums order_sums(const model::Material& material, double tau, const ElementNodes& X,
                     const ElementField& beta, const Directions& directions,
                     const ElementNodes& Y) {
  OrderSums sums;
  for (const ShapeValues& s : assembly_points()) {
    const SurfacePoint p = surface_point(X, s);
    const Eigen::Vector3d slope = p.frame.leftCols<2>() * gradient_at(beta, p);
    const Shapes phi(s.phi.data());
    Eigen::Matrix<double, 30, 1> row;
    row << phi, phi.cwiseProduct(directions[1].transpose() * slope),
        phi.cwiseProduct(directions[2].transpose() * slope);
    const double order = value_at(beta, s), known = order + value_at(Y, s).dot(slope);
    const double drag = material.order_drag(order) / tau;
    sums.matrix += (p.dS * drag) * row * row.transpose();
    sums.linear -= (p.dS * drag * known) * row;
    if (!material.has_lipid_density()) continue;
    const Eigen::Matrix<double, pressures, 1> q =
        p.dS * material.packing_slope(order) * Shapes(s.quadratic.data()).head<pressures>();
    sums.lipids += q * row.transpose();
    sums.known_lipids -= known * q;
  }
  return sums;
}

Eigen::Matrix<double, pressures, 1> pressure_integrals(const ElementNodes& X) {
  Eigen::Matrix<double, pressures, 1> sums = decltype(sums)::Zero();
  for (const ShapeValues& s : assembly_points())
    sums += surface_point(X, s).dS * Shapes(s.quadratic.data()).head<pressures>();
  return sums;
}

// What a triangle adds, its unknowns as in unknowns_of.
struct StepPiece {
  explicit StepPiece(const StationaryLayout& state)
      : tangential(10 * state.per_node),
        p(tangential + 20),
        matrix(Eigen::MatrixXd::Zero(p + pressures, p + pressures)),
        linear(Eigen::VectorXd::Zero(p + pressures)) {}

  // Ten numbers each, the first of which are those of `first`, the others s and s'.
  void add(NodeUnknown first, const Square& sums) {
    const std::array at = kinds(first);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        matrix.block<10, 10>(at[i], at[j]) += sums.block<10, 10>(10 * int(i), 10 * int(j));
  }
  void add(NodeUnknown first, const Eigen::Matrix<double, 30, 1>& sums) {
    const std::array at = kinds(first);
    for (std::size_t i = 0; i < 3; ++i) linear.segment<10>(at[i]) += sums.segment<10>(10 * int(i));
  }
  // Against p.
  void add_constraint(NodeUnknown first, const Eigen::Matrix<double, pressures, 30>& sums) {
    const std::array at = kinds(first);
    for (std::size_t i = 0; i < 3; ++i) {
      matrix.block<pressures, 10>(p, at[i]) += sums.middleCols<10>(10 * int(i));
      matrix.block<10, pressures>(at[i], p) += sums.middleCols<10>(10 * int(i)).transpose();
    }
  }
  std::array<int, 3> kinds(NodeUnknown first) const {
    return {10 * int(first), tangential, tangential + 10};
  }

  int tangential, p;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd linear;
};

}  // namespace

StepLayout::StepLayout(const Triangulation& mesh, const model::Material& material,
                       model::Model model)
    : state(mesh, model),
      per_node(state.per_node + 2),
      pattern(per_node * mesh.nodes + mesh.quadratic_nodes, unknowns_of(mesh, per_node),
              couplings(state, state.free_order && material.has_lipid_density())) {
  for (int i = 0; i < mesh.nodes; ++i)
    for (int c = 0; c < state.per_node; ++c) unknowns.push_back(per_node * i + c);
  places = places_of(state, unknowns, pattern);
}

void assemble(const model::Material& material, const StepLayout& layout, const StepBase& base,
              StepResistance& out) {
  const Triangulation& mesh = layout.state.mesh;
  if (out.matrix.rows() != layout.size()) out.matrix = layout.pattern.zero();
  std::fill_n(out.matrix.valuePtr(), out.matrix.nonZeros(), 0.);
  out.linear.setZero(layout.size());
  out.borders.setZero(layout.size(), 7);
  for_each_by_colour(mesh, [&](int e) {
    static thread_local ElementSystem element;
    const ElementNodes X = on_element(mesh, e, base.old.X);
    const ElementField beta = on_element(mesh, e, base.old.beta);
    const Directions directions{on_element(mesh, e, base.curvature.node_normals),
                                on_element(mesh, e, base.tangents[0]),
                                on_element(mesh, e, base.tangents[1])};
    assemble_element(material,
                     {.X = X,
                      .node_normals = directions[0],
                      .projected_normals = on_element(mesh, e, base.curvature.normals),
                      .beta = beta,
                      .H = on_element(mesh, e, base.curvature.H),
                      .order_force = ElementField::Zero()},
                     0, element);
    const Square T = displacements(directions);
    StepPiece piece(layout.state);
    piece.add(node_d, Square(T.transpose() * element.flow.topLeftCorner<30, 30>() * T / base.tau));
    piece.add_constraint(node_d, element.flow.block<pressures, 30>(FlowPiece::q, 0) * T);
    if (layout.state.free_order) {
      const OrderSums order =
          order_sums(material, base.tau, X, beta, directions, on_element(mesh, e, base.Y));
      piece.add(node_beta, order.matrix);
      piece.add(node_beta, order.linear);
      if (material.has_lipid_density()) {
        piece.add_constraint(node_beta, order.lipids);
        piece.linear.tail<pressures>() += order.known_lipids;
      }
    }
    layout.pattern.add(e, piece.matrix, out.matrix);
    layout.pattern.add(e, piece.linear, out.linear);

    const Eigen::Matrix<double, 30, 6> rigid = T.transpose() * element.constraints.rightCols<6>();
    const std::array kinds{int(node_d), layout.state.per_node, layout.state.per_node + 1};
    for (int k = 0; k < 30; ++k)
      out.borders.row(layout.per_node * mesh.triangles(k % 10, e) + kinds[std::size_t(k / 10)])
          .tail<6>() += rigid.row(k);
    const auto integrals = pressure_integrals(X);
    for (int a = 0; a < pressures; ++a)
      out.borders(layout.pressure() + mesh.quadratic(a, e), 0) -= integrals[a];
  });
}

}  // namespace sbeh::surface3d
