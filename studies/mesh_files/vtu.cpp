// Writing VTU: unstructured grid of Lagrange triangles, all arrays raw in one appended block.
#include "studies/mesh_files/bytes.h"
#include "studies/mesh_files/mesh_file.h"

#include <fmt/format.h>

#include <cstdint>

namespace sbeh::studies {

namespace {

constexpr std::uint8_t plain_triangle = 5, lagrange_triangle = 69;  // VTK's cell types

// The block and the XML elements that point into it.
class Appended {
 public:
  template <class T, class Values>
  std::string array(const char* type, const std::string& attributes, const Values& values) {
    const std::size_t offset = data.size();
    append_number(data, std::uint64_t(values.size() * sizeof(T)));
    for (const auto value : values) append_number(data, T(value));
    return fmt::format("<DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>\n", type,
                       attributes, offset);
  }
  std::string data;
};

std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name)
    if (c == '"')
      text += "&quot;";
    else if (c == '&')
      text += "&amp;";
    else if (c == '<')
      text += "&lt;";
    else
      text += c;
  return text;
}

}  // namespace

std::string vtu_text(const meshing::CurvedMesh& mesh, const NodeFields& fields,
                     const Globals& globals) {
  Appended appended;
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<UnstructuredGrid>\n");
  if (!globals.empty()) xml += "<FieldData>\n";
  for (const auto& [name, values] : globals)
    xml += appended.array<double>(
        "Float64", fmt::format("Name=\"{}\" NumberOfTuples=\"{}\"", escaped(name), values.size()),
        values);
  if (!globals.empty()) xml += "</FieldData>\n";
  xml += fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
                     mesh.node_count(), mesh.triangle_count());
  xml += appended.array<double>("Float64", "Name=\"Points\" NumberOfComponents=\"3\"",
                                mesh.nodes.reshaped());
  xml += "</Points>\n<Cells>\n";
  xml += appended.array<std::int64_t>("Int64", "Name=\"connectivity\"", mesh.triangles.reshaped());
  const auto per_cell = mesh.triangles.rows();
  const Eigen::VectorXi ends =
      Eigen::VectorXi::LinSpaced(mesh.triangle_count(), 1, mesh.triangle_count()) * per_cell;
  xml += appended.array<std::int64_t>("Int64", "Name=\"offsets\"", ends);
  const std::uint8_t type = mesh.order == 1 ? plain_triangle : lagrange_triangle;
  xml += appended.array<std::uint8_t>("UInt8", "Name=\"types\"",
                                      Eigen::VectorXi::Constant(mesh.triangle_count(), type));
  xml += "</Cells>\n<PointData>\n";
  for (const auto& [name, values] : fields)
    xml += appended.array<double>(
        "Float64",
        fmt::format("Name=\"{}\" NumberOfComponents=\"{}\"", escaped(name), values.rows()),
        values.reshaped());
  xml += "</PointData>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
  return xml + appended.data + "\n</AppendedData>\n</VTKFile>\n";
}

}  // namespace sbeh::studies
