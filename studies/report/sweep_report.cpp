#include "studies/report/sweep_report.h"

#include "studies/io/csv.h"
#include "studies/io/output.h"
#include "studies/report/html.h"
#include "studies/report/svg_chart.h"
#include "studies/scan/scan_table.h"
#include "studies/sweep/sweep_status.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_charts = 60, most_lines = 4, most_rows_of_page = 1000;

// "L = 0.03, friction = 0.1": the values of a case, by the last words of their keys.
std::string values_text(const SweepPlan& plan, const PlannedCase& of) {
  std::string text;
  for (std::size_t k = 0; k < plan.keys.size(); ++k)
    text += fmt::format("{}{} = {}", k == 0 ? "" : ", ",
                        plan.keys[k].substr(plan.keys[k].find_last_of('.') + 1), of.values[k]);
  return text;
}

ChartLine energy_over_time(const CsvTable& series) {
  ChartLine line{.name = "energy"};
  for (std::size_t row = 0; row < series.rows.size(); ++row) {
    line.x.push_back(series.number(row, "time"));
    line.y.push_back(series.number(row, "energy"));
  }
  return line;
}

std::size_t count_of_values(const CsvTable& table, const std::string& column) {
  std::set<std::string> values;
  for (std::size_t row = 0; row < table.rows.size(); ++row) values.insert(table.text(row, column));
  return values.size();
}

// A line for each model, branch and value of what changes less.
std::vector<ChartLine> energies_over(const CsvTable& table, const std::string& x) {
  const std::string other = x == "L" ? "reduced_volume" : "L";
  std::vector<ChartLine> lines;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.text(row, "status") != name(PointStatus::stationary)) continue;
    const std::string called =
        fmt::format("{} {}, {} = {}", table.text(row, "model"), table.text(row, "branch"),
                    other == "L" ? "L" : "V_r", table.text(row, other));
    auto line = std::ranges::find(lines, called, &ChartLine::name);
    if (line == lines.end()) line = lines.insert(lines.end(), ChartLine{.name = called});
    line->x.push_back(table.number(row, x));
    line->y.push_back(table.number(row, "energy"));
  }
  if (lines.size() > most_lines) lines.resize(most_lines);
  return lines;
}

Chart chart_of(const SweepPlan& plan, const PlannedCase& of) {
  const CsvTable table = read_csv(plan.results_of(of.number));
  ChartFrame frame{.title = fmt::format("{}: {}", of.number, values_text(plan, of)), .y_name = "U"};
  if (plan.kind == InputKind::run || plan.kind == InputKind::relax) {
    frame.x = AxisScale::logarithmic;
    return {frame, {energy_over_time(table)}};
  }
  const bool by_L = count_of_values(table, "L") > count_of_values(table, "reduced_volume");
  frame.x_name = by_L ? "L" : "V_r";
  return {frame, energies_over(table, by_L ? "L" : "reduced_volume")};
}

std::string charts(const SweepPlan& plan, const std::vector<CaseState>& states) {
  std::vector<const PlannedCase*> done;
  for (std::size_t k = 0; k < states.size(); ++k)
    if (states[k].status == CaseStatus::done) done.push_back(&plan.cases[k]);
  const std::size_t step = (done.size() + most_charts - 1) / most_charts;
  std::vector<Chart> shown;
  for (std::size_t k = 0; k < done.size(); k += step) shown.push_back(chart_of(plan, *done[k]));
  const std::string text = svg_charts(shown);
  if (text.empty()) return "";
  std::string note;
  if (step > 1) note = fmt::format("<p class=\"note\">One of {} cases in a row.</p>\n", step);
  return note + "<div class=\"charts\">\n" + text + "</div>\n";
}

std::string failures(const SweepPlan& plan, const std::vector<CaseState>& states) {
  std::string text;
  for (const CaseState& state : states)
    if (const std::string wrong = complaint_about(plan, state); !wrong.empty())
      text += html::element("li", wrong) + "\n";
  return text.empty() ? text : "<ul>\n" + text + "</ul>\n";
}

}  // namespace

ReportSummary write_sweep_report(const fs::path& folder, std::string_view version) {
  const SweepPlan plan = read_plan(folder);
  ReportSummary summary{.file = folder / "report.html"};
  summary.replaced = replaces_report(summary.file);
  write_sweep_table(plan);
  const std::vector<CaseState> states = states_of(plan);
  const std::string title =
      fmt::format("Sweep: {} cases of sbeh {}", plan.cases.size(), sbeh::name(plan.kind));
  std::vector<html::Fact> facts;
  for (const CaseStatus status : values_of(CaseStatus{}))
    if (const int count = count_of(states, status); count > 0)
      facts.push_back({name(status), std::to_string(count)});

  std::string body = "<header>\n" + html::element("h1", title) + "</header>\n<main>\n"
                   + html::section("Cases", html::facts(facts));
  if (const std::string wrong = failures(plan, states); !wrong.empty())
    body += html::section("What failed", wrong);
  if (const std::string small = charts(plan, states); !small.empty())
    body += html::section("Case by case", small);
  body += html::section(
      "Table", html::table(read_csv(folder / "sweep.csv"), most_rows_of_page, "sweep.csv"));
  body += html::section("How to go on with it",
                        html::element("pre", fmt::format("sbeh sweep {}", folder.string())));
  write_file(summary.file, html::page(title, generator_of(version), body + "</main>\n"));
  return summary;
}

}  // namespace sbeh::studies
