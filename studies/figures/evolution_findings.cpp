// The findings of the evolution from the perturbed sphere: figures 3 and 4.
#include "studies/figures/findings.h"
#include "studies/figures/history.h"

#include <fmt/format.h>

#include <optional>

namespace sbeh::studies::figures {

namespace {

Agreement agrees(bool it_does) { return it_does ? Agreement::yes : Agreement::no; }

// In the first row of a model.
std::string text_of(const CsvTable& table, const char* model, const char* column) {
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (table.text(row, "model") == model) return table.text(row, column);
  return "";
}

// A number that is the same in all rows of a model that have it.
double number_of(const CsvTable& table, const char* model, const char* column) {
  for (std::size_t row = 0; row < table.rows.size(); ++row)
    if (const double value = table.number(row, column);
        table.text(row, "model") == model && std::isfinite(value))
      return value;
  return std::nan("");
}

// ---- figure 3 -----------------------------------------------------------------------------------

// How far a state is from the stationary oblate, whose two larger principal moments are equal.
struct LastState {
  double instant, time, energy, oblate, least, middle, largest;
  double above() const { return std::abs(energy / oblate - 1); }
  bool is_oblate() const { return above() < 1e-3 && largest / middle < middle / least; }
};

// Of the last of all instants, if the run has come so far.
std::optional<LastState> last_state(const CsvTable& evolution, const char* model) {
  std::optional<LastState> last;
  for (std::size_t row = 0; row < evolution.rows.size(); ++row) {
    const auto at = [&](const char* column) { return evolution.number(row, column); };
    if (evolution.text(row, "model") == model && (!last || at("instant") > last->instant))
      last = {at("instant"),  at("time"),     at("energy"),  at("energy_oblate"),
              at("moment_1"), at("moment_2"), at("moment_3")};
  }
  return last && std::isfinite(last->time) ? last : std::nullopt;
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

Finding who_is_lower(const History& sbeh, const History& ssh,
                     const std::string& residual_stiffness) {
  const double end = std::min(sbeh.end(), ssh.end());
  std::size_t worst = 0;
  const auto above = [&](std::size_t i) { return sbeh.value[i] - ssh.at(sbeh.time[i]); };
  for (std::size_t i = 0; i < sbeh.size(); ++i)
    if (sbeh.time[i] > 0 && sbeh.time[i] <= end && (worst == 0 || above(i) > above(worst)))
      worst = i;
  const double at_end = sbeh.at(end) - ssh.at(end);
  return {
      fmt::format(
          "U(SBEH, k0 = {}) − U(SSH): {:+.5f} at t = {:.4g}, where it is largest, {:+.5f} at t = "
          "{:.4g}",
          residual_stiffness, above(worst), sbeh.time[worst], at_end, end),
      "SBEH ends lower, but is not always lower on the way",
      agrees(above(worst) > 0 && at_end < 0)};
}

// W₂ is largest on the way from the threefold shape to the oblate; empty where a run ends before.
std::optional<double> time_of_change(const History& W2) {
  if (W2.empty()) return {};
  const std::size_t i = W2.largest(threefold_from, W2.end());
  if (i + 1 >= W2.size()) return {};
  return W2.time[i];
}

std::vector<Finding> changes(const std::optional<double>& sbeh, const std::optional<double>& ssh) {
  std::vector<Finding> findings;
  if (sbeh && ssh)
    findings.push_back(
        {fmt::format("the threefold shape is left (W2 is largest) at t = {:.3g} by SSH, at t = "
                     "{:.3g} by SBEH",
                     *ssh, *sbeh),
         "SSH leaves it earlier", agrees(*ssh < *sbeh)});
  if (sbeh)  // within a fifth
    findings.push_back({fmt::format("SBEH leaves it at t = {:.3g}", *sbeh), "between 2.4 and 2.6",
                        agrees(std::abs(*sbeh / 2.5 - 1) <= 0.2)});
  return findings;
}

// `change` is when the threefold shape is left; std, β̄ and W₂ have the same times.
Finding spread(const History& std_of_order, double change) {
  const auto at = [&](std::size_t i) {
    return fmt::format("{:.4f} at t = {:.3g}", std_of_order.value[i], std_of_order.time[i]);
  };
  const std::size_t last = std_of_order.size() - 1, top = std_of_order.largest(0, change),
                    low = std_of_order.smallest(change, std_of_order.end());
  const double before = std_of_order.at(change);
  const bool seen = low < last;
  const bool as_said = std_of_order.time[top] < change && before < std_of_order.value[top]
                    && std_of_order.value[low] < before
                    && std_of_order.last() > std_of_order.value[low];
  return {fmt::format(
              "standard deviation of the order: at first largest, {}; {:.4f} when the threefold "
              "shape is left; then {}{}",
              at(top), before, at(low), seen ? ", and at the end " + at(last) : ""),
          "rises up to the first change, has a lower plateau, falls with the next change and rises "
          "at the end",
          seen ? agrees(as_said) : Agreement::open};
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
    if (const auto s = last_state(evolution, model))
      findings.push_back(
          {fmt::format(
               "{} (k0 = {}) at t = {:.4g}: U = {:.6f}, that of the stationary oblate {:.6f}; "
               "principal moments {:.3f}, {:.3f}, {:.3f}",
               model, text_of(evolution, model, "residual_stiffness"), s->time, s->energy,
               s->oblate, s->least, s->middle, s->largest),
           "ends as an oblate", agrees(s->is_oblate())});
  const double sbeh = number_of(evolution, "SBEH", "energy_oblate_k0_0"),
               ssh = number_of(evolution, "SSH", "energy_oblate_k0_0");
  if (std::isfinite(sbeh) && std::isfinite(ssh))
    findings.push_back(
        {fmt::format("stationary oblates of this reduced volume with k0 = 0: U = {:.6f} "
                     "(SBEH), {:.6f} (SSH)",
                     sbeh, ssh),
         "SBEH ends with the lower energy", agrees(sbeh < ssh)});
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
  if (sbeh.size() > 1 && ssh.size() > 1)
    findings.push_back(who_is_lower(sbeh, ssh, text_of(measures, "SBEH", "residual_stiffness")));
  const auto change = time_of_change(of("SBEH", "W2"));
  for (const Finding& finding : changes(change, time_of_change(of("SSH", "W2"))))
    findings.push_back(finding);
  if (change) findings.push_back(spread(of("SBEH", "order_std"), *change));
  if (ssh.size() > 1) {
    const History none = of("SSH", "order_std");
    const double largest = none.value[none.largest(0, none.end())];
    findings.push_back({fmt::format("SSH: std of the order {:.1e} at most", largest), "zero",
                        agrees(largest < 1e-12)});
  }
  for (const char* model : {"SBEH", "SSH"})
    if (const std::string from = text_of(measures, model, "unresolved_from"); !from.empty())
      findings.push_back(
          {fmt::format("{}: the triangles do not resolve the surface from t = {} on; "
                       "numbers after that are not to be trusted",
                       model, from),
           "", Agreement::open});
  return findings;
}

}  // namespace sbeh::studies::figures
