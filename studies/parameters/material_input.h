// The table [material], which all inputs share: the physics.
#pragma once

#include "model/material.h"
#include "studies/parameters/parameters.h"

namespace sbeh::studies {

/// The optional table [material]: keys as the parameters of model::Material, and
///   L = 0.05                              one-constant approximation, instead of L1, L2, L3
///   friction = 0.1                        instead of friction_tangential and friction_normal
///   landau_de_gennes = { a, b, c }        u(β) = (β²/8)(12a + 4bβ + 9cβ²), instead of potential
/// What the table does not say is as in `absent`. Viscosity and friction are refused for a model which has
/// its own; the result has their defaults. Throws InputError.
model::Material read_material(const TomlTable& table, model::Model model,
                              model::Material absent = {});

/// Whether the table says all that the model does not say itself: `absent` is then not asked for anything.
bool is_complete(const TomlTable& table, model::Model model);

/// The same for inputs that say L, which is L1 then, elsewhere: refuses L and L1; the result has the default L1, and is a
/// material with the least and the greatest `L`, ascending. `where` is what the refusal says.
model::Material read_material_without_L(
    const TomlTable& table, const std::vector<double>& L,
    std::string_view where = "a scan, where L comes from [scan]");

/// The coefficients, or landau_de_gennes. Throws InputError unless the potential is bounded below.
void read_value(const TomlTable& table, const char* key, model::Potential& potential);
/// Its highest power even, with a coefficient > 0, or a constant.
bool is_bounded_below(const model::Potential& potential);
/// { stiffness, W2 } or { stiffness, delta_a0 }.
void read_value(const TomlTable& table, const char* key, model::AreaDifference& of);
/// Coefficients of the powers of the order, one at least.
void read_value(const TomlTable& table, const char* key, model::Polynomial& polynomial);

/// Writes the table, without what the model says itself; the other form without L1 and what else is named.
void write_material(TomlText& toml, const model::Material& material, model::Model model);
void write_material_without_L(TomlText& toml, const model::Material& material,
                              ParameterNames without = {});

/// The parameters that matter only while something moves: states of rest do not depend on them.
inline const ParameterNames parameters_of_motion{"viscosity", "immobility", "friction_tangential",
                                                 "friction_normal", "order_viscosity"};

/// Those that a model may say itself: see has_own_drag.
inline const ParameterNames parameters_of_drag{"viscosity", "friction_tangential",
                                               "friction_normal"};

/// The models that have states of rest of their own: those of a scan.
inline constexpr std::array rest_models{model::Model::SBEH, model::Model::SSH};

/// Throws if one of the keys, which say something of the order, is there though the model has none.
void refuse_order(const TomlTable& table, model::Model model, const ParameterNames& keys);

}  // namespace sbeh::studies
