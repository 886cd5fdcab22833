#include "studies/states/revolved_order.h"

#include "axisym/diagnostics.h"

#include <vector>

namespace sbeh::studies {

namespace {

// On a meridian and the opposite one.
AreaSamples samples_of(const axisym::Nodes& X) {
  std::vector<Eigen::Vector4d> all;
  axisym::for_each_point(X, axisym::assembly_points(),
                         [&](int, const axisym::ShapeValues&, const axisym::CurvePoint& p) {
                           for (const double side : {-1, 1})
                             all.emplace_back(side * p.x[0], 0, p.x[1], p.dS / 2);
                         });
  AreaSamples samples{Eigen::Matrix3Xd(3, all.size()), Eigen::VectorXd(all.size())};
  for (std::size_t k = 0; k < all.size(); ++k) {
    samples.points.col(Eigen::Index(k)) = all[k].head<3>();
    samples.areas[Eigen::Index(k)] = all[k][3];
  }
  return samples;
}

}  // namespace

void complete_order(const model::Material& material, const OrderPattern& pattern,
                    axisym::State& state) {
  if (pattern.is_there()) {
    Eigen::Matrix3Xd nodes = Eigen::Matrix3Xd::Zero(3, state.X.cols());
    nodes.row(0) = state.X.row(0);
    nodes.row(2) = state.X.row(1);
    state.beta = with_pattern(state.beta, pattern, nodes, samples_of(state.X));
  }
  if (material.conserves_order())
    state.beta.array() += shift_to_mean(material, axisym::diagnose(material, state).order_mean);
}

}  // namespace sbeh::studies
