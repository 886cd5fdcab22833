#include "studies/scan_input.h"

#include "studies/material_input.h"
#include "studies/toml_reader.h"

namespace sbeh::studies {

const char* name(Method method) { return method == Method::newton ? "newton" : "flow"; }

const std::vector<std::string>& known_branches() {
  static const std::vector<std::string> branches{"oblate"};
  return branches;
}

namespace {

void read_scan_table(const TomlTable& table, ScanInput& input) {
  input.reduced_volume = table.grid("reduced_volume", {.low = 0, .high = 1, .low_open = true});
  input.L = table.grid("L", above(0));
  input.models.clear();
  for (const std::string& word : table.words("models", model_words(), model_words()))
    input.models.push_back(model_of(word));
  input.branches = table.words("branches", known_branches(), input.branches);
  const std::string newton = name(Method::newton), flow = name(Method::flow);
  if (table.word("method", {newton, flow}, newton) == flow) input.method = Method::flow;
  if (input.method != Method::flow)
    table.refuse("end_time", "must not be given without method = \"flow\"");
  input.flow_end_time = table.number("end_time", above(0), input.flow_end_time);
  table.reject_unknown_keys();
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
