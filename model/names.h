// Enumerations that stand in files. Each has one list, of the words for its values in their order:
//   constexpr auto names(Model) { return std::array{"SBEH", "SSH"}; }
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace sbeh {

template <class E>
concept Named = requires(E value) {
  names(value);
};

template <Named E>
constexpr const char* name(E value) {
  return names(value).at(std::size_t(value));
}

/// All values, in their order.
template <Named E>
constexpr auto values_of(E) {
  std::array<E, names(E{}).size()> values{};
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = E(k);
  return values;
}

/// The value of this name; empty for another word.
template <Named E>
constexpr std::optional<E> value_named(std::string_view word) {
  for (const E value : values_of(E{}))
    if (word == name(value)) return value;
  return {};
}

}  // namespace sbeh
