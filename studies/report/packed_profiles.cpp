#include "studies/report/packed_profiles.h"

#include "studies/states/profile_file.h"

#include <algorithm>

namespace sbeh::studies {

std::size_t most_profile_nodes(std::size_t profiles) {
  constexpr std::size_t most_nodes_of_all = 500'000, largest_profile = 97, least_profile = 25;
  return std::clamp(most_nodes_of_all / std::max<std::size_t>(profiles, 1), least_profile,
                    largest_profile);
}

PackedProfiles::PackedProfiles(std::size_t expected)
    : most_nodes_(most_profile_nodes(expected)), fields_("profiles", {"r", "z", "order", "H"}) {}

void PackedProfiles::add(int index, const std::filesystem::path& file) {
  using Row = ProfileRow;
  const auto nodes = evenly(read_rows(profile_columns(), file), most_nodes_);
  fields_.add(std::to_string(index),
              field_values(nodes, std::array{&Row::r, &Row::z, &Row::order, &Row::mean_curvature}));
}

}  // namespace sbeh::studies
