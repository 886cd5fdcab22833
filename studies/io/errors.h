// What is wrong with what a user gave, or with the place for results; and that the user wants to stop.
#pragma once

#include <stdexcept>

namespace sbeh::studies {

/// Wrong input. what() says where, what, and what is allowed: `file:line: [section] key = value: must be …`.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The results cannot be read or written: folder, file, reason, what to do.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A signal came while something was at work that keeps nothing.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace sbeh::studies
