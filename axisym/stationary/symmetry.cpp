#include "axisym/stationary/symmetry.h"

namespace sbeh::axisym {

namespace {

Field even(const Field& f) { return (f + f.reverse()) / 2; }

}  // namespace

StationaryState upside_down(const StationaryState& state) {
  StationaryState turned = state;
  turned.X = state.X.rowwise().reverse();
  turned.X.row(1) = -turned.X.row(1).eval();
  turned.beta = state.beta.reverse();
  turned.H = state.H.reverse();
  turned.Lambda = state.Lambda.reverse();
  return turned;
}

bool is_symmetric(const Nodes& X) {
  const double height = X(1, 0) + X(1, X.cols() - 1);
  return (X.row(0) - X.row(0).reverse()).cwiseAbs().maxCoeff() < 1e-6
      && ((X.row(1) + X.row(1).reverse()).array() - height).abs().maxCoeff() < 1e-6;
}

StationaryState symmetric_part(const StationaryState& state) {
  StationaryState mean = state;
  const double middle = (state.X(1, 0) + state.X(1, state.X.cols() - 1)) / 2;
  mean.X.row(0) = even(state.X.row(0)).transpose();
  mean.X.row(1) = ((state.X.row(1) - state.X.row(1).reverse()) / 2).array() + middle;
  mean.beta = even(state.beta);
  mean.H = even(state.H);
  mean.Lambda = even(state.Lambda);
  return mean;
}

}  // namespace sbeh::axisym
