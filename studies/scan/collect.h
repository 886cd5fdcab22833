// Rows that are found independently of each other.
#pragma once

#include "studies/io/interrupt.h"

#include <tbb/parallel_for.h>

#include <vector>

namespace sbeh::studies {

/// Runs find(k) for every k in parallel; the rows in the order of k. Incomplete when interrupted.
template <class Row, class Find>
std::vector<Row> collect(std::size_t count, Find&& find) {
  std::vector<std::vector<Row>> found(count);
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t k) {
    if (!interrupt_signal()) found[k] = find(k);
  });
  std::vector<Row> rows;
  for (const auto& some : found) rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

}  // namespace sbeh::studies
