#include "axisym/rim/profile.h"

#include <algorithm>
#include <cmath>

namespace sbeh::axisym::spectral {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr int parts = 9;  // of an element: three P3 elements

// Values over one element, from those at its nodes.
class Interpolant {
 public:
  Interpolant(const VectorXd& nodes, const VectorXd& values) : nodes_(nodes), values_(values) {
    weights_.resize(nodes.size());
    const double scale = 4 / (nodes[nodes.size() - 1] - nodes[0]);  // keeps the products near 1
    for (Index i = 0; i < nodes.size(); ++i) {
      double product = 1;
      for (Index j = 0; j < nodes.size(); ++j)
        if (j != i) product *= (nodes[i] - nodes[j]) * scale;
      weights_[i] = 1 / product;
    }
  }
  double operator()(double x) const {  // barycentric
    double above = 0, below = 0;
    for (Index i = 0; i < nodes_.size(); ++i) {
      if (x == nodes_[i]) return values_[i];
      const double share = weights_[i] / (x - nodes_[i]);
      above += share * values_[i];
      below += share;
    }
    return above / below;
  }

 private:
  VectorXd nodes_, values_, weights_;
};

}  // namespace

State profile_of(const RimProblem& problem, const VectorXd& y) {
  const VectorXd sigma = rim_nodes(problem.mesh), psi = problem.angles_at_nodes(y),
                 beta = problem.order_at_nodes(y);
  const int degree = problem.mesh.degree, half = problem.mesh.elements * parts;
  State state{.X = Nodes::Zero(2, 2 * half + 1), .beta = Field(2 * half + 1)};
  state.beta[0] = beta[0];
  double r = 0, z = 0;
  for (int e = 0; e < problem.mesh.elements; ++e) {
    const VectorXd at = sigma.segment(e * degree, degree + 1);
    const Interpolant angle(at, psi.segment(e * degree, degree + 1)),
        order(at, beta.segment(e * degree, degree + 1));
    const double step = (at[degree] - at[0]) / parts;
    for (int k = 0; k < parts; ++k) {
      for (const ShapeValues& s : diagnostic_points()) {
        const double a = angle(at[0] + (k + s.x) * step), ds = y[0] * step * s.weight;
        r += ds * std::cos(a);
        z -= ds * std::sin(a);
      }
      const Index node = e * parts + k + 1;
      state.X.col(node) << r, z;
      state.beta[node] = k + 1 == parts ? beta[(e + 1) * degree] : order(at[0] + (k + 1) * step);
    }
  }
  state.X.row(1).array() -= z;  // the equator
  for (Index i = 0; i < half; ++i) {
    state.X.col(2 * half - i) << state.X(0, i), -state.X(1, i);
    state.beta[2 * half - i] = state.beta[i];
  }
  return state;
}

}  // namespace sbeh::axisym::spectral
