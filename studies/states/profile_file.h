// A state of the axisymmetric solver as a table: one line per node, all digits kept.
#pragma once

#include "axisym/curve.h"
#include "studies/io/columns.h"

#include <filesystem>
#include <string_view>

namespace sbeh::studies {

/// A node, in the order from the north pole to the south pole.
struct ProfileRow {
  double arc_length, r, z, order, mean_curvature;
};
const Columns<ProfileRow>& profile_columns();

/// From the first pole to each node.
axisym::Field arc_lengths(const axisym::Nodes& X);

/// A row for every node of the P3 elements (3 per element and one). Numbers read back are the same bits.
/// Throws OutputError.
void write_profile(const std::filesystem::path& path, const axisym::State& state);

/// Throws OutputError when the file cannot be read or is no such table; it ends with `advice`.
axisym::State read_profile(const std::filesystem::path& path,
                           std::string_view advice = "delete it to have it computed again");

}  // namespace sbeh::studies
