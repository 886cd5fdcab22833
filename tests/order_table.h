// Observed orders of convergence.
#pragma once

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace sbeh::test {

/// Errors under refinement, printed as a table with the order observed from row to row.
class OrderTable {
 public:
  OrderTable(std::string quantity, std::string step_name)
      : quantity_(std::move(quantity)), step_name_(std::move(step_name)) {}

  void add(double step, double error) { rows_.push_back({step, std::abs(error)}); }

  /// Orders between successive rows: log(error ratio)/log(step ratio).
  std::vector<double> orders() const {
    std::vector<double> p;
    for (std::size_t k = 1; k < rows_.size(); ++k)
      p.push_back(std::log(rows_[k - 1].error / rows_[k].error)
                  / std::log(rows_[k - 1].step / rows_[k].step));
    return p;
  }
  /// The order of the last refinement, after printing the table.
  double print() const {
    std::printf("%s\n  %-12s %-12s order\n", quantity_.c_str(), step_name_.c_str(), "error");
    const auto p = orders();
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      std::printf("  %-12.5g %-12.3e", rows_[k].step, rows_[k].error);
      if (k > 0) std::printf(" %.2f", p[k - 1]);
      std::printf("\n");
    }
    return p.empty() ? std::numeric_limits<double>::quiet_NaN() : p.back();
  }

 private:
  struct Row {
    double step, error;
  };
  std::string quantity_, step_name_;
  std::vector<Row> rows_;
};

}  // namespace sbeh::test
