// `sbeh stability`: axisymmetric states, perturbed in 3D.
#include "studies/stability/stability.h"

#include "studies/stability/stability_cost.h"
#include "tools/commands/commands.h"

#include <algorithm>
#include <cmath>

namespace sbeh::tools {

namespace {

int stability(const Study& study) {
  const studies::StabilityInput input = studies::read_stability(study.input);
  const std::filesystem::path folder = study.results();
  const studies::StabilitySummary s = studies::run_stability(input, folder, SBEH_VERSION);
  fmt::print("{}{} runs in {}; {} computed in {:.0f} s\n", studies::table_of(s), s.rows.size(),
             (folder / "stability.csv").string(), s.computed, s.seconds);
  return finish(study, studies::ResultsKind::stability, s.interrupted);
}

}  // namespace

Command add_stability(CLI::App& program) {
  return add_study(program, studies::InputKind::stability, "axisymmetric states, perturbed in 3D",
                   stability);
}

namespace {

double two_digits(double positive) {
  const double unit = std::pow(10, std::floor(std::log10(positive)) - 1);
  return unit * std::round(positive / unit);
}

}  // namespace

void check_stability(const std::string& file) {
  const studies::StabilityInput input = studies::read_stability(file);
  const studies::StabilityCost cost = studies::cost_of(input);
  fmt::print(
      "{}: {} run{} of perturbed states with about {} triangles, about {:.0f} steps and {} of one "
      "core\n\n{}",
      file, cost.runs, cost.runs == 1 ? "" : "s", input.triangles,
      two_digits(std::max(cost.steps, 1.)), duration(cost.seconds),
      studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
