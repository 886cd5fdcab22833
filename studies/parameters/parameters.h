// Structs with a table of parameters (model/parameter.h), read from TOML and written back.
#pragma once

#include "model/material.h"
#include "model/polynomial.h"
#include "studies/io/description.h"
#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace sbeh::studies {

/// Some parameters, by name.
using ParameterNames = std::vector<std::string_view>;
inline bool contains(const ParameterNames& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The value of a key, of the parameter's kind; unchanged where the key is absent. Ranges are the struct's:
/// see checked.
inline void read_value(const TomlTable& table, const char* key, double& value) {
  value = table.number(key, {}, value);
}
inline void read_value(const TomlTable& table, const char* key, int& value) {
  constexpr int any = std::numeric_limits<int>::max();
  value = table.integer(key, -any, any, value);
}
inline void read_value(const TomlTable& table, const char* key, bool& value) {
  value = table.boolean(key, value);
}
inline void read_value(const TomlTable& table, const char* key, std::optional<double>& value) {
  if (table.has(key)) value = table.number(key);
}
template <class E>
requires std::is_enum_v<E>
void read_value(const TomlTable& table, const char* key, E& value) {
  value = table.choice(key, values_of(E{}), std::optional(value));
}

/// Throws InputError for unknown keys, and for what the struct's validate() refuses.
template <class Struct>
void check(const TomlTable& table, const Struct& read) {
  table.reject_unknown_keys();
  try {
    read.validate();
  } catch (const std::invalid_argument& error) {
    table.fail_from(error);
  }
}

/// Reads the parameters but those of `without`, or only those of `these`.
template <class Struct>
void read_parameters(const TomlTable& table, Struct& into, const ParameterNames& without = {}) {
  for_each_parameter(into, [&](const model::Parameter& parameter, auto& value) {
    if (!contains(without, parameter.name)) read_value(table, parameter.name, value);
  });
}
template <class Struct>
void read_some(const TomlTable& table, Struct& into, const ParameterNames& these) {
  for_each_parameter(into, [&](const model::Parameter& parameter, auto& value) {
    if (contains(these, parameter.name)) read_value(table, parameter.name, value);
  });
}

/// What stands in files: of polynomials and numbers those that are given, an area difference that is there, an order that does
/// not relax.
template <class Value>
bool is_said(const Value& value) {
  if constexpr (std::derived_from<Value, model::Polynomial>)
    return !value.empty();
  else if constexpr (std::same_as<Value, model::AreaDifference>)
    return value.is_there();
  else if constexpr (std::same_as<Value, std::optional<double>>)
    return value.has_value();
  else if constexpr (std::same_as<Value, model::OrderDynamics>)
    return value != model::OrderDynamics::relaxing;
  else
    return true;
}

/// Writes them; `these` in their own order.
template <class Struct>
void write_parameters(TomlText& toml, const Struct& from, const ParameterNames& without = {}) {
  for_each_parameter(from, [&](const model::Parameter& parameter, const auto& value) {
    if (!contains(without, parameter.name) && is_said(value)) toml.value(parameter.name, value);
  });
}
template <class Struct>
void write_some(TomlText& toml, const Struct& from, const ParameterNames& these) {
  for (const std::string_view key : these)
    for_each_parameter(from, [&](const model::Parameter& parameter, const auto& value) {
      if (key == parameter.name && is_said(value)) toml.value(key, value);
    });
}

/// The parameters in which two structs differ, but for `without`.
template <class Struct>
std::vector<Difference> differences(const Struct& a, const Struct& b,
                                    const ParameterNames& without = {}) {
  std::vector<std::string> values;
  for_each_parameter(a, [&](const auto&, const auto& value) { values.push_back(as_toml(value)); });
  std::vector<Difference> found;
  std::size_t k = 0;
  for_each_parameter(b, [&](const model::Parameter& parameter, const auto& value) {
    const std::string &first = values[k++], second = as_toml(value);
    if (first != second && !contains(without, parameter.name))
      found.push_back({parameter.name, first, second});
  });
  return found;
}

/// The whole table [numerics] of either solver.
template <class Numerics>
Numerics read_numerics(const TomlTable& table) {
  Numerics numerics;
  read_parameters(table, numerics);
  check(table, numerics);
  return numerics;
}
template <class Numerics>
void write_numerics(TomlText& toml, const Numerics& numerics) {
  toml.table("numerics");
  write_parameters(toml, numerics);
}

}  // namespace sbeh::studies
