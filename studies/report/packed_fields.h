// Fields at the nodes of curves and surfaces for a live page, in 16 bits.
#pragma once

#include "studies/report/bundle.h"

#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// So many at most, evenly spread, with the first and the last.
template <class Item>
std::vector<Item> evenly(const std::vector<Item>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<Item> chosen;
  for (std::size_t k = 0; k < most; ++k)
    chosen.push_back(all[most == 1 ? 0 : k * (all.size() - 1) / (most - 1)]);
  return chosen;
}

/// Becomes two parts of the data:
///   NAME.csv   a row for each that is added: key, nodes, and of each field the range, FIELD_low and FIELD_high
///   NAME       their fields, one after the other, as differences from node to node
class PackedFields {
 public:
  PackedFields(std::string_view name, const std::vector<std::string>& fields);

  /// `values`: of each field at all nodes.
  void add(std::string_view key, const std::vector<std::vector<double>>& values);
  void put_into(Bundle& bundle) const;

 private:
  std::string name_, table_;
  std::vector<std::uint16_t> numbers_;
};

}  // namespace sbeh::studies
