// The meridian of an axisymmetric shape and the closed cross section it gives.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

namespace sbeh::picture {

using Points = std::vector<std::array<double, 2>>;

/// From the north pole to the south pole; the surface is its revolution about the z axis.
struct Profile {
  std::vector<double> r;
  std::vector<double> z;
  std::vector<double> order;
};

/// Finds its columns r, z, order by name; throws InputError.
Profile read_profile(const std::filesystem::path& file);

/// The cross section in a plane through the axis: closed (first point = last point) and centred in z.
struct Cut {
  Points points;              ///< (±r, z)
  std::vector<double> order;  ///< β at each point
  double half_width = 0.0;
  double half_height = 0.0;
};

Cut mirrored(const Profile& profile);

/// Only the points a picture can show: those farther apart than `spacing`, or where the curve turns.
Cut thinned(const Cut& cut, double spacing);

}  // namespace sbeh::picture
