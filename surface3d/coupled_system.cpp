#include "surface3d/coupled_system.h"

#include "surface3d/parallel.h"

namespace sbeh::surface3d {

namespace {

// V and p.
constexpr int head = FlowPiece::H;

// T: unknowns of the whole flow of an element by those of the flow along the normals n,
// V = Σ v_a φ_a n_a and p a number; the rest, of which λ is the last, stays as it is.
Eigen::MatrixXd normal_motion(const ElementNodes& n, int whole) {
  constexpr int speeds = 10;
  const int rest = whole - head;
  Eigen::MatrixXd T = Eigen::MatrixXd::Zero(whole, speeds + rest + 1);
  for (int k = 0; k < 3; ++k) T.block<10, 10>(10 * k, 0) = n.row(k).asDiagonal();
  T.block(head, speeds, rest, rest).setIdentity();
  T.block<head - FlowPiece::p, 1>(FlowPiece::p, speeds + rest).setOnes();
  return T;
}

std::variant<Monolithic, Split> chosen(Scheme scheme, const Triangulation& mesh) {
  if (scheme == Scheme::split) return Split(mesh);
  return Monolithic();
}

}  // namespace

CoupledSystem::CoupledSystem(const Triangulation& mesh, const model::Material& material,
                             Scheme scheme, model::AreaConstraint area)
    : material_(material),
      area_(area),
      nodes_(mesh.nodes),
      quadratic_nodes_(mesh.quadratic_nodes),
      multipliers_((along_normals() ? 1 : 7) + (material.area_difference.is_there() ? 1 : 0)),
      ranks_(mesh.ranks),
      scheme_(chosen(scheme, mesh)),
      layout_(
          flow_layout(mesh, area, has_displacement(), multipliers_ + (along_normals() ? 1 : 0))),
      has_moment_(material.area_difference.is_there()) {}

bool CoupledSystem::has_displacement() const {
  return std::visit([](const auto& scheme) { return scheme.has_displacement; }, scheme_);
}

// Momentum, (P1) and what the multipliers meet.
void CoupledSystem::set_flow(const ElementSystem& element, bool keep_volume,
                             FlowPiece& piece) const {
  const int lambda = FlowPiece::Y + (has_displacement() ? 30 : 0), size = lambda + multipliers_;
  const int others = multipliers_ - (has_moment_ ? 1 : 0), moment = lambda + others;
  piece.matrix.setZero(size, size);
  piece.rhs.setZero(size);
  piece.matrix.topLeftCorner<ElementSystem::tests, ElementSystem::unknowns>() = element.flow;
  piece.rhs.head<ElementSystem::tests>() = element.rhs;
  piece.matrix.block(0, lambda, 30, others) = element.constraints.leftCols(others);      // (V4)
  if (has_moment_ && keep_volume) piece.matrix.col(moment).head<30>() = element.moment;  // (V13)
  if (!keep_volume) piece.matrix.col(lambda).setZero();
  piece.matrix.bottomLeftCorner(multipliers_, 30) =
      piece.matrix.topRightCorner(30, multipliers_).transpose();  // (P2), (P3)
}

void CoupledSystem::add_flow(int e, const ElementNodes& normals, FlowPiece& piece) {
  if (along_normals()) {
    const Eigen::MatrixXd T = normal_motion(normals, int(piece.matrix.rows()));
    piece.matrix = (T.transpose() * piece.matrix * T).eval();
    piece.rhs = (T.transpose() * piece.rhs).eval();
    total_area_rate_[e] = piece.rhs[piece.rhs.size() - 1];
  }
  layout_.pattern.add(e, piece.matrix, flow_.matrix);
  layout_.pattern.add(e, piece.rhs, flow_.rhs);
}

void CoupledSystem::assemble(const Triangulation& mesh, const State& old,
                             const Curvature& curvature, const Field& order_force,
                             const Origin& from, double tau, const Constraints& constraints) {
  layout_.pattern.set_zero(flow_);
  lipids_ = Field();
  node_normals_ = curvature.node_normals;
  total_area_rate_.setZero(along_normals() ? mesh.count() : 0);
  std::visit([&](auto& scheme) { scheme.begin(mesh, node_normals_, tau); }, scheme_);

  for_each_by_colour(mesh, [&](int e) {
    static thread_local ElementSystem element;
    static thread_local FlowPiece piece;
    const MovingTriangle triangle{.e = e,
                                  .tau = tau,
                                  .X = on_element(mesh, e, old.X),
                                  .node_normals = on_element(mesh, e, node_normals_),
                                  .from = on_element(mesh, e, from.X),
                                  .H_from = on_element(mesh, e, from.H)};
    assemble_element(material_,
                     {.X = triangle.X,
                      .node_normals = triangle.node_normals,
                      .projected_normals = on_element(mesh, e, curvature.normals),
                      .beta = on_element(mesh, e, old.beta),
                      .H = on_element(mesh, e, curvature.H),
                      .order_force = on_element(mesh, e, order_force)},
                     constraints.area_rate, element);
    set_flow(element, constraints.keep_volume, piece);
    std::visit([&](auto& scheme) { scheme.add(mesh, triangle, element.mesh, piece); }, scheme_);
    add_flow(e, triangle.node_normals, piece);
  });
  sum_over_ranks(mesh, flow_.rhs);
  sum_over_ranks(mesh, total_area_rate_);
  std::visit([&](auto& scheme) { scheme.end(mesh); }, scheme_);
  set_multipliers(constraints);
  if (has_moment_)
    set_moment(total_mean_curvature(mesh, old.X, curvature.H), constraints, from.X - old.X, tau);
}

// What a pattern does not add: their rows are common to all elements.
void CoupledSystem::set_multipliers(const Constraints& constraints) {
  const int lambda = layout_.lambda;
  if (along_normals()) flow_.rhs[flow_.rhs.size() - 1] = total_area_rate_.sum();
  flow_.rhs[lambda] = constraints.keep_volume ? constraints.volume_rate : 0;  // (P2)
  if (!constraints.keep_volume) set_diagonal(lambda, 1);
}

// Of a multiplier, on the first rank.
void CoupledSystem::set_diagonal(int multiplier, double value) {
  if (ranks_.is_first()) flow_.matrix.coeffRef(multiplier, multiplier) = value;
}

// (P3) at the end of the step, W₂ to first order there: the way from the surface of the integrals to where Y begins, and V.
void CoupledSystem::set_moment(double W2, const Constraints& constraints, const Nodes& way,
                               double tau) {
  const model::AreaDifference& ad = material_.area_difference;
  const int moment = layout_.lambda + multipliers_ - 1;
  if (!constraints.keep_volume) {  // on a sphere W₂ changes with the area alone
    set_diagonal(moment, 1);
    flow_.rhs[moment] = 0;
    return;
  }
  double on_way = 0;
  for (SparseMatrix::InnerIterator it(flow_.matrix, moment); it; ++it) {
    if (along_normals() && it.col() < nodes_)
      on_way += it.value() * node_normals_.col(it.col()).dot(way.col(it.col()));
    if (!along_normals() && it.col() < 3 * nodes_)
      on_way += it.value() * way(it.col() % 3, it.col() / 3);
  }
  ranks_.sum({&on_way, 1});
  set_diagonal(moment, -constraints.area * ad.compliance() / tau);
  flow_.rhs[moment] = (ad.W2 - W2 - on_way) / tau;  // (P3)
}

void CoupledSystem::set_lipids(const Field& load) {
  auto rhs = flow_.rhs.segment(layout_.p, quadratic_nodes_);
  if (lipids_.size() > 0) rhs += lipids_;
  rhs -= load;  // (P1)
  lipids_ = load;
}

const LinearSystem& CoupledSystem::motion() const {
  return std::visit([](const auto& scheme) -> const LinearSystem& { return scheme.motion(); },
                    scheme_);
}
Eigen::VectorXd CoupledSystem::motion_rhs(const Eigen::VectorXd& flow) const {
  return std::visit(
      [&](const auto& scheme) { return scheme.motion_rhs(velocity(flow), curvature(flow)); },
      scheme_);
}

Nodes CoupledSystem::velocity(const Eigen::VectorXd& flow) const {
  if (along_normals()) return node_normals_ * flow.head(nodes_).asDiagonal();
  return flow.head(3 * nodes_).reshaped(3, nodes_);
}
Field CoupledSystem::pressure(const Eigen::VectorXd& flow) const {
  if (along_normals()) return Field::Constant(quadratic_nodes_, flow[flow.size() - 1]);
  return flow.segment(layout_.p, quadratic_nodes_);
}
Field CoupledSystem::curvature(const Eigen::VectorXd& flow) const {
  return flow.segment(layout_.H, nodes_);
}
Nodes CoupledSystem::displacement(const Eigen::VectorXd& flow,
                                  const Eigen::VectorXd& motion) const {
  const Eigen::VectorXd Y = flow.segment(layout_.Y, layout_.lambda - layout_.Y);
  return std::visit(
      [&](const auto& scheme) { return scheme.displacement(velocity(flow), Y, motion); }, scheme_);
}
void CoupledSystem::scale_displacements(double factor, Eigen::VectorXd& flow,
                                        Eigen::VectorXd& motion) const {
  flow.segment(layout_.Y, layout_.lambda - layout_.Y) *= factor;
  motion *= factor;
}

}  // namespace sbeh::surface3d
