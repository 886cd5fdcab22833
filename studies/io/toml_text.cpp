#include "studies/io/toml_text.h"

#include "studies/io/conventions.h"
#include "studies/io/spelling.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {
constexpr std::size_t list_width = 80;  // and the key before it
}

std::string as_toml(double value) { return fmt::format("{}", value); }  // shortest exact
std::string as_toml(int value) { return fmt::format("{}", value); }
std::string as_toml(bool value) { return value ? "true" : "false"; }
std::string as_toml(const std::string& text) { return in_quotes(text); }
std::string as_toml(const meshing::Harmonic& h) {
  return fmt::format("[{}, {}, {}]", h.l, h.m, h.amplitude);
}
std::string as_toml(const std::optional<double>& value) { return value ? as_toml(*value) : ""; }

std::string as_toml(const axisym::Mode& mode) {
  return fmt::format("[{}, {}]", mode.l, mode.amplitude);
}

std::string as_toml(const model::Polynomial& polynomial) {
  return as_toml(polynomial.coefficients());
}

std::string as_toml(const model::AreaDifference& of) {
  return fmt::format("{{ stiffness = {}, W2 = {} }}", of.stiffness, of.W2);
}

std::string list_as_toml(const std::vector<std::string>& values) {
  std::string text = "[", separator;
  std::size_t line_start = 0;
  for (const std::string& value : values) {
    if (text.size() + separator.size() + value.size() - line_start > list_width) {
      separator = ",\n  ";
      line_start = text.size() + 2;
    }
    text += separator + value;
    separator = ", ";
  }
  return text + "]";
}

TomlText::TomlText(std::string_view version)
    : text_(fmt::format("# sbeh {}: every parameter of this run; can be run again\n", version)) {
  for (const char* line : conventions) text_ += fmt::format("## {}\n", line);
}

void TomlText::table(std::string_view name) { text_ += fmt::format("\n[{}]\n", name); }

void TomlText::line(std::string_view key, std::string_view value) {
  text_ += fmt::format("{} = {}\n", key, value);
}

}  // namespace sbeh::studies
