#include "studies/mesh/make_mesh.h"

#include "meshing/curvature.h"
#include "meshing/curving.h"
#include "meshing/defects.h"
#include "meshing/fitted_surface.h"
#include "meshing/measures.h"
#include "meshing/remeshing.h"
#include "meshing/repair.h"
#include "meshing/revolution.h"
#include "meshing/shapes.h"
#include "studies/io/errors.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace sbeh::studies {

using meshing::DefectKind;
using meshing::TriangleMesh;

namespace {

meshing::Resolution resolution_of(const MeshRequest& r) {
  meshing::Resolution resolution;
  resolution.triangles = r.triangles.value_or(resolution.triangles);
  resolution.order = r.order.value_or(resolution.order);
  resolution.grading = r.grading;
  resolution.validate();
  return resolution;
}

bool is_repairable(DefectKind kind) {
  switch (kind) {
    case DefectKind::degenerate:
    case DefectKind::repeated:
    case DefectKind::unused_point:
    case DefectKind::orientation_differs:
    case DefectKind::inward:
      return true;
    default:
      return false;
  }
}

[[noreturn]] void refuse(const FileShape& shape, const meshing::Defect& defect) {
  const char* advice = "";
  if (shape.repair)
    advice = "; --repair does not help there";
  else if (is_repairable(defect.kind))
    advice = "; --repair can mend that";
  else if (defect.kind == DefectKind::open)
    advice = "; --repair closes holes of at most 8 edges and joins points of equal coordinates";
  throw InputError(fmt::format("{}: {}{}", shape.file.string(), defect.text, advice));
}

// Defects that leave nothing to repair with.
bool is_hopeless(DefectKind kind) { return kind <= DefectKind::no_such_point; }

TriangleMesh checked(const FileShape& shape, TriangleMesh mesh, MadeMesh& made) {
  auto defect = find_defect(mesh);
  if (defect && shape.repair && !is_hopeless(defect->kind)) {
    const meshing::Repair repair = meshing::repaired(mesh);
    for (const std::string& what : repair.done) made.notes.push_back("repaired: " + what);
    mesh = repair.mesh;
    defect = find_defect(mesh);
  }
  if (defect) refuse(shape, *defect);
  return mesh;
}

std::shared_ptr<const meshing::FittedSurface> fitted(const std::filesystem::path& file,
                                                     const TriangleMesh& plain) {
  try {
    return std::make_shared<const meshing::FittedSurface>(plain);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void curve(const MeshRequest& request, const std::filesystem::path& file, const TriangleMesh& plain,
           MadeMesh& made) {
  const meshing::Resolution resolution = resolution_of(request);
  if (request.grading > 0 && !request.triangles)
    throw InputError(
        "grading: the triangles of a file stay as they are unless their number is given");
  const auto surface = fitted(file, plain);
  if (request.triangles) {
    const meshing::Projection onto_surface = meshing::onto(surface);
    made.mesh = meshing::curved(
        meshing::remeshed(plain, resolution.triangles, onto_surface, resolution.grading),
        resolution.order, onto_surface);
  } else {
    made.mesh = meshing::curved(plain, resolution.order,
                                meshing::Placement([&](int t, const Eigen::Vector3d& barycentric) {
                                  return surface->at(t, barycentric);
                                }));
  }
}

void make(const SphereShape&, const MeshRequest& request, MadeMesh& made) {
  made.mesh = meshing::sphere(resolution_of(request));
}

void make(const EllipsoidShape& shape, const MeshRequest& request, MadeMesh& made) {
  if (shape.semi_axes.has_value() == request.reduced_volume.has_value())
    throw InputError("ellipsoid: give either its semi-axes or its reduced volume");
  if (shape.semi_axes && shape.prolate)
    throw InputError("ellipsoid: prolate or oblate is a choice for a given reduced volume only");
  made.mesh = shape.semi_axes ? meshing::ellipsoid(*shape.semi_axes, resolution_of(request))
                              : meshing::ellipsoid(*request.reduced_volume, shape.prolate,
                                                   resolution_of(request));
}

void make(const HarmonicShape& shape, const MeshRequest& request, MadeMesh& made) {
  const meshing::Resolution resolution = resolution_of(request);
  made.mesh = request.reduced_volume
                ? meshing::harmonic_sphere(shape.modes, *request.reduced_volume, resolution)
                : meshing::harmonic_sphere(shape.modes, resolution);
}

void make(const ProfileShape& shape, const MeshRequest& request, MadeMesh& made) {
  const axisym::State state =
      read_profile(shape.file, "must be a table of nodes as a scan leaves them in points/");
  try {
    const meshing::RevolvedMesh revolved = meshing::revolved(state, resolution_of(request));
    made.mesh = revolved.mesh;
    made.fields["order"] = revolved.beta.transpose();
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", shape.file.string(), error.what()));
  }
}

void make(const FileShape& shape, const MeshRequest& request, MadeMesh& made) {
  const MeshFile file = read_mesh(shape.file);
  if (const auto* plain = std::get_if<TriangleMesh>(&file))
    return curve(request, shape.file, checked(shape, *plain, made), made);
  const CurvedFile& curved = std::get<CurvedFile>(file);
  if (request.triangles || request.grading > 0
      || request.order.value_or(curved.mesh.order) != curved.mesh.order)
    throw InputError(
        fmt::format("{}: has curved triangles of order {}, which stay as they are: their number "
                    "and order cannot be chosen",
                    shape.file.string(), curved.mesh.order));
  if (!curved.mesh.nodes.allFinite())
    throw InputError(
        fmt::format("{}: a coordinate of a node is no finite number", shape.file.string()));
  if (const auto defect = find_defect(meshing::corners(curved.mesh)))
    throw InputError(fmt::format("{}: {}", shape.file.string(), defect->text));
  made.mesh = curved.mesh;
  made.fields = curved.fields;
}

void scale(const MeshRequest& request, MadeMesh& made) {
  if (request.area && !(*request.area > 0 && std::isfinite(*request.area)))
    throw InputError(fmt::format("area {}: must be > 0", *request.area));
  const double area = request.area.value_or(meshing::area(made.mesh));
  const bool has_it_already = std::holds_alternative<EllipsoidShape>(request.shape)
                           || std::holds_alternative<HarmonicShape>(request.shape);
  if (!request.reduced_volume || has_it_already) {
    if (request.area) meshing::scale_to_area(made.mesh, area);
    return;
  }
  const double v = *request.reduced_volume;
  if (!(v > 0 && v <= 1))
    throw InputError(fmt::format("reduced volume {}: must be > 0 and <= 1", v));
  if (!meshing::correct_area_volume(made.mesh, area, v))
    throw InputError(
        fmt::format("reduced volume {}: the shape has {:.6g}, too far away to be moved there", v,
                    meshing::reduced_volume(made.mesh)));
}

std::string name_of(const MeshRequest& request) {
  if (const auto* profile = std::get_if<ProfileShape>(&request.shape))
    return profile->file.string();
  if (const auto* file = std::get_if<FileShape>(&request.shape)) return file->file.string();
  return "the shape";
}

}  // namespace

meshing::Quality quality_of_sound(const meshing::CurvedMesh& mesh) {
  if (!mesh.nodes.allFinite())
    throw std::invalid_argument("a coordinate of a node is no finite number");
  meshing::Quality q = meshing::quality_of(mesh);
  if (!(q.min_jacobian > 0))
    throw std::invalid_argument(fmt::format(
        "triangle {} folds over when it is curved; take more triangles, or the surface is not "
        "smooth there",
        q.worst_triangle));
  if (q.self_intersections > 0)
    throw std::invalid_argument(fmt::format(
        "the curved triangles {} and {} pass through each other ({} such pairs); take more "
        "triangles, or the surface itself does so",
        q.first_pair[0], q.first_pair[1], q.self_intersections));
  return q;
}

MadeMesh make_mesh(const MeshRequest& request) {
  MadeMesh made;
  try {
    std::visit([&](const auto& shape) { make(shape, request, made); }, request.shape);
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
  scale(request, made);
  try {
    made.quality = quality_of_sound(made.mesh);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", name_of(request), error.what()));
  }
  if (made.mesh.order > 1)
    made.fields["mean_curvature"] = meshing::node_mean_curvature(made.mesh).transpose();
  return made;
}

std::string report(const meshing::Quality& q) {
  fmt::memory_buffer text;
  const auto line = [&](const char* name, const auto& value) {
    fmt::format_to(std::back_inserter(text), "{}: {}\n", name, value);
  };
  line("triangles", q.triangles);
  line("area", q.area);
  line("volume", q.volume);
  line("reduced_volume", q.reduced_volume);
  line("min_angle_deg", q.min_angle);
  line("max_angle_deg", q.max_angle);
  line("edge_ratio", q.edge_ratio);
  line("self_intersections", q.self_intersections);
  line("euler", q.euler);
  line("closed", "yes");
  line("orientation", q.volume > 0 ? "outward" : "inward");
  line("min_jacobian", q.min_jacobian);
  line("max_jacobian", q.max_jacobian);
  std::string valences;
  for (const auto& [valence, count] : q.valences)
    valences += fmt::format("{}{}x{}", valences.empty() ? "" : " ", count, valence);
  line("valences", valences);
  return fmt::to_string(text);
}

}  // namespace sbeh::studies
