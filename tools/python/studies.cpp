// Studies, from an input to a folder of results, as on the command line.
#include "studies/evolution/relax.h"
#include "studies/evolution/run.h"
#include "studies/io/conventions.h"
#include "studies/modes/modes.h"
#include "studies/report/result_units.h"
#include "studies/rest_states/run_end.h"
#include "studies/rest_states/states.h"
#include "studies/scan/scan.h"
#include "tools/python/bindings.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

namespace sbeh::python {

namespace {

namespace fs = std::filesystem;

// What failed, if anything did.
std::string scan(const fs::path& input, const fs::path& folder, int threads) {
  const auto summary = at_work([&] {
    std::optional<tbb::global_control> limit;
    if (threads > 0)
      limit.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    return studies::run_scan(studies::read_scan(input), folder, SBEH_VERSION);
  });
  if (summary.failed == 0) return "";
  return fmt::format("{} of {} points failed, the first one because {}", summary.failed,
                     summary.points, summary.first_failure);
}

std::string point_file(const std::string& model, const std::string& branch, double reduced_volume,
                       double L) {
  const auto of = value_named<model::Model>(model);
  const auto along = value_named<axisym::Branch>(branch);
  if (!of || !along) throw py::value_error("model or branch is not known");
  return studies::stem({reduced_volume, L, *of, *along}) + ".csv";
}

// How an evolution ended, and what shows whether it is to be trusted.
template <class Result>
py::dict end_of(const Result& run) {
  py::dict end;
  end["stop"] = model::describe(run.stop);
  using model::FlowStop;
  end["ended_well"] = run.stop == FlowStop::end_time || run.stop == FlowStop::at_rest
                   || run.stop == FlowStop::near_rest;
  end["fault"] = model::describe(run.fault);
  end["time"] = run.last.time;
  end["steps"] = run.steps;
  end["rejected"] = run.last.rejected;
  end["energy"] = run.last.energy.total();
  end["energy_rises"] = run.last.rises.sum;
  end["rises_too_far"] = model::rises_too_far(run.last);
  return end;
}

py::dict relax(const fs::path& input, const fs::path& folder) {
  return end_of(at_work([&] {
                  return studies::run_relax(studies::read_relax(input), folder, SBEH_VERSION);
                }).run);
}

py::dict run(const fs::path& input, const fs::path& folder, bool resume) {
  const auto summary = at_work([&] {
    const auto asked = resume ? studies::read_resumed_run(input, folder) : studies::read_run(input);
    auto done = studies::run_surface(asked, folder, SBEH_VERSION, resume);
    studies::rest_of_run(asked, done, folder, SBEH_VERSION);
    return done;
  });
  py::dict end = end_of(summary.run);
  end["unresolved_from"] = summary.unresolved_from;
  return end;
}

// A table of a folder in physical units, as text.
std::string physical_table(const fs::path& folder, const std::string& file,
                           const std::optional<fs::path>& units_from) {
  const studies::ResultUnits units(folder, units_from);
  return studies::text_of(units.converted(studies::read_csv(folder / file), file));
}

std::vector<std::string> describe_units(const fs::path& folder,
                                        const std::optional<fs::path>& units_from) {
  return studies::ResultUnits(folder, units_from).text();
}

double modes(const fs::path& input, const fs::path& folder) {
  return at_work([&] {
    return studies::run_modes(studies::read_modes(input), folder, SBEH_VERSION).rigid_residual;
  });
}

void rest_states(const fs::path& input, const fs::path& folder) {
  const bool interrupted = at_work([&] {
    return studies::run_states(studies::read_states(input), folder, SBEH_VERSION).interrupted;
  });
  if (interrupted) throw studies::Interrupted("interrupted");
}

}  // namespace

void add_studies(py::module_& m) {
  m.def("point_file", point_file, py::arg("model"), py::arg("branch"), py::arg("reduced_volume"),
        py::arg("L"));
  m.def("scan", scan, py::arg("input"), py::arg("folder"), py::arg("threads"));
  m.def("relax", relax, py::arg("input"), py::arg("folder"));
  m.def("run", run, py::arg("input"), py::arg("folder"), py::arg("resume"));
  m.def("modes", modes, py::arg("input"), py::arg("folder"));
  m.def("rest_states", rest_states, py::arg("input"), py::arg("folder"));
  m.def("physical_table", physical_table, py::arg("folder"), py::arg("file"),
        py::arg("units_from").none(true));
  m.def("describe_units", describe_units, py::arg("folder"), py::arg("units_from").none(true));
  std::string text;
  for (const char* line : studies::conventions) text.append(text.empty() ? 0 : 1, '\n') += line;
  m.attr("conventions") = text;
}

}  // namespace sbeh::python
