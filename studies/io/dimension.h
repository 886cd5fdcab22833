// In which powers of the units of length, energy and time numbers are measured: those of every column of a table.
#pragma once

#include <optional>
#include <string_view>

namespace sbeh::studies {

struct Dimension {
  int length = 0, energy = 0, time = 0;

  bool operator==(const Dimension&) const = default;
};

namespace dimension {
inline constexpr Dimension none{}, length{.length = 1}, area{.length = 2}, volume{.length = 3},
    curvature{.length = -1}, energy{.energy = 1}, tension{.length = -2, .energy = 1},
    pressure{.length = -3, .energy = 1}, time{.time = 1}, rate{.time = -1},
    speed{.length = 1, .time = -1}, power{.energy = 1, .time = -1},
    friction{.length = -4, .energy = 1, .time = 1};
}  // namespace dimension

/// Of the numbers in columns of that name, which means the same in all tables, or else in the list is that of one `table`, a
/// file's name without its ending; `none` of words, counts, ratios, and of what only the numerics know. Empty for a
/// name that is not in the list in dimension.cpp.
std::optional<Dimension> dimension_of(std::string_view column, std::string_view table = {});

/// Of the values of a key of inputs that may be texts with a unit; `none` of the others.
Dimension dimension_of_key(std::string_view key);

}  // namespace sbeh::studies
