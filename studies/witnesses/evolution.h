// One evolution in 3D by methods that are independent of each other.
#pragma once

#include "studies/evolution/run_input.h"
#include "studies/witnesses/state.h"

#include <string>

namespace sbeh::studies {

/// Why harmonics do not follow this run; empty where they do: from harmonics or an ellipsoid, with the area of every piece kept
/// and an order that relaxes.
std::string no_harmonic_flow(const RunInput& run);

/// The 3D solver at the times of the run's rows. Throws InputError, std::invalid_argument (a start that does not exist) and
/// Interrupted.
WitnessState evolution_on_triangles(const RunInput& run);

/// The same, read from the folder of this run; a failure where it has not come to its end. Throws OutputError.
WitnessState evolution_of_folder(const RunInput& run, const std::string& folder);

/// Harmonics at the times of the run's rows, and once more with the degree less two, from which the remark says how far the
/// energies are. Only where no_harmonic_flow is empty. Throws std::invalid_argument (a start that does not exist) and Interrupted.
WitnessState evolution_by_harmonics(const RunInput& run, const HarmonicFlowMethod& method);

}  // namespace sbeh::studies
