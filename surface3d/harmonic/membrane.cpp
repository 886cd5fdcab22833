#include "surface3d/harmonic/membrane.h"

#include "model/energy_density.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <ceres/jet.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sbeh::surface3d {

using Eigen::Index;
using Eigen::MatrixX3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

// ---- fields at the points -----------------------------------------------------------------------

// Derivatives of a field in normal coordinates, as HarmonicBasis has them.
enum { value, by_s, by_t, by_ss, by_st, by_tt };

struct PointFields {
  std::array<MatrixX3d, jet_size> x;  // each points x 3
  std::array<VectorXd, 3> beta;       // each points
};

PointFields at_points(const HarmonicBasis& basis, const HarmonicMembrane& membrane) {
  PointFields fields;
  for (std::size_t k = 0; k < jet_size; ++k) fields.x[k] = basis.Y[k] * membrane.X;
  for (std::size_t k = 0; k < fields.beta.size(); ++k) fields.beta[k] = basis.Y[k] * membrane.beta;
  return fields;
}

// ---- the energy ---------------------------------------------------------------------------------

constexpr int energy_variables = 18;  // x_s, x_t, x_ss, x_st, x_tt; β, β_s, β_t
using Number = ceres::Jet<double, energy_variables>;
using Vector = std::array<Number, 3>;

Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector vector_at(const MatrixX3d& x, Index p, int first) {
  return {Number(x(p, 0), first), Number(x(p, 1), first + 1), Number(x(p, 2), first + 2)};
}

// Per area of the unit sphere.
model::EnergyDensity<Number> density_at(const model::Material& material, const PointFields& at,
                                        Index p) {
  const Vector x_s = vector_at(at.x[by_s], p, 0), x_t = vector_at(at.x[by_t], p, 3),
               x_ss = vector_at(at.x[by_ss], p, 6), x_st = vector_at(at.x[by_st], p, 9),
               x_tt = vector_at(at.x[by_tt], p, 12), n = cross(x_s, x_t);
  const Number beta(at.beta[value][p], 15), beta_s(at.beta[by_s][p], 16),
      beta_t(at.beta[by_t][p], 17);
  const Number E = dot(x_s, x_s), F = dot(x_s, x_t), G = dot(x_t, x_t), JJ = dot(n, n),
               J = sqrt(JJ);
  const Number l = dot(x_ss, n) / J, m = dot(x_st, n) / J, k = dot(x_tt, n) / J;
  const Number gradient =
      (G * beta_s * beta_s - 2. * F * beta_s * beta_t + E * beta_t * beta_t) / JJ;
  auto e =
      model::energy_density(material, beta, gradient, Number((G * l - 2. * F * m + E * k) / JJ),
                            Number((l * k - m * m) / JJ));
  for (Number* part : {&e.distortion, &e.bending, &e.gaussian, &e.thermotropic}) *part *= J;
  return e;
}

// ---- the metric ---------------------------------------------------------------------------------

// Per point an orthonormal frame of the surface and what turns derivatives by s and t into those along it.
struct Tangents {
  MatrixX3d t1, t2, nu;    // points x 3
  VectorXd area;           // J, dS = J dω
  VectorXd c1s, c2s, c2t;  // ∂_1 = c1s ∂_s, ∂_2 = c2s ∂_s + c2t ∂_t
};

std::optional<Tangents> tangents_of(const PointFields& at) {
  const Index count = at.x[value].rows();
  Tangents frame{MatrixX3d(count, 3), MatrixX3d(count, 3), MatrixX3d(count, 3), VectorXd(count),
                 VectorXd(count),     VectorXd(count),     VectorXd(count)};
  for (Index p = 0; p < count; ++p) {
    const Vector3d x_s = at.x[by_s].row(p), x_t = at.x[by_t].row(p), n = x_s.cross(x_t);
    const double length = x_s.norm(), J = n.norm();
    if (!(J > 0)) return {};
    frame.t1.row(p) = x_s / length;
    frame.nu.row(p) = n / J;
    frame.t2.row(p) = n.cross(x_s) / (J * length);
    frame.area[p] = J;
    frame.c1s[p] = 1 / length;
    frame.c2s[p] = -x_s.dot(x_t) / (length * J);
    frame.c2t[p] = length / J;
  }
  return frame;
}

// Some of the points: as many as the cache has room for.
struct Some {
  Index first, count;
};
void for_some_at_a_time(Index points, auto&& visit) {
  constexpr Index at_a_time = 128;
  for (Index first = 0; first < points; first += at_a_time)
    visit(Some{first, std::min(at_a_time, points - first)});
}
auto of(const Some& some, const auto& all) { return all.middleRows(some.first, some.count); }

// Derivatives of V along the frame at some of the points, by the coefficients of V, one component after the other. Keeps its memory.
class Strains {
 public:
  Strains(const HarmonicBasis& basis, const Tangents& frame) : basis_(basis), frame_(frame) {}

  void move_to(const Some& some) {
    const auto Y_s = of(some, basis_.Y[by_s]), Y_t = of(some, basis_.Y[by_t]);
    Y1_ = of(some, frame_.c1s).asDiagonal() * Y_s;
    Y2_ = of(some, frame_.c2s).asDiagonal() * Y_s;
    Y2_ += of(some, frame_.c2t).asDiagonal() * Y_t;
  }
  // Rows of a·∂_1V + b·∂_2V.
  const MatrixXd& rows(const MatrixX3d& a, const MatrixX3d& b) {
    const Index count = Y1_.cols();
    rows_.resize(Y1_.rows(), 3 * count);
    for (Index k = 0; k < 3; ++k)
      rows_.middleCols(k * count, count) =
          a.col(k).asDiagonal() * Y1_ + b.col(k).asDiagonal() * Y2_;
    return rows_;
  }

 private:
  const HarmonicBasis& basis_;
  const Tangents& frame_;
  MatrixXd Y1_, Y2_, rows_;
};

MatrixX3d scaled(const VectorXd& by, const MatrixX3d& a) { return by.asDiagonal() * a; }

// ---- the drag -----------------------------------------------------------------------------------

// (V1), below the diagonal: ½ the sum of squares of σ_11, σ_22, and twice that of σ_12.
MatrixXd viscous_drag(const HarmonicBasis& basis, const Tangents& frame, const VectorXd& eta_dS) {
  const VectorXd root = (0.5 * eta_dS).cwiseSqrt();
  const Index count = basis.Y[value].cols();
  MatrixXd drag = MatrixXd::Zero(3 * count, 3 * count);
  Strains strains(basis, frame);
  for_some_at_a_time(root.size(), [&](const Some& some) {
    strains.move_to(some);
    const MatrixX3d none = MatrixX3d::Zero(some.count, 3),
                    r1 = scaled(of(some, root), of(some, frame.t1)),
                    r2 = scaled(of(some, root), of(some, frame.t2));
    const auto add_square = [&](const MatrixX3d& a, const MatrixX3d& b) {
      drag.selfadjointView<Eigen::Lower>().rankUpdate(strains.rows(a, b).transpose());
    };
    add_square(2 * r1, none);
    add_square(none, 2 * r2);
    add_square(std::numbers::sqrt2 * r2, std::numbers::sqrt2 * r1);
  });
  return drag;
}

// (V2)
MatrixXd friction_drag(const model::Material& material, const MatrixXd& mass, const MatrixXd& Y,
                       const Tangents& frame, const VectorXd& area) {
  const Index count = Y.cols();
  const double excess = material.friction_normal - material.friction_tangential;
  MatrixXd drag = MatrixXd::Zero(3 * count, 3 * count);
  for (Index k = 0; k < 3; ++k) {
    drag.block(k * count, k * count, count, count) = material.friction_tangential * mass;
    for (Index i = 0; excess != 0 && i < 3; ++i)
      drag.block(i * count, k * count, count, count) +=
          excess * Y.transpose()
          * area.cwiseProduct(frame.nu.col(i)).cwiseProduct(frame.nu.col(k)).asDiagonal() * Y;
  }
  return drag;
}

// Orthogonal enough: shifts along and turns about x, y, z; unknowns x 6.
MatrixXd rigid_motions(const MatrixX3d& X) {
  const Index count = X.rows();
  MatrixXd motions = MatrixXd::Zero(3 * count, 6);
  for (Index k = 0; k < 3; ++k) {
    const Index a = (k + 1) % 3, b = (k + 2) % 3;
    motions(k * count, k) = 1;
    motions.col(3 + k).segment(a * count, count) = -X.col(b);
    motions.col(3 + k).segment(b * count, count) = X.col(a);
  }
  return motions;
}

// Rows of (P1), one for each of the first `tests` harmonics, and of (P2).
MatrixXd kept_measures(const HarmonicBasis& basis, Index tests, const Tangents& frame,
                       const VectorXd& area) {
  const MatrixXd& Y = basis.Y[value];
  MatrixXd rows = MatrixXd::Zero(tests + 1, 3 * Y.cols());
  Strains strains(basis, frame);
  for_some_at_a_time(area.size(), [&](const Some& some) {
    const auto by_area = [&](const MatrixX3d& a) { return scaled(of(some, area), of(some, a)); };
    strains.move_to(some);
    rows.topRows(tests).noalias() += of(some, Y).leftCols(tests).transpose()
                                   * strains.rows(by_area(frame.t1), by_area(frame.t2));
  });
  rows.row(tests) = (Y.transpose() * scaled(area, frame.nu)).reshaped().transpose();
  return rows;
}

// V with the least ½VᵀRV − fᵀV where CV = 0; of R what is on and below the diagonal.
VectorXd constrained_minimum(const MatrixXd& R, const VectorXd& f, const MatrixXd& C) {
  const Eigen::LLT<MatrixXd> root(R);
  const VectorXd force = root.matrixL().solve(f);
  const MatrixXd fixed = root.matrixL().solve(C.transpose());
  const VectorXd multipliers = (fixed.transpose() * fixed).ldlt().solve(fixed.transpose() * force);
  return root.matrixU().solve(force - fixed * multipliers);
}

}  // namespace

HarmonicMechanics::HarmonicMechanics(const model::Material& material, model::Model model,
                                     int degree)
    : material_(model::effective(material, model)), free_order_(model::has_free_order(model)) {
  if (degree < 4 || degree > 32)
    throw std::invalid_argument(fmt::format("degree {}: must be in [4, 32]", degree));
  if (area_constraint(model) == model::AreaConstraint::global)
    throw std::invalid_argument(fmt::format(
        "model {}: the flow of harmonics keeps the area of every piece", sbeh::name(model)));
  if (material.area_difference.is_there())
    throw std::invalid_argument("area_difference: the flow of harmonics has none");
  if (material.has_lipid_density())
    throw std::invalid_argument("lipid_density: the flow of harmonics keeps the area");
  if (material.conserves_order())
    throw std::invalid_argument("order: the flow of harmonics has only one that relaxes");
  const SphereRule rule = sphere_rule(2 * (degree + 1));
  basis_ = harmonic_basis(degree, rule.omega);
  weights_ = rule.weights;
}

HarmonicMembrane HarmonicMechanics::through(const Eigen::Matrix3Xd& x, const VectorXd& beta) const {
  const MatrixXd weighted = weights_.asDiagonal() * basis_.Y[value];
  return {weighted.transpose() * x.transpose(), weighted.transpose() * beta};
}

auto HarmonicMechanics::measure(const HarmonicMembrane& membrane) const -> std::optional<Measures> {
  const PointFields at = at_points(basis_, membrane);
  Measures all;
  MatrixXd slopes(points().cols(), energy_variables);
  for (Index p = 0; p < points().cols(); ++p) {
    const Vector3d x = at.x[value].row(p), x_s = at.x[by_s].row(p), x_t = at.x[by_t].row(p);
    const Vector3d n = x_s.cross(x_t);
    if (!(n.norm() > 0)) return {};
    all.area += weights_[p] * n.norm();
    all.volume += weights_[p] * x.dot(n) / 3;
    all.order_mean += weights_[p] * n.norm() * at.beta[value][p];
    const auto e = density_at(material_, at, p);
    all.energy.distortion += weights_[p] * e.distortion.a;
    all.energy.bending += weights_[p] * (e.bending.a + e.gaussian.a);
    all.energy.thermotropic += weights_[p] * e.thermotropic.a;
    slopes.row(p) = weights_[p] * e.total().v.transpose();
  }
  all.order_min = at.beta[value].minCoeff();
  all.order_mean /= all.area;
  all.order_max = at.beta[value].maxCoeff();
  all.by_X = MatrixX3d::Zero(membrane.X.rows(), 3);
  for (Index k = 0; k < 5; ++k)
    all.by_X += basis_.Y[std::size_t(by_s + k)].transpose() * slopes.middleCols<3>(3 * k);
  all.by_beta = VectorXd::Zero(membrane.X.rows());
  for (Index k = 0; k < 3; ++k)
    all.by_beta += basis_.Y[std::size_t(k)].transpose() * slopes.col(15 + k);
  return all;
}

auto HarmonicMechanics::rates(const HarmonicMembrane& membrane) const -> std::optional<Rates> {
  const std::optional<Measures> measures = measure(membrane);
  const PointFields at = at_points(basis_, membrane);
  const std::optional<Tangents> frame = tangents_of(at);
  if (!measures || !frame) return {};
  const VectorXd area = weights_.cwiseProduct(frame->area);  // dS
  const MatrixXd& Y = basis_.Y[value];
  const MatrixXd mass = Y.transpose() * area.asDiagonal() * Y;

  const VectorXd eta = at.beta[value].unaryExpr([&](double b) { return material_.eta(b); });
  const MatrixXd viscous = viscous_drag(basis_, *frame, area.cwiseProduct(eta));
  const MatrixXd friction = friction_drag(material_, mass, Y, *frame, area);
  MatrixXd resistance = viscous + friction;
  if (material_.frictionless()) {  // no force moves it rigidly: any resistance will do
    const MatrixXd rigid = rigid_motions(membrane.X);
    resistance += rigid * rigid.transpose();
  }
  const VectorXd V =
      constrained_minimum(resistance, -measures->by_X.reshaped(),
                          kept_measures(basis_, harmonic_count(degree() - 1), *frame, area));

  Rates rates{.rate = {V.reshaped(membrane.X.rows(), 3), VectorXd::Zero(membrane.X.rows())},
              .dissipation = {}};
  rates.dissipation.viscous = V.dot(viscous.selfadjointView<Eigen::Lower>() * V);
  rates.dissipation.friction = V.dot(friction * V);
  if (free_order_) {
    rates.rate.beta = mass.llt().solve(-measures->by_beta) / material_.order_drag();
    rates.dissipation.order = -measures->by_beta.dot(rates.rate.beta);
  }
  return rates;
}

}  // namespace sbeh::surface3d
