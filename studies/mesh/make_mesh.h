// A mesh as a user asks for it: a shape, how fine, how large; made, checked and reported.
#pragma once

#include "axisym/curve.h"
#include "meshing/names.h"
#include "meshing/quality.h"
#include "meshing/resolution.h"
#include "meshing/spherical_harmonics.h"
#include "studies/mesh_files/mesh_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace sbeh::studies {

struct SphereShape {};
/// Either the semi-axes along x, y, z, or the spheroid about z of the request's reduced volume.
struct EllipsoidShape {
  std::optional<Eigen::Vector3d> semi_axes;
  bool prolate = false;
};
/// With a reduced volume in the request all amplitudes are multiplied by one factor.
struct HarmonicShape {
  std::vector<meshing::Harmonic> modes;
};
/// A profile as `write_profile` leaves it, revolved; its order becomes the field "order".
struct ProfileShape {
  std::filesystem::path file;
};
/// An axisymmetric state, revolved; its order becomes the field "order".
struct StateShape {
  axisym::State state;
};

/// A user's mesh. Plain triangles are curved; without `triangles` they stay as they are.
struct FileShape {
  std::filesystem::path file;
  bool repair = false;
};

struct MeshRequest {
  std::variant<SphereShape, EllipsoidShape, HarmonicShape, ProfileShape, StateShape, FileShape>
      shape;
  std::optional<int> triangles = {};  ///< about so many
  std::optional<int> order = {};      ///< 3
  double grading = 0;                 ///< meshing::Resolution
  meshing::PointGroup symmetry = {};  ///< of the triangles; the shape must have it
  std::optional<double> area = {};    ///< else the shape's own; 4π for the spheroid of given V_r
  std::optional<double> reduced_volume = {};  ///< else the shape's own
};

struct MadeMesh {
  meshing::CurvedMesh mesh;
  NodeFields fields;  ///< "mean_curvature" for order > 1; "order" of a profile; those of the file
  meshing::Quality quality;
  meshing::Names names;            ///< of the triangles as a file has them
  std::vector<std::string> notes;  ///< what the user should know, such as what was repaired
};

/// The mesh, which is closed, outward, of sphere topology and free of folds and self-intersections.
/// Throws InputError: what is wrong with the request, or which triangle or point of the file.
MadeMesh make_mesh(const MeshRequest& request);

/// The quality of a mesh whose curved triangles neither fold over nor pass through each other. Throws
/// std::invalid_argument that names the triangle for any other.
meshing::Quality quality_of_sound(const meshing::CurvedMesh& mesh,
                                  const meshing::Names& names = {});

/// `name: value` lines, of a shape that a formula gives beside what it has by itself (shape_numbers.h).
std::string report(const MadeMesh& made, const MeshRequest& request);

}  // namespace sbeh::studies
