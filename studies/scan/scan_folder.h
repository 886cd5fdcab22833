// The folder of a scan: what is there, and how a point is kept.
#pragma once

#include "studies/io/interrupt.h"
#include "studies/io/output.h"
#include "studies/io/part.h"
#include "studies/io/progress.h"
#include "studies/scan/branch_points.h"

#include <mutex>

namespace sbeh::studies {

/// A scan in its folder, or a part of it.
struct Scan {
  Scan(const ScanInput& of, const std::filesystem::path& path, std::string_view version,
       const Part& some = {});

  /// Whether the points of a reduced volume belong to its part.
  bool takes(double reduced_volume) const;
  bool has(const PointKey& key) { return row_of(key) != nullptr; }

  /// The row and state of a point that was finished before.
  std::optional<PointOutcome> finished(const PointKey& key);

  /// Keeps a point: its files first, so that a row means that they are whole.
  void keep(const PointKey& key, PointOutcome& point);

  /// Computes the point from its case and keeps it, unless it is there; gives it either way. Empty when
  /// interrupted.
  template <class Compute>
  std::optional<PointOutcome> point(const PointKey& key, Compute&& compute) {
    if (auto there = finished(key)) return there;
    if (interrupt_signal()) return {};
    PointOutcome outcome = compute(case_of(input, key));
    keep(key, outcome);
    return outcome;
  }
  /// The same, kept only where it belongs to the part.
  template <class Compute>
  std::optional<PointOutcome> passed(const PointKey& key, Compute&& compute) {
    if (takes(key.reduced_volume)) return point(key, compute);
    if (interrupt_signal()) return {};
    return compute(case_of(input, key));
  }

  const ScanInput& input;
  const Part part;
  const OutputFolder folder;
  ScanTable table;
  std::mutex mutex;  ///< of the table; before progress, whose start asks for rows
  Progress progress;
  int computed = 0;

 private:
  const OutputFolder& prepare(std::string_view version) const;
  Progress begun(std::string_view version);
  void take_parts(std::string_view version);
  const PointResult* row_of(const PointKey& key);
};

}  // namespace sbeh::studies
