// A 3D run that is stepped from outside.
#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_start.h"
#include "tools/python/bindings.h"

namespace sbeh::python {

namespace {

namespace fs = std::filesystem;
using studies::FlowMoment;
using surface3d::FlowRecord;

class Run {
 public:
  explicit Run(const fs::path& file) : input_(studies::read_run(file)) {
    studies::RunStart start = at_work([&] { return studies::start_of(input_); });
    now_ = std::move(start.moment);
    remarks_ = std::move(start.remarks);
  }

  /// Until the time, for so many steps at the most; `after_step`, which may end it by False, sees every step. Why it ended.
  std::string advance(double until, std::optional<int> steps, bool stop_at_rest,
                      const std::optional<py::function>& after_step);

  const FlowMoment& now() const { return now_; }
  const studies::RunInput& input() const { return input_; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  surface3d::Diagnostics diagnostics() const {
    return surface3d::diagnose(*now_.mesh, input_.material, now_.state);
  }
  void write_frame(const fs::path& path) const { studies::write_frame(path, now_, input_); }

 private:
  studies::RunInput input_;
  FlowMoment now_;
  std::vector<std::string> remarks_;
};

std::string Run::advance(double until, std::optional<int> steps, bool stop_at_rest,
                         const std::optional<py::function>& after_step) {
  int left = steps.value_or(std::numeric_limits<int>::max());
  bool asked_to_end = false;
  const double before = now_.record.time;
  const FlowMoment start = now_;
  const auto see = [&](const FlowRecord& record, const surface3d::State& state,
                       const surface3d::StepView& view, bool) {
    now_ = {view.mesh, state, now_.target, record, view.memory, view.fields};
    if (record.time == before) return true;  // the start
    asked_to_end = --left <= 0;
    if (after_step) {
      const py::gil_scoped_acquire locked;
      const py::object answer = (*after_step)();
      asked_to_end = asked_to_end || (py::isinstance<py::bool_>(answer) && !answer.cast<bool>());
    }
    return !asked_to_end && studies::interrupt_signal() == 0;
  };
  const auto result = at_work([&] {
    return surface3d::run_flow(input_.material, input_.model, start, input_.numerics,
                               {.end_time = until, .stop_at_rest = stop_at_rest}, see);
  });
  return result.stop == model::FlowStop::interrupted && asked_to_end ? "" : describe(result.stop);
}

py::dict dict_of(const FlowRecord& r, const surface3d::Diagnostics& d) {
  py::dict all;
  all["time"] = r.time;
  all["time_step"] = r.time_step;
  all["energy"] = d.energy.total();
  all["energy_distortion"] = d.energy.distortion;
  all["energy_bending"] = d.energy.bending;
  all["energy_thermotropic"] = d.energy.thermotropic;
  all["energy_area_difference"] = d.energy.area_difference;
  all["dissipation_friction"] = r.dissipation.friction;
  all["dissipation_order"] = r.dissipation.order;
  all["dissipation_viscous"] = r.dissipation.viscous;
  all["speed_max"] = r.speed_max;
  all["energy_rises"] = r.rises.sum;
  all["area"] = d.area;
  all["volume"] = d.volume;
  all["reduced_volume"] = d.reduced_volume;
  all["order_min"] = d.order_min;
  all["order_mean"] = d.order_mean;
  all["order_max"] = d.order_max;
  all["H_abs_max"] = d.H_abs_max;
  all["resolution"] = d.resolution;
  all["mesh_quality"] = d.mesh_quality;
  return all;
}

}  // namespace

void add_runs(py::module_& m) {
  py::class_<Run>(m, "Run")
      .def(py::init<const fs::path&>(), py::arg("input"))
      .def("advance", &Run::advance, py::arg("until"), py::arg("steps"), py::arg("stop_at_rest"),
           py::arg("after_step"))
      .def("measures", [](const Run& run) { return dict_of(run.now().record, run.diagnostics()); })
      .def_property_readonly("time", [](const Run& run) { return run.now().record.time; })
      .def_property_readonly("model", [](const Run& run) { return name(run.input().model); })
      .def_property_readonly("material", [](const Run& run) { return run.input().material; })
      .def_property_readonly("remarks", &Run::remarks)
      .def_property_readonly(
          "points", [](const Run& run) { return Eigen::MatrixXd(run.now().state.X.transpose()); })
      .def_property_readonly(
          "triangles",
          [](const Run& run) { return Eigen::MatrixXi(run.now().mesh->triangles.transpose()); })
      .def_property_readonly("order", [](const Run& run) { return run.now().state.beta; })
      .def_property_readonly(
          "velocity",
          [](const Run& run) { return Eigen::MatrixXd(run.now().fields.V.transpose()); })
      .def_property_readonly("mean_curvature",
                             [](const Run& run) -> surface3d::Field {
                               const auto c =
                                   surface3d::curvature_of(*run.now().mesh, run.now().state.X);
                               return c ? c->H : surface3d::Field();
                             })
      .def("write_frame", &Run::write_frame, py::arg("path"));
}

}  // namespace sbeh::python
