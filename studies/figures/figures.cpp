#include "studies/figures/figures.h"

#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/scan/scan.h"
#include "studies/scan/scan_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace sbeh::studies::figures {

namespace fs = std::filesystem;
using model::FlowStop;

namespace {

// False when interrupted.
bool make_scan(const Sources& sources, std::string_view version) {
  const fs::path place = sources.folder / scan_folder;
  const ScanSummary s = run_scan(sources.inputs.oblates, place, version);
  if (s.computed > 0)
    tell(
        fmt::format("{}: {} points computed in {:.1f} s\n", place.string(), s.computed, s.seconds));
  return !s.interrupted;
}

bool make_run(const Sources& sources, const PlannedRun& plan, std::string_view version,
              Summary& summary) {
  const auto found = sources.find(plan);
  if (found && found->ended) return true;
  const RunSummary s = complete_run(sources.folder, plan, found, version);
  const FlowStop stop = s.run.stop;
  if (stop == FlowStop::interrupted) return false;
  const std::string place = (sources.folder / plan.folder).string();
  tell(fmt::format("{}: {} at t = {:.6g}, energy {:.8g}\n", place, model::describe(stop),
                   s.run.last.time, s.run.last.energy.total()));
  if (stop != FlowStop::end_time && stop != FlowStop::at_rest)
    summary.failed.push_back(
        fmt::format("{}: ended at t = {:.6g}: {}", place, s.run.last.time, model::describe(stop)));
  if (s.unresolved_from)
    summary.unresolved.push_back(fmt::format("{} from t = {:.4g}", place, *s.unresolved_from));
  return true;
}

// What all figures need, each run once. False when interrupted.
bool make_all(const std::vector<Figure>& wanted, const Sources& sources, std::string_view version,
              Summary& summary) {
  if (std::ranges::any_of(wanted, needs_scan) && !make_scan(sources, version)) return false;
  std::set<std::string> made;
  for (const Figure figure : wanted)
    for (const PlannedRun& plan : runs_for(figure, sources.inputs)) {
      if (!made.insert(plan.folder).second) continue;
      if (interrupt_signal() || !make_run(sources, plan, version, summary)) return false;
    }
  return true;
}

// Of the scan and the 3D runs together; not known when none of them was made here.
double seconds_for(Figure figure, const Sources& sources) {
  double sum = 0;
  bool known = false;
  const fs::path scan = sources.folder / scan_folder / "scan.csv";
  if (needs_scan(figure) && fs::exists(scan)) {
    for (const PointResult& row : read_rows(scan_columns(), scan)) sum += row.wall_seconds;
    known = true;
  }
  for (const PlannedRun& plan : runs_for(figure, sources.inputs))
    if (const auto seconds = seconds_of(sources.folder, plan)) {
      sum += *seconds;
      known = true;
    }
  return known ? sum : not_known;
}

std::vector<Finding> findings_of(Figure figure, const fs::path& folder) {
  const fs::path file = folder / (std::string(name(figure)) + ".csv");
  if (!fs::exists(file)) return {};
  switch (figure) {
    case Figure::energy:
      return energy_findings(read_rows(energy_columns(), file));
    case Figure::shapes:
      return shapes_findings(read_rows(shape_columns(), file));
    case Figure::evolution:
      return evolution_findings(read_rows(evolution_columns(), file));
    case Figure::measures:
      return measures_findings(read_rows(measure_columns(), file));
  }
  return {};
}

}  // namespace

const Columns<FigureRow>& figure_columns() {
  using Row = FigureRow;
  static const Columns<Row> columns{
      column("figure", &Row::figure),
      column("command", &Row::command),
      known_column("seconds", &Row::seconds, "{:.0f}"),
      column<Row>("result", inside(&Row::finding, &Finding::result)),
      column<Row>("paper", inside(&Row::finding, &Finding::paper)),
      column<Row>("agreement", inside(&Row::finding, &Finding::agreement)),
  };
  return columns;
}

Summary make_figures(const Request& request, std::string_view version) {
  const Inputs inputs = read_inputs(request.inputs, request.triangles);
  if (request.draw_only && !fs::is_directory(request.folder))
    throw InputError(
        fmt::format("{}: no such folder: there is nothing to draw", request.folder.string()));
  const OutputFolder folder(request.folder);
  const Sources sources{request.folder, inputs, request.triangles};
  Summary summary;
  if (!request.draw_only && !make_all(request.figures, sources, version, summary)) {
    summary.interrupted = true;
    return summary;
  }
  for (const Figure figure : request.figures)
    summary.missing.emplace_back(figure, write_tables(figure, sources));
  std::vector<FigureRow> rows;
  for (const Figure figure : values_of(Figure{}))
    for (const Finding& finding : findings_of(figure, request.folder))
      rows.push_back({.figure = number(figure),
                      .command = fmt::format("sbeh figures {}", name(figure)),
                      .seconds = seconds_for(figure, sources),
                      .finding = finding});
  write_file(folder / "figures.csv", table_text(figure_columns(), rows));
  return summary;
}

std::string text_of(const std::vector<FigureRow>& figures) {
  std::string text;
  int before = 0;
  for (const auto& [figure, command, seconds, finding] : figures) {
    if (figure != before)
      text += fmt::format("figure {}: {}{}\n", figure, command,
                          std::isnan(seconds) ? "" : fmt::format(", {:.0f} s of runs", seconds));
    before = figure;
    text += fmt::format("  {:<4} {}\n", name(finding.agreement), finding.result);
    if (!finding.paper.empty()) text += fmt::format("       paper: {}\n", finding.paper);
  }
  return text;
}

}  // namespace sbeh::studies::figures
