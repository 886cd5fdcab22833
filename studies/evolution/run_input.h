// What one 3D run is asked for: model, surface, material, numerics and times.
#pragma once

#include "meshing/spherical_harmonics.h"
#include "model/material.h"
#include "studies/evolution/start_shape.h"
#include "studies/evolution/times.h"
#include "studies/parameters/units.h"
#include "studies/scan/scan_row.h"
#include "studies/states/initial_order.h"
#include "surface3d/flow.h"
#include "surface3d/options.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// r = 1 + Σ a_lm Y_lm, real orthonormal, then scaled to the area 4π.
struct HarmonicSphere {
  std::vector<meshing::Harmonic> modes;  ///< degrees 0 … 32, none twice
  std::optional<double> reduced_volume;  ///< all a_lm times one factor

  bool operator==(const HarmonicSphere&) const = default;
};

/// A mesh in a file, scaled to the area 4π.
struct MeshFileStart {
  std::string file;

  bool operator==(const MeshFileStart&) const = default;
};

/// A frame of an earlier run: surface and order.
struct FrameStart {
  std::string file;

  bool operator==(const FrameStart&) const = default;
};
bool is_there(const FrameStart& frame);
/// Throws InputError when it is no frame.
Origin origin_of(const FrameStart& frame);

/// A mode of a stationary state, out of the folder of `sbeh modes`: the state revolved and displaced.
struct ModeStart {
  std::string file;
  double amplitude = 0;  ///< the largest displacement, along the normal; < 0: the other way

  bool operator==(const ModeStart&) const = default;
};
bool is_there(const ModeStart& mode);
/// Throws InputError when it is no mode.
Origin origin_of(const ModeStart& mode);

/// How a run ends that would come to rest.
enum class RunFinish {
  flow,   ///< where nothing moves any more
  newton  ///< near there, from where Newton's method leads on: see rest_states/run_end.h
};
constexpr auto names(RunFinish) { return std::array{"flow", "newton"}; }

/// Top-level key `model`; tables [surface] and [time], optional [material] and [numerics]. What a start that is
/// a result was computed with stands for what the file does not say of model and material.
struct RunInput : Physics {
  std::variant<Ellipsoid, HarmonicSphere, MeshFileStart, ScanRow, FrameStart, ModeStart> start;
  int triangles = 320;                          ///< about so many; files bring their own
  double initial_order = model::full_order;     ///< where the start brings none, 0 … 1
  OrderPattern order_pattern;                   ///< likewise, added to it
  std::vector<meshing::Harmonic> perturbation;  ///< displaces along the normal by Σ a_lm Y_lm
  /// Of triangles, and the part of it that each step is projected onto: keys `symmetry`, `keep_symmetry`.
  surface3d::FlowSymmetry symmetry{};
  surface3d::Numerics numerics;
  Times times;  ///< states: frames
  RunFinish finish = RunFinish::flow;
  double checkpoint_minutes = 10;  ///< of wall time between checkpoints, > 0
  std::optional<Units> units{};    ///< for people: no number depends on them

  bool operator==(const RunInput&) const = default;
};

/// Throws InputError.
RunInput read_run(const std::filesystem::path& path);
/// The same of a file that was read already.
RunInput run_in(const TomlTable& file);
/// The same for a run in a folder that is gone on with: it stands in for a start that is no longer there.
RunInput read_resumed_run(const std::filesystem::path& path, const std::filesystem::path& folder);

/// The whole input, defaults included, as TOML under a comment with the program's version: reading the text
/// gives the same input, bit for bit.
std::string describe(const RunInput& input, std::string_view version);

}  // namespace sbeh::studies
