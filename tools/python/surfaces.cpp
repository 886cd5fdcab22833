// Meshes of shapes, and frames of runs.
#include "studies/evolution/frame_file.h"
#include "studies/mesh/make_mesh.h"
#include "tools/python/bindings.h"

#include <cmath>

namespace sbeh::python {

namespace {

namespace fs = std::filesystem;
using meshing::CurvedMesh;
using studies::NodeFields;

// What lives on the nodes, one row a node.
py::dict fields_of(const NodeFields& fields) {
  py::dict all;
  for (const auto& [name, values] : fields)
    if (values.rows() == 1)
      all[py::str(name)] = Eigen::VectorXd(values.transpose());
    else
      all[py::str(name)] = Eigen::MatrixXd(values.transpose());
  return all;
}

py::dict dict_of(const CurvedMesh& mesh, const NodeFields& fields) {
  py::dict all;
  all["points"] = Eigen::MatrixXd(mesh.nodes.transpose());
  all["triangles"] = Eigen::MatrixXi(mesh.triangles.transpose());
  all["fields"] = fields_of(fields);
  return all;
}

py::dict dict_of(const meshing::Quality& q) {
  py::dict all;
  all["area"] = q.area;
  all["volume"] = q.volume;
  all["reduced_volume"] = q.reduced_volume;
  all["min_angle"] = q.min_angle;
  all["max_angle"] = q.max_angle;
  all["edge_ratio"] = q.edge_ratio;
  all["min_jacobian"] = q.min_jacobian;
  return all;
}

studies::MeshRequest request_of(const std::string& shape, const py::dict& of) {
  using Axes = std::optional<Eigen::Vector3d>;
  using Modes = std::vector<std::tuple<int, int, double>>;
  studies::MeshRequest request{.shape = studies::SphereShape{}};
  if (shape == "ellipsoid")
    request.shape = studies::EllipsoidShape{of["axes"].cast<Axes>(), of["prolate"].cast<bool>()};
  if (shape == "harmonic") {
    studies::HarmonicShape harmonic;
    for (const auto& [l, m, amplitude] : of["modes"].cast<Modes>())
      harmonic.modes.push_back({l, m, amplitude});
    request.shape = harmonic;
  }
  if (shape == "revolve") request.shape = studies::ProfileShape{of["path"].cast<fs::path>()};
  if (shape == "file")
    request.shape = studies::FileShape{of["path"].cast<fs::path>(), of["repair"].cast<bool>()};
  request.triangles = of["triangles"].cast<std::optional<int>>();
  request.order = of["order"].cast<std::optional<int>>();
  request.grading = of["grading"].cast<double>();
  request.area = of["area"].cast<std::optional<double>>();
  request.reduced_volume = of["reduced_volume"].cast<std::optional<double>>();
  return request;
}

py::dict mesh(const std::string& shape, const py::dict& of) {
  const auto request = request_of(shape, of);
  const studies::MadeMesh made = at_work([&] { return studies::make_mesh(request); });
  py::dict all = dict_of(made.mesh, made.fields);
  all["quality"] = dict_of(made.quality);
  all["notes"] = made.notes;
  return all;
}

void write_mesh(const fs::path& path, const Eigen::MatrixXd& points,
                const Eigen::MatrixXi& triangles,
                const std::map<std::string, Eigen::MatrixXd>& fields) {
  CurvedMesh mesh{.order = triangles.cols() == 3 ? 1
                         : triangles.cols() == 6 ? 2
                                                 : 3,
                  .triangles = triangles.transpose(),
                  .nodes = points.transpose()};
  NodeFields by_rows;
  for (const auto& [name, values] : fields) by_rows[name] = values.transpose();
  studies::write_mesh(path, mesh, by_rows);
}

// Also what a run needs besides to go on is there, but is nobody else's matter.
py::dict frame(const fs::path& path) {
  const auto moment = studies::read_frame(path);
  const auto curvature = surface3d::curvature_of(*moment.mesh, moment.state.X);
  if (!curvature) throw studies::InputError(path.string() + ": the surface is degenerate");
  NodeFields fields{{"order", moment.state.beta.transpose()},
                    {"mean_curvature", curvature->H.transpose()},
                    {"normal", curvature->node_normals}};
  if (moment.fields.V.size() > 0) fields["velocity"] = moment.fields.V;
  py::dict all = dict_of(studies::curved_mesh(moment), fields);
  all["time"] = moment.record.time;
  const auto physics = studies::physics_of_frame(path);
  all["model"] = physics ? py::cast(name(physics->model)) : py::none();
  all["material"] = physics ? py::cast(physics->material) : py::none();
  return all;
}

}  // namespace

void add_surfaces(py::module_& m) {
  m.def("mesh", mesh, py::arg("shape"), py::arg("of"));
  m.def("write_mesh", write_mesh, py::arg("path"), py::arg("points"), py::arg("triangles"),
        py::arg("fields"));
  m.def("read_frame", frame, py::arg("path"));
  m.def("small_triangles", [](int order) {
    Eigen::Matrix<int, Eigen::Dynamic, 3> all(order * order, 3);
    const auto small = meshing::small_triangles(order);
    for (std::size_t k = 0; k < small.size(); ++k) all.row(Eigen::Index(k)) = small[k];
    return all;
  });
}

}  // namespace sbeh::python
