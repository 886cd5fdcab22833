// The parts of the compiled module sbeh._sbeh. What users see is written in Python around them.
#pragma once

#include "studies/io/interrupt.h"

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace sbeh::python {

namespace py = pybind11;

void add_material(py::module_& m);
void add_states(py::module_& m);
void add_studies(py::module_& m);
void add_surfaces(py::module_& m);
void add_runs(py::module_& m);

/// Does the work without Python's lock. Ctrl-C ends it as on the command line, and is then raised.
template <class Work>
auto at_work(Work&& work) {
  const auto raise_if_interrupted = [] {
    if (studies::interrupt_signal() == 0) return;
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  };
  const studies::CaughtInterrupts caught;
  auto result = [&] {
    const py::gil_scoped_release unlocked;
    return work();
  }();
  raise_if_interrupted();
  return result;
}

}  // namespace sbeh::python
