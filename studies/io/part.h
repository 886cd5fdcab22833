// One of several equal parts of some work.
#pragma once

namespace sbeh::studies {

struct Part {
  int part = 1, parts = 1;  ///< 1 ≤ part ≤ parts

  /// Whether the piece of this number, 1 …, belongs to it: every `parts`-th does.
  bool has(int number) const { return (number - part) % parts == 0; }
};

}  // namespace sbeh::studies
