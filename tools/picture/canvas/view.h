// From where a surface is seen.
#pragma once

#include <Eigen/Core>

namespace sbeh::picture {

/// Where the eye is, seen from the middle of the surface, and what is up.
struct View {
  Eigen::Vector3d from;
  Eigen::Vector3d up;
};
inline const View side_view{{0.5, -1.0, 0.45}, {0, 0, 1}}, top_view{{0, 0, 1}, {0, 1, 0}};

}  // namespace sbeh::picture
