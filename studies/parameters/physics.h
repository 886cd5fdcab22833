// The equations that a state belongs to, and what becomes of them when a run starts from a result.
#pragma once

#include "model/material.h"
#include "studies/io/description.h"
#include "studies/io/toml_reader.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace sbeh::studies {

struct Physics {
  model::Model model = model::Model::SBEH;
  model::Material material;

  bool operator==(const Physics&) const = default;
};

/// A result from which an evolution starts.
struct Origin {
  std::string place;               ///< its file, or the row of a scan
  std::optional<Physics> physics;  ///< with which it was computed; empty where that is not known
};

/// Key `model`, here where it is `named`, and table [material] of an evolution. What they do not say is as in
/// its origin, which is asked for only then, or the default where it has none. Of an origin that is not
/// known to have been computed with anything, model and elastic constants must be said. Throws InputError.
Physics read_physics(const TomlTable& file, const std::optional<model::Model>& named,
                     const TomlTable& material,
                     const std::function<std::optional<Origin>()>& origin);

/// Of the run.toml of an evolution. Throws InputError.
Physics read_physics(const std::filesystem::path& description);

/// What a model does not say itself, where it is not the same.
std::vector<Difference> differences(const Physics& there, const Physics& here);

/// Energies of a start with what it was computed with, and with what goes on.
struct StartEnergies {
  double there, here;
};
/// What is to be said of a start: what goes on is not what it was computed with, or that is not known.
/// `energies` are asked for in the first case. Empty where nothing has changed.
std::optional<std::string> remark_on(const Origin& origin, const Physics& here,
                                     const std::function<StartEnergies()>& energies);

}  // namespace sbeh::studies
