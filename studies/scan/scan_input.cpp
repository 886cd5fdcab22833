#include "studies/scan/scan_input.h"

#include "studies/io/toml_reader.h"
#include "studies/parameters/material_input.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

const char* name(Method method) { return method == Method::newton ? "newton" : "flow"; }

const std::vector<std::string>& known_branches() {
  static const std::vector<std::string> branches{"oblate", "prolate", "stomatocyte"};
  return branches;
}

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
      || !has(input.branches, std::string("oblate")))
    table.fail("beyond_fold",
               "needs method = \"newton\", the model \"SBEH\" and the branch \"oblate\"");
}

void read_scan_table(const TomlTable& table, ScanInput& input) {
  input.reduced_volume = table.grid("reduced_volume", reduced_volumes);
  input.L = table.grid("L", above(0));
  input.models.clear();
  for (const model::Model flow : {model::Model::HelfrichLocal, model::Model::HelfrichGlobal})
    table.refuse_word("models", name(flow),
                      "must not be scanned: its states of rest are those of SSH");
  for (const std::string& word : table.words("models", scan_model_words(), scan_model_words()))
    input.models.push_back(model_of(word));
  input.branches = table.words("branches", known_branches(), input.branches);
  const std::string newton = name(Method::newton), flow = name(Method::flow);
  if (table.word("method", {newton, flow}, newton) == flow) input.method = Method::flow;
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
  input.numerics = read_numerics(numerics);
  return input;
}

}  // namespace sbeh::studies
