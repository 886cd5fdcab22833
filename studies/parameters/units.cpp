#include "studies/parameters/units.h"

#include <fmt/format.h>

#include <stdexcept>

namespace sbeh::studies {

namespace {

// By one of its two names.
void read_rigidity(const TomlTable& table, Units& units) {
  constexpr const char *in_kT = "bending_rigidity_kT", *in_J = "bending_rigidity_J";
  units.in_kT = !table.has(in_J);
  if (!units.in_kT) table.refuse(in_kT, "must not be given together with bending_rigidity_J");
  units.bending_rigidity = table.number(units.in_kT ? in_kT : in_J, above(0));
}

void read_drag(const TomlTable& table, Units& units) {
  if (table.has("surface_viscosity")) {
    table.refuse(
        "friction",
        "must not be given together with surface_viscosity: either tells the unit of time");
    units.surface_viscosity = table.number("surface_viscosity", above(0));
  } else if (table.has("friction")) {
    units.friction = table.number("friction", above(0));
  }
}

}  // namespace

std::optional<Units> read_units(const TomlTable& file) {
  if (!file.has("units")) return {};
  const TomlTable table = file.table("units");
  Units units;
  units.temperature = table.number("temperature", above(0), units.temperature);
  units.radius_um = table.number("radius_um", above(0));
  read_rigidity(table, units);
  read_drag(table, units);
  table.reject_unknown_keys();
  return units;
}

void write_units(TomlText& toml, const std::optional<Units>& units) {
  if (!units) return;
  toml.table("units");
  toml.value("radius_um", units->radius_um);
  toml.value(units->in_kT ? "bending_rigidity_kT" : "bending_rigidity_J", units->bending_rigidity);
  toml.value("temperature", units->temperature);
  if (units->surface_viscosity) toml.value("surface_viscosity", *units->surface_viscosity);
  if (units->friction) toml.value("friction", *units->friction);
}

Scales scales_of(const Units& units, const model::Material& material, model::Model model) {
  const model::Material m = effective(material, model);
  const double kappa = m.kappa(model::full_order);
  if (!(kappa > 0))
    throw std::invalid_argument("a membrane without bending stiffness has no physical units");
  Scales scales;
  scales.length = 1e-6 * units.radius_um;
  scales.energy = units.rigidity() / kappa;
  scales.thermal = units.thermal();
  scales.in_kT = units.in_kT;
  const double R = scales.length, E = *scales.energy;
  if (units.surface_viscosity) {
    if (m.viscosity == 0)
      throw std::invalid_argument(
          "surface_viscosity tells no time: the material has no viscosity; give friction (Pa s/m) "
          "instead");
    scales.time = *units.surface_viscosity * R * R / (m.viscosity * E);
  } else if (units.friction) {
    if (m.friction_normal == 0)
      throw std::invalid_argument(
          "friction tells no time: the material has no friction; give surface_viscosity "
          "(Pa s m) instead");
    scales.time = *units.friction * R * R * R * R / (m.friction_normal * E);
  }
  return scales;
}

std::optional<Scales> lengths_of(const std::optional<Units>& units) {
  if (!units) return {};
  return Scales{.length = 1e-6 * units->radius_um};
}

std::optional<Scales> read_scales(const TomlTable& file, const std::optional<Units>& units,
                                  const model::Material& material, model::Model model) {
  if (!units) return {};
  try {
    return scales_of(*units, material, model);
  } catch (const std::invalid_argument& error) {
    file.fail("units", error.what());
  }
}

std::vector<std::string> text_of(const Units& units, const Scales& scales, std::string_view where) {
  const double thermal = units.thermal();
  const auto line = [&](const char* what, const Dimension& d) {
    return fmt::format("{} of 1 is {:.6g} {}", what, scales.factor(d), scales.unit(d));
  };
  std::vector<std::string> lines{
      fmt::format("length: R = {:.6g} µm, the radius of the sphere of equal area", units.radius_um),
      line("a curvature", dimension::curvature)};
  if (scales.time) lines.push_back(line("a friction", dimension::friction));
  const auto add = [&](const std::string& text) {
    lines.push_back(fmt::format("{}{}", text, where));
  };
  add(
      fmt::format("energy: E₀ = κ/κ̂ = {:.6g} J = {:.6g} k_BT with κ = {:.6g} J = {:.6g} k_BT at "
                  "{:.6g} K",
                  *scales.energy, *scales.energy / thermal, units.rigidity(),
                  units.rigidity() / thermal, units.temperature));
  if (!scales.time)
    lines.emplace_back("time: T is not known: [units] has neither surface_viscosity nor friction");
  else
    add(units.surface_viscosity
            ? fmt::format("time: T = μ_s R²/(μ̂ E₀) = {:.6g} s with μ_s = {:.6g} Pa s m",
                          *scales.time, *units.surface_viscosity)
            : fmt::format("time: T = γ R⁴/(γ̂ E₀) = {:.6g} s with γ = {:.6g} Pa s/m", *scales.time,
                          *units.friction));
  add(line("a tension or a potential", dimension::tension));
  add(line("a pressure", dimension::pressure));
  add(line("a speed", dimension::speed));
  add(line("a dissipation", dimension::power));
  return lines;
}

}  // namespace sbeh::studies
