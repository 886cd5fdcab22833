// The compiled half of the Python package sbeh.
#include "studies/io/errors.h"
#include "studies/io/progress.h"
#include "tools/python/bindings.h"

namespace sbeh::python {

namespace {

// What is told goes to a function of Python, from whatever thread.
void tell_to_python(std::optional<py::function> listener) {
  if (!listener) {
    studies::tell_to({}, false);
    return;
  }
  // Never released: threads may tell until the process ends.
  auto* hear = new py::function(std::move(*listener));  // NOLINT(cppcoreguidelines-owning-memory)
  studies::tell_to(
      [hear](std::string_view text) {
        const py::gil_scoped_acquire locked;
        try {
          (*hear)(text);
        } catch (py::error_already_set& error) {
          error.discard_as_unraisable("a listener of sbeh");
        }
      },
      true);
}

}  // namespace

PYBIND11_MODULE(_sbeh, m) {
  m.doc() = "Compiled half of sbeh: see the package.";
  m.attr("version") = SBEH_VERSION;
  py::register_exception<studies::InputError>(m, "InputError", PyExc_ValueError).doc() =
      "Wrong input: where, what, and what is allowed.";
  py::register_exception<studies::OutputError>(m, "OutputError", PyExc_OSError).doc() =
      "Results cannot be read or written: folder, file, reason, what to do.";
  py::register_exception<studies::Interrupted>(m, "Interrupted", PyExc_KeyboardInterrupt);
  m.def("tell_to", tell_to_python, py::arg("listener").none(true),
        "Gives messages and progress to a function of one text; with None to standard error.");
  add_material(m);
  add_states(m);
  add_studies(m);
  add_surfaces(m);
  add_runs(m);
}

}  // namespace sbeh::python
