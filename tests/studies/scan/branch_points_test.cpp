// What a scan says of a state that is not what was asked for, and of one at a fold.
#include "studies/scan/branch_points.h"

#include <gtest/gtest.h>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using model::Model;

ScanInput input_of(int elements) {
  ScanInput input;
  input.L = {0.05};
  input.numerics.elements = elements;
  return input;
}

void expect_refused(const PointOutcome& point, Branch shape) {
  EXPECT_EQ(point.row.status, PointStatus::failed);
  EXPECT_EQ(point.row.shape, name(shape));
  EXPECT_NE(point.row.stop_reason.find(std::string("is of class ") + name(shape)),
            std::string::npos)
      << point.row.stop_reason;
}

TEST(StartOfAnotherBranch, is_refused_with_its_class_named) {
  const ScanInput input = input_of(32);
  for (const auto& [asked, given] :
       {std::pair{Branch::prolate, Branch::oblate}, {Branch::oblate, Branch::prolate}}) {
    SCOPED_TRACE(std::string(name(given)) + " given for " + name(asked));
    const auto start = enter_branch(input, given, 0.05);
    ASSERT_TRUE(start);
    expect_refused(follow_to(input, {0.8, 0.05, Model::SSH, asked}, *start), given);
    const double v = start->at.reduced_volume;
    expect_refused(rescale_to(input, {v, 0.07, Model::SSH, asked}, *start), given);
    expect_refused(order_from(input, {v, 0.05, Model::SBEH, asked}, *start), given);
    EXPECT_EQ(follow_to(input, {0.8, 0.05, Model::SSH, given}, *start).row.status,
              PointStatus::stationary);
  }
}

TEST(Evolution, that_comes_to_rest_at_another_class_is_refused_with_it) {
  ScanInput input = input_of(24);
  input.method = Method::flow;
  input.numerics.tolerance = 1e-3;
  std::vector<SeriesRow> history;
  // Starts from an oblate spheroid, and has no reason to turn inside out at this reduced volume.
  const auto point = flow_to_rest(input, {0.8, 0.05, Model::SSH, Branch::stomatocyte}, history);
  ASSERT_TRUE(point);
  expect_refused(*point, Branch::oblate);
}

TEST(StateAtAFold, is_told_with_the_L_and_the_stability_of_the_side_before_it) {
  const ScanInput input = input_of(48);
  for (const Branch branch : {Branch::oblate, Branch::stomatocyte})
    for (const double v : {0.55, 0.58, 0.61, 0.64}) {
      SCOPED_TRACE(std::string(name(branch)) + " " + std::to_string(v));
      const auto entry = enter_branch(input, branch, 0.05);
      ASSERT_TRUE(entry);
      const PointOutcome ssh = follow_to(input, {v, 0.05, Model::SSH, branch}, *entry);
      ASSERT_TRUE(ssh.state);
      const PointOutcome fold =
          order_from(input, {v, 0.12, Model::SBEH, branch}, {{v, 0.05}, *ssh.state});
      EXPECT_EQ(fold.row.status, PointStatus::unresolved) << fold.row.stop_reason;
      EXPECT_EQ(fold.row.fold_side, "at");
      ASSERT_TRUE(fold.row.fold_L) << fold.row.stop_reason;
      EXPECT_LT(*fold.row.fold_L, 0.12);
      EXPECT_EQ(fold.row.negative_directions, 0);  // minima up to there
    }
}

}  // namespace
}  // namespace sbeh::studies
