#include "tools/commands/command.h"

#include "studies/io/errors.h"
#include "studies/io/interrupt.h"
#include "studies/io/progress.h"
#include "studies/report/path_kind.h"

#include <tbb/global_control.h>

#include <charconv>
#include <optional>
#include <stdexcept>

namespace sbeh::tools {

namespace fs = std::filesystem;

fs::path Study::results() const {
  return folder.empty() ? fs::path("results") / fs::path(input).stem() : fs::path(folder);
}

Command add_study(CLI::App& program, studies::InputKind kind, const char* text,
                  std::function<int(const Study&)> run) {
  const auto study = std::make_shared<Study>();
  CLI::App* app = program.add_subcommand(sbeh::name(kind), text);
  app->add_option("FILE", study->input, "input (TOML)")->required();
  app->add_option("-o,--output", study->folder, "folder for the results (results/NAME)");
  app->add_flag("--no-pictures", study->no_pictures, "tables only");
  app->add_option("--threads", study->threads, "at most so many (all cores)")
      ->check(CLI::Range(1, 4096));
  return {app, [study, kind, run = std::move(run)] {
            studies::catch_interrupts();
            std::optional<tbb::global_control> limit;
            if (study->threads > 0)
              limit.emplace(tbb::global_control::max_allowed_parallelism,
                            std::size_t(study->threads));
            try {
              return run(*study);
            } catch (const studies::InputError&) {
              studies::refuse_other_kind(study->input, sbeh::name(kind));
              throw;
            } catch (const std::invalid_argument& error) {  // only the start itself could tell
              throw studies::InputError(fmt::format("{}: {}", study->input, error.what()));
            }
          }};
}

studies::Part part_of(const std::string& text) {
  studies::Part part;
  const std::size_t slash = text.find('/');
  const auto number = [](std::string_view digits, int& into) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), into);
    return error == std::errc() && end == digits.data() + digits.size();
  };
  const std::string_view all = text;
  if (slash == std::string::npos || !number(all.substr(0, slash), part.part)
      || !number(all.substr(slash + 1), part.parts) || part.part < 1 || part.part > part.parts)
    throw studies::InputError(
        fmt::format("--part {}: must be such as 3/16, the third of sixteen", text));
  return part;
}

void draw_results(studies::ResultsKind kind, const fs::path& folder) {
  if (draw({sbeh::name(kind), folder.string()}) != 0)
    complain(
        fmt::format("no pictures; the tables in {0} are complete. "
                    "Try again with: sbeh picture {1} {0}",
                    folder.string(), sbeh::name(kind)));
}

int exit_code_of_success() { return studies::interrupt_signal() ? exit_code_of_interrupt() : 0; }

int finish(const Study& study, studies::ResultsKind kind, bool interrupted) {
  if (interrupted) {
    complain("interrupted; the same command goes on from here");
    return exit_code_of_interrupt();
  }
  if (!study.no_pictures) draw_results(kind, study.results());
  return exit_code_of_success();
}

std::string duration(double seconds) {
  constexpr double minute = 60, hour = 3600;
  const auto in = [seconds](double unit, const char* name) {
    return fmt::format("{:.{}f} {}", seconds / unit, seconds < 9.95 * unit ? 1 : 0, name);
  };
  if (seconds < 1) return fmt::format("{:.1g} s", seconds);
  return seconds < 2 * minute ? in(1, "s") : seconds < 2 * hour ? in(minute, "min") : in(hour, "h");
}

const char* beside_times(bool every_step) { return every_step ? " and one for each step" : ""; }

}  // namespace sbeh::tools
