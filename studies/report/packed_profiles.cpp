#include "studies/report/packed_profiles.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace {

constexpr std::size_t most_nodes_of_all = 500'000, largest_profile = 97, least_profile = 25;

struct ProfileField {
  const char* name;
  double ProfileRow::*value;
};
constexpr std::array<ProfileField, 4> profile_fields{{{"r", &ProfileRow::r},
                                                      {"z", &ProfileRow::z},
                                                      {"order", &ProfileRow::order},
                                                      {"H", &ProfileRow::mean_curvature}}};

// Evenly spread nodes, with both poles.
std::vector<ProfileRow> thinned(const std::vector<ProfileRow>& nodes, std::size_t most) {
  if (nodes.size() <= most) return nodes;
  std::vector<ProfileRow> few;
  for (std::size_t k = 0; k < most; ++k) few.push_back(nodes[k * (nodes.size() - 1) / (most - 1)]);
  return few;
}

}  // namespace

PackedProfiles::PackedProfiles(std::size_t expected)
    : most_nodes_(std::clamp(most_nodes_of_all / std::max<std::size_t>(expected, 1), least_profile,
                             largest_profile)) {}

void PackedProfiles::add(int index, const std::filesystem::path& file) {
  const std::vector<ProfileRow> nodes = thinned(read_rows(profile_columns(), file), most_nodes_);
  Line& line = lines_.emplace_back(Line{index, int(nodes.size())});
  for (std::size_t k = 0; k < profile_fields.size(); ++k) {
    const auto value = profile_fields[k].value;
    for (const ProfileRow& node : nodes) line.ranges[k].include(node.*value);
    for (const ProfileRow& node : nodes) numbers_.push_back(quantised(node.*value, line.ranges[k]));
  }
}

void PackedProfiles::put_into(Bundle& bundle) const {
  std::string table = "index,nodes";
  for (const ProfileField& field : profile_fields)
    table += fmt::format(",{0}_low,{0}_high", field.name);
  table += "\n";
  for (const Line& line : lines_) {
    table += fmt::format("{},{}", line.index, line.nodes);
    for (const auto& [low, high, empty] : line.ranges)
      table += fmt::format(",{:.8g},{:.8g}", low, high);
    table += "\n";
  }
  bundle.add("profiles.csv", table);
  bundle.add("profiles", differences(numbers_, 1));
}

}  // namespace sbeh::studies
