// stability.csv: a row per perturbed state, in the columns that users and pictures rely on.
#pragma once

#include "studies/io/growing_table.h"
#include "studies/stability/stability_run.h"

namespace sbeh::studies {

const Columns<StabilityResult>& stability_columns();

/// stability.csv of a folder. Throws OutputError when the file is no such table.
using StabilityTable = GrowingTable<StabilityResult>;
StabilityTable stability_table(const OutputFolder& folder);

/// Of the history of a run.
const Columns<PerturbedAt>& perturbed_columns();

}  // namespace sbeh::studies
