// Profiles of a live page, in 16 bits.
#pragma once

#include "studies/report/bundle.h"
#include "studies/states/profile_file.h"

#include <array>
#include <filesystem>
#include <vector>

namespace sbeh::studies {

/// Becomes two parts of the data:
///   profiles.csv   a row per profile: what it belongs to, the nodes, the ranges of the fields
///   profiles       r, z, order and mean curvature of each, as differences from node to node
class PackedProfiles {
 public:
  /// Where many are expected each has fewer nodes.
  explicit PackedProfiles(std::size_t expected);

  /// The profile in a file, thinned where it has more nodes than a picture needs. Throws OutputError where it is damaged.
  void add(int index, const std::filesystem::path& file);
  void put_into(Bundle& bundle) const;

 private:
  struct Line {
    int index, nodes;
    std::array<NumberRange, 4> ranges{};
  };
  std::size_t most_nodes_;
  std::vector<Line> lines_;
  std::vector<std::uint16_t> numbers_;
};

}  // namespace sbeh::studies
