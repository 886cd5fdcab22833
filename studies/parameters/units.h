// The table [units]: of which vesicle the dimensionless numbers are, and what one of them is in physical units.
#pragma once

#include "model/material.h"
#include "studies/io/scales.h"
#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"

#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

/// A vesicle and its membrane. Of the last two at most one is there; without them times have no physical unit.
struct Units {
  double radius_um = 1;                       ///< R, of the sphere of equal area
  double bending_rigidity = 0;                ///< κ at full order
  bool in_kT = true;                          ///< κ is in k_BT, and so are energies; else in J
  double temperature = 300;                   ///< K
  std::optional<double> surface_viscosity{};  ///< μ_s, Pa s m
  std::optional<double> friction{};           ///< γ_⊥, Pa s/m

  double thermal() const { return 1.380649e-23 * temperature; }                   ///< k_BT in J
  double rigidity() const { return bending_rigidity * (in_kT ? thermal() : 1); }  ///< κ in J

  bool operator==(const Units&) const = default;
};

/// The table [units] of an input, where it has one:
///   radius_um = 10
///   bending_rigidity_kT = 20    or bending_rigidity_J
///   temperature = 300           K; this where it is not said
///   surface_viscosity = 5e-10   Pa s m; or friction, Pa s/m; without them times stay dimensionless
/// Throws InputError.
std::optional<Units> read_units(const TomlTable& file);
void write_units(TomlText& toml, const std::optional<Units>& units);

/// Of E₀ = κ/κ̂ and T = μ_s R²/(μ̂ E₀) or γR⁴/(γ̂ E₀), with κ̂, μ̂ and γ̂ of the material as the model has it. Throws std::invalid_argument where it has no stiffness, or not the viscosity or the
/// friction that the units speak of.
Scales scales_of(const Units& units, const model::Material& material, model::Model model);

/// The radius alone: for what is read before the material. Empty without units.
std::optional<Scales> lengths_of(const std::optional<Units>& units);
/// The same as scales_of for the table [units] of an input: throws InputError there. Empty without units.
std::optional<Scales> read_scales(const TomlTable& file, const std::optional<Units>& units,
                                  const model::Material& material, model::Model model);

/// A line for each scale with its formula, for people: of R, E₀, T, and what else is measured by them. `where` ends those that
/// are not of lengths alone.
std::vector<std::string> text_of(const Units& units, const Scales& scales,
                                 std::string_view where = {});

}  // namespace sbeh::studies
