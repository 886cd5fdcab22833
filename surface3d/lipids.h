// A membrane whose lipids have another area when they are ordered: n dS is what its pieces keep.
#pragma once

#include "surface3d/curvature.h"
#include "surface3d/dissipation.h"

namespace sbeh::surface3d {

/// The area that the lipids have at full order, ∫ n/n(2/3) dS, and the volume; area and volume where all orders have the same area.
Target lipids_and_volume(const Triangulation& mesh, const model::Material& material,
                         const State& state);

/// correct_area_volume for that area; H: curvature of the surface.
bool correct_lipids_volume(const Triangulation& mesh, const model::Material& material,
                           const Field& H, const Target& target, State& state);

/// (n'/n(2/3) β̇, q) for the P2 functions q of the pressure, with n of `at`: what (P1) has of the order. P2 nodes.
Field lipid_load(const Triangulation& mesh, const model::Material& material, const State& at,
                 const Motion& motion);

}  // namespace sbeh::surface3d
