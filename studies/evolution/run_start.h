// The first state of a 3D run.
#pragma once

#include "studies/evolution/run_input.h"
#include "surface3d/flow.h"

namespace sbeh::studies {

struct RunStart {
  meshing::CurvedMesh mesh;  ///< order 3, area 4π
  surface3d::Field beta;     // nodes
  surface3d::Target target;  ///< its own area and volume
};

/// Makes the surface that the input asks for. Throws InputError (a mesh or frame that is not what it
/// should be), OutputError (files that cannot be read) and std::invalid_argument (a shape that does not
/// exist, a perturbation too large for it).
RunStart start_of(const RunInput& input);

/// Displaces the nodes along the normals by Σ a_lm Y_lm of their directions from the centre. Throws
/// std::invalid_argument where that is too large for the surface.
void perturb(meshing::CurvedMesh& mesh, const std::vector<meshing::Harmonic>& modes);

}  // namespace sbeh::studies
