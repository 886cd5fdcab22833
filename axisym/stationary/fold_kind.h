// What gives way where a branch of ordered shapes ends in a fold as L grows.
#pragma once

#include "axisym/curve.h"
#include "model/material.h"
#include "model/names.h"

#include <optional>

namespace sbeh::axisym {

/// Where the order changes most in the direction in which the energy is flat: at the ring that is farthest from the axis, at a
/// pole, or at a ring between that is nearer to the axis than those beside it; or, if that is where it is rather large and more
/// than half of the surface takes part, on the whole of it.
enum class FoldKind { rim, pole, neck, whole };
constexpr auto names(FoldKind) { return std::array{"rim", "pole", "neck", "whole"}; }

/// Of a state of SBEH at a fold along L, in a material but for L. Empty where the linear system cannot be solved.
std::optional<FoldKind> fold_kind(const model::Material& material, double L,
                                  const StationaryState& state);

}  // namespace sbeh::axisym
