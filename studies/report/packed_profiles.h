// Profiles of a live page, in 16 bits.
#pragma once

#include "studies/report/packed_fields.h"

#include <array>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace sbeh::studies {

/// How many nodes a profile may have on a page of so many.
std::size_t most_profile_nodes(std::size_t profiles);

/// Of each field at all nodes.
template <class Node, std::size_t fields>
std::vector<std::vector<double>> field_values(const std::vector<Node>& nodes,
                                              const std::array<double Node::*, fields>& members) {
  std::vector<std::vector<double>> values;
  for (const auto member : members) {
    std::vector<double>& field = values.emplace_back();
    for (const Node& node : nodes) field.push_back(node.*member);
  }
  return values;
}

/// The parts `profiles` (packed_fields.h): r, z, order and H.
class PackedProfiles {
 public:
  /// Where many are expected each has fewer nodes.
  explicit PackedProfiles(std::size_t expected);

  /// The profile in a file, thinned where it has more nodes than a picture needs. Throws OutputError where it is damaged.
  void add(int index, const std::filesystem::path& file);
  void put_into(Bundle& bundle) const { fields_.put_into(bundle); }

 private:
  std::size_t most_nodes_;
  PackedFields fields_;
};

}  // namespace sbeh::studies
