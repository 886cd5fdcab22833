// sbeh.Material
#include "model/material.h"

#include "tools/python/bindings.h"

#include <array>
#include <map>
#include <string>
#include <utility>

namespace sbeh::python {

namespace {

using model::Material;

template <class Visit>
void for_each_number(Material& material, Visit&& visit) {
  model::for_each_parameter(material, [&](const model::Parameter& p, auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, double>) visit(p, value);
  });
}

std::array<std::pair<const char*, model::Polynomial*>, 4> polynomials_of(Material& material) {
  return {{{"flexoelectric", &material.flexoelectric},
           {"kappa", &material.kappa_powers},
           {"kappa_gauss", &material.kappa_gauss_powers},
           {"lipid_density", &material.lipid_density}}};
}

// A list of coefficients; what is wrong with it is said with the parameter's name.
template <class Powers>
Powers powers_of(const std::string& name, const py::handle& value) {
  try {
    return Powers(py::cast<std::vector<double>>(value));
  } catch (const std::invalid_argument& error) {
    throw py::value_error(name + ": " + error.what());
  }
}

// {"stiffness": ..., "W2": ...}
model::AreaDifference area_difference_of(const py::handle& value) {
  model::AreaDifference of;
  for (const auto& [key, number] : py::cast<std::map<std::string, double>>(value)) {
    if (key != "stiffness" && key != "W2")
      throw py::type_error("area_difference has no '" + key + "'");
    (key == "W2" ? of.W2 : of.stiffness) = number;
  }
  return of;
}

model::OrderDynamics order_named(const std::string& word) {
  if (const auto order = value_named<model::OrderDynamics>(word)) return *order;
  throw py::value_error("order: must be relaxing, conserved or diffusive, not " + word);
}

// As `material` but for the parameters given by name, L for the one-constant approximation.
Material changed(Material material, const py::kwargs& values) {
  for (const auto& item : values) {
    const auto name = py::cast<std::string>(item.first);
    const py::handle value = item.second;
    bool known = name == "L" || name == "potential" || name == "area_difference" || name == "order";
    if (name == "order") material.order = order_named(py::cast<std::string>(value));
    if (name == "area_difference") material.area_difference = area_difference_of(value);
    if (name == "L") material = material.with_L(py::cast<double>(value));
    if (name == "potential") material.potential = powers_of<model::Potential>(name, value);
    for (const auto& [key, powers] : polynomials_of(material)) {
      if (name != key) continue;
      *powers = powers_of<model::Polynomial>(name, value);
      known = true;
    }
    model::for_each_parameter(material, [&](const model::Parameter& p, auto& number) {
      if constexpr (std::is_same_v<std::decay_t<decltype(number)>, std::optional<double>>)
        if (name == p.name) {
          number = py::cast<double>(value);
          known = true;
        }
    });
    for_each_number(material, [&](const model::Parameter& p, double& number) {
      if (name != p.name) return;
      number = py::cast<double>(value);
      known = true;
    });
    if (!known) throw py::type_error("Material has no parameter '" + name + "'");
  }
  material.validate();
  return material;
}

py::dict dict_of(Material material) {
  py::dict values;
  for_each_number(material,
                  [&](const model::Parameter& p, double& number) { values[p.name] = number; });
  values["potential"] = material.potential.coefficients();
  for (const auto& [key, powers] : polynomials_of(material))
    if (!powers->empty()) values[key] = powers->coefficients();
  const model::AreaDifference& areas = material.area_difference;
  if (areas.is_there())
    values["area_difference"] =
        py::dict(py::arg("stiffness") = areas.stiffness, py::arg("W2") = areas.W2);
  if (material.conserves_order()) values["order"] = name(material.order);
  model::for_each_parameter(material, [&](const model::Parameter& p, const auto& value) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<double>>)
      if (value) values[p.name] = *value;
  });
  return values;
}

}  // namespace

void add_material(py::module_& m) {
  py::class_<Material> material(
      m, "Material",
      R"(The physics of a membrane; dimensionless, lengths in radii of the sphere of equal area.

Parameters are given by name, the others are those of the paper: L (one-constant approximation, instead of
L1, L2, L3), L1, L2, L3, potential (coefficients of the powers of the order), viscosity, immobility,
friction_tangential, friction_normal, order_viscosity, residual_stiffness, spontaneous_curvature (of the
sign of the trace H, -2 on the unit sphere), flexoelectric (coefficients of f(order) in f H), kappa and kappa_gauss (coefficients too, instead of those by the elastic constants),
lipid_density (coefficients of n(order), lipids per area up to a factor), area_difference (of the two leaflets, {"stiffness": k_ad, "W2": of no strain}; an infinite stiffness is the bilayer couple), order ("relaxing", or with a mean_order "conserved" or "diffusive", then with an order_mobility). Raises ValueError for values that are not allowed.)");
  material.def(py::init([](const py::kwargs& values) { return changed({}, values); }))
      .def("replace", &changed, "The same with other values of the parameters that are named.")
      .def("to_dict", &dict_of, "All parameters by name.")
      .def("kappa", &Material::kappa<double>, py::arg("order") = model::full_order,
           "Bending stiffness kappa(order) = (9/4) order^2 (2 L1 + L2 + L3) + k0.")
      .def("kappa_gauss", &Material::kappa_gauss<double>, py::arg("order") = model::full_order,
           "Saddle-splay stiffness kappa_G(order) = -(9/4) order^2 (2 L1 + L3).")
      .def(
          "u", [](const Material& self, double order) { return self.potential.value(order); },
          py::arg("order"), "Thermotropic potential u(order), energy per area.")
      .def("__eq__", [](const Material& a, const Material& b) { return a == b; })
      .def("__repr__", [](const Material& self) {
        return "Material(" + py::str(dict_of(self)).cast<std::string>() + ")";
      });
  Material any;
  for_each_number(any, [&](const model::Parameter& p, double&) {
    material.def_property_readonly(
        p.name,
        [name = std::string(p.name)](const Material& self) {
          return py::object(dict_of(self)[name.c_str()]);
        },
        p.meaning);
  });
  material.def_property_readonly(
      "flexoelectric", [](const Material& self) { return self.flexoelectric.coefficients(); },
      "Coefficients of the powers of the order in f.");
  material.def_property_readonly(
      "lipid_density", [](const Material& self) { return self.lipid_density.coefficients(); },
      "Coefficients of the powers of the order in n, lipids per area; empty where the area is "
      "kept.");
  material.def_property_readonly(
      "potential", [](const Material& self) { return self.potential.coefficients(); },
      "u(order), coefficients of its powers");
}

}  // namespace sbeh::python
