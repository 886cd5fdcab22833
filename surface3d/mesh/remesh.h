// New triangles for a surface that has evolved.
#pragma once

#include "meshing/point_group.h"
#include "model/material.h"
#include "surface3d/surface.h"

#include <memory>
#include <string>

namespace sbeh::surface3d {

struct RemeshOptions {
  int triangles = 0;  ///< about so many, 20 … 200000; 0: as many as there are
  double grading = 1;  ///< 0 … 10: sides ∝ 1/(1 + grading R|B|/√2), R = √(A/4π); 0: all the same
  /// Largest change of the energy, relative to the elastic one, 0 … 1; see README.md for what is usual.
  double largest_energy_change = 1e-2;
  /// That old triangles and state have about the origin, and new ones are to have.
  meshing::PointGroup symmetry = {};

  /// Throws std::invalid_argument with name, value and constraint.
  void validate() const;
};

/// What became of the surface.
struct RemeshReport {
  int triangles_before = 0, triangles_after = 0;
  double min_angle_before = 0, min_angle_after = 0;  ///< degrees, of the plain triangles
  double quality_before = 0, quality_after = 0;      ///< see mesh_quality
  double energy_before = 0, energy_after = 0;        ///< U
  double energy_change = 0;  ///< (after − before)/(distortion + bending before)
  double area_change = 0;    ///< relative, as it was before area and volume were restored
  double volume_change = 0;  ///< the same
  double distance = 0;       ///< largest one from the old surface, in units of R = √(A/4π)
};

/// The new surface, or why there is none.
struct RemeshResult {
  std::shared_ptr<const Triangulation> mesh;  ///< empty when refused
  State state;                                ///< empty when refused
  std::string refusal;                        ///< a sentence; empty when there is a mesh
  RemeshReport report;                        ///< as far as it came
};

/// Triangles with sides by curvature. Their nodes lie on the curved triangles of the old surface, β is
/// the old field there, within its old range; then correct_area_volume restores area and volume to
/// 1e-12 (of a sphere the area alone).
/// Refused is a mesh that is no sphere, that intersects itself, that changes the energy beyond the
/// bound; and one with angles below 25° or a quality below 0.4 if they were better before. The result
/// depends on nothing but the input, to the last bit. Throws as RemeshOptions::validate,
/// and std::invalid_argument where the old mesh has not the symmetry.
RemeshResult remesh(const Triangulation& mesh, const State& state, const model::Material& material,
                    const RemeshOptions& options = {});

}  // namespace sbeh::surface3d
