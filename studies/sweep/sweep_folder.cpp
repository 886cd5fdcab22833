#include "studies/sweep/sweep_folder.h"

#include "studies/io/columns.h"
#include "studies/io/output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace sbeh::studies {

namespace fs = std::filesystem;

namespace {

// Of all lines but comments, by Fowler, Noll and Vo (FNV-1a, 64 bits).
std::string checksum_of(const std::string& description) {
  std::istringstream text(description);
  std::uint64_t sum = 0xcbf29ce484222325;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with('#')) continue;
    for (const char letter : line + "\n")
      sum = (sum ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
  }
  return fmt::format("{:016x}", sum);
}

// ---- the plan as a table ------------------------------------------------------------------------

const Columns<PlannedCase>& plan_columns() {
  static const Columns<PlannedCase> columns{
      column("number", &PlannedCase::number),
      column("command", &PlannedCase::kind),
      column<PlannedCase>("seconds", inside(&PlannedCase::cost, &CaseCost::seconds), "{:.3g}"),
      column<PlannedCase>("megabytes", inside(&PlannedCase::cost, &CaseCost::megabytes), "{:.3g}"),
      column<PlannedCase>("cores", inside(&PlannedCase::cost, &CaseCost::cores)),
      column("checksum", &PlannedCase::checksum),
  };
  return columns;
}

fs::path plan_file(const fs::path& folder) { return folder / "plan.csv"; }

std::string numbered(int number, const char* ending) {
  return fmt::format("{:04d}{}", number, ending);
}

// ---- making -------------------------------------------------------------------------------------

// Cases of a sweep that was killed before its plan was written are those that would be made now, or are in the way.
void require_same_cases(const fs::path& there, const SweepCases& cases) {
  for (const SweepCase& of : cases.cases) {
    const fs::path file = there / numbered(of.number, "") / "run.toml";
    if (!fs::exists(file) || checksum_of(read_file(file)) != checksum_of(of.description))
      throw OutputError(
          fmt::format("{}: is there without a plan.csv, and is not what this sweep makes; choose "
                      "another folder "
                      "with -o or move it away",
                      there.string()));
  }
}

// All cases at once: under another name until they are whole.
void make_cases(const fs::path& folder, const SweepCases& cases) {
  if (fs::exists(folder / "cases")) return require_same_cases(folder / "cases", cases);
  const fs::path making = folder / "cases.part";
  for (const SweepCase& of : cases.cases) {
    const fs::path at = making / numbered(of.number, "");
    make_folder(at);
    write_file(at / "run.toml", of.description);
  }
  std::error_code error;
  fs::rename(making, folder / "cases", error);
  if (error)
    throw OutputError(
        fmt::format("{}: cannot be written: {}", (folder / "cases").string(), error.message()));
}

}  // namespace

fs::path SweepPlan::case_folder(int number) const {
  return folder / "cases" / numbered(number, "");
}
fs::path SweepPlan::input_of(int number) const { return case_folder(number) / "run.toml"; }
fs::path SweepPlan::results_of(int number) const {
  return case_folder(number)
       / (kind == InputKind::scan     ? "scan.csv"
          : kind == InputKind::states ? "states.csv"
                                      : "series.csv");
}
fs::path SweepPlan::log_of(int number) const { return folder / "logs" / numbered(number, ".txt"); }
fs::path SweepPlan::end_of(int number) const { return folder / "ended" / numbered(number, ".csv"); }

bool holds_sweep(const fs::path& folder) { return fs::exists(plan_file(folder)); }

SweepPlan read_plan(const fs::path& folder) {
  if (!holds_sweep(folder))
    throw InputError(
        fmt::format("{0}: holds no sweep: it has no plan.csv (make it by: sbeh sweep FILE.toml -o "
                    "{0})",
                    folder.string()));
  SweepPlan plan{.folder = folder, .keys = {}, .cases = {}};
  const CsvTable table = read_csv(plan_file(folder));
  plan.cases = read_rows(plan_columns(), plan_file(folder));
  const std::size_t own = plan_columns().size();
  if (table.columns.size() <= own || plan.cases.empty())
    throw OutputError(fmt::format("{}: is damaged: make the sweep again in another folder",
                                  plan_file(folder).string()));
  plan.keys.assign(table.columns.begin() + std::ptrdiff_t(own), table.columns.end());
  for (std::size_t k = 0; k < plan.cases.size(); ++k)
    plan.cases[k].values.assign(table.rows[k].begin() + std::ptrdiff_t(own), table.rows[k].end());
  plan.kind = plan.cases.front().kind;
  return plan;
}

std::string plan_text(const std::vector<std::string>& keys, const SweepCases& cases) {
  std::string text = header_of(plan_columns());
  for (const std::string& key : keys) text.append(1, ',') += csv_field(key);
  text += "\n";
  for (const SweepCase& of : cases.cases) {
    text += line_of(plan_columns(), PlannedCase{.number = of.number,
                                                .kind = cases.kind,
                                                .cost = of.cost,
                                                .checksum = checksum_of(of.description),
                                                .values = {}});
    for (const std::string& value : of.values) text.append(1, ',') += csv_field(value);
    text += "\n";
  }
  return text;
}

MadeSweep make_sweep(const SweepInput& input, const fs::path& path, std::string_view version) {
  const SweepCases cases = cases_of(input, version);
  const std::string plan = plan_text(swept_keys(input), cases);
  const OutputFolder folder(path);
  if (holds_sweep(path)) {
    if (read_file(plan_file(path)) != plan)
      refuse(folder, "holds another sweep (see its plan.csv), which is not overwritten");
    return {read_plan(path), true};
  }
  refuse_results(folder, {"run.toml", "series.csv", "scan.csv", "states.csv"});
  for (const char* beside : {"logs", "ended"}) make_folder(folder / beside);
  make_cases(path, cases);
  write_file(plan_file(path), plan);
  return {read_plan(path), false};
}

bool is_as_made(const SweepPlan& plan, const PlannedCase& of) {
  const fs::path file = plan.input_of(of.number);
  return fs::exists(file) && checksum_of(read_file(file)) == of.checksum;
}

// ---- ends ---------------------------------------------------------------------------------------

namespace {

const Columns<CaseEnd>& end_columns() {
  static const Columns<CaseEnd> columns{
      column("number", &CaseEnd::key),
      column("exit_code", &CaseEnd::exit_code),
      column("seconds", &CaseEnd::seconds, "{:.3g}"),
      column("reason", &CaseEnd::reason),
  };
  return columns;
}

}  // namespace

std::optional<CaseEnd> read_end(const SweepPlan& plan, int number) {
  const fs::path file = plan.end_of(number);
  if (!fs::exists(file)) return {};
  const std::vector<CaseEnd> rows = read_rows(end_columns(), file);
  if (rows.empty())
    throw OutputError(
        fmt::format("{}: is damaged; delete it to have that case looked at again", file.string()));
  const bool lost = rows.front().exit_code == 0 && !fs::exists(plan.results_of(number));
  return lost ? std::nullopt : std::optional(rows.front());
}

void write_end(const SweepPlan& plan, const CaseEnd& end) {
  write_file(plan.end_of(end.key), table_text(end_columns(), std::vector{end}));
}

}  // namespace sbeh::studies
