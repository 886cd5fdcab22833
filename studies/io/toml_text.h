// Strict writing of TOML: what toml_reader.h reads back as the same values, bit for bit.
#pragma once

#include "axisym/start_shapes.h"
#include "meshing/spherical_harmonics.h"
#include "model/material.h"

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace sbeh::studies {

/// A value as it stands in a file; numbers have as many digits as they need.
std::string as_toml(double value);
std::string as_toml(int value);
std::string as_toml(const std::optional<double>& value);  ///< of none: an empty text
std::string as_toml(bool value);
std::string as_toml(const std::string& text);
std::string as_toml(const meshing::Harmonic& harmonic);
std::string as_toml(const axisym::Mode& mode);

/// A choice by its name.
template <class Choice>
requires std::is_enum_v<Choice> std::string as_toml(Choice choice) {
  return as_toml(std::string(name(choice)));
}

/// The coefficients of its powers.
std::string as_toml(const model::Polynomial& polynomial);
std::string as_toml(const model::AreaDifference& of);

/// A value that stands in a file as it is here.
struct AsIs {
  std::string text;
};
inline std::string as_toml(const AsIs& value) { return value.text; }

/// A list of values as they stand in a file, broken into lines that are not too long.
std::string list_as_toml(const std::vector<std::string>& values);

template <class T>
std::string as_toml(const std::vector<T>& list) {
  std::vector<std::string> values;
  values.reserve(list.size());
  for (const auto& element : list) values.push_back(as_toml(element));
  return list_as_toml(values);
}

/// The text of a file, which grows table by table and line by line.
class TomlText {
 public:
  /// Begins with a comment that names the program's version, and comments with the conventions (conventions.h).
  explicit TomlText(std::string_view version);

  void table(std::string_view name);
  template <class T>
  void value(std::string_view key, const T& value) {
    line(key, as_toml(value));
  }
  const std::string& text() const { return text_; }

 private:
  void line(std::string_view key, std::string_view value);
  std::string text_;
};

}  // namespace sbeh::studies
