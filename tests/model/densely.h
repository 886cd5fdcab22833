// A band matrix as a dense one.
#pragma once

#include "model/numerics/band_matrix.h"

namespace sbeh::model {

inline Eigen::MatrixXd densely(const BandMatrix& band) {
  return Eigen::MatrixXd::NullaryExpr(band.size(), band.size(), [&](auto i, auto j) {
    return std::abs(i - j) <= band.half_width() ? band(int(i), int(j)) : 0;
  });
}

}  // namespace sbeh::model
