// The fields of a line of a comma separated table.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sbeh::studies {

/// Fields in double quotes may contain commas and doubled quotes; the quotes are taken off.
std::vector<std::string> split_csv(std::string_view line);

/// The text as a field: in quotes where it needs them.
std::string csv_field(std::string_view text);

/// The whole text as a number (nan and inf included). False when it is none.
bool parse_number(std::string_view text, double& value);

}  // namespace sbeh::studies
