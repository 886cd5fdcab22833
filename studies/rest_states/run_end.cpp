#include "studies/rest_states/run_end.h"

#include "studies/evolution/frame_file.h"
#include "studies/io/interrupt.h"
#include "studies/rest_states/states.h"

#include <fmt/format.h>

#include <cmath>

namespace sbeh::studies {

namespace fs = std::filesystem;
using surface3d::FlowStop;

std::optional<RestRow> rest_of_run(const RunInput& input, const RunSummary& run,
                                   const fs::path& folder, std::string_view version) {
  const FlowStop stop = run.run.stop;
  if (input.finish != RunFinish::newton
      || (stop != FlowStop::at_rest && stop != FlowStop::near_rest))
    return {};
  StatesInput asked;
  asked.model = input.model;
  asked.start = StatesStart::frame;
  asked.file = (folder / run.last_frame).string();
  asked.file_in_description = (fs::path("..") / run.last_frame).string();
  const FlowMoment end = read_frame(asked.file);
  const surface3d::Target target = end.target;
  if (surface3d::is_sphere(*end.mesh, target.area, target.volume)) return {};
  asked.reduced_volume = {surface3d::reduced_volume(target.area, target.volume)};
  asked.L = {input.material.L1};
  asked.material = without_L(input.material);
  asked.units = input.units;
  const StatesSummary found = run_states(asked, folder / rest_folder, version);
  if (found.interrupted || found.rows.empty()) throw Interrupted("interrupted");
  return found.rows.front();
}

std::string describe_rest(const RestRow& row) {
  std::string text = fmt::format("energy {:.10g}", energy_of(row));
  if (!std::isnan(row.energy_error)) text += fmt::format(" (± {:.1g})", row.energy_error);
  const int falls = row.measures ? row.measures->negative_directions : 0;
  if (falls == 0) return text + ", a minimum";
  return text + fmt::format(", a saddle: it falls in {} direction{}", falls, falls == 1 ? "" : "s");
}

}  // namespace sbeh::studies
