// The findings of the evolution from the perturbed sphere: figures 3 and 4.
#include "studies/figures/findings.h"
#include "studies/figures/history.h"

#include <fmt/format.h>

#include <optional>

namespace sbeh::studies::figures {

namespace {

Agreement agrees(bool it_does) { return it_does ? Agreement::yes : Agreement::no; }

// ---- figure 3 -----------------------------------------------------------------------------------

struct Moments {
  double time, least, middle, largest;
  // Two equal moments and a smaller one.
  bool oblate() const { return largest < 1.02 * middle && least < 0.9 * middle; }
};

std::optional<Moments> last_moments(const CsvTable& evolution, const char* model) {
  for (std::size_t row = evolution.rows.size(); row-- > 0;)
    if (evolution.text(row, "model") == model)
      return Moments{evolution.number(row, "time"), evolution.number(row, "moment_1"),
                     evolution.number(row, "moment_2"), evolution.number(row, "moment_3")};
  return {};
}

// ---- figure 4 -----------------------------------------------------------------------------------

History history_of(const CsvTable& measures, const char* model, const char* column) {
  History h;
  for (std::size_t row = 0; row < measures.rows.size(); ++row)
    if (measures.text(row, "model") == model) {
      h.time.push_back(measures.number(row, "time"));
      h.value.push_back(measures.number(row, column));
    }
  return h;
}

std::string residual_stiffness_of(const CsvTable& table, const char* model) {
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (table.text(row, "model") == model) return table.text(row, "residual_stiffness");
  return "";
}

Finding falling(const History& energy, const char* model) {
  constexpr double rounding = 1e-12;
  const double rise = energy.largest_rise();
  const bool falls = rise <= rounding * std::abs(energy.last());
  return {
      falls ? fmt::format("{}: the energy falls from {:.6f} to {:.6f} at t = {:.4g}", model,
                          energy.value.front(), energy.last(), energy.end())
            : fmt::format("{}: the energy rises by {:.1e} from one time to the next", model, rise),
      "the energy decreases over time", agrees(falls)};
}

// From here on the first, violent change is over and the shape is threefold.
constexpr double threefold_from = 0.6;

Finding who_is_lower(const History& sbeh, const History& ssh) {
  const double end = std::min(sbeh.end(), ssh.end());
  std::size_t worst = 0;
  const auto above = [&](std::size_t i) { return sbeh.value[i] - ssh.at(sbeh.time[i]); };
  for (std::size_t i = 0; i < sbeh.size(); ++i)
    if (sbeh.time[i] > 0 && sbeh.time[i] <= end && (worst == 0 || above(i) > above(worst)))
      worst = i;
  const double at_end = sbeh.at(end) - ssh.at(end);
  return {
      fmt::format("U(SBEH) − U(SSH): {:+.5f} at t = {:.4g}, where it is largest, {:+.5f} at t = "
                  "{:.4g}",
                  above(worst), sbeh.time[worst], at_end, end),
      "SBEH ends lower, but is not always lower on the way",
      agrees(above(worst) > 0 && at_end < 0)};
}

// W₂ is largest on the way from the threefold shape to the oblate.
Finding who_is_earlier(const History& sbeh, const History& ssh) {
  const auto time = [](const History& h) {
    const std::size_t i = h.largest(threefold_from, h.end());
    return i < h.size() ? h.time[i] : std::nan("");
  };
  const double late = time(sbeh), early = time(ssh);
  const bool seen = late < 0.99 * sbeh.end() && early < 0.99 * ssh.end();
  return {fmt::format("the threefold shape is left, by the largest W2 after t = {}, at t = {:.4g} "
                      "(SSH) and {:.4g} (SBEH){}",
                      threefold_from, early, late, seen ? "" : ", where a run ends"),
          "SSH changes its shape earlier; SBEH is threefold from about 0.6 to 2.4",
          seen ? agrees(early < late) : Agreement::open};
}

Finding spread(const History& std_of_order) {
  const std::size_t top = std_of_order.largest(0, std_of_order.end());
  const std::size_t low = std_of_order.smallest(std_of_order.time[top], std_of_order.end());
  const bool rises_again = std_of_order.last() > 1.01 * std_of_order.value[low];
  return {fmt::format("std of the order: {:.4f} at t = {:.3g} (largest), {:.4f} at 1, {:.4f} at 2, "
                      "{:.4f} at {:.3g} (smallest later), {:.4f} at {:.4g}",
                      std_of_order.value[top], std_of_order.time[top], std_of_order.at(1),
                      std_of_order.at(2), std_of_order.value[low], std_of_order.time[low],
                      std_of_order.last(), std_of_order.end()),
          "rises up to the first change, then a lower plateau, falls with the next change, and "
          "rises at the end",
          agrees(rises_again && std_of_order.at(1) < std_of_order.value[top])};
}

}  // namespace

std::vector<Finding> evolution_findings(const CsvTable& evolution) {
  std::vector<Finding> findings;
  if (!evolution.rows.empty()) {
    const double v = evolution.number(0, "reduced_volume");
    findings.push_back(
        {fmt::format("reduced volume {:.4f}", v), "0.738", agrees(std::abs(v - 0.738) <= 0.0005)});
  }
  for (const char* model : {"SBEH", "SSH"})
    if (const auto m = last_moments(evolution, model))
      findings.push_back(
          {fmt::format("{} (k0 = {}) at t = {:.4g}: principal moments {:.3f}, {:.3f}, {:.3f}: {}",
                       model, residual_stiffness_of(evolution, model), m->time, m->least, m->middle,
                       m->largest, m->oblate() ? "an oblate" : "not an oblate, or not yet"),
           "ends as an oblate", agrees(m->oblate())});
  return findings;
}

std::vector<Finding> measures_findings(const CsvTable& measures) {
  const auto of = [&](const char* model, const char* column) {
    return history_of(measures, model, column);
  };
  const History sbeh = of("SBEH", "energy"), ssh = of("SSH", "energy");
  std::vector<Finding> findings;
  if (sbeh.size() > 1) findings.push_back(falling(sbeh, "SBEH"));
  if (ssh.size() > 1) findings.push_back(falling(ssh, "SSH"));
  if (sbeh.size() > 1 && ssh.size() > 1) {
    findings.push_back(who_is_lower(sbeh, ssh));
    findings.push_back(who_is_earlier(of("SBEH", "W2"), of("SSH", "W2")));
  }
  if (sbeh.size() > 1) findings.push_back(spread(of("SBEH", "order_std")));
  if (ssh.size() > 1) {
    const History none = of("SSH", "order_std");
    const double largest = none.value[none.largest(0, none.end())];
    findings.push_back({fmt::format("SSH: std of the order {:.1e} at most", largest), "zero",
                        agrees(largest < 1e-12)});
  }
  return findings;
}

}  // namespace sbeh::studies::figures
