// The shapes that the start of an evolution may have: one list for each kind of input.
#pragma once

#include "meshing/point_group.h"
#include "studies/io/spelling.h"
#include "studies/io/toml_reader.h"
#include "studies/io/toml_text.h"
#include "studies/parameters/material_input.h"
#include "studies/parameters/physics.h"
#include "studies/states/initial_order.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sbeh::studies {

/// A shape in the list of an input: its place there is that of its type in the variant Input::start.
template <class Input>
struct StartShape {
  std::string name;
  std::vector<std::string> keys;  ///< that belong to it, besides `shape`
  void (*read)(const TomlTable& start, Input& input);
  bool is_result = false;  ///< brings its model and material

  bool has(std::string_view key) const {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  }
};

/// The one that the key `shape` names. Throws InputError for another word, and for keys which belong to
/// other shapes than that one.
template <class Input>
const StartShape<Input>& chosen_shape(const TomlTable& start,
                                      const std::vector<StartShape<Input>>& shapes) {
  std::vector<std::string> names;
  names.reserve(shapes.size());
  for (const auto& shape : shapes) names.push_back(shape.name);
  const std::string chosen = start.word("shape", names);
  const auto& own = *std::find_if(shapes.begin(), shapes.end(),
                                  [&](const auto& shape) { return shape.name == chosen; });
  for (const auto& other : shapes)
    for (const std::string& key : other.keys) {
      if (own.has(key)) continue;
      std::string owners;
      for (const auto& shape : shapes)
        if (shape.has(key)) owners += (owners.empty() ? "" : " and ") + in_quotes(shape.name);
      start.refuse(key, "belongs to shape = " + owners + ", not to " + in_quotes(chosen));
    }
  return own;
}

/// The model that the file names: at its top, or for the row of a scan in the table of the start, which may
/// be enough. Empty where a result brings it. Throws InputError.
template <class Input>
std::optional<model::Model> named_model(const TomlTable& file, const TomlTable& start,
                                        const std::vector<StartShape<Input>>& shapes) {
  if (!file.has("model") && start.has("shape")) {
    const StartShape<Input>& shape = chosen_shape(start, shapes);
    if (shape.has("model") && start.has("model")) return start.choice("model", rest_models);
    if (shape.is_result && !shape.has("model")) return {};
  }
  return file.choice("model", values_of(model::Model{}));
}

/// The result from which an evolution starts; empty where its start is none.
template <class Start>
std::optional<Origin> origin_of_any(const Start& start) {
  return std::visit(
      [](const auto& shape) -> std::optional<Origin> {
        if constexpr (requires { origin_of(shape); })
          return origin_of(shape);
        else
          return {};
      },
      start);
}

/// The point group that a key names; C1 without it. Throws InputError.
meshing::PointGroup read_symmetry(const TomlTable& table, std::string_view key);

/// Ellipsoid, scaled to the area 4π: of a reduced volume, or with axes.
struct Ellipsoid {
  std::optional<double> reduced_volume;  ///< V_r, 0 < V_r <= 1: of revolution
  bool prolate = false;                  ///< which ellipsoid of that reduced volume
  std::vector<double>
      axes;  ///< semi-axes > 0, up to 1 : 1000: equatorial and polar, or along x, y, z

  bool operator==(const Ellipsoid&) const = default;
};

/// Throws InputError. `axes` is what that key must be, such as "two numbers, …", `count` of them.
Ellipsoid read_ellipsoid(const TomlTable& start, std::size_t count, std::string_view axes);
void write_shape(TomlText& toml, const Ellipsoid& ellipsoid);

}  // namespace sbeh::studies
