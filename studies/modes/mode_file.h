// A mode of a stationary state as a file: for ParaView, and for a 3D run to start from.
#pragma once

#include "axisym/modes/eigenmodes.h"
#include "meshing/curved_mesh.h"
#include "meshing/resolution.h"
#include "studies/parameters/physics.h"

#include <filesystem>
#include <string>

namespace sbeh::studies {

/// Which mode: `number` counts those of one m and parity from the most unstable on.
struct ModeKey {
  int m = 0;
  axisym::Parity parity = axisym::Parity::none;
  int number = 1;

  bool operator==(const ModeKey&) const = default;
};
/// Name of its files without ending, such as m2_even_1.
std::string stem(const ModeKey& key);

/// The mode u(s) cos mφ along the normal and b(s) cos mφ of the order, with the state it belongs to: that of the flow,
/// which grows at `rate`, where that is known, otherwise that of the energy.
struct StateMode : Physics {
  axisym::State state;
  ModeKey key;
  double eigenvalue, rate;  ///< `rate` may be `not_known`
  axisym::Field u, b;       ///< at the nodes of the state; the largest |u| is 1, at first positive
};

/// u and b times one factor, so that they are as StateMode has them; of a mode of the order alone the largest |b| is 1.
void normalise(axisym::Field& u, axisym::Field& b);

/// The state revolved on a mesh, with the mode at its nodes.
struct RevolvedMode {
  meshing::CurvedMesh mesh;
  Eigen::VectorXd beta;
  Eigen::VectorXd along_normal;   ///< u cos mφ
  Eigen::Matrix3Xd displacement;  ///< that along ν
  Eigen::VectorXd order_change;   ///< b cos mφ
};
/// Throws std::invalid_argument where the profile cannot be meshed.
RevolvedMode revolved(const StateMode& mode, const meshing::Resolution& resolution);

/// VTU with P3 Lagrange triangles of the surface at rest; point data `order`, `mean_curvature`, `displacement` (a vector)
/// and `order_change`; field data: the mode's key, eigenvalue and rate, the profile with u and b, model and
/// material. Throws OutputError, and std::invalid_argument where the profile cannot be meshed.
void write_mode(const std::filesystem::path& path, const StateMode& mode);

/// The same bits. Throws InputError when the file is damaged or holds no mode.
StateMode read_mode(const std::filesystem::path& path);

}  // namespace sbeh::studies
