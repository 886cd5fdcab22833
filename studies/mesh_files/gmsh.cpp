// Gmsh's .msh as text: read in the versions 2 and 4.1, written in 2.2, which all programs read. Curved triangles of
// order 2 and 3 have their points in the order of CurvedMesh.
#include "studies/io/errors.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace sbeh::studies {

namespace {

// An element type of Gmsh that is part of a surface.
struct FaceType {
  long type;
  int points, order;  // order 0: a polygon
};
constexpr FaceType face_types[] = {{2, 3, 1}, {3, 4, 0}, {9, 6, 2}, {21, 10, 3}};

struct Elements {
  std::unordered_map<long, int> place;  // of a point, by its number
  std::vector<double> points;
  std::vector<std::vector<int>> faces;
  std::vector<int> orders;  // of the faces
  int others = 0;
};

void add_point(const TextLines& lines, long number, std::size_t first_word, Elements& all) {
  if (!all.place.emplace(number, int(all.points.size() / 3)).second)
    lines.fail(fmt::format("node {} is there twice", number));
  for (std::size_t k = 0; k < 3; ++k) all.points.push_back(lines.number(first_word + k));
}

void add_element(const TextLines& lines, long type, std::size_t first_word, Elements& all) {
  const auto* const face = std::ranges::find(face_types, type, &FaceType::type);
  if (face == std::end(face_types)) {
    ++all.others;
    return;
  }
  std::vector<int> corners;
  for (int k = 0; k < face->points; ++k) {
    const long number = lines.integer(first_word + std::size_t(k));
    const auto found = all.place.find(number);
    if (found == all.place.end()) lines.fail(fmt::format("node {}: is not there", number));
    corners.push_back(found->second);
  }
  all.faces.push_back(std::move(corners));
  all.orders.push_back(face->order);
}

// ---- version 2 ----------------------------------------------------------------------------------

long count_of(TextLines& lines, std::size_t word, std::string_view what) {
  const long count = lines.integer(word);
  if (count < 0) lines.fail(fmt::format("the count of {} must be >= 0", what));
  return count;
}

void read_nodes_2(TextLines& lines, Elements& all) {
  lines.require_next("the nodes");
  const long count = count_of(lines, 0, "nodes");
  for (long k = 0; k < count; ++k) {
    lines.require_next(fmt::format("the nodes: {} of {}", k, count));
    add_point(lines, lines.integer(0), 1, all);
  }
}

void read_elements_2(TextLines& lines, Elements& all) {
  lines.require_next("the elements");
  const long count = count_of(lines, 0, "elements");
  for (long k = 0; k < count; ++k) {
    lines.require_next(fmt::format("the elements: {} of {}", k, count));
    add_element(lines, lines.integer(1), std::size_t(3 + count_of(lines, 2, "tags")), all);
  }
}

// ---- version 4.1: in blocks ---------------------------------------------------------------------

void read_nodes_4(TextLines& lines, Elements& all) {
  lines.require_next("the nodes");
  const long blocks = count_of(lines, 0, "blocks");
  for (long block = 0; block < blocks; ++block) {
    lines.require_next("the nodes");
    std::vector<long> numbers(std::size_t(count_of(lines, 3, "nodes")));
    for (long& number : numbers) {
      lines.require_next("the nodes");
      number = lines.integer(0);
    }
    for (const long number : numbers) {
      lines.require_next("the nodes");
      add_point(lines, number, 0, all);
    }
  }
}

void read_elements_4(TextLines& lines, Elements& all) {
  lines.require_next("the elements");
  const long blocks = count_of(lines, 0, "blocks");
  for (long block = 0; block < blocks; ++block) {
    lines.require_next("the elements");
    const long type = lines.integer(2), count = count_of(lines, 3, "elements");
    for (long k = 0; k < count; ++k) {
      lines.require_next("the elements");
      add_element(lines, type, 1, all);
    }
  }
}

// ---- all ----------------------------------------------------------------------------------------

int version_of(TextLines& lines) {
  if (!lines.next() || lines.words()[0] != "$MeshFormat")
    lines.fail("is no mesh of Gmsh: must begin with $MeshFormat");
  lines.require_next("$MeshFormat");
  const double version = lines.number(0);
  const bool is_known = (version >= 2 && version < 3) || (version >= 4.1 && version < 5);
  if (!is_known || lines.integer(1) != 0)
    lines.fail(
        fmt::format("version {}{}: must be text of version 2.2 or 4.1, as `gmsh -save -format "
                    "msh41 FILE` writes it",
                    version, lines.integer(1) != 0 ? ", binary" : ""));
  return version < 3 ? 2 : 4;
}

Eigen::Matrix3Xd points_of(const Elements& all) {
  return Eigen::Map<const Eigen::Matrix3Xd>(all.points.data(), 3,
                                            Eigen::Index(all.points.size() / 3));
}

// Points that no face has, such as the centres of arcs, are no part of the surface.
MeshFile surface_of(const Elements& all, const std::string& file) {
  std::vector<std::string> notes = left_out(all.others, "points, lines or solids");
  const int order = all.orders.empty() ? 1 : all.orders.front();
  if (std::ranges::all_of(all.orders, [](int k) { return k < 2; })) {
    MeshBuilder mesh;
    for (std::size_t k = 0; k < all.points.size(); k += 3)
      mesh.add_point(all.points[k], all.points[k + 1], all.points[k + 2]);
    for (const auto& face : all.faces) mesh.add_face(face);
    return {PlainFile{mesh.mesh()}, std::move(notes)};
  }
  if (std::ranges::any_of(all.orders, [&](int k) { return k != order; }))
    throw InputError(fmt::format("{}: has faces of several orders: must be of one", file));
  CurvedCellsFile cells;
  cells.cells.points = points_of(all);
  cells.cells.cells.resize(Eigen::Index(all.faces.front().size()), Eigen::Index(all.faces.size()));
  for (std::size_t k = 0; k < all.faces.size(); ++k)
    cells.cells.cells.col(Eigen::Index(k)) =
        Eigen::Map<const Eigen::VectorXi>(all.faces[k].data(), Eigen::Index(all.faces[k].size()));
  return {std::move(cells), std::move(notes)};
}

}  // namespace

MeshFile parse_gmsh(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  const int version = version_of(lines);
  Elements all;
  while (lines.next()) {
    const std::string_view section = lines.words()[0];
    if (section == "$Nodes")
      version == 2 ? read_nodes_2(lines, all) : read_nodes_4(lines, all);
    else if (section == "$Elements")
      version == 2 ? read_elements_2(lines, all) : read_elements_4(lines, all);
  }
  return surface_of(all, file);
}

std::string gmsh_text(const meshing::CurvedMesh& mesh, const NodeFields& fields) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", mesh.node_count());
  for (int k = 0; k < mesh.node_count(); ++k)
    fmt::format_to(out, "{} {} {} {}\n", k + 1, mesh.nodes(0, k), mesh.nodes(1, k),
                   mesh.nodes(2, k));
  const auto* const type = std::ranges::find(face_types, mesh.order, &FaceType::order);
  fmt::format_to(out, "$EndNodes\n$Elements\n{}\n", mesh.triangle_count());
  for (int k = 0; k < mesh.triangle_count(); ++k) {
    fmt::format_to(out, "{} {} 2 1 1", k + 1, type->type);
    for (const int node : mesh.triangles.col(k)) fmt::format_to(out, " {}", node + 1);
    fmt::format_to(out, "\n");
  }
  fmt::format_to(out, "$EndElements\n");
  for (const auto& [name, values] : fields) {
    if (values.rows() != 1 && values.rows() != 3) continue;  // Gmsh has no others
    fmt::format_to(out, "$NodeData\n1\n\"{}\"\n1\n0\n3\n0\n{}\n{}\n", name, values.rows(),
                   values.cols());
    for (Eigen::Index k = 0; k < values.cols(); ++k) {
      fmt::format_to(out, "{}", k + 1);
      for (const double value : values.col(k)) fmt::format_to(out, " {}", value);
      fmt::format_to(out, "\n");
    }
    fmt::format_to(out, "$EndNodeData\n");
  }
  return fmt::to_string(text);
}

}  // namespace sbeh::studies
