#include "studies/evolution/relax.h"

#include "studies/evolution/flow_progress.h"
#include "studies/evolution/series_writer.h"
#include "studies/evolution/state_files.h"
#include "studies/io/interrupt.h"
#include "studies/io/results_folder.h"
#include "studies/states/profile_file.h"

namespace sbeh::studies {

RelaxSummary run_relax(const RelaxInput& input, const std::filesystem::path& path,
                       std::string_view version) {
  const RelaxStart start = start_of(input);
  const OutputFolder folder(path);
  refuse_results(folder, {"run.toml", "series.csv", "scan.csv"}, "a run", "is");
  write_file(folder / "run.toml", describe(input, version));

  SeriesWriter series(folder, input.times);
  StateFiles profiles(folder, "profiles", ".csv", input.times.states);
  BriefProgress progress(input.times.end);
  axisym::Numerics numerics = input.numerics;
  numerics.elements = axisym::element_count(start.state.X);
  const axisym::FlowResult run = axisym::run_flow(
      start.material, input.model, start.state, start.target, numerics, schedule_of(input.times),
      [&](const axisym::FlowRecord& record, const axisym::State& state, bool exact) {
        series.see(record, exact, [&] { return axisym::diagnose(start.material, state); });
        profiles.see(record.time, exact, [&](const auto& file) { write_profile(file, state); });
        progress.see(record);
        return interrupt_signal() == 0;
      });
  series.finish(run.last, [&] { return axisym::diagnose(start.material, run.state); });
  profiles.finish(run.last.time, [&](const auto& file) { write_profile(file, run.state); });
  progress.finish();
  return {run, int(profiles.entries().size())};
}

}  // namespace sbeh::studies
