// What a triangle has at a point, as linear functions of the unknowns at its nodes.
#pragma once

#include "model/numerics/contraction.h"
#include "surface3d/bent_shapes.h"
#include "surface3d/stationary/point_density.h"

#include <array>
#include <vector>

namespace sbeh::surface3d::at_point {

inline constexpr int unknown_d = 10 * node_d, unknown_Lambda = 10 * node_Lambda,
                     unknown_H = 10 * node_H, unknown_beta = 10 * node_beta,
                     element_unknowns = 10 * node_unknowns;

/// The raw data as linear functions of the unknowns.
class Rows {
 public:
  Rows(const ElementNodes& normals, const BentShapes& s, bool bent);
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;
  std::array<model::DataRow<10>, raw_data> rows;

 private:
  using Shape = Eigen::Matrix<double, 10, 1>;
  std::array<Shape, 15> along_;  // times a component of the normals
};

struct ElementState {
  ElementNodes X, normals, Lambda;
  ElementField H, beta;
};
ElementState on_element(const StationaryState& state, const Nodes& normals,
                        const Triangulation& mesh, int e);
Raw raw_data_of(const ElementState& state, const BentShapes& s);

}  // namespace sbeh::surface3d::at_point
