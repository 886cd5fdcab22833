#include "tools/picture/command_line.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cstdio>
#include <string_view>
#include <utility>

namespace sbeh::picture {
namespace {

// All of the text: numbers with commas between; empty if it is anything else.
std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  const char *at = text.data(), *end = at + text.size();
  while (true) {
    double value = 0.0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc()) return {};
    numbers.push_back(value);
    if (next == end) return numbers;
    if (*next != ',') return {};
    at = next + 1;
  }
}

template <class Choice>
std::vector<std::string> names_of(Choice) {
  std::vector<std::string> all;
  for (const Choice choice : values_of(Choice{})) all.emplace_back(name(choice));
  return all;
}

// CLI11 has seen that it is one.
template <class Choice>
Choice choice_of(const std::string& word) {
  for (const Choice choice : values_of(Choice{}))
    if (word == name(choice)) return choice;
  throw InputError(fmt::format("{}: unknown choice", word));
}

}  // namespace

Size parse_size(const std::string& text) {
  Size size;
  char rest = 0;
  const int found = std::sscanf(text.c_str(), "%dx%d%c", &size.width, &size.height, &rest);
  const auto possible = [](int length) { return length >= 300 && length <= 8000; };
  if (found != 2 || !possible(size.width) || !possible(size.height)) {
    throw InputError(
        fmt::format("--size {}: give width and height in pixels, each 300 to 8000, "
                    "as in 1600x1200.",
                    text));
  }
  return size;
}

double parse_length(const std::string& option, const std::string& text) {
  constexpr std::array<std::pair<std::string_view, double>, 3> units{
      {{"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}}};
  for (const auto& [unit, millimetres] : units) {
    if (!text.ends_with(unit)) continue;
    const auto number = numbers_of(std::string_view(text).substr(0, text.size() - unit.size()));
    const double length = number.size() == 1 ? number[0] * millimetres : 0.0;
    if (length >= 20.0 && length <= 1000.0) return length;
  }
  throw InputError(fmt::format("{} {}: give a length with mm, cm or in, 20 mm to 1 m, as in 86mm.",
                               option, text));
}

Range parse_scale(const std::string& text) {
  const std::vector<double> ends = numbers_of(text);
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    throw InputError(fmt::format(
        "--scale {}: give the values of the darkest and of the lightest colour, as in 0.4,0.67.",
        text));
  return {ends[0], ends[1]};
}

View parse_view(const std::string& text) {
  if (text == "side") return side_view;
  if (text == "top") return top_view;
  const std::vector<double> eye = numbers_of(text);
  if (eye.size() != 3 || (eye[0] == 0.0 && eye[1] == 0.0 && eye[2] == 0.0))
    throw InputError(
        fmt::format("--view {}: give side, top, or where the eye is, as in 1,-1,0.5.", text));
  const bool along_z = eye[0] == 0.0 && eye[1] == 0.0;
  return {{eye[0], eye[1], eye[2]}, along_z ? top_view.up : side_view.up};
}

void add_options(CLI::App& command, const std::vector<std::string>& pictures, const Has& has,
                 Options& options, Words& words) {
  if (pictures.size() > 1)
    command.add_option("--only", options.only, "Only this picture")
        ->check(CLI::IsMember(pictures))
        ->allow_extra_args(false);
  auto* size =
      command.add_option("--size", words.size, "Width and height in pixels, e.g. 1600x1200");
  auto* width =
      command
          .add_option("--width", words.width, "Width on paper, e.g. 86mm; letters are of 8 points")
          ->excludes(size);
  command
      .add_option("--height", words.height, "Height on paper; by default what the content asks for")
      ->needs(width);
  command.add_option("--format", words.formats, "png, svg, pdf; several with commas between")
      ->delimiter(',')
      ->check(CLI::IsMember(names_of(Format{})));
  if (has.units) {
    command.add_flag("--units", words.units, "In physical units, those of [units] in DIR/run.toml");
    command.add_option("--units-from", words.units_from,
                       "In those of the table [units] of this file");
  }
  if (has.energies)
    command.add_option("--energy-shift", options.energy_shift,
                       "What is added to the energy, by default 4π; with --units so many E₀");
  if (has.panels)
    command
        .add_option("--panels", options.panels,
                    "Of the diagram, in this order: lowest, gap, energy, order, curvature")
        ->delimiter(',')
        ->check(CLI::IsMember({"lowest", "gap", "energy", "order", "curvature"}));
  if (has.fields) {
    command.add_option("--field", words.field, "What shapes are coloured by: order, curvature")
        ->check(CLI::IsMember(names_of(Field{})));
    command.add_option("--colours", words.colours, "viridis, cividis, magma, grey")
        ->check(CLI::IsMember(names_of(Palette{})));
    command.add_option("--scale", words.scale,
                       "Values of the darkest and the lightest colour, e.g. 0.4,0.67");
  }
  if (has.views)
    command.add_option("--view", words.views, "side, top, or where the eye is, e.g. 1,-1,0.5")
        ->allow_extra_args(false);
  if (has.frames)
    command.add_option("--frames", options.frames, "Times of the shapes, e.g. 0,0.1,10")
        ->delimiter(',');
}

void read_words(const Words& words, Options& options) {
  if (!words.size.empty()) options.size = parse_size(words.size);
  if (!words.width.empty()) options.width_mm = parse_length("--width", words.width);
  if (!words.height.empty()) options.height_mm = parse_length("--height", words.height);
  for (const std::string& word : words.formats) options.formats.push_back(choice_of<Format>(word));
  if (!words.field.empty()) options.field = choice_of<Field>(words.field);
  if (!words.colours.empty()) options.palette = choice_of<Palette>(words.colours);
  if (!words.scale.empty()) options.scale = parse_scale(words.scale);
  if (words.units || !words.units_from.empty())
    options.units.emplace(options.directory,
                          words.units_from.empty()
                              ? std::nullopt
                              : std::optional(std::filesystem::path(words.units_from)));
  for (const std::string& word : words.views) options.views.push_back(parse_view(word));
}

}  // namespace sbeh::picture
