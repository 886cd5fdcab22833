// `sbeh stability`: axisymmetric states, perturbed in 3D.
#include "studies/stability/stability.h"

#include "tools/commands/commands.h"

#include <algorithm>

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

void check_stability(const std::string& file) {
  const studies::StabilityInput input = studies::read_stability(file);
  const std::vector<studies::StabilityKey> runs = studies::keys_of(input);
  double steps = 0;
  for (const studies::StabilityKey& key : runs)
    steps += input.end_time / input.material.with_L(key.L).kappa(model::full_order)
           / input.numerics_3d.largest_step;
  const double minutes = 4.3e-4 * input.triangles * steps / 60;  // measured on one core of 2026
  fmt::print(
      "{}: {} runs of perturbed states with about {} triangles, at most about {:.0f} min of one "
      "core\n\n{}",
      file, runs.size(), input.triangles, std::max(1., minutes),
      studies::describe(input, SBEH_VERSION));
}

}  // namespace sbeh::tools
