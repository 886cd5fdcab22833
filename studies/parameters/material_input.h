// The tables that all inputs share: [material], the physics, and [numerics], the discretisation.
#pragma once

#include "axisym/options.h"
#include "model/material.h"
#include "studies/io/toml_reader.h"
#include "surface3d/options.h"

namespace sbeh::studies {

/// The optional table [material]: keys as the members of model::Material, and
///   L = 0.05                              one-constant approximation, instead of L1, L2, L3
///   friction = 0.1                        instead of friction_tangential and friction_normal
///   potential = [c0, c1, …]               u(β) = Σ c_k β^k, bounded below
///   landau_de_gennes = { a, b, c }        u(β) = (β²/8)(12a + 4bβ + 9cβ²), instead of potential
/// What the table does not say is as in `absent`. Refuses viscosity and friction for a model which has
/// its own. Throws InputError.
model::Material read_material(const TomlTable& table, model::Model model,
                              model::Material absent = {});

/// The same for inputs that say L elsewhere: refuses L, L1, L2, L3; the result has their defaults. `where`
/// is what the refusal says.
model::Material read_material_without_L(
    const TomlTable& table, std::string_view where = "a scan, where L comes from [scan]");

/// The optional table [numerics]: keys as the members of axisym::Numerics. Throws InputError.
axisym::Numerics read_numerics(const TomlTable& table);

/// The same for a 3D run: keys as the members of surface3d::Numerics.
surface3d::Numerics read_numerics_3d(const TomlTable& table);

/// The names of all models, and of those that a scan has.
const std::vector<std::string>& model_words();
const std::vector<std::string>& scan_model_words();

/// The model of that name, one of model_words().
model::Model model_of(const std::string& word);

/// Throws if one of the keys, which say something of the order, is there though the model has none.
void refuse_order(const TomlTable& table, model::Model model, const std::vector<std::string>& keys);

}  // namespace sbeh::studies
