// What the inputs of all evolutions in time share: the shapes of a start with their keys, and [time].
#pragma once

#include "model/material.h"
#include "studies/io/number_range.h"
#include "studies/io/toml_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

inline constexpr Interval orders = between(0, 1);
inline constexpr int largest_degree = 32;  ///< of harmonics

/// A shape that a start may have, and the keys that belong to it besides `shape`.
struct StartShape {
  std::string name;
  std::vector<std::string> keys;
};

/// The key `shape`, the name of one of `shapes`. Throws InputError for another word, and for keys which
/// belong to other shapes than that one.
std::string read_shape(const TomlTable& start, const std::vector<StartShape>& shapes);

/// The keys of an ellipsoid: reduced_volume and kind, or axes.
struct EllipsoidKeys {
  std::optional<double> reduced_volume;  ///< V_r, 0 < V_r <= 1
  std::vector<double> axes;              ///< semi-axes > 0, up to 1 : 1000, or none
  bool prolate = false;
};

/// Throws InputError. `axes` is what that key must be, such as "two numbers, …", `count` of them.
EllipsoidKeys read_ellipsoid(const TomlTable& start, std::size_t count, std::string_view axes);

/// Until when, and the times at which something is written.
struct Times {
  double end;                  ///< > 0
  std::vector<double> output;  ///< 0 … end, ascending
  std::vector<double> states;  ///< likewise
  bool every_step;             ///< a row of the history for each step too
  bool stop_at_rest;
};

/// The keys end, output, every_step, stop_at_rest of [time], and `states`, the name of the key with the
/// times of whole states. Throws InputError; other keys are the caller's.
Times read_times(const TomlTable& time, std::string_view states);

/// 0 and 200 times in equal ratios up to `end`, from 1e-5 or, if smaller, end/100.
std::vector<double> default_output_times(double end);

/// 0, `end` and 6 times in equal ratios between, from 1e-3 or, if smaller, end/100.
std::vector<double> default_profile_times(double end);

}  // namespace sbeh::studies
