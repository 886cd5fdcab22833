// How the numbers are meant: what stands at the head of every run.toml, in reports, and with converted tables.
#pragma once

#include <array>

namespace sbeh::studies {

/// Units, the sign of H, what energies are counted from, H₀ against c₀ of the literature: lines without an end.
inline constexpr std::array conventions{
    "Dimensionless: lengths in R = √(A/4π), energies in κ/(2L₁ + L₂ + L₃ + k₀).",
    "H is the trace of the shape operator, −2/R on a sphere.",
    "F = (κ/2)∫(H − H₀)² dS with H₀ = 0 is 8πκ on a sphere: F/(8πκ) = 1.",
    "spontaneous_curvature H₀ is −c₀ of Helfrich's (κ/2)∫(C₁ + C₂ − c₀)² dS.",
    "energy_bending is F + κ_G∫K dS; where all of L is L₁, κ_G = −κ(β) + k₀.",
};

}  // namespace sbeh::studies
