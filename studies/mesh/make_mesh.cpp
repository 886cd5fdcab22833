#include "studies/mesh/make_mesh.h"

#include "meshing/curvature.h"
#include "meshing/curving.h"
#include "meshing/measures.h"
#include "meshing/remeshing.h"
#include "meshing/revolution.h"
#include "meshing/shapes.h"
#include "studies/io/errors.h"
#include "studies/mesh/file_surface.h"
#include "studies/mesh/shape_numbers.h"
#include "studies/states/profile_file.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace sbeh::studies {

namespace {

meshing::Resolution resolution_of(const MeshRequest& r) {
  meshing::Resolution resolution;
  resolution.triangles = r.triangles.value_or(resolution.triangles);
  resolution.order = r.order.value_or(resolution.order);
  resolution.grading = r.grading;
  resolution.symmetry = r.symmetry;
  resolution.fitted = true;  // as a run begins
  resolution.validate();
  return resolution;
}

void curve(const MeshRequest& request, const std::shared_ptr<const meshing::FittedSurface>& surface,
           MadeMesh& made) {
  const meshing::Resolution resolution = resolution_of(request);
  if (request.grading > 0 && !request.triangles)
    throw InputError(
        "grading: the triangles of a file stay as they are unless their number is given");
  if (!request.triangles) {
    made.mesh = curved(*surface, resolution.order);
    return;
  }
  made.names = {};
  const meshing::Projection onto_surface = meshing::onto(surface);
  made.mesh = meshing::curved(
      meshing::remeshed(surface->mesh(), resolution.triangles, onto_surface, resolution.grading),
      resolution.order, onto_surface);
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

void make(const StateShape& shape, const MeshRequest& request, MadeMesh& made) {
  const meshing::RevolvedMesh revolved = meshing::revolved(shape.state, resolution_of(request));
  made.mesh = revolved.mesh;
  made.fields["order"] = revolved.beta.transpose();
}

void make(const ProfileShape& shape, const MeshRequest& request, MadeMesh& made) {
  const axisym::State state =
      read_profile(shape.file, "must be a table of nodes as a scan leaves them in points/");
  try {
    make(StateShape{state}, request, made);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}", shape.file.string(), error.what()));
  }
}

void make(const FileShape& shape, const MeshRequest& request, MadeMesh& made) {
  FileSurface file = surface_of_file(shape.file, shape.repair);
  made.notes = std::move(file.notes);
  made.names = std::move(file.names);
  if (const auto* plain = std::get_if<0>(&file.surface)) return curve(request, *plain, made);
  CurvedFile& curved = std::get<CurvedFile>(file.surface);
  if (request.triangles || request.grading > 0
      || request.order.value_or(curved.mesh.order) != curved.mesh.order)
    throw InputError(
        fmt::format("{}: has curved triangles of order {}, which stay as they are: their number "
                    "and order cannot be chosen",
                    shape.file.string(), curved.mesh.order));
  made.mesh = std::move(curved.mesh);
  made.fields = std::move(curved.fields);
}

void scale_about_origin(const MeshRequest& request, MadeMesh& made) {
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

// The surface of a file keeps its place.
void scale(const MeshRequest& request, MadeMesh& made) {
  if (!std::holds_alternative<FileShape>(request.shape)
      || (!request.area && !request.reduced_volume))
    return scale_about_origin(request, made);
  const Eigen::Vector3d place = meshing::centre(made.mesh);
  made.mesh.nodes.colwise() -= place;
  scale_about_origin(request, made);
  made.mesh.nodes.colwise() += place;
}

std::string name_of(const MeshRequest& request) {
  if (const auto* profile = std::get_if<ProfileShape>(&request.shape))
    return profile->file.string();
  if (const auto* file = std::get_if<FileShape>(&request.shape)) return file->file.string();
  return "the shape";
}

}  // namespace

meshing::Quality quality_of_sound(const meshing::CurvedMesh& mesh, const meshing::Names& names) {
  if (!mesh.nodes.allFinite())
    throw std::invalid_argument("a coordinate of a node is no finite number");
  meshing::Quality q = meshing::quality_of(mesh);
  const auto name = [&](int t) { return triangle_name(meshing::corners(mesh), t, names); };
  if (!(q.min_jacobian > 0))
    throw std::invalid_argument(fmt::format(
        "{} folds over when it is curved; take more triangles, or the surface is not smooth there",
        name(q.worst_triangle)));
  if (q.self_intersections > 0)
    throw std::invalid_argument(fmt::format(
        "{} and {}, curved, pass through each other ({} such pairs); take more triangles, or the "
        "surface itself does so",
        name(q.first_pair[0]), name(q.first_pair[1]), q.self_intersections));
  return q;
}

namespace {

// Of a file whose triangles cannot be curved as they are.
std::string advice(MeshRequest request) {
  auto* shape = std::get_if<FileShape>(&request.shape);
  if (!shape || std::exchange(shape->repair, true)) return {};
  try {
    make_mesh(request);
    return "; " + advice_to_repair(shape->file);
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

MadeMesh make_mesh(const MeshRequest& request) {
  MadeMesh made;
  try {
    std::visit([&](const auto& shape) { make(shape, request, made); }, request.shape);
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
  scale(request, made);
  try {
    made.quality = quality_of_sound(made.mesh, made.names);
  } catch (const std::invalid_argument& error) {
    throw InputError(fmt::format("{}: {}{}", name_of(request), error.what(), advice(request)));
  }
  if (made.mesh.order > 1)
    made.fields["mean_curvature"] = meshing::node_mean_curvature(made.mesh).transpose();
  return made;
}

std::string report(const MadeMesh& made, const MeshRequest& request) {
  const meshing::Quality& q = made.quality;
  fmt::memory_buffer text;
  const auto line = [&](const char* name, const auto& value) {
    fmt::format_to(std::back_inserter(text), "{}: {}\n", name, value);
  };
  line("triangles", q.triangles);
  line("area", q.area);
  line("volume", q.volume);
  line("reduced_volume", q.reduced_volume);
  if (const auto bending = bending_of(made.mesh)) line("bending", *bending);
  if (const auto shape = shape_numbers(request)) {
    line("shape_area", shape->area);
    line("shape_volume", shape->volume);
    line("shape_bending", shape->bending);
  }
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
