// Equality of inputs, member by member.
#pragma once

#include "studies/compare/compare_input.h"
#include "studies/evolution/relax_input.h"
#include "studies/evolution/run_input.h"
#include "studies/scan/scan_input.h"
#include "studies/stability/stability_input.h"

#include <gtest/gtest.h>

#include <tuple>
#include <type_traits>

namespace sbeh::studies::test {

// Bindings name every member: a new one breaks the build until it is compared.

inline void expect_same(const model::Material& a, const model::Material& b) {
  const auto tie = [](const model::Material& material) {
    const auto& [L1, L2, L3, potential, viscosity, immobility, tangential, normal, order_viscosity,
                 stiffness, curvature] = material;
    return std::tie(L1, L2, L3, potential, viscosity, immobility, tangential, normal,
                    order_viscosity, stiffness, curvature);
  };
  EXPECT_TRUE(tie(a) == tie(b));
}

inline void expect_same(const axisym::Numerics& a, const axisym::Numerics& b) {
  const auto tie = [](const axisym::Numerics& numerics) {
    const auto& [tolerance, first, smallest, largest, extrapolate, rest] =
        static_cast<const model::TimeControl&>(numerics);
    return std::tie(numerics.elements, numerics.grading, tolerance, first, smallest, largest,
                    extrapolate, rest);
  };
  EXPECT_TRUE(tie(a) == tie(b));
}

inline void expect_same(const surface3d::Numerics& a, const surface3d::Numerics& b) {
  const auto tie = [](const surface3d::Numerics& numerics) {
    const auto& [tolerance, first, smallest, largest, extrapolate, rest] =
        static_cast<const model::TimeControl&>(numerics);
    return std::tie(numerics.integrator, numerics.scheme, numerics.factorisation,
                    numerics.solver_tolerance, numerics.remesh, numerics.most_triangles, tolerance,
                    first, smallest, largest, extrapolate, rest);
  };
  EXPECT_TRUE(tie(a) == tie(b));
}

inline void expect_same(const ScanInput& a, const ScanInput& b) {
  const auto tie = [](const ScanInput& input) {
    const auto& [reduced_volume, L, models, branches, method, beyond_fold, material, numerics,
                 end] = input;
    return std::tie(reduced_volume, L, models, branches, method, beyond_fold, end);
  };
  EXPECT_TRUE(tie(a) == tie(b));
  expect_same(a.material, b.material);
  expect_same(a.numerics, b.numerics);
}

inline void expect_same(const SurfaceMethod& a, const SurfaceMethod& b) {
  const auto tie = [](const SurfaceMethod& method) {
    return std::tie(method.run, method.revolved, method.triangles, method.end_time,
                    method.numerics.tolerance, method.numerics.rest_speed);
  };
  EXPECT_TRUE(tie(a) == tie(b));
}

inline void expect_same(const CompareInput& a, const CompareInput& b) {
  const auto tie = [](const CompareInput& input) {
    const auto& [model, branch, reduced_volume, L, methods, material, numerics, surface3d,
                 harmonics, tolerance, tolerance_3d] = input;
    return std::tie(model, branch, reduced_volume, L, methods, harmonics.degree, tolerance,
                    tolerance_3d);
  };
  EXPECT_TRUE(tie(a) == tie(b));
  expect_same(a.material, b.material);
  expect_same(a.numerics, b.numerics);
  expect_same(a.surface3d, b.surface3d);
}

inline void expect_same(const StabilityInput& a, const StabilityInput& b) {
  const auto tie = [](const StabilityInput& input) {
    const auto& [reduced_volume, L, models, branches, perturbations, triangles, end, numerics_3d,
                 material, numerics] = input;
    return std::tie(reduced_volume, L, models, branches, perturbations, triangles, end);
  };
  EXPECT_TRUE(tie(a) == tie(b));
  expect_same(a.numerics_3d, b.numerics_3d);
  expect_same(a.material, b.material);
  expect_same(a.numerics, b.numerics);
}

inline void expect_same(const RelaxInput& a, const RelaxInput& b) {
  const auto tie_rest = [](const RelaxInput& input) {
    const auto& [model, start, order, material, numerics, times] = input;
    return std::tie(model, start, order, times);
  };
  EXPECT_TRUE(tie_rest(a) == tie_rest(b));
  expect_same(a.material, b.material);
  expect_same(a.numerics, b.numerics);
}

inline void expect_same(const RunInput& a, const RunInput& b) {
  const auto tie_rest = [](const RunInput& input) {
    const auto& [model, start, triangles, order, perturbation, material, numerics, times,
                 checkpoint] = input;
    return std::tie(model, start, triangles, order, perturbation, times, checkpoint);
  };
  EXPECT_TRUE(tie_rest(a) == tie_rest(b));
  expect_same(a.material, b.material);
  expect_same(a.numerics, b.numerics);
}

}  // namespace sbeh::studies::test
