#include "studies/sweep/sweep_input.h"

#include "studies/io/toml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// ---- grids and lists ----------------------------------------------------------------------------

std::vector<SweepAxis> read_sweep_grid(const TomlTable& grid) {
  std::vector<SweepAxis> axes;
  for (const std::string& key : grid.keys()) {
    SweepAxis& axis = axes.emplace_back();
    axis.keys = {key};
    const auto [inner, name] = grid.place_of(key);
    for (const std::string& value : inner.values(name)) axis.steps.push_back({value});
  }
  return axes;
}

SweepAxis read_together(const TomlTable& table) {
  SweepAxis axis;
  axis.keys = table.keys();
  for (const std::string& key : axis.keys) {
    const auto [inner, name] = table.place_of(key);
    const std::vector<std::string> values = inner.list(name);
    if (axis.steps.empty()) axis.steps.resize(values.size());
    if (values.size() != axis.steps.size())
      inner.fail(name, fmt::format("must have as many values as {}, {}: they go together",
                                   axis.keys.front(), axis.steps.size()));
    for (std::size_t k = 0; k < values.size(); ++k) axis.steps[k].push_back(values[k]);
  }
  return axis;
}

// ---- random values ------------------------------------------------------------------------------

struct RandomRange {
  double from, to;
  bool logarithmic;
};

RandomRange read_range(const TomlTable& random, const std::string& key) {
  const auto [inner, name] = random.place_of(key);
  const TomlTable table = inner.table(name);
  RandomRange range{.from = table.number("from"), .to = table.number("to"), .logarithmic = false};
  range.logarithmic = table.word("spacing", {"linear", "log"}, "linear") == "log";
  table.reject_unknown_keys();
  if (range.from >= range.to) table.fail("to", "must be > from");
  if (range.logarithmic && range.from <= 0) table.fail("from", "must be > 0 for spacing = \"log\"");
  return range;
}

// With u in 0 ≤ u < 1, rounded to 12 digits: the same on all machines.
double at(const RandomRange& range, double u) {
  const double exact = range.logarithmic
                         ? std::exp((1 - u) * std::log(range.from) + u * std::log(range.to))
                         : (1 - u) * range.from + u * range.to;
  const double rounded = std::strtod(fmt::format("{:.11e}", exact).c_str(), nullptr);
  return std::clamp(rounded, range.from, range.to);
}

SweepAxis read_random(const TomlTable& random) {
  const int samples = random.integer("samples", 1, int(most_cases));
  const int seed = random.integer("seed", 0, std::numeric_limits<int>::max());
  SweepAxis axis;
  std::vector<RandomRange> ranges;
  for (const std::string& key : random.keys()) {
    if (key == "samples" || key == "seed") continue;
    axis.keys.push_back(key);
    ranges.push_back(read_range(random, key));
  }
  if (ranges.empty())
    random.fail("samples",
                "of no key: give some, as in \"material.L\" = { from = 0.01, to = 0.1 }");
  std::mt19937_64 bits(static_cast<unsigned>(seed));
  for (int k = 0; k < samples; ++k) {
    std::vector<std::string>& step = axis.steps.emplace_back();
    for (const RandomRange& range : ranges)
      step.push_back(as_toml(at(range, std::ldexp(double(bits() >> 11), -53))));
  }
  return axis;
}

// ---- the whole ----------------------------------------------------------------------------------

void require_single_keys(const TomlTable& sweep, const SweepInput& input) {
  std::vector<std::string> keys = swept_keys(input);
  std::ranges::sort(keys);
  const auto twice = std::ranges::adjacent_find(keys);
  if (twice != keys.end()) sweep.fail("grid", fmt::format("{} must not be swept twice", *twice));
}

void require_few(const TomlTable& sweep, const SweepInput& input) {
  double count = 1;
  for (const SweepAxis& axis : input.axes) count *= double(axis.steps.size());
  if (count > double(most_cases))
    sweep.fail("grid", fmt::format("must have fewer values: that makes {:.10g} cases with the "
                                   "other lists, more than {}",
                                   count, most_cases));
}

}  // namespace

SweepInput read_sweep(const fs::path& path) {
  const TomlTable file = TomlFile::parse(path), sweep = file.table("sweep");
  SweepInput input{.file = path, .base = path, .axes = {}};
  if (sweep.has("base")) {
    input.base = sweep.path("base");
    file.reject_unknown_keys();
  }
  const TomlTable grid = sweep.table("grid"), random = sweep.table("random");
  const bool has_together = sweep.has("together"), has_random = sweep.has("random");
  sweep.reject_unknown_keys();
  input.axes = read_sweep_grid(grid);
  if (has_together)
    for (const TomlTable& table : sweep.tables("together"))
      input.axes.push_back(read_together(table));
  if (has_random) input.axes.push_back(read_random(random));
  std::erase_if(input.axes, [](const SweepAxis& axis) { return axis.keys.empty(); });
  if (input.axes.empty())
    throw InputError(fmt::format(
        "{}: [sweep] sweeps no key: give values in [sweep.grid], as in \"material.L\" = [0.03, "
        "0.05], in [[sweep.together]] or in [sweep.random]",
        path.string()));
  require_single_keys(sweep, input);
  require_few(sweep, input);
  return input;
}

std::vector<std::string> swept_keys(const SweepInput& input) {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : input.axes)
    keys.insert(keys.end(), axis.keys.begin(), axis.keys.end());
  return keys;
}

std::size_t case_count(const SweepInput& input) {
  std::size_t count = 1;
  for (const SweepAxis& axis : input.axes) count *= axis.steps.size();
  return count;
}

}  // namespace sbeh::studies
