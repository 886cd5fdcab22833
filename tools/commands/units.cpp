// `sbeh units`: what the numbers of an input or of results are in physical units, and tables in these.
#include "studies/report/result_units.h"
#include "tools/commands/commands.h"

#include <optional>

namespace sbeh::tools {

namespace fs = std::filesystem;

namespace {

struct Words {
  std::string path, from, into;
  bool overwrite = false;
};

void print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print("{}\n", line);
}

int of_input(const Words& words) {
  if (!words.into.empty())
    throw studies::InputError(
        fmt::format("{}: is an input, which has no tables to be written with -o", words.path));
  const studies::DescribedUnits described = studies::described_units(words.path);
  const auto units = words.from.empty() ? described.units
                                        : studies::read_units(studies::TomlFile::parse(words.from));
  if (!units)
    throw studies::InputError(
        fmt::format("{}: has no table [units]", words.from.empty() ? words.path : words.from));
  print(studies::ResultUnits(described, *units).text());
  return 0;
}

int of_results(const Words& words) {
  const auto from = words.from.empty() ? std::nullopt : std::optional(fs::path(words.from));
  const studies::ResultUnits units(words.path, from);
  if (words.into.empty()) {
    print(units.text());
    return 0;
  }
  const auto written =
      studies::write_converted(words.path, units, words.into, words.overwrite, SBEH_VERSION);
  print(units.text());
  fmt::print("{} tables in {}\n", written.count, words.into);
  for (const std::string& left : written.left) complain(left + "; it is left out");
  return 0;
}

}  // namespace

Command add_units(CLI::App& program) {
  const auto words = std::make_shared<Words>();
  CLI::App* app = program.add_subcommand(
      "units", "what the numbers of an input or of results are in physical units");
  app->add_option("PATH", words->path, "folder of results, or input (TOML), with a table [units]")
      ->required();
  app->add_option("--units-from", words->from, "the table [units] of this file instead");
  app->add_option("-o,--output", words->into, "folder for the tables in physical units");
  app->add_flag("--overwrite", words->overwrite, "replace tables that are there");
  return {app, [words] {
            return fs::is_directory(words->path) ? of_results(*words) : of_input(*words);
          }};
}

}  // namespace sbeh::tools
