// The findings of the evolution from the perturbed sphere: figures 3 and 4.
#include "studies/figures/figures.h"
#include "studies/figures/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace sbeh::studies::figures {

using model::Model;

namespace {

constexpr std::array models{Model::SBEH, Model::SSH};

template <class Row>
const Row* first_of(const std::vector<Row>& rows, Model model) {
  const auto at =
      std::find_if(rows.begin(), rows.end(), [&](const Row& row) { return row.model == model; });
  return at == rows.end() ? nullptr : &*at;
}

// Without residual stiffness; the same in all rows of the model that have it.
double energy_of_oblate(const std::vector<EvolutionRow>& evolution, Model model) {
  for (const EvolutionRow& row : evolution)
    if (row.model == model && row.nearest && std::isfinite(row.nearest->energy_oblate_k0_0))
      return row.nearest->energy_oblate_k0_0;
  return not_known;
}

// ---- figure 3 -----------------------------------------------------------------------------------

// The two larger principal moments of the stationary oblate are equal.
bool is_oblate(const EvolutionState& state) {
  const auto& [least, middle, largest] = state.moments;
  return std::abs(state.energy / state.energy_oblate - 1) < 1e-3
      && largest / middle < middle / least;
}

// Of the last of all instants.
const EvolutionRow* last_of(const std::vector<EvolutionRow>& evolution, Model model) {
  const EvolutionRow* last = nullptr;
  for (const EvolutionRow& row : evolution)
    if (row.model == model && (!last || row.instant > last->instant)) last = &row;
  return last;
}

// ---- figure 4 -----------------------------------------------------------------------------------

History history_of(const std::vector<MeasureRow>& measures, Model model,
                   double MeasureRow::*quantity) {
  History h;
  for (const MeasureRow& row : measures)
    if (row.model == model) {
      h.time.push_back(row.time);
      h.value.push_back(row.*quantity);
      h.ended = row.ended;
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

Finding who_is_lower(const History& sbeh, const History& ssh, double residual_stiffness) {
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
      sbeh.ended && ssh.ended ? agrees(above(worst) > 0 && at_end < 0) : Agreement::open};
}

// W₂ is largest on the way from the threefold shape to the oblate; empty where a run ends before, or may become larger yet.
std::optional<double> time_of_change(const History& W2) {
  if (W2.empty() || !W2.ended) return {};
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

// ---- what is missing ----------------------------------------------------------------------------

Finding not_there(Model model) {
  return {fmt::format("{}: its run is not there", name(model)), "", Agreement::open};
}

// Of a run without a frame at the last instant.
Finding not_so_far(Model model, double instant) {
  return {fmt::format("{}: no frame at t = {:.4g}: its run has not come so far, or has left none",
                      name(model), instant),
          "", Agreement::open};
}

Finding not_finished(Model model, double time) {
  return {
      fmt::format("{}: its run is not finished, it is at t = {:.4g}: what depends on its end is "
                  "not judged",
                  name(model), time),
      "", Agreement::open};
}

}  // namespace

std::vector<Finding> evolution_findings(const std::vector<EvolutionRow>& evolution) {
  std::vector<Finding> findings;
  if (!evolution.empty()) {
    const auto& first = evolution.front().nearest;
    const double v = first ? first->reduced_volume : not_known;
    findings.push_back(
        {fmt::format("reduced volume {:.4f}", v), "0.738", agrees(std::abs(v - 0.738) <= 0.0005)});
  }
  for (const Model model : models) {
    const EvolutionRow* row = last_of(evolution, model);
    if (!evolution.empty() && !row) findings.push_back(not_there(model));
    if (row && !row->nearest) findings.push_back(not_so_far(model, row->instant));
    if (row && row->nearest) {
      const EvolutionState& s = *row->nearest;
      findings.push_back(
          {fmt::format(
               "{} (k0 = {}) at t = {:.4g}: U = {:.6f}, that of the stationary oblate {:.6f}; "
               "principal moments {:.3f}, {:.3f}, {:.3f}",
               name(model), row->residual_stiffness, s.time, s.energy, s.energy_oblate,
               s.moments[0], s.moments[1], s.moments[2]),
           "ends as an oblate", agrees(is_oblate(s))});
    }
  }
  const double sbeh = energy_of_oblate(evolution, Model::SBEH),
               ssh = energy_of_oblate(evolution, Model::SSH);
  if (std::isfinite(sbeh) && std::isfinite(ssh))
    findings.push_back(
        {fmt::format("stationary oblates of this reduced volume with k0 = 0: U = {:.6f} "
                     "(SBEH), {:.6f} (SSH)",
                     sbeh, ssh),
         "SBEH ends with the lower energy", agrees(sbeh < ssh)});
  return findings;
}

std::vector<Finding> measures_findings(const std::vector<MeasureRow>& measures) {
  const auto of = [&](Model model, double MeasureRow::*quantity) {
    return history_of(measures, model, quantity);
  };
  const History sbeh = of(Model::SBEH, &MeasureRow::energy),
                ssh = of(Model::SSH, &MeasureRow::energy);
  std::vector<Finding> findings;
  for (const auto& [model, run] : {std::pair(Model::SBEH, &sbeh), std::pair(Model::SSH, &ssh)}) {
    if (!measures.empty() && run->empty()) findings.push_back(not_there(model));
    if (!run->ended) findings.push_back(not_finished(model, run->end()));
  }
  if (sbeh.size() > 1) findings.push_back(falling(sbeh, "SBEH"));
  if (ssh.size() > 1) findings.push_back(falling(ssh, "SSH"));
  if (sbeh.size() > 1 && ssh.size() > 1)
    findings.push_back(
        who_is_lower(sbeh, ssh, first_of(measures, Model::SBEH)->residual_stiffness));
  const auto change = time_of_change(of(Model::SBEH, &MeasureRow::W2));
  for (const Finding& finding : changes(change, time_of_change(of(Model::SSH, &MeasureRow::W2))))
    findings.push_back(finding);
  if (change) findings.push_back(spread(of(Model::SBEH, &MeasureRow::order_std), *change));
  if (ssh.size() > 1) {
    const History none = of(Model::SSH, &MeasureRow::order_std);
    const double largest = none.value[none.largest(0, none.end())];
    findings.push_back({fmt::format("SSH: std of the order {:.1e} at most", largest), "zero",
                        agrees(largest < 1e-12)});
  }
  for (const Model model : models)
    if (const MeasureRow* first = first_of(measures, model); first && first->unresolved_from)
      findings.push_back(
          {fmt::format("{}: the triangles do not resolve the surface from t = {} on; "
                       "numbers after that are not to be trusted",
                       name(model), *first->unresolved_from),
           "", Agreement::open});
  return findings;
}

}  // namespace sbeh::studies::figures
