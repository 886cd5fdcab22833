#include "studies/parameters/describe.h"

#include "studies/io/spelling.h"
#include "studies/io/toml_reader.h"

#include <fmt/format.h>

namespace sbeh::studies {

namespace {

constexpr std::size_t list_width = 80;  // and the key before it

// ---- values -------------------------------------------------------------------------------------

std::string as_toml(double value) { return fmt::format("{}", value); }  // shortest exact
std::string as_toml(int value) { return fmt::format("{}", value); }
std::string as_toml(bool value) { return value ? "true" : "false"; }
std::string as_toml(const std::string& text) { return in_quotes(text); }
std::string as_toml(model::Model model) { return in_quotes(name(model)); }
std::string as_toml(Method method) { return in_quotes(name(method)); }
std::string as_toml(Witness witness) { return in_quotes(name(witness)); }
std::string as_toml(const meshing::Harmonic& h) {
  return fmt::format("[{}, {}, {}]", h.l, h.m, h.amplitude);
}
std::string as_toml(const std::pair<int, double>& mode) {
  return fmt::format("[{}, {}]", mode.first, mode.second);
}

/// A list, broken into lines that are not too long.
template <class List>
std::string list_as_toml(const List& list) {
  std::string text = "[", separator;
  std::size_t line_start = 0;
  for (const auto& element : list) {
    const std::string next = as_toml(element);
    if (text.size() + separator.size() + next.size() - line_start > list_width) {
      separator = ",\n  ";
      line_start = text.size() + 2;
    }
    text += separator + next;
    separator = ", ";
  }
  return text + "]";
}
template <class T>
std::string as_toml(const std::vector<T>& list) {
  return list_as_toml(list);
}
std::string as_toml(const std::array<double, 2>& list) { return list_as_toml(list); }
std::string as_toml(const Eigen::Vector3d& list) { return list_as_toml(list); }

/// The text that grows table by table and line by line.
class TomlText {
 public:
  explicit TomlText(std::string_view version)
      : text_(fmt::format("# sbeh {}: every parameter of this run; can be run again\n", version)) {}

  void table(const char* name) { text_ += fmt::format("\n[{}]\n", name); }
  template <class T>
  void value(const char* key, const T& value) {
    text_ += fmt::format("{} = {}\n", key, as_toml(value));
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// ---- tables -------------------------------------------------------------------------------------

enum class Elasticity { with_L, without_L };

/// Without what the model says itself. The binding names every member, so that a new one is not
/// forgotten here.
void write_material(TomlText& toml, const model::Material& material, Elasticity elasticity,
                    model::Model model = model::Model::SBEH) {
  const auto& [L1, L2, L3, potential, viscosity, immobility, friction_tangential, friction_normal,
               order_viscosity, residual_stiffness, spontaneous_curvature] = material;
  toml.table("material");
  if (elasticity == Elasticity::with_L) {
    toml.value("L1", L1);
    toml.value("L2", L2);
    toml.value("L3", L3);
  }
  toml.value("potential", potential.coefficients());
  if (!has_own_drag(model)) toml.value("viscosity", viscosity);
  toml.value("immobility", immobility);
  if (!has_own_drag(model)) {
    toml.value("friction_tangential", friction_tangential);
    toml.value("friction_normal", friction_normal);
  }
  toml.value("order_viscosity", order_viscosity);
  toml.value("residual_stiffness", residual_stiffness);
  toml.value("spontaneous_curvature", spontaneous_curvature);
}

void write_surface_method(TomlText& toml, const SurfaceMethod& method) {
  toml.table("surface3d");
  if (!method.run.empty()) {
    toml.value("run", method.run);
    return;
  }
  toml.value("start", std::string(method.revolved ? "revolved" : "ellipsoid"));
  toml.value("triangles", method.triangles);
  toml.value("end", method.end_time);
  toml.value("tolerance", method.numerics.tolerance);
  toml.value("rest_speed", method.numerics.rest_speed);
}

void write_tolerances(TomlText& toml, const char* table, const Tolerances& tolerances) {
  if (tolerances.empty()) return;
  toml.table(table);
  for (const std::string& quantity : tolerated_quantities())
    if (const auto at = tolerances.find(quantity); at != tolerances.end())
      toml.value(quantity.c_str(), at->second);
}

void write_time_control(TomlText& toml, const model::TimeControl& control) {
  const auto& [tolerance, first_step, smallest_step, largest_step, extrapolate, rest_speed] =
      control;
  toml.value("tolerance", tolerance);
  toml.value("first_step", first_step);
  toml.value("smallest_step", smallest_step);
  toml.value("largest_step", largest_step);
  toml.value("extrapolate", extrapolate);
  toml.value("rest_speed", rest_speed);
}

void write_numerics(TomlText& toml, const axisym::Numerics& numerics) {
  toml.table("numerics");
  toml.value("elements", numerics.elements);
  toml.value("grading", numerics.grading);
  write_time_control(toml, numerics);
}

void write_ellipsoid(TomlText& toml, const auto& ellipsoid) {
  toml.value("shape", std::string("ellipsoid"));
  if (ellipsoid.axes) toml.value("axes", *ellipsoid.axes);
  if (ellipsoid.reduced_volume) {
    toml.value("reduced_volume", *ellipsoid.reduced_volume);
    toml.value("kind", std::string(ellipsoid.prolate ? "prolate" : "oblate"));
  }
}

void write_shape(TomlText& toml, const Ellipsoid& ellipsoid) { write_ellipsoid(toml, ellipsoid); }

void write_shape(TomlText& toml, const Ellipsoid3d& ellipsoid) { write_ellipsoid(toml, ellipsoid); }

void write_shape(TomlText& toml, const Harmonics& harmonics) {
  toml.value("shape", std::string("harmonics"));
  if (!harmonics.shape.empty()) toml.value("modes", harmonics.shape);
  if (harmonics.order) toml.value("order", *harmonics.order);
  if (!harmonics.order_modes.empty()) toml.value("order_modes", harmonics.order_modes);
}

void write_shape(TomlText& toml, const ScanRow& row) {
  toml.value("shape", std::string("scan"));
  toml.value("folder", row.folder);
  toml.value("model", row.model);
  toml.value("branch", row.branch);
  toml.value("reduced_volume", row.reduced_volume);
  toml.value("L", row.L);
}

void write_shape(TomlText& toml, const HarmonicSphere& sphere) {
  toml.value("shape", std::string("harmonics"));
  toml.value("modes", sphere.modes);
}

void write_shape(TomlText& toml, const MeshFileStart& mesh) {
  toml.value("shape", std::string("mesh"));
  toml.value("file", mesh.file);
}

void write_shape(TomlText& toml, const FrameStart& frame) {
  toml.value("shape", std::string("frame"));
  toml.value("file", frame.file);
}

void write_surface(TomlText& toml, const RunInput& input) {
  toml.table("surface");
  std::visit([&toml](const auto& shape) { write_shape(toml, shape); }, input.start);
  const bool own_mesh = std::holds_alternative<MeshFileStart>(input.start),
             own_state = std::holds_alternative<FrameStart>(input.start);
  if (!own_mesh && !own_state) toml.value("triangles", input.triangles);
  if (!own_state && !std::holds_alternative<ScanRow>(input.start) && has_free_order(input.model))
    toml.value("order", input.initial_order);
  if (!input.perturbation.empty()) toml.value("perturbation", input.perturbation);
}

void write_start(TomlText& toml, const RelaxInput& input) {
  toml.table("start");
  std::visit([&toml](const auto& shape) { write_shape(toml, shape); }, input.start);
  if (std::holds_alternative<Ellipsoid>(input.start) && has_free_order(input.model))
    toml.value("order", input.initial_order);
}

void write_time(TomlText& toml, const auto& input, const char* states,
                const std::vector<double>& state_times) {
  toml.table("time");
  toml.value("end", input.end_time);
  toml.value("output", input.output_times);
  toml.value(states, state_times);
  toml.value("every_step", input.every_step);
  toml.value("stop_at_rest", input.stop_at_rest);
}

}  // namespace

InputKind kind_of(const std::filesystem::path& path) {
  const TomlTable file = TomlFile::parse(path);
  const bool scan = file.has("scan"), relax = file.has("start"), run = file.has("surface"),
             compare = file.has("compare"), stability = file.has("stability");
  const int count = scan + relax + run + compare + stability;
  if (count != 1)
    throw InputError(fmt::format(
        "{}: must have {}[scan] (a scan), [start] (one axisymmetric evolution), [surface] (one "
        "3D run), [compare] (one case by several methods) or [stability] (axisymmetric states, "
        "perturbed in 3D){}",
        path.string(), count > 1 ? "only one of " : "a table ",
        count > 1 ? "" : "; it has none of them"));
  return scan    ? InputKind::scan
       : relax   ? InputKind::relax
       : run     ? InputKind::run
       : compare ? InputKind::compare
                 : InputKind::stability;
}

std::string describe(const ScanInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("scan");
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  toml.value("models", input.models);
  toml.value("branches", input.branches);
  toml.value("method", input.method);
  if (input.method == Method::flow) toml.value("end_time", input.flow_end_time);
  if (input.method == Method::newton) toml.value("beyond_fold", input.beyond_fold);
  write_material(toml, input.material, Elasticity::without_L);
  write_numerics(toml, input.numerics);
  return toml.text();
}

std::string describe(const RelaxInput& input, std::string_view version) {
  TomlText toml(version);
  toml.value("model", input.model);
  write_start(toml, input);
  write_material(toml, input.material, Elasticity::with_L, input.model);
  write_numerics(toml, input.numerics);
  write_time(toml, input, "profiles", input.profile_times);
  return toml.text();
}

std::string describe(const RunInput& input, std::string_view version) {
  TomlText toml(version);
  toml.value("model", input.model);
  write_surface(toml, input);
  write_material(toml, input.material, Elasticity::with_L, input.model);
  toml.table("numerics");
  write_time_control(toml, input.numerics);
  toml.value("integrator", std::string(name(input.numerics.integrator)));
  toml.value("scheme", std::string(name(input.numerics.scheme)));
  toml.value("factorisation", std::string(name(input.numerics.factorisation)));
  toml.value("solver_tolerance", input.numerics.solver_tolerance);
  toml.value("remesh", input.numerics.remesh);
  toml.value("most_triangles", input.numerics.most_triangles);
  write_time(toml, input, "frames", input.frame_times);
  toml.value("checkpoint_minutes", input.checkpoint_minutes);
  return toml.text();
}

std::string describe(const CompareInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("compare");
  toml.value("model", input.model);
  toml.value("branch", input.branch);
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  toml.value("methods", input.methods);
  write_material(toml, input.material, Elasticity::without_L);
  write_numerics(toml, input.numerics);
  if (input.has(Witness::surface3d)) write_surface_method(toml, input.surface3d);
  if (input.has(Witness::harmonics)) {
    toml.table("harmonics");
    toml.value("degree", input.harmonics.degree);
  }
  write_tolerances(toml, "tolerance", input.tolerance);
  write_tolerances(toml, "tolerance_3d", input.tolerance_3d);
  return toml.text();
}

std::string describe(const StabilityInput& input, std::string_view version) {
  TomlText toml(version);
  toml.table("stability");
  toml.value("reduced_volume", input.reduced_volume);
  toml.value("L", input.L);
  toml.value("models", input.models);
  toml.value("branches", input.branches);
  toml.value("perturbations", input.perturbations);
  toml.table("surface3d");
  toml.value("triangles", input.triangles);
  toml.value("end", input.end_time);
  toml.value("largest_step", input.numerics_3d.largest_step);
  toml.value("tolerance", input.numerics_3d.tolerance);
  write_material(toml, input.material, Elasticity::without_L);
  write_numerics(toml, input.numerics);
  return toml.text();
}

}  // namespace sbeh::studies
