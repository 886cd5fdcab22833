#include "studies/report/packed_profiles.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {

constexpr std::size_t most_nodes = 97;

struct ProfileField {
  const char* name;
  double ProfileRow::*value;
};
constexpr std::array<ProfileField, 4> profile_fields{{{"r", &ProfileRow::r},
                                                      {"z", &ProfileRow::z},
                                                      {"order", &ProfileRow::order},
                                                      {"H", &ProfileRow::mean_curvature}}};

// As many nodes as a picture needs, with both poles.
std::vector<ProfileRow> thinned(const std::vector<ProfileRow>& nodes) {
  if (nodes.size() <= most_nodes) return nodes;
  std::vector<ProfileRow> few;
  for (std::size_t k = 0; k < most_nodes; ++k)
    few.push_back(nodes[k * (nodes.size() - 1) / (most_nodes - 1)]);
  return few;
}

}  // namespace

void PackedProfiles::add(int index, const std::filesystem::path& file) {
  const std::vector<ProfileRow> nodes = thinned(read_rows(profile_columns(), file));
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
