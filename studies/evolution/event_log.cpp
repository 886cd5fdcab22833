#include "studies/evolution/event_log.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace sbeh::studies {

std::string passed_limits(const surface3d::Indicators& r) {
  std::vector<std::string> words;
  const auto above = [&](const char* what, double value, double limit) {
    if (value > limit) words.push_back(fmt::format("{} {:.3g} > {}", what, value, limit));
  };
  above("|B| times the node spacing", r.resolution, surface3d::largest_resolution);
  above("difference of the two curvatures", r.curvature_gap, surface3d::largest_curvature_gap);
  const auto below = [&](const char* what, double value, double limit) {
    if (value < limit) words.push_back(fmt::format("{} {:.3g} < {}", what, value, limit));
  };
  below("mesh quality", r.mesh_quality, surface3d::smallest_quality);
  below("smallest angle", r.min_angle, surface3d::smallest_angle);
  return fmt::format("{}", fmt::join(words, ", "));
}

const Columns<EventRow>& event_columns() {
  using Row = EventRow;
  using surface3d::Indicators, surface3d::RemeshReport;
  const auto before = [](std::string name, double Indicators::*member) {
    return column<Row>(std::move(name), inside(&Row::indicators, member));
  };
  const auto change = [](std::string name, double RemeshReport::*member) {
    return column<Row>(std::move(name), inside(&Row::report, member));
  };
  static const Columns<Row> columns{
      column("time", &Row::time),
      column("event", &Row::event),
      column("triangles", &Row::triangles),
      before("min_angle", &Indicators::min_angle),
      before("mesh_quality", &Indicators::mesh_quality),
      before("turn", &Indicators::resolution),
      before("curvature_gap", &Indicators::curvature_gap),
      change("energy_change", &RemeshReport::energy_change),
      change("area_change", &RemeshReport::area_change),
      change("volume_change", &RemeshReport::volume_change),
      change("distance", &RemeshReport::distance),
  };
  return columns;
}

namespace {
// Resolved again is what would be by a twentieth more: a run along a limit would say so with each step.
surface3d::Indicators nearer_to_limits(surface3d::Indicators r) {
  constexpr double share = 1.05;
  r.resolution *= share;
  r.curvature_gap *= share;
  r.mesh_quality /= share;
  r.min_angle /= share;
  return r;
}
}  // namespace

EventLog::EventLog(const OutputFolder& folder, bool remesh, double until, ProgressLine& line)
    : table_(folder / "events.csv", header_of(event_columns()), until),
      remesh_(remesh),
      line_(line) {
  for (const EventRow& row : rows_of(event_columns(), table_.kept())) {
    if (row.event == "resolved") resolved_ = true;
    if (row.event != "unresolved") continue;
    resolved_ = false;
    if (!unresolved_from_) unresolved_from_ = row.time;
  }
}

void EventLog::append(const EventRow& event) {
  table_.append(event.time, line_of(event_columns(), event));
}

void EventLog::see(const surface3d::FlowRecord& record, const surface3d::StepView& view) {
  const double t = record.time;
  const surface3d::Indicators& r = view.indicators;
  if (view.remeshed) see_new_mesh(t, r, *view.remeshed);
  if (view.remeshed && view.remeshed->mesh) return;
  const bool may_change = remesh_ && !view.memory.remeshing_over;
  const bool resolved = surface3d::resolved(resolved_ ? r : nearer_to_limits(r));
  if (resolved == resolved_ || (may_change && !resolved)) return;
  resolved_ = resolved;
  append({t, resolved ? "resolved" : "unresolved", view.mesh->count(), r, {}});
  if (resolved) {
    line_.say(fmt::format("sbeh: resolved again from t = {:.6g}", t));
    return;
  }
  if (!unresolved_from_) unresolved_from_ = t;
  line_.say(fmt::format("sbeh: unresolved from t = {:.6g}: {}{}", t, passed_limits(r),
                        remesh_ ? "" : "; more triangles, or [numerics] remesh = true, may help"));
}

void EventLog::see_new_mesh(double t, const surface3d::Indicators& before,
                            const surface3d::RemeshResult& made) {
  const surface3d::RemeshReport& report = made.report;
  append({t, made.mesh ? "remeshed" : "not-remeshed", report.triangles_before, before, report});
  line_.say(made.mesh ? fmt::format(
                "sbeh: t = {:.6g}: {}; {} new triangles for {}, smallest angle {:.0f} "
                "degrees after {:.0f}, energy changed by {:.1e}",
                t, passed_limits(before), report.triangles_after, report.triangles_before,
                report.min_angle_after, report.min_angle_before, report.energy_change)
                      : fmt::format("sbeh: t = {:.6g}: no new triangles: {}", t, made.refusal));
}

}  // namespace sbeh::studies
