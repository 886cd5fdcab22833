#include "studies/scan/scan_stack.h"

#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/progress.h"
#include "studies/io/stopwatch.h"
#include "studies/parameters/material_number.h"

#include <fmt/format.h>

#include <sstream>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::array tables{"scan.csv",         "folds.csv",  "stability_lines.csv",
                            "equal_energy.csv", "lowest.csv", "beyond_fold.csv",
                            "further.csv"};

// A value for each axis.
std::string joined(const ScanInput& input, const auto& part) {
  std::string text;
  for (std::size_t k = 0; k < input.axes.size(); ++k) text += part(k) + ",";
  return text;
}

// One table of all layers that have it, by axes and then as they stand; empty without any.
std::string merged(const ScanInput& input, const std::vector<ScanLayer>& layers,
                   const fs::path& folder, const char* table) {
  std::string text;
  for (const ScanLayer& layer : layers) {
    const fs::path file = folder / layer.folder / table;
    if (!fs::exists(file)) continue;
    std::istringstream lines(read_file(file));
    std::string line;
    std::getline(lines, line);
    if (text.empty())
      text = joined(input, [&](std::size_t k) { return input.axes[k].parameter; }) + line + "\n";
    const std::string at =
        joined(input, [&](std::size_t k) { return fmt::format("{}", layer.values[k]); });
    while (std::getline(lines, line)) text += at + line + "\n";
  }
  return text;
}

void write_tables(const ScanInput& input, const std::vector<ScanLayer>& layers,
                  const OutputFolder& folder) {
  for (const char* table : tables)
    if (const std::string text = merged(input, layers, folder.path(), table); !text.empty())
      write_file(folder / table, text);
}

void add(const ScanSummary& of_layer, ScanSummary& sum) {
  sum.points += of_layer.points;
  sum.stationary += of_layer.stationary;
  sum.unresolved += of_layer.unresolved;
  sum.limit += of_layer.limit;
  sum.failed += of_layer.failed;
  if (sum.first_failure.empty()) sum.first_failure = of_layer.first_failure;
  sum.computed += of_layer.computed;
  sum.lowest_not_found += of_layer.lowest_not_found;
}

}  // namespace

std::vector<ScanLayer> layers_of(const ScanInput& input) {
  ScanInput bare = input;
  bare.axes.clear();
  std::vector<ScanLayer> layers{{{}, "", bare}};
  for (const ScanAxis& axis : input.axes) {
    const MaterialNumber& number = *MaterialNumber::named(axis.parameter);
    std::vector<ScanLayer> next;
    for (const ScanLayer& layer : layers)
      for (const double value : axis.values) {
        ScanLayer one = layer;
        one.values.push_back(value);
        one.folder += fmt::format("{}{}_{}", one.folder.empty() ? "" : "_", axis.parameter, value);
        one.input.material = number.with(one.input.material, value);
        next.push_back(std::move(one));
      }
    layers = std::move(next);
  }
  return layers;
}

ScanSummary run_stack(const ScanInput& input, const fs::path& path, std::string_view version) {
  const Stopwatch watch;
  const OutputFolder folder(path);
  begin_or_continue(folder, describe(input, version), "scan.csv", "a scan");
  const std::vector<ScanLayer> layers = layers_of(input);
  ScanSummary sum;
  for (std::size_t k = 0; k < layers.size() && !interrupt_signal(); ++k) {
    tell(fmt::format("{} ({} of {})\n", layers[k].folder, k + 1, layers.size()));
    add(run_scan(layers[k].input, folder / layers[k].folder, version), sum);
    write_tables(input, layers, folder);
  }
  sum.interrupted = interrupt_signal() != 0;
  sum.seconds = watch.seconds();
  return sum;
}

ScanSummary run_stack_part(const ScanInput& input, const fs::path& path, const Part& part,
                           std::string_view version) {
  const Stopwatch watch;
  ScanSummary sum;
  for (const ScanLayer& layer : layers_of(input))
    if (!interrupt_signal())
      add(run_scan_part(layer.input, path / layer.folder, part, version), sum);
  sum.interrupted = interrupt_signal() != 0;
  sum.seconds = watch.seconds();
  return sum;
}

}  // namespace sbeh::studies
