#include "studies/states/order_formula.h"

#include <fmt/format.h>
#include <muParser.h>

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sbeh::studies {

namespace {

enum Variable { v_z, v_r, v_theta, v_x, v_y, v_phi, variables };
constexpr std::array variable_names{"z", "r", "theta", "x", "y", "phi"};

std::array<double, variables> variables_at(const Eigen::Vector3d& x) {
  const double r = std::hypot(x[0], x[1]);
  return {x[2], r, std::atan2(r, x[2]), x[0], x[1], std::atan2(x[1], x[0])};
}

}  // namespace

Eigen::VectorXd values_of_formula(const std::string& formula, bool of_revolution,
                                  const Eigen::Matrix3Xd& places) {
  std::array<double, variables> here{};
  Eigen::VectorXd values(places.cols());
  try {
    mu::Parser parser;
    parser.DefineConst("pi", std::numbers::pi);
    for (std::size_t k = 0; k < (of_revolution ? std::size_t(v_x) : here.size()); ++k)
      parser.DefineVar(variable_names.at(k), &here.at(k));
    parser.SetExpr(formula);
    for (Eigen::Index i = 0; i < places.cols(); ++i) {
      here = variables_at(places.col(i));
      values[i] = parser.Eval();
    }
  } catch (const mu::Parser::exception_type& error) {
    throw std::invalid_argument(
        fmt::format("{} Known: {}, pi and functions as tanh, exp, sqrt, max", error.GetMsg(),
                    of_revolution ? "z, r, theta" : "x, y, z, r, theta, phi"));
  }
  return values;
}

}  // namespace sbeh::studies
