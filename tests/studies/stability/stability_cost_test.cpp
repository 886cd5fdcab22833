// What a study of stability is said to cost, against what its runs took.
#include "studies/stability/stability_cost.h"

#include <gtest/gtest.h>

namespace sbeh::studies {
namespace {

using axisym::Branch;
using model::Model;

struct Measured {
  Model model;
  Branch branch;
  double reduced_volume, L, largest_step, end;
  meshing::Harmonic mode;
  int steps;
};

// Steps do not depend on the machine; triangles change them little: 320 of the first six, 180 or 80 of the others.
const std::vector<Measured> runs{
    {Model::SSH, Branch::oblate, 0.6, 0.05, 0.5, 14, {2, 2, 0.01}, 63},
    {Model::SSH, Branch::oblate, 0.6, 0.05, 0.5, 14, {3, 3, 0.01}, 48},
    {Model::SSH, Branch::oblate, 0.7, 0.05, 0.5, 14, {2, 2, 0.01}, 113},
    {Model::SSH, Branch::oblate, 0.76, 0.05, 0.5, 14, {2, 2, 0.01}, 301},
    {Model::SSH, Branch::oblate, 0.8, 0.05, 0.5, 14, {2, 2, 0.01}, 268},
    {Model::SSH, Branch::oblate, 0.8, 0.05, 0.5, 14, {3, 3, 0.01}, 39},
    {Model::SBEH, Branch::oblate, 0.6, 0.07, 0.1, 2, {2, 2, 0.01}, 212},
    {Model::SBEH, Branch::oblate, 0.6, 0.07, 0.1, 2, {3, 1, 0.005}, 209},
    {Model::SBEH, Branch::oblate, 0.7, 0.05, 0.1, 2, {3, 1, 0.005}, 28},
    {Model::SBEH, Branch::oblate, 0.8, 0.01, 0.1, 2, {3, 1, 0.005}, 81},
    {Model::SBEH, Branch::oblate, 0.8, 0.05, 0.1, 2, {3, 3, 0.01}, 141},
    {Model::SBEH, Branch::oblate, 0.7, 0.03, 0.1, 2, {2, 2, 0.01}, 449},
    {Model::SBEH, Branch::oblate, 0.7, 0.01, 0.1, 2, {3, 3, 0.01}, 712},
    {Model::SBEH, Branch::oblate, 0.8, 0.05, 0.1, 20, {2, 2, 0.01}, 2074},
    {Model::SBEH, Branch::prolate, 0.65, 0.05, 0.1, 2, {2, 2, 0.01}, 41},
    {Model::SSH, Branch::prolate, 0.65, 0.05, 0.1, 2, {3, 3, 0.01}, 38},
    {Model::SSH, Branch::oblate, 0.65, 0.05, 0.1, 2, {3, 3, 0.01}, 126},
    {Model::SSH, Branch::oblate, 0.74, 0.05, 0.5, 14, {2, 2, 0.02}, 401},
    {Model::SSH, Branch::prolate, 0.8, 0.02, 0.2, 5, {4, 2, 0.02}, 41},
};

TEST(StabilityCost, is_within_a_factor_of_two_of_the_steps_of_each_run) {
  for (const Measured& run : runs) {
    StabilityInput input;
    input.models = {run.model};
    input.branches = {run.branch};
    input.reduced_volume = {run.reduced_volume};
    input.L = {run.L};
    input.perturbations = {run.mode};
    input.numerics_3d.largest_step = run.largest_step;
    input.end_time = run.end;
    const StabilityCost cost = cost_of(input);
    EXPECT_EQ(cost.runs, 1);
    EXPECT_LT(cost.steps, 2 * run.steps) << run.reduced_volume << ' ' << run.mode.m;
    EXPECT_GT(cost.steps, 0.5 * run.steps) << run.reduced_volume << ' ' << run.mode.m;
  }
}

TEST(StabilityCost, looks_at_some_runs_of_many_evenly) {
  StabilityInput input = read_stability("studies/inputs/stability.toml");
  EXPECT_EQ(cost_of(input).runs, 36);
  double sum = 0;
  const std::vector<double> lengths = input.L;
  for (const double L : lengths) {  // nine runs each, of which none is left out
    input.L = {L};
    sum += cost_of(input).steps;
  }
  input.L = lengths;
  EXPECT_NEAR(cost_of(input).steps / sum, 1, 0.25);
}

}  // namespace
}  // namespace sbeh::studies
