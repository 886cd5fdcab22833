#include "studies/io/toml_messages.h"

#include "axisym/options.h"
#include "model/material.h"
#include "studies/io/spelling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace sbeh::studies {

std::string shown_key(std::string_view key) {
  const bool bare = !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
    return std::isalnum(c) || c == '_' || c == '-';
  });
  return bare ? std::string(key) : in_quotes(key);
}

std::string shown(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* integer = node.as_integer()) return fmt::format("{}", integer->get());
  if (const auto* number = node.as_floating_point()) {
    const std::string digits = fmt::format("{}", number->get());
    return digits.find_first_not_of("-0123456789") == std::string::npos ? digits + ".0" : digits;
  }
  std::vector<std::string> parts;
  if (const auto* list = node.as_array()) {
    for (const toml::node& element : *list) parts.push_back(shown(element));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  if (const auto* table = node.as_table()) {
    for (const auto& [key, value] : *table)
      parts.push_back(fmt::format("{} = {}", shown_key(key.str()), shown(value)));
    return fmt::format("{{ {} }}", fmt::join(parts, ", "));
  }
  std::ostringstream other;  // booleans, dates, times
  node.visit([&other](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) other << value;
  });
  return other.str();
}

int line_of(const toml::node& node) { return int(node.source().begin.line); }

std::string place(const TableState& table, int line) {
  return line > 0 ? fmt::format("{}:{}", table.file, line) : table.file;
}

std::string full_name(const TableState& table, std::string_view key) {
  const std::string name = table.prefix + shown_key(key);
  return table.section.empty() ? name : fmt::format("[{}] {}", table.section, name);
}

std::string section_name(const TableState& table, std::string_view key) {
  return fmt::format("{}{}{}", table.section, table.section.empty() ? "" : ".", shown_key(key));
}

void fail_at(const TableState& table, std::string_view key, const toml::node& value,
             std::string_view what) {
  if (value.is_table() && !value.as_table()->is_inline())
    throw InputError(
        fmt::format("{}: [{}]: {}", place(table, line_of(value)), section_name(table, key), what));
  constexpr std::size_t longest_value = 60;  // letters of a value in a message
  std::string text = shown(value);
  if (text.size() > longest_value) {
    std::size_t end = longest_value - 3;
    while (end > 0 && (text[end] & 0xc0) == 0x80) --end;  // not within a letter of UTF-8
    text = text.substr(0, end) + "...";
  }
  throw InputError(fmt::format("{}: {} = {}: {}", place(table, line_of(value)),
                               full_name(table, key), text, what));
}

bool asked_for(const TableState& table, std::string_view key) {
  return std::find(table.asked.begin(), table.asked.end(), key) != table.asked.end();
}

namespace {

// Keys that stand in one table, and might be looked for in another; the first of the tables that a kind of input has.
struct KeyPlace {
  std::vector<std::string_view> keys, tables;
};
const std::vector<KeyPlace>& key_places() {
  static const std::vector<KeyPlace> all = [] {
    const model::Material any_material;
    const axisym::Numerics any_numerics;
    std::vector<std::string_view> material{"friction", "landau_de_gennes"};
    for_each_parameter(any_material, [&](const model::Parameter& parameter, const auto&) {
      material.emplace_back(parameter.name);
    });
    std::vector<std::string_view> numerics;
    for_each_parameter(any_numerics, [&](const model::Parameter& parameter, const auto&) {
      numerics.emplace_back(parameter.name);
    });
    return std::vector<KeyPlace>{
        {material, {"material"}},
        {{"triangles"}, {"surface", "surface3d"}},
        {{"coarser"}, {"surface3d"}},
        {{"end"}, {"time", "surface3d"}},
        {{"output", "frames", "profiles", "every_step", "stop_at_rest", "finish",
          "checkpoint_minutes"},
         {"time"}},
        {{"remesh", "most_triangles", "integrator", "scheme", "factorisation"}, {"numerics"}},
        {numerics, {"numerics"}},
        {{"L"}, {"scan", "stability", "compare", "modes", "material"}},
        {{"reduced_volume", "branch", "branches"},
         {"scan", "stability", "compare", "modes", "start", "surface"}},
        {{"radius_um", "bending_rigidity_kT", "bending_rigidity_J", "temperature",
          "surface_viscosity"},
         {"units"}}};
  }();
  return all;
}

}  // namespace

std::optional<std::string> place_of_key(const TableState& table, std::string_view key) {
  const TableState& file = table.file_table ? *table.file_table : table;
  for (const KeyPlace& place : key_places()) {
    if (std::ranges::find(place.keys, key) == place.keys.end()) continue;
    for (const std::string_view other : place.tables)
      if (other != table.section && asked_for(file, other)) return std::string(other);
  }
  return {};
}

std::string unknown(const TableState& table, const toml::key& key,
                    const std::optional<std::string>& meant) {
  const auto* child = table.table->get_as<toml::table>(key.str());
  const bool section = child && !child->is_inline();
  const std::string name =
      section ? fmt::format("[{}]", section_name(table, key.str())) : full_name(table, key.str());
  return fmt::format("{}: {}: unknown {}{}", place(table, int(key.source().begin.line)), name,
                     section ? "table" : "key",
                     meant ? fmt::format("; did you mean {}?", in_quotes(*meant)) : ".");
}

void refuse_misspelt(const TableState& table, const std::vector<std::string>& keys) {
  if (!table.table) return;
  const toml::key* found = nullptr;
  std::string meant;
  for (const auto& [present, value] : *table.table) {
    if (asked_for(table, present.str())) continue;
    const auto key = nearest(present.str(), keys);
    if (!key) continue;
    const bool nearer =
        !found || edit_distance(present.str(), *key) < edit_distance(found->str(), meant);
    if (!nearer) continue;
    found = &present;
    meant = *key;
  }
  if (found) throw InputError(unknown(table, *found, meant));
}

void fail_missing(const TableState& table, std::string_view key, std::string_view kind) {
  refuse_misspelt(table, {std::string(key)});
  const bool top = table.section.empty() && table.prefix.empty();
  throw InputError(fmt::format("{}: {}: missing{}; {}", place(table, table.line),
                               full_name(table, key), top ? " at the top of the file" : "", kind));
}

}  // namespace sbeh::studies
