// TSI, the triangulated surfaces of FreeDTS and TS2CG: `version`, `box a b c`, and numbered lists `vertex`,
// `triangle`, `inclusion`, `exclusion`. Coordinates are in the periodic box, 0 … a.
#include "studies/io/errors.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/text_lines.h"

#include <fmt/format.h>

#include <cmath>
#include <queue>
#include <unordered_map>

namespace sbeh::studies {

namespace {

struct Tsi {
  Eigen::Vector3d box = Eigen::Vector3d::Zero();  // 0: none
  std::unordered_map<long, int> place;            // of a vertex, by its number
  MeshBuilder mesh;
  int others = 0;
};

void read_vertices(TextLines& lines, long count, Tsi& tsi) {
  for (long k = 0; k < count; ++k) {
    lines.require_next(fmt::format("the vertices: {} of {}", k, count));
    if (!tsi.place.emplace(lines.integer(0), int(tsi.mesh.point_count())).second)
      lines.fail(fmt::format("vertex {} is there twice", lines.integer(0)));
    tsi.mesh.add_point(lines.number(1), lines.number(2), lines.number(3));
  }
}

void read_triangles(TextLines& lines, long count, Tsi& tsi) {
  for (long k = 0; k < count; ++k) {
    lines.require_next(fmt::format("the triangles: {} of {}", k, count));
    std::vector<int> corners;
    for (const std::size_t word : {1, 2, 3}) {
      const auto found = tsi.place.find(lines.integer(word));
      if (found == tsi.place.end())
        lines.fail(fmt::format("corner {}: there is no such vertex", lines.integer(word)));
      corners.push_back(found->second);
    }
    tsi.mesh.add_face(std::move(corners));
  }
}

// Puts every point beside its neighbours, where an edge leads across the border of the box: whether one did.
bool unwrap(const Eigen::Vector3d& box, meshing::PolygonMesh& mesh) {
  std::vector<std::vector<int>> neighbours(std::size_t(mesh.point_count()));
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      neighbours[std::size_t(face[k])].push_back(face[(k + 1) % face.size()]);
  std::vector<bool> placed(neighbours.size());
  bool across = false;
  for (int first = 0; first < mesh.point_count(); ++first) {
    std::queue<int> next;
    if (!placed[std::size_t(first)]) next.push(first);
    placed[std::size_t(first)] = true;
    for (; !next.empty(); next.pop())
      for (const int q : neighbours[std::size_t(next.front())]) {
        if (placed[std::size_t(q)]) continue;
        placed[std::size_t(q)] = true;
        const Eigen::Vector3d away = mesh.points.col(q) - mesh.points.col(next.front());
        const Eigen::Vector3d boxes = (away.array() / box.array()).round();
        across = across || !boxes.isZero();
        mesh.points.col(q) -= boxes.cwiseProduct(box);
        next.push(q);
      }
  }
  return across;
}

}  // namespace

MeshFile parse_tsi(std::string_view text, const std::string& file) {
  TextLines lines(text, file);
  Tsi tsi;
  while (lines.next()) {
    const std::string_view first = lines.words()[0];
    if (first == "version") continue;
    if (first == "box") {
      for (const int k : {0, 1, 2}) tsi.box[k] = lines.number(std::size_t(k) + 1);
      if (!(tsi.box.minCoeff() > 0 && tsi.box.allFinite()))
        lines.fail("box: its lengths must be > 0");
      continue;
    }
    const bool known =
        first == "vertex" || first == "triangle" || first == "inclusion" || first == "exclusion";
    if (!known)
      lines.fail(
          fmt::format("\"{}\": must be version, box, vertex, triangle, inclusion or exclusion",
                      first.substr(0, 40)));
    const bool is_mesh = first == "vertex" || first == "triangle";
    const bool is_vertices = first == "vertex";
    const long count = lines.integer(1);
    if (count < 0) lines.fail("the count must be >= 0");
    if (!is_mesh)
      for (long k = 0; k < count; ++k, ++tsi.others) lines.require_next("inclusions");
    else if (is_vertices)
      read_vertices(lines, count, tsi);
    else
      read_triangles(lines, count, tsi);
  }
  meshing::PolygonMesh mesh = tsi.mesh.mesh();
  std::vector<std::string> notes;
  if (tsi.others > 0)
    notes.push_back(fmt::format("{} inclusions or exclusions left out", tsi.others));
  if (!tsi.box.isZero() && mesh.points.allFinite() && unwrap(tsi.box, mesh))
    notes.emplace_back("is put together across the borders of its box");
  return {PlainFile{std::move(mesh)}, std::move(notes)};
}

// In the middle of a cube of twice its length.
std::string tsi_text(const meshing::TriangleMesh& mesh) {
  const Eigen::Vector3d low = mesh.points.rowwise().minCoeff(),
                        high = mesh.points.rowwise().maxCoeff();
  const double box = 2 * (high - low).maxCoeff();
  const Eigen::Vector3d shift = Eigen::Vector3d::Constant(box / 2) - (low + high) / 2;
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "version 1.1\nbox {0} {0} {0}\nvertex {1}\n", box, mesh.point_count());
  for (int k = 0; k < mesh.point_count(); ++k) {
    const Eigen::Vector3d x = mesh.points.col(k) + shift;
    fmt::format_to(out, "{} {} {} {}\n", k, x[0], x[1], x[2]);
  }
  fmt::format_to(out, "triangle {}\n", mesh.triangle_count());
  for (int k = 0; k < mesh.triangle_count(); ++k) {
    const auto c = mesh.triangles.col(k);
    fmt::format_to(out, "{} {} {} {}\n", k, c[0], c[1], c[2]);
  }
  return fmt::to_string(text) + "inclusion 0\n";
}

}  // namespace sbeh::studies
