// Stationary states, one at a time.
#include "studies/scan/branch_points.h"
#include "studies/states/profile_file.h"
#include "tools/python/bindings.h"

#include <fmt/format.h>

namespace sbeh::python {

namespace {

using studies::PointOutcome;

// The row of a scan's table, as its text.
py::dict row_of(const PointOutcome& point) {
  py::dict row;
  for (const auto& column : studies::scan_columns())
    row[py::str(column.name)] = column.write(point.row);
  return row;
}

template <class Value>
Value named(const std::string& word, const char* what) {
  const auto value = value_named<Value>(word);
  if (!value) throw py::value_error(std::string(what) + " = '" + word + "' is not known");
  return *value;
}

PointOutcome stationary(const std::string& branch, double reduced_volume,
                        const model::Material& material, const std::string& model, int elements,
                        double grading, int modes) {
  const auto require = [](const char* name, double value, const model::Interval& allowed) {
    if (!allowed.contains(value))
      throw studies::InputError(
          fmt::format("stationary(): {} = {}: must be {}", name, value, allowed.text()));
  };
  require("reduced_volume", reduced_volume, studies::reduced_volumes);
  require("L", material.L1, model::above(0));
  require("modes", modes, model::between(0, axisym::most_modes));
  axisym::StationaryCase of{.model = named<model::Model>(model, "model"),
                            .branch = named<axisym::Branch>(branch, "branch"),
                            .reduced_volume = reduced_volume,
                            .material = material};
  of.numerics.elements = elements;
  of.numerics.grading = grading;
  of.numerics.validate();
  return at_work([&] {
    PointOutcome point = studies::branch_point(of);
    point.row.key = {reduced_volume, of.L(), of.model, of.branch};
    if (modes > 0) studies::add_modes(of, modes, point);
    if (of.model == model::Model::SBEH && point.row.status == studies::PointStatus::stationary)
      if (const auto fold = studies::fold_above(of, *point.state)) {
        point.row.fold_L = fold->state.at.L;
        point.row.fold_L_error = fold->place_error;
      }
    return point;
  });
}

// Arrays of a node each; empty where there is no state.
template <class Value>
auto of_state(Value value) {
  return [value](const PointOutcome& point) -> axisym::Field {
    return point.state ? axisym::Field(value(*point.state)) : axisym::Field();
  };
}

}  // namespace

void add_states(py::module_& m) {
  using axisym::StationaryState;
  py::class_<PointOutcome>(m, "State")
      .def_property_readonly("row", row_of)
      .def_property_readonly("arc_length", of_state([](const StationaryState& s) {
                               return studies::arc_lengths(s.X);
                             }))
      .def_property_readonly(
          "r", of_state([](const StationaryState& s) { return s.X.row(0).transpose(); }))
      .def_property_readonly(
          "z", of_state([](const StationaryState& s) { return s.X.row(1).transpose(); }))
      .def_property_readonly("order", of_state([](const StationaryState& s) { return s.beta; }))
      .def_property_readonly("mean_curvature",
                             of_state([](const StationaryState& s) { return s.H; }))
      .def_property_readonly("tension",
                             [](const PointOutcome& p) { return p.state ? p.state->tension : NAN; })
      .def_property_readonly(
          "pressure", [](const PointOutcome& p) { return p.state ? p.state->pressure : NAN; });
  m.def("stationary", stationary, py::arg("branch"), py::arg("reduced_volume"), py::arg("material"),
        py::arg("model"), py::arg("elements"), py::arg("grading"), py::arg("modes"));
}

}  // namespace sbeh::python
