// What a scan says of a state that is not what was asked for, and of one at a fold.
#include "studies/scan/branch_points.h"

#include <gtest/gtest.h>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using axisym::StationaryCase;
using model::Model;

StationaryCase case_of(double v, double L, Model model, Branch branch, int elements) {
  StationaryCase of{.model = model, .branch = branch, .reduced_volume = v};
  of.material = of.material.with_L(L);
  of.numerics.elements = elements;
  return of;
}

void expect_refused(const PointOutcome& point, Branch shape) {
  EXPECT_EQ(point.row.status, PointStatus::failed);
  EXPECT_EQ(point.row.shape, name(shape));
  EXPECT_NE(point.row.stop_reason.find(std::string("is of class ") + name(shape)),
            std::string::npos)
      << point.row.stop_reason;
}

TEST(StartOfAnotherBranch, is_refused_with_its_class_named) {
  for (const auto& [asked, given] :
       {std::pair{Branch::prolate, Branch::oblate}, {Branch::oblate, Branch::prolate}}) {
    SCOPED_TRACE(std::string(name(given)) + " given for " + name(asked));
    const auto at = [](double v, double L, Model model, Branch branch) {
      return case_of(v, L, model, branch, 32);
    };
    const StationaryCase given_case = at(0.8, 0.05, Model::SSH, given),
                         asked_case = at(0.8, 0.05, Model::SSH, asked);
    axisym::SshBranch branch(given, given_case.material, given_case.numerics);
    const PointOutcome start = ssh_point(given_case, branch);
    EXPECT_EQ(start.row.status, PointStatus::stationary);
    ASSERT_TRUE(start.state);
    expect_refused(ssh_point(asked_case, branch), given);
    const Neighbour there{given_case.at(), *start.state};
    expect_refused(rescale_to(at(0.8, 0.07, Model::SSH, asked), there), given);
    expect_refused(order_from(at(0.8, 0.05, Model::SBEH, asked), *start.state), given);
  }
}

TEST(Evolution, that_comes_to_rest_at_another_class_is_refused_with_it) {
  StationaryCase of = case_of(0.8, 0.05, Model::SSH, Branch::stomatocyte, 24);
  of.numerics.tolerance = 1e-3;
  std::vector<SeriesRow> history;
  // Starts from an oblate spheroid, and has no reason to turn inside out at this reduced volume.
  const auto point = flow_to_rest(of, 200, history);
  ASSERT_TRUE(point);
  expect_refused(*point, Branch::oblate);
}

TEST(StateAtAFold, is_told_with_what_loses_its_order_there) {
  struct Fold {
    double v, H0, L;
    const char* where;
  };
  for (const Fold& f : {Fold{0.6, 0, 0.1, "at the rim"},
                        {0.8, 0, 0.15, "at the rim"},
                        {0.9, 0, 0.9, "of the whole surface"},
                        {0.75, -2.4, 0.1, "at the pole"},
                        {0.7, -2.4, 0.1, "at the pole"}}) {
    SCOPED_TRACE(testing::Message() << f.v << ", H0 = " << f.H0);
    const auto of = [&](double L, Model model) {
      auto at = case_of(f.v, L, model, Branch::oblate, 48);
      at.material.spontaneous_curvature = f.H0;
      return at;
    };
    const StationaryCase classical = of(0.05, Model::SSH);
    axisym::SshBranch states(Branch::oblate, classical.material, classical.numerics);
    const PointOutcome ssh = ssh_point(classical, states);
    ASSERT_TRUE(ssh.state);
    const PointOutcome fold = order_from(of(f.L, Model::SBEH), *ssh.state);
    EXPECT_EQ(fold.row.fold_side, "at");
    EXPECT_NE(fold.row.stop_reason.find(f.where), std::string::npos) << fold.row.stop_reason;
  }
}

TEST(StateAtAFold, is_told_with_the_L_and_the_stability_of_the_side_before_it) {
  for (const Branch branch : {Branch::oblate, Branch::stomatocyte})
    for (const double v : {0.55, 0.58, 0.61, 0.64}) {
      SCOPED_TRACE(std::string(name(branch)) + " " + std::to_string(v));
      const StationaryCase classical = case_of(v, 0.05, Model::SSH, branch, 48);
      axisym::SshBranch states(branch, classical.material, classical.numerics);
      const PointOutcome ssh = ssh_point(classical, states);
      ASSERT_TRUE(ssh.state);
      const PointOutcome fold = order_from(case_of(v, 0.12, Model::SBEH, branch, 48), *ssh.state);
      EXPECT_EQ(fold.row.status, PointStatus::unresolved) << fold.row.stop_reason;
      EXPECT_EQ(fold.row.fold_side, "at");
      ASSERT_TRUE(fold.row.fold_L) << fold.row.stop_reason;
      EXPECT_LT(*fold.row.fold_L, 0.12);
      EXPECT_EQ(fold.row.negative_directions, 0);  // minima up to there
    }
}

// From 24 and 48 elements, of folds at a rim, a pole and a neck.
TEST(ErrorsOfFolds, bound_what_more_elements_change) {
  for (const auto& [branch, v, L] : {std::tuple{Branch::oblate, 0.6, 0.1},
                                     {Branch::oblate, 0.8, 0.2},
                                     {Branch::prolate, 0.6, 0.2},
                                     {Branch::stomatocyte, 0.6, 0.01}}) {
    const auto fold_with = [&](int elements) {
      const StationaryCase classical = case_of(v, 0.05, Model::SSH, branch, elements);
      axisym::SshBranch states(branch, classical.material, classical.numerics);
      return order_from(case_of(v, L, Model::SBEH, branch, elements),
                        *ssh_point(classical, states).state)
          .row;
    };
    const PointResult best = fold_with(192);
    for (const int elements : {24, 48}) {
      SCOPED_TRACE(testing::Message() << name(branch) << ' ' << v << ", " << elements);
      const PointResult row = fold_with(elements);
      ASSERT_TRUE(row.fold_L && row.fold_L_error && row.error) << row.stop_reason;
      EXPECT_LE(row.error->energy, 1e-8 * (1 + std::abs(row.diagnostics->energy.total())));
      EXPECT_LT(std::abs(row.diagnostics->energy.total() - best.diagnostics->energy.total()),
                row.error->energy + best.error->energy + 1e-10);
      EXPECT_LT(std::abs(*row.fold_L - *best.fold_L),
                *row.fold_L_error + *best.fold_L_error + 1e-12);
    }
  }
}

}  // namespace
}  // namespace sbeh::studies
