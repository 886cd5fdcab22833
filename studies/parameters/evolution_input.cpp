#include "studies/parameters/evolution_input.h"

#include "studies/io/spelling.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

namespace {

constexpr double largest_aspect = 1000;  // of ellipsoids

bool has_key(const StartShape& shape, const std::string& key) {
  return std::find(shape.keys.begin(), shape.keys.end(), key) != shape.keys.end();
}

std::vector<double> default_times(double first, double end, int count) {
  std::vector<double> times =
      evenly_spaced(std::min(first, end / 100), end, count, Spacing::logarithmic);
  times.insert(times.begin(), 0);
  return times;
}

}  // namespace

std::string read_shape(const TomlTable& start, const std::vector<StartShape>& shapes) {
  std::vector<std::string> names;
  names.reserve(shapes.size());
  for (const StartShape& shape : shapes) names.push_back(shape.name);
  std::string chosen = start.word("shape", names);
  const StartShape& own = *std::find_if(
      shapes.begin(), shapes.end(), [&](const StartShape& shape) { return shape.name == chosen; });
  for (const StartShape& other : shapes)
    for (const std::string& key : other.keys) {
      if (has_key(own, key)) continue;
      std::string owners;
      for (const StartShape& shape : shapes)
        if (has_key(shape, key)) owners += (owners.empty() ? "" : " and ") + in_quotes(shape.name);
      start.refuse(key, "belongs to shape = " + owners + ", not to " + in_quotes(chosen));
    }
  return chosen;
}

EllipsoidKeys read_ellipsoid(const TomlTable& start, std::size_t count, std::string_view axes) {
  EllipsoidKeys keys;
  if (start.has("axes")) {
    start.refuse("reduced_volume", "must not be given together with axes");
    start.refuse("kind", "must not be given together with axes, which tell it");
    keys.axes = start.numbers("axes", above(0));
    if (keys.axes.size() != count) start.fail("axes", fmt::format("must be {}", axes));
    const auto [least, largest] = std::minmax_element(keys.axes.begin(), keys.axes.end());
    if (*largest / largest_aspect > *least)
      start.fail("axes",
                 fmt::format("must not differ by more than a factor of {}", largest_aspect));
  } else {
    keys.reduced_volume = start.number("reduced_volume", reduced_volumes);
  }
  keys.prolate = start.word("kind", {"oblate", "prolate"}, "oblate") == "prolate";
  return keys;
}

Times read_times(const TomlTable& time, std::string_view states) {
  Times times;
  times.end = time.number("end", above(0));
  const Interval run = between(0, times.end);
  times.output = time.grid("output", run, default_output_times(times.end));
  times.states = time.grid(states, run, default_profile_times(times.end));
  times.every_step = time.boolean("every_step", false);
  times.stop_at_rest = time.boolean("stop_at_rest", true);
  return times;
}

std::vector<double> default_output_times(double end) { return default_times(1e-5, end, 200); }

std::vector<double> default_profile_times(double end) { return default_times(1e-3, end, 7); }

}  // namespace sbeh::studies
