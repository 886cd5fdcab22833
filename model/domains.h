// The parts of a surface whose order is above the middle of its extremes.
#pragma once

namespace sbeh::model {

/// None where the order is the same everywhere but for 0.1. Along straight lines between the nodes: to the second order of their distance.
struct Domains {
  int count = 0;        ///< connected parts of higher order
  double area = 0;      ///< of all of them
  double boundary = 0;  ///< length of all their boundaries

  static constexpr double least_contrast = 0.1;
};

}  // namespace sbeh::model
