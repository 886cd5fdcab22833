// From each pass down both ways, to the states between which it lies.
#pragma once

#include "studies/io/growing_table.h"
#include "studies/rest_states/pass_row.h"

#include <vector>

namespace sbeh::studies {

using RestTable = GrowingTable<RestRow>;

/// Whether all states are there of which the passes are.
bool passes_begun(const OutputFolder& folder);

/// Goes from each state of the table that is `stationary` with one negative direction, along its mode, down both ways (descent.h), on by
/// Newton's method, and adds the ends that are not there to the table: the same state of the same material, volume and negative
/// directions, wherever it lies, is one. Not from ends, and what is of no branch: where another leaves, a fold, new triangles. Starts from
/// the frames in the folder; what passes.csv has is not done again. Returns its rows. Throws OutputError, and InputError where a frame is
/// damaged or not there.
std::vector<PassRow> cross_passes(const StatesInput& input, const OutputFolder& folder,
                                  RestTable& states);

}  // namespace sbeh::studies
