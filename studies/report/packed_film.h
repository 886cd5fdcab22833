// Curved surfaces with fields at their nodes for a live page, in 16 bits.
#pragma once

#include "studies/mesh_files/mesh_file.h"
#include "studies/report/bundle.h"

#include <string>
#include <vector>

namespace sbeh::studies {

/// A page with more numbers in its frames would be larger than some 40 MB.
inline constexpr std::size_t most_film_numbers = 24'000'000;

/// How many frames of so many a page holds, and how many modes of each.
struct FilmRoom {
  std::size_t frames = 0, modes = 0;
};
/// A frame and a mode having so many numbers; one frame at least.
FilmRoom film_room(std::size_t frames, std::size_t of_frame, std::size_t of_mode);

/// The curved surface in a file with these fields. Throws InputError, saying that it is no `what`.
CurvedFile read_surface(const std::filesystem::path& path, const std::vector<std::string>& fields,
                        std::string_view what);

/// Becomes these parts of the data:
///   fields.csv     name and range of each field: x, y, z, and what else there is
///   meshes.csv     of each mesh its curved triangles, nodes, and frames
///   mesh/0 …       the small plain triangles of a mesh, by their nodes
///   frames/0 …     the fields of its frames, as differences from one to the next
class PackedFilm {
 public:
  /// After x, y and z.
  explicit PackedFilm(const std::vector<std::string>& fields);

  /// The next frame, `values` being those of the fields, fields x nodes. Tells which mesh it has: the last one, where that has the
  /// same triangles.
  std::size_t add(const meshing::CurvedMesh& surface, const Eigen::MatrixXf& values);
  void put_into(Bundle& bundle) const;

 private:
  struct Mesh {
    Eigen::MatrixXi curved;  // 10 nodes x triangles
    Eigen::Matrix3Xi plain;
    std::vector<Eigen::MatrixXf> frames;  // fields x nodes
  };
  void put_mesh(std::size_t index, Bundle& bundle) const;

  std::vector<std::string> names_;
  std::vector<NumberRange> ranges_;
  std::vector<Mesh> meshes_;
};

}  // namespace sbeh::studies
