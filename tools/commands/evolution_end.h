// How an evolution ended, and what was wrong with it, for the user: of `sbeh relax` and `sbeh run`.
#pragma once

#include "model/time/flow_record.h"

#include <string_view>

namespace sbeh::tools {

/// What a solver has to say of two ends that are its own.
struct EndWords {
  std::string_view unresolved, self_contact;
};

/// Prints why, when and with what energy it ended, and of one that came to its end time how fast it moved then,
/// where that is not below `at_rest`.
void print_end(model::FlowStop stop, const model::FlowRecord& last, int steps, double at_rest);

/// Complains of what went wrong: of an end that is none, and of an energy that rose. Whether anything did.
bool complain_of_end(model::FlowStop stop, model::FlowFault fault, const model::FlowRecord& last,
                     const EndWords& words);

}  // namespace sbeh::tools
