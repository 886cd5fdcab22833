// The paper's figures: which runs they need, and what is found in their tables.
#include "studies/figures/figures.h"

#include "studies/figures/history.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace sbeh::studies::figures {
namespace {

using model::Model;

// ---- plan ---------------------------------------------------------------------------------------

TEST(FiguresPlan, knows_figures_by_name_and_by_number) {
  for (const Figure figure : values_of(Figure{})) {
    EXPECT_EQ(figure_of(name(figure)), figure);
    EXPECT_EQ(figure_of(std::to_string(number(figure))), figure);
  }
  EXPECT_FALSE(figure_of("0"));
  EXPECT_FALSE(figure_of("shape"));
}

TEST(FiguresPlan, has_a_run_of_its_own_parameters_for_every_stationary_shape) {
  const Inputs inputs = read_inputs("studies/inputs", 320);
  const auto runs = runs_for(Figure::shapes, inputs);
  ASSERT_EQ(runs.size(), inputs.oblates.reduced_volume.size() * inputs.oblates.L.size());
  std::set<std::string> folders;
  std::size_t k = 0;
  for (const double v : inputs.oblates.reduced_volume)
    for (const double L : inputs.oblates.L) {
      const PlannedRun& run = runs[k++];
      folders.insert(run.folder);
      EXPECT_EQ(run.folder, fmt::format("oblates_3d/SBEH_v{}_L{}", v, L));
      EXPECT_EQ(std::get<Ellipsoid>(run.input.start).reduced_volume, v);
      EXPECT_EQ(run.input.material.L1, L);
      EXPECT_EQ(run.input.triangles, 320);
    }
  EXPECT_EQ(folders.size(), runs.size());
}

TEST(FiguresPlan, has_both_models_where_they_are_compared) {
  const Inputs inputs = read_inputs("studies/inputs", {});
  for (const Figure figure : {Figure::energy, Figure::evolution, Figure::measures}) {
    int sbeh = 0, ssh = 0;
    for (const PlannedRun& run : runs_for(figure, inputs))
      ++(run.input.model == Model::SBEH ? sbeh : ssh);
    EXPECT_GT(sbeh, 0);
    EXPECT_EQ(sbeh, ssh);
  }
}

// The picture shows frames near its instants.
TEST(FiguresPlan, has_inputs_with_frames_at_the_instants_of_the_evolution) {
  const Inputs inputs = read_inputs("studies/inputs", {});
  for (const RunInput* input : {&inputs.sbeh, &inputs.ssh})
    for (const double instant : instants)
      EXPECT_NE(std::find(input->times.states.begin(), input->times.states.end(), instant),
                input->times.states.end())
          << instant;
}

// ---- histories ----------------------------------------------------------------------------------

TEST(FiguresHistory, is_linear_between_its_times_and_constant_beyond) {
  const History h{{0, 1, 3}, {2, 4, 0}};
  EXPECT_EQ(h.at(-1), 2);
  EXPECT_EQ(h.at(0.5), 3);
  EXPECT_EQ(h.at(2), 2);
  EXPECT_EQ(h.at(5), 0);
  EXPECT_EQ(h.largest_rise(), 2);
  EXPECT_EQ(h.largest(0, 3), 1u);
  EXPECT_EQ(h.smallest(0, 1), 0u);
  EXPECT_EQ(h.largest(4, 5), h.size());
}

// ---- findings -----------------------------------------------------------------------------------

// The agreement of the finding about what the paper says so, whose result begins so; fails when there is
// none.
Agreement about(const std::vector<Finding>& findings, const std::string& paper,
                const std::string& result = "") {
  for (const Finding& finding : findings)
    if (finding.paper.find(paper) != std::string::npos && finding.result.starts_with(result))
      return finding.agreement;
  ADD_FAILURE() << "no finding about: " << paper;
  return Agreement::open;
}

// Two points of each model whose energies fall to rest; `gaps` U(SSH) − U(SBEH) for L = 0.01, 0.02.
std::vector<EnergyRow> energies(const std::array<double, 2>& gaps, double bump = 0) {
  std::vector<EnergyRow> rows;
  for (const int k : {0, 1})
    for (const Model model : {Model::SBEH, Model::SSH})
      for (const double t : {0., 1., 2., 3.}) {
        const double gap = model == Model::SBEH ? gaps[std::size_t(k)] * t / 3 : 0;
        rows.push_back({.solver = Solver::axisymmetric,
                        .model = model,
                        .reduced_volume = 0.6,
                        .L = k == 0 ? 0.01 : 0.02,
                        .triangles = {},
                        .at_rest = true,
                        .time = t,
                        .energy = -8 - t - gap + (t == 2 ? bump : 0)});
      }
  return rows;
}

TEST(FiguresFindings, see_whether_energies_fall) {
  EXPECT_EQ(about(energy_findings(energies({0.1, 0.2})), "energies fall"), Agreement::yes);
  EXPECT_EQ(about(energy_findings(energies({0.1, 0.2}, 1.5)), "energies fall"), Agreement::no);
}

TEST(FiguresFindings, see_which_model_has_the_lower_energy_and_how_the_gap_grows) {
  const auto lower = [](const std::array<double, 2>& gaps) {
    return about(energy_findings(energies(gaps)), "lower energy");
  };
  const auto grows = [](const std::array<double, 2>& gaps) {
    return about(energy_findings(energies(gaps)), "gap widens");
  };
  EXPECT_EQ(lower({0.1, 0.2}), Agreement::yes);
  EXPECT_EQ(lower({0.1, -0.2}), Agreement::no);
  EXPECT_EQ(grows({0.1, 0.2}), Agreement::yes);
  EXPECT_EQ(grows({0.2, 0.1}), Agreement::no);
}

TEST(FiguresFindings, measure_how_far_3d_is_from_axisymmetric) {
  std::vector<EnergyRow> rows = energies({0.1, 0.2});
  const auto add = [&](Model model, std::optional<bool> at_rest, double time, double energy) {
    rows.push_back({Solver::in_3d, model, 0.6, 0.01, 320, at_rest, time, energy});
  };
  add(Model::SSH, true, 0, -8);
  add(Model::SSH, true, 3, -11.0011);
  const auto findings = energy_findings(rows);
  EXPECT_NE(findings.back().result.find("1.0e-04"), std::string::npos) << findings.back().result;
  EXPECT_EQ(findings.back().agreement, Agreement::open);
  EXPECT_EQ(about(findings, "stationary", "3D"), Agreement::yes);
  add(Model::SBEH, {}, 3, -9);  // has not ended
  EXPECT_EQ(about(energy_findings(rows), "stationary", "3D"), Agreement::yes);
  EXPECT_EQ(energy_findings(rows).back().result, findings.back().result);
  rows.back().at_rest = false;
  EXPECT_EQ(about(energy_findings(rows), "stationary", "3D"), Agreement::no);
}

std::vector<ShapeRow> shapes(double order_at_larger_L, double radius) {
  const auto row = [](double L, double order, double order_radius, double from_ssh, double ssh) {
    return ShapeRow{.reduced_volume = 0.6,
                    .L = L,
                    .energy = 0,
                    .energy_SSH = 0,
                    .order_min = order,
                    .order_max = 0,
                    .H_abs_max = 0,
                    .order_min_radius = order_radius,
                    .distance_from_SSH = from_ssh,
                    .SSH_distance = ssh,
                    .in_3d = {}};
  };
  return {row(0.01, 0.6, 1, 0.01, 0), row(0.02, order_at_larger_L, radius, 0.02, 1e-8)};
}

TEST(FiguresFindings, see_where_and_how_the_order_falls) {
  EXPECT_EQ(about(shapes_findings(shapes(0.5, 1)), "order falls"), Agreement::yes);
  EXPECT_EQ(about(shapes_findings(shapes(0.61, 1)), "order falls"), Agreement::no);
  EXPECT_EQ(about(shapes_findings(shapes(0.5, 1)), "at the rim"), Agreement::yes);
  EXPECT_EQ(about(shapes_findings(shapes(0.5, 0.3)), "at the rim"), Agreement::no);
  EXPECT_EQ(about(shapes_findings(shapes(0.5, 1)), "same for all L"), Agreement::yes);
}

EvolutionState state_at(double time, double energy, const std::array<double, 3>& moments) {
  return {.time = time,
          .energy = energy,
          .energy_oblate = -9.8,
          .energy_oblate_k0_0 = -9.8,
          .reduced_volume = 0.7376,
          .order_min = 0,
          .order_max = 0,
          .H_abs_max = 0,
          .moments = moments,
          .frame = ""};
}

std::vector<EvolutionRow> evolution(double energy, double largest_moment) {
  return {{Model::SSH, 0, 0, state_at(0, -3, {0.3, 0.3, 0.4})},
          {Model::SSH, 0, 10, state_at(10, energy, {0.1, 0.45, largest_moment})}};
}

TEST(FiguresFindings, tell_an_oblate_by_its_energy_and_its_moments) {
  const auto is_oblate = [](double energy, double moment) {
    return about(evolution_findings(evolution(energy, moment)), "ends as an oblate");
  };
  EXPECT_EQ(is_oblate(-9.7999, 0.46), Agreement::yes);
  EXPECT_EQ(is_oblate(-8.4, 0.46), Agreement::no);  // the threefold shape
  EXPECT_EQ(is_oblate(-9.7999, 2.5),
            Agreement::no);  // longer in one direction than flat in another
  EXPECT_EQ(about(evolution_findings(evolution(-9.8, 0.46)), "0.738"), Agreement::yes);
}

TEST(FiguresFindings, do_not_judge_a_run_that_has_not_come_so_far) {
  std::vector<EvolutionRow> rows = evolution(-9.8, 0.46);
  rows.back().nearest.reset();
  for (const Finding& finding : evolution_findings(rows))
    EXPECT_NE(finding.paper, "ends as an oblate");
}

// W₂ rises to its largest value at `change`, energies fall, SSH's faster on the way.
std::vector<MeasureRow> measures(double sbeh_change, double ssh_change, double end) {
  std::vector<MeasureRow> rows;
  for (const bool sbeh : {true, false})
    for (double t = 0; t <= end; t += 0.1) {
      const double change = sbeh ? sbeh_change : ssh_change;
      const double energy = -8 - std::tanh(2 * (t - change)) - (sbeh && t > 3.9 ? 0.2 : 0);
      const double std = t < 0.8        ? 1.1 * t
                       : t < change     ? 0.7
                       : t < change + 1 ? 0.4 - 0.1 * (t - change)
                                        : 0.5;
      rows.push_back({.model = sbeh ? Model::SBEH : Model::SSH,
                      .residual_stiffness = sbeh ? 0.004 : 0,
                      .unresolved_from = sbeh ? std::optional(0.5) : std::nullopt,
                      .time = t,
                      .energy = energy,
                      .W2 = -26 - std::abs(t - change),
                      .order_std = sbeh ? std : 0,
                      .order_variance = 0,
                      .reduced_volume = 0.7376});
    }
  return rows;
}

TEST(FiguresFindings, see_who_leaves_the_threefold_shape_earlier_and_when) {
  EXPECT_EQ(about(measures_findings(measures(2.5, 1.5, 5)), "SSH leaves it earlier"),
            Agreement::yes);
  EXPECT_EQ(about(measures_findings(measures(1.5, 2.5, 5)), "SSH leaves it earlier"),
            Agreement::no);
  EXPECT_EQ(about(measures_findings(measures(2.5, 1.5, 5)), "2.4 and 2.6"), Agreement::yes);
  EXPECT_EQ(about(measures_findings(measures(1.5, 1, 5)), "2.4 and 2.6"), Agreement::no);
  for (const Finding& finding : measures_findings(measures(2.5, 1.5, 2)))
    EXPECT_NE(finding.paper, "SSH leaves it earlier") << finding.result;
}

TEST(FiguresFindings, see_the_energies_cross_and_the_spread_of_the_order_come_back) {
  const auto findings = measures_findings(measures(2.5, 1.5, 5));
  EXPECT_EQ(about(findings, "ends lower"), Agreement::yes);
  EXPECT_EQ(about(measures_findings(measures(1, 2.5, 3)), "ends lower"), Agreement::no);
  EXPECT_EQ(about(findings, "lower plateau"), Agreement::yes);
  EXPECT_EQ(about(measures_findings(measures(2.5, 1.5, 3)), "lower plateau"), Agreement::open);
  EXPECT_NE(findings.back().result.find("from t = 0.5 on"), std::string::npos);
}

// What of a run that has not ended looks like its last change, need not be it.
TEST(FiguresFindings, name_a_run_that_is_not_finished_and_do_not_judge_its_end) {
  std::vector<MeasureRow> rows = measures(2.5, 1.5, 5);
  for (MeasureRow& row : rows) row.ended = row.model != Model::SBEH;
  const auto findings = measures_findings(rows);
  EXPECT_TRUE(findings.front().result.starts_with("SBEH: its run is not finished, it is at t = 5"))
      << findings.front().result;
  EXPECT_EQ(about(findings, "ends lower"), Agreement::open);
  EXPECT_EQ(about(findings, "energy decreases"), Agreement::yes);
  for (const char* judged : {"SSH leaves it earlier", "2.4 and 2.6", "lower plateau"})
    for (const Finding& finding : findings)
      EXPECT_EQ(finding.paper.find(judged), std::string::npos) << finding.result;
}

TEST(FiguresFindings, name_a_run_that_is_not_there_or_has_not_come_so_far) {
  std::vector<MeasureRow> rows = measures(2.5, 1.5, 5);
  std::erase_if(rows, [](const MeasureRow& row) { return row.model == Model::SSH; });
  EXPECT_EQ(measures_findings(rows).front().result, "SSH: its run is not there");
  std::vector<EvolutionRow> shapes = evolution(-9.8, 0.46);
  shapes.back().nearest.reset();
  const auto findings = evolution_findings(shapes);
  EXPECT_EQ(about(findings, "", "SBEH: its run is not there"), Agreement::open);
  EXPECT_EQ(about(findings, "", "SSH: no frame at t = 10"), Agreement::open);
}

TEST(FiguresFindings, are_none_without_rows) {
  EXPECT_TRUE(energy_findings({}).empty());
  EXPECT_TRUE(shapes_findings({}).empty());
  EXPECT_TRUE(evolution_findings({}).empty());
  EXPECT_TRUE(measures_findings({}).empty());
}

}  // namespace
}  // namespace sbeh::studies::figures
