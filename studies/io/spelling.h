// Words in messages and files: the nearest known word, and quotes.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Least number of letters to insert, remove, replace or swap with the next one; capitals count as
/// small letters.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word nearest to `word`; none if more than half of it would have to change.
std::optional<std::string> nearest(std::string_view word, const std::vector<std::string>& known);

/// The text between quotes, escaped as TOML wants it.
std::string in_quotes(std::string_view text);

/// `"a", "b"`
std::string in_quotes(const std::vector<std::string>& words);

}  // namespace sbeh::studies
