// The cases of a sweep, each read by the reader of its command.
#include "studies/evolution/relax.h"
#include "studies/evolution/run_input.h"
#include "studies/evolution/run_start.h"
#include "studies/rest_states/states_input.h"
#include "studies/scan/scan_cost.h"
#include "studies/sweep/sweep_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// ---- one case -----------------------------------------------------------------------------------

// As many steps as the longest ones need, and a thousand of the first transient.
double steps_of(double end, const model::TimeControl& steps) {
  return 1000 + end / steps.largest_step;
}

constexpr double megabytes_of_axisymmetric = 100;

CaseCost costing(double seconds, double megabytes) {
  constexpr double hour = 3600, most_cores = 4;
  return {seconds, megabytes, int(std::clamp(std::ceil(seconds / hour), 1., most_cores))};
}

CaseCost cost_of_case(const RunInput& input) {
  const RunCost cost = cost_of(input, input.triangles);
  return costing(cost.seconds_per_step * steps_of(input.times.end, input.numerics), cost.megabytes);
}
CaseCost cost_of_case(const RelaxInput& input) {
  return costing(seconds_per_step(input) * steps_of(input.times.end, input.numerics),
                 megabytes_of_axisymmetric);
}
CaseCost cost_of_case(const ScanInput& input) {
  return costing(seconds_of(input), megabytes_of_axisymmetric + 0.01 * double(point_count(input)));
}
CaseCost cost_of_case(const StatesInput& input) {
  RunInput surface;
  return costing(seconds_of(input, input.triangles),
                 2 * cost_of(surface, input.triangles).megabytes);
}

void complete(SweepCase& of, const auto& input, std::string_view version) {
  of.description = describe(input, version);
  of.cost = cost_of_case(input);
}

void complete(SweepCase& of, InputKind kind, const TomlTable& file, std::string_view version) {
  if (kind == InputKind::run) complete(of, run_in(file), version);
  if (kind == InputKind::relax) complete(of, relax_in(file), version);
  if (kind == InputKind::scan) complete(of, scan_in(file), version);
  if (kind == InputKind::states) complete(of, states_in(file), version);
}

// ---- all of them --------------------------------------------------------------------------------

// The k-th combination, the last axis fastest.
std::vector<std::string> combination(const std::vector<SweepAxis>& axes, std::size_t k) {
  std::vector<const std::vector<std::string>*> steps;
  for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
    steps.push_back(&axis->steps[k % axis->steps.size()]);
    k /= axis->steps.size();
  }
  std::vector<std::string> values;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step)
    values.insert(values.end(), (*step)->begin(), (*step)->end());
  return values;
}

std::string text_of(const std::vector<TomlValue>& values) {
  std::string text;
  for (const TomlValue& value : values)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", value.key, value.value);
  return text;
}

// The file as the user has named it, in place of its whole path.
std::string with_name(std::string text, const fs::path& whole, const fs::path& named) {
  if (text.starts_with(whole.string())) text.replace(0, whole.string().size(), named.string());
  return text;
}

void require_kind_to_sweep(InputKind kind, const SweepInput& input) {
  for (const InputKind known :
       {InputKind::run, InputKind::relax, InputKind::scan, InputKind::states})
    if (kind == known) return;
  throw InputError(fmt::format(
      "{}: is an input of sbeh {}: what can be swept is one of run, relax, scan and states",
      input.base.string(), sbeh::name(kind)));
}

}  // namespace

SweepCases cases_of(const SweepInput& input, std::string_view version) {
  const fs::path base = fs::absolute(input.base);  // so are the files that it names
  const std::vector<std::string> keys = swept_keys(input);
  SweepCases all;
  for (std::size_t k = 0; k < case_count(input); ++k) {
    SweepCase& of = all.cases.emplace_back();
    of.number = int(k) + 1;
    of.values = combination(input.axes, k);
    std::vector<TomlValue> values;
    for (std::size_t n = 0; n < keys.size(); ++n) values.push_back({keys[n], of.values[n]});
    const auto refuse_case = [&](const std::string& what) {
      throw InputError(fmt::format("{}: case {} ({}): {}", input.file.string(), of.number,
                                   text_of(values), with_name(what, base, input.base)));
    };
    try {
      const std::string_view beside = input.base == input.file ? "sweep" : "";
      const TomlTable file = TomlFile::parse_with(base, values, beside);
      all.kind = file.has("sweep") ? InputKind::sweep : kind_in(file, base);
      require_kind_to_sweep(all.kind, input);
      complete(of, all.kind, file, version);
    } catch (const InputError& error) {
      refuse_case(error.what());
    } catch (const std::invalid_argument& error) {  // only the input as a whole could tell
      refuse_case(error.what());
    }
  }
  return all;
}

}  // namespace sbeh::studies
