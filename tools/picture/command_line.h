// The words of the command line that pictures share, and what they mean.
#pragma once

#include "tools/picture/options.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace sbeh::picture {

/// What a command draws, and so which options it has.
struct Has {
  bool energies = false;  ///< --energy-shift
  bool fields = false;    ///< --field, --colours, --scale
  bool views = false;     ///< --view
  bool frames = false;    ///< --frames
  bool panels = false;    ///< --panels
  bool units = true;      ///< --units, --units-from
};

/// The options as they were written.
struct Words {
  std::string size, width, height, field, colours, scale, units_from;
  bool units = false;
  std::vector<std::string> formats, views;
};

/// Adds --only (where there are several pictures), --size, --width, --height, --format and those of `has`. Both have to
/// outlive the command.
void add_options(CLI::App& command, const std::vector<std::string>& pictures, const Has& has,
                 Options& options, Words& words);

/// What the words mean. Throws InputError, naming the option and what is allowed.
void read_words(const Words& words, Options& options);

/// "1600x1200": 300 to 8000 pixels each.
Size parse_size(const std::string& text);
/// "86mm", "8.6cm", "3.4in": 20 to 1000 mm. `option` is named in errors.
double parse_length(const std::string& option, const std::string& text);
/// "0.4,0.67": the lower one first.
Range parse_scale(const std::string& text);
/// "side", "top", or where the eye is, "1,-1,0.5".
View parse_view(const std::string& text);

}  // namespace sbeh::picture
