#include "studies/report/packed_film.h"

#include "meshing/quality.h"
#include "studies/io/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace sbeh::studies {

FilmRoom film_room(std::size_t frames, std::size_t of_frame, std::size_t of_mode) {
  if (frames == 0) return {};
  const std::size_t held = std::clamp<std::size_t>(most_film_numbers / of_frame, 1, frames);
  const std::size_t left = most_film_numbers - std::min(held * of_frame, most_film_numbers);
  return {held, left / (held * of_mode)};
}

CurvedFile read_surface(const std::filesystem::path& path, const std::vector<std::string>& fields,
                        std::string_view what) {
  if (auto file = read_curved_mesh(path))
    if (std::ranges::all_of(fields, [&](const auto& name) { return file->fields.contains(name); }))
      return std::move(*file);
  throw InputError(
      fmt::format("{}: is no {}: delete it to have a page without it", path.string(), what));
}

PackedFilm::PackedFilm(const std::vector<std::string>& fields) : names_{"x", "y", "z"} {
  names_.insert(names_.end(), fields.begin(), fields.end());
  ranges_.resize(names_.size());
}

std::size_t PackedFilm::add(const meshing::CurvedMesh& surface, const Eigen::MatrixXf& values) {
  const auto same = [&](const Eigen::MatrixXi& triangles) {
    return triangles.cols() == surface.triangles.cols() && triangles == surface.triangles;
  };
  if (meshes_.empty() || !same(meshes_.back().curved))
    meshes_.push_back({surface.triangles, meshing::lattice(surface).triangles, {}});
  Eigen::MatrixXf& frame = meshes_.back().frames.emplace_back(names_.size(), surface.node_count());
  frame.topRows<3>() = surface.nodes.cast<float>();
  frame.bottomRows(values.rows()) = values;
  for (std::size_t k = 0; k < names_.size(); ++k)
    for (const float value : frame.row(Eigen::Index(k))) ranges_[k].include(value);
  return meshes_.size() - 1;
}

void PackedFilm::put_mesh(std::size_t index, Bundle& bundle) const {
  const Mesh& mesh = meshes_[index];
  std::vector<std::uint16_t> numbers;
  for (const Eigen::MatrixXf& frame : mesh.frames)
    for (std::size_t k = 0; k < names_.size(); ++k)
      for (const float value : frame.row(Eigen::Index(k)))
        numbers.push_back(quantised(value, ranges_[k]));
  bundle.add(fmt::format("mesh/{}", index),
             std::vector<std::uint32_t>(mesh.plain.data(), mesh.plain.data() + mesh.plain.size()));
  bundle.add(fmt::format("frames/{}", index),
             differences(numbers, std::size_t(mesh.frames.front().size())));
}

void PackedFilm::put_into(Bundle& bundle) const {
  std::string fields = "name,low,high\n", meshes = "triangles,nodes,frames\n";
  for (std::size_t k = 0; k < names_.size(); ++k)
    fields += fmt::format("{},{:.8g},{:.8g}\n", names_[k], ranges_[k].low, ranges_[k].high);
  for (std::size_t k = 0; k < meshes_.size(); ++k) {
    put_mesh(k, bundle);
    meshes += fmt::format("{},{},{}\n", meshes_[k].curved.cols(), meshes_[k].frames.front().cols(),
                          meshes_[k].frames.size());
  }
  bundle.add("fields.csv", fields);
  bundle.add("meshes.csv", meshes);
}

}  // namespace sbeh::studies
