#include "studies/scan/scan_input.h"

#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"
#include "studies/parameters/material_input.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

std::size_t point_count(const ScanInput& input) {
  return input.reduced_volume.size() * input.L.size() * input.models.size() * input.branches.size();
}

namespace {

constexpr std::size_t most_points = 1'000'000;  // 20 GB of profiles

// Whether the scan looks for what `beyond_fold` starts from.
void require_folds(const TomlTable& table, const ScanInput& input) {
  const auto has = [](const auto& list, const auto& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  if (input.method != Method::newton || !has(input.models, model::Model::SBEH)
      || !has(input.branches, axisym::Branch::oblate))
    table.fail("beyond_fold",
               "needs method = \"newton\", the model \"SBEH\" and the branch \"oblate\"");
}

void read_scan_table(const TomlTable& table, ScanInput& input) {
  input.reduced_volume = table.grid("reduced_volume", reduced_volumes);
  input.L = table.grid("L", above(0));
  for (const model::Model flow : {model::Model::HelfrichLocal, model::Model::HelfrichGlobal})
    table.refuse_word("models", name(flow),
                      "must not be scanned: its states of rest are those of SSH");
  input.models = table.choices("models", rest_models, std::optional(input.models));
  input.branches =
      table.choices("branches", values_of(axisym::Branch{}), std::optional(input.branches));
  read_value(table, "method", input.method);
  if (input.method != Method::flow)
    table.refuse("end_time", "must not be given without method = \"flow\"");
  input.flow_end_time = table.number("end_time", above(0), input.flow_end_time);
  input.beyond_fold = table.boolean("beyond_fold", input.beyond_fold);
  if (input.beyond_fold) require_folds(table, input);
  table.reject_unknown_keys();
  if (point_count(input) > most_points)
    table.fail("L",
               fmt::format("must have fewer values: that makes {} points with the other lists, "
                           "more than {}",
                           point_count(input), most_points));
}

}  // namespace

ScanInput read_scan(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const TomlTable scan = file.table("scan");
  const TomlTable material = file.table("material");
  const TomlTable numerics = file.table("numerics");
  file.reject_unknown_keys();
  ScanInput input;
  read_scan_table(scan, input);
  input.material = read_material_without_L(material);
  input.numerics = read_numerics<axisym::Numerics>(numerics);
  return input;
}

std::string describe(const ScanInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("scan");
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  toml.value("models", input.models);
  toml.value("branches", input.branches);
  toml.value("method", input.method);
  if (input.method == Method::flow) toml.value("end_time", input.flow_end_time);
  if (input.method == Method::newton) toml.value("beyond_fold", input.beyond_fold);
  write_material_without_L(toml, input.material);
  write_numerics(toml, input.numerics);
  return toml.text();
}

}  // namespace sbeh::studies
