// The first state of a 3D run, and what the run costs.
#pragma once

#include "meshing/revolution.h"
#include "studies/evolution/frame_file.h"
#include "studies/evolution/run_input.h"
#include "studies/modes/mode_file.h"

#include <string>
#include <vector>

namespace sbeh::studies {

struct RunStart {
  FlowMoment moment;
  std::vector<std::string> remarks;  ///< what is not as it was where the start comes from
};

/// Makes the surface that the input asks for: order 3, area 4π, its own area and volume as target. Throws
/// InputError (a mesh or frame that is not what it should be), OutputError (files that cannot be read) and
/// std::invalid_argument (a shape that does not exist, a perturbation too large for it).
RunStart start_of(const RunInput& input);

/// Displaces the nodes along the normals by Σ a_lm Y_lm of their directions from the centre. Throws
/// std::invalid_argument where that is too large for the surface.
void perturb(meshing::CurvedMesh& mesh, const std::vector<meshing::Harmonic>& modes);

/// The state revolved and displaced by `amplitude` times a mode, its order with it. Throws std::invalid_argument where
/// that takes the order out of its range, or folds the surface.
meshing::RevolvedMesh displaced(const StateMode& mode, double amplitude,
                                const meshing::Resolution& resolution);

/// Seconds and MB as measured with the defaults on one core of 2026; good to a factor of two.
struct RunCost {
  int unknowns;  ///< of the linear system of the flow: V, p, H, and with Y where monolithic
  double seconds_per_step;  ///< of one core
  double megabytes;
  double frame_megabytes;  ///< of one file
};

/// Of a run on a surface with so many triangles (V − E + F = 2).
RunCost cost_of(const RunInput& input, int triangles);

}  // namespace sbeh::studies
