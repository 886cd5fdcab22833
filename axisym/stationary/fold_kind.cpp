#include "axisym/stationary/fold_kind.h"

#include "axisym/stationary/arclength.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace sbeh::axisym {

namespace {

// The share of the surface that takes part in a change of order: (∫|f| dS)² / (A ∫f² dS), 1 where it is the same everywhere.
double participation(const Nodes& X, const Field& f) {
  double area = 0, first = 0, second = 0;
  for_each_point(X, diagnostic_points(), [&](int e, const ShapeValues& s, const CurvePoint& p) {
    const double value = value_at(f, e, s);
    area += p.dS;
    first += p.dS * std::abs(value);
    second += p.dS * value * value;
  });
  return first * first / (area * second);
}

struct Place {
  FoldKind kind;
  Eigen::Index node;
};

// Poles, rings of largest and of smallest radius.
std::vector<Place> places_of(const Nodes& X) {
  const auto r = X.row(0);
  const Eigen::Index last = X.cols() - 1;
  Eigen::Index rim = 0;
  r.maxCoeff(&rim);
  std::vector<Place> places{{FoldKind::pole, 0}, {FoldKind::pole, last}, {FoldKind::rim, rim}};
  for (Eigen::Index i = 2; i + 1 < last; ++i)
    if (r[i] < r[i - 1] && r[i] <= r[i + 1]) places.push_back({FoldKind::neck, i});
  return places;
}

// The one nearest to a node along the curve.
FoldKind nearest(const Nodes& X, Eigen::Index node) {
  Field s = Field::Zero(X.cols());
  for (Eigen::Index i = 1; i < s.size(); ++i) s[i] = s[i - 1] + (X.col(i) - X.col(i - 1)).norm();
  const std::vector<Place> places = places_of(X);
  const auto distance = [&](const Place& place) { return std::abs(s[place.node] - s[node]); };
  return std::ranges::min_element(places, {}, distance)->kind;
}

}  // namespace

std::optional<FoldKind> fold_kind(const model::Material& material, double L,
                                  const StationaryState& state) {
  const Eigen::Index nodes = state.beta.size();
  const double v = volume(state.X) / (4 * std::numbers::pi / 3);
  const Line along_L{material, model::Model::SBEH, {v, L}, {v, 2 * L}};
  // Where the branch turns back, its direction is that in which the energy is flat. At a fold only its share of a given
  // direction can be prescribed, here of an order that is lost everywhere.
  const Increment lost{Field::Zero(nodes), Field::Zero(nodes), Field::Zero(nodes),
                       Field::Constant(nodes, -1)};
  const auto here = with_tangent(along_L, {state, 0}, &lost);
  if (!here) return {};
  const Field& softest = here->tangent.beta;
  Eigen::Index node = 0;
  softest.cwiseAbs().maxCoeff(&node);
  const bool is_ordered_there =
      2 * state.beta[node] > state.beta.minCoeff() + state.beta.maxCoeff();
  return is_ordered_there && participation(state.X, softest) > 0.5 ? FoldKind::whole
                                                                   : nearest(state.X, node);
}

}  // namespace sbeh::axisym
