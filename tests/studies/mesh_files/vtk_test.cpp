// VTK's files, XML and legacy, with all kinds of cells.
#include "meshing/polygon_cutting.h"
#include "meshing/shapes.h"
#include "studies/mesh_files/formats.h"
#include "tests/studies/mesh_files/tetrahedron.h"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <array>

namespace sbeh::studies {
namespace {

namespace fs = std::filesystem;
using test::expect_a_tetrahedron;
using test::replaced;
using VtkFile = test::MeshFileTest;

// A file of VTK with these cells of the tetrahedron's points.
std::string vtu(std::string_view connectivity, std::string_view offsets, std::string_view types,
                int cells) {
  return fmt::format(
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"><UnstructuredGrid>"
      "<Piece NumberOfPoints=\"4\" NumberOfCells=\"{}\"><Points><DataArray type=\"Float64\" "
      "NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0 0 0 "
      "1</DataArray></Points><Cells>"
      "<DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">{}</DataArray>"
      "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">{}</DataArray>"
      "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">{}</DataArray>"
      "</Cells></Piece></UnstructuredGrid></VTKFile>",
      cells, connectivity, offsets, types);
}

TEST_F(VtkFile, has_its_faces_read_and_is_told_what_is_left_out) {
  const fs::path plain = write("a.vtu", vtu("0 2 1 0 1 3 0 3 2 1 2 3", "3 6 9 12", "5 5 5 5", 4));
  expect_a_tetrahedron(plain);
  EXPECT_TRUE(read_mesh(plain).notes.empty());
  const fs::path mixed = write("b.vtu", vtu("0 0 1 0 2 1 1 2 0 1 3 0 3 2 1 2 3 0 1 2",
                                            "1 3 6 8 11 14 17 20", "1 3 5 3 7 5 5 4", 8));
  expect_a_tetrahedron(mixed);
  EXPECT_NE(read_mesh(mixed).notes.at(0).find("4 points or lines left out"), std::string::npos);
  EXPECT_EQ(std::get<PlainFile>(read_mesh(mixed).mesh).mesh.names.triangles,
            (std::vector{2, 4, 5, 6}));
  expect_a_tetrahedron(write("c.vtu", vtu("0 2 1 3 0 2", "6", "6", 1)));  // a strip
  EXPECT_TRUE(refusal("d.vtu", vtu("0 1 2 3", "4", "10", 1))
                  .starts_with(": cell 0 (VTK's type 10, 4 points): must be a triangle"));
  EXPECT_TRUE(refusal("e.vtu", vtu("0 1 1 2", "2 4", "3 3", 2)).starts_with(": has no triangles"));
}

TEST_F(VtkFile, has_quadrilaterals_polygons_and_pixels_read_as_polygons) {
  const std::string points =
      "# vtk DataFile Version 2.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 int\n"
      "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1\n";
  const std::string around = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n",
                    by_rows = "4 0 2 1 3\n4 4 5 6 7\n4 0 1 4 5\n4 2 6 3 7\n4 0 4 2 6\n4 1 3 5 7\n";
  for (const auto& [type, cells] : {std::pair(7, around), {9, around}, {8, by_rows}}) {
    const std::string text = fmt::format(
        "{0}CELLS 6 30\n{1}CELL_TYPES 6\n{2} {2} {2} {2} {2} {2}\n", points, cells, type);
    const MeshFile mesh = read_mesh(write("a.vtk", text));
    const auto& cube = std::get<PlainFile>(mesh.mesh).mesh;
    EXPECT_EQ(cube.face_count(), 6);
    EXPECT_EQ(first_polygon(cube), 0);
    meshing::TriangleMesh cut{cube.points, Eigen::Matrix3Xi(3, 12)};
    for (Eigen::Index face = 0; face < 6; ++face)
      for (Eigen::Index k = 0; k < 2; ++k)
        cut.triangles.col(2 * face + k) =
            Eigen::Vector3i(meshing::cut_into_triangles(cube.points, cube.faces[std::size_t(face)])
                                .at(std::size_t(k))
                                .data());
    EXPECT_FALSE(meshing::find_defect(cut)) << type;
    EXPECT_NEAR(meshing::volume(cut), 1, 1e-15) << type;
  }
}

// What VTK's own writers make of it: text and binary, as before version 5 and since.
template <class Writer, class Data>
std::vector<std::string> legacy_texts(Data* data) {
  std::vector<std::string> texts;
  for (const int version : {42, 51})
    for (const bool binary : {false, true}) {
      vtkNew<Writer> writer;
      writer->SetInputData(data);
      writer->SetFileVersion(version);
      if (binary)
        writer->SetFileTypeToBinary();
      else
        writer->SetFileTypeToASCII();
      writer->WriteToOutputStringOn();
      writer->Write();
      texts.push_back(writer->GetOutputStdString());
    }
  return texts;
}

vtkNew<vtkPoints> corners(int data_type) {
  vtkNew<vtkPoints> points;
  points->SetDataType(data_type);
  for (const auto& x : {std::array{0., 0., 0.}, {1., 0., 0.}, {0., 1., 0.}, {0., 0., 1.}})
    points->InsertNextPoint(x.data());
  return points;
}

constexpr vtkIdType faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
constexpr vtkIdType edge[2] = {0, 1};

TEST_F(VtkFile, of_the_legacy_kind_is_read_as_vtk_writes_polydata) {
  for (const int data_type : {VTK_FLOAT, VTK_DOUBLE, VTK_INT}) {
    vtkNew<vtkPolyData> data;
    const auto points = corners(data_type);
    data->SetPoints(points);
    vtkNew<vtkCellArray> polygons, vertices, lines;
    for (const auto& face : faces) polygons->InsertNextCell(3, face);
    vertices->InsertNextCell(1, edge);
    lines->InsertNextCell(2, edge);
    data->SetPolys(polygons);
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("height of the points");
    heights->SetNumberOfValues(4);
    heights->Fill(0.25);
    data->GetPointData()->AddArray(heights);
    data->GetFieldData()->AddArray(heights);
    for (const std::string& text : legacy_texts<vtkPolyDataWriter>(data.Get())) {
      expect_a_tetrahedron(write("a.vtk", text));
      expect_a_tetrahedron(write("legacy.vtp", text));  // told by what is in it
    }
    data->SetVerts(vertices);
    data->SetLines(lines);
    for (const std::string& text : legacy_texts<vtkPolyDataWriter>(data.Get())) {
      const fs::path file = write("a.vtk", text);
      expect_a_tetrahedron(file);
      const MeshFile mesh = read_mesh(file);
      EXPECT_NE(mesh.notes.at(0).find("2 points or lines left out"), std::string::npos);
      EXPECT_EQ(std::get<PlainFile>(mesh.mesh).mesh.names.triangles, (std::vector{2, 3, 4, 5}));
    }
    vtkNew<vtkCellArray> none, strips;
    data->SetPolys(none);
    strips->InsertNextCell({0, 2, 1, 3, 0, 2});
    data->SetStrips(strips);
    for (const std::string& text : legacy_texts<vtkPolyDataWriter>(data.Get()))
      expect_a_tetrahedron(write("a.vtk", text));
  }
}

TEST_F(VtkFile, of_the_legacy_kind_keeps_curved_triangles_to_the_bit) {
  for (const int order : {2, 3}) {
    const meshing::CurvedMesh mesh =
        meshing::ellipsoid({1, 1.3, 0.7}, {.triangles = 80, .order = order});
    write_mesh(path("m.vtu"), mesh);
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(path("m.vtu").c_str());
    reader->Update();
    for (const std::string& text : legacy_texts<vtkUnstructuredGridWriter>(reader->GetOutput())) {
      const auto back = read_curved_mesh(write("m.vtk", text));
      ASSERT_TRUE(back);
      EXPECT_EQ(back->mesh.triangles, mesh.triangles);
      const bool binary = text.find("BINARY") != std::string::npos;
      EXPECT_LE((back->mesh.nodes - mesh.nodes).cwiseAbs().maxCoeff(), binary ? 0 : 1e-10);
    }
  }
}

const std::string legacy_tetrahedron =
    "# vtk DataFile Version 3.0\nby hand\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0\n"
    "0 1 0 0 0 1\nPOLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

TEST_F(VtkFile, of_the_legacy_kind_is_read_as_others_write_it) {
  const std::string& text = legacy_tetrahedron;
  const std::string points = text.substr(0, text.find("POLYGONS")),
                    grid = replaced(points, "POLYDATA", "UNSTRUCTURED_GRID");
  for (const std::string& variant :
       {text, replaced(text, "\n", "\r\n"), replaced(text, "\n", "\r"), "\xef\xbb\xbf" + text,
        replaced(replaced(text, "ASCII", "ascii"), "POLYGONS", "polygons"),
        replaced(text, "0 0 1\n", "0 0 1 "), text.substr(0, text.size() - 1),
        replaced(text, "POINTS", "FIELD FieldData 1\nname%20it 2 1 int\n1 2\nPOINTS"),
        replaced(text, "POLYGONS", "METADATA\nINFORMATION 0\n\nPOLYGONS"),
        text + "POINT_DATA 4\nSCALARS s float 1\nLOOKUP_TABLE default\n1 2 3 4\n",
        text + "CELL_DATA 4\nnonsense\n",
        points + "VERTICES 1 2\n1 0\nTRIANGLE_STRIPS 1 7\n6 0 2 1 3 0 2\n",
        grid + "CELLS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\nCELL_TYPES 4\n5\n5 5 5",
        grid + "CELL_TYPES 2\n6 1\nCELLS 2 9\n6 0 2 1 3 0 2 1 0\n"})
    expect_a_tetrahedron(write("a.vtk", variant));
}

TEST_F(VtkFile, of_the_legacy_kind_that_is_wrong_is_refused_where_it_is) {
  const std::string& text = legacy_tetrahedron;
  const auto said = [&](std::string_view from, std::string_view to) {
    return refusal("a.vtk", replaced(text, from, to));
  };
  EXPECT_TRUE(said("ASCII", "ASCI").starts_with(":3: \"asci\": must be ASCII or BINARY"));
  EXPECT_TRUE(said("POLYDATA", "STRUCTURED_GRID").starts_with(":4: holds \"structured_grid\""));
  EXPECT_TRUE(said("4 float", "5 float").starts_with(":8: points: \"POLYGONS\": must be a number"));
  EXPECT_TRUE(said("4 float", "-4 float").starts_with(":5: points: -4: must be"));
  EXPECT_TRUE(said("4 float", "99999999 float").starts_with(":5: is cut off: points must have"));
  EXPECT_TRUE(said("float", "real").starts_with(":5: \"real\": unknown type"));
  EXPECT_TRUE(
      said("POLYGONS 4 16", "POLYGONS 7 16").starts_with(":12: polygons: cell 4: has more"));
  EXPECT_TRUE(
      said("POLYGONS 4 16", "POLYGONS 3 16").starts_with(":12: polygons: 3 cells have fewer"));
  EXPECT_TRUE(said("3 1 2 3", "3 1 2 nan").starts_with(":12: polygons: nan: must be an integer"));
  EXPECT_TRUE(said("3 1 2 3", "-3 1 2 3").starts_with(":12: polygons: cell 3: has more points"));
  EXPECT_TRUE(said("3 1 2 3", "3 1 2 4").starts_with(": cell 3: point 4: there are only 4"));
  EXPECT_TRUE(said("POLYGONS", "POLYGON").starts_with(":8: \"polygon\": unknown keyword"));
  EXPECT_TRUE(said("# vtk", "# VTX").starts_with(": is no file of VTK"));
}

TEST_F(VtkFile, of_the_legacy_kind_that_is_cut_off_or_damaged_anywhere_does_no_harm) {
  vtkNew<vtkUnstructuredGrid> grid;
  const auto points = corners(VTK_DOUBLE);
  grid->SetPoints(points);
  for (const auto& face : faces) grid->InsertNextCell(VTK_TRIANGLE, 3, face);
  for (const std::string& text : legacy_texts<vtkUnstructuredGridWriter>(grid.Get())) {
    const std::size_t body = text.find("DATASET"), end = text.rfind('5');  // of the last type
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (at <= end && text.find("BINARY") == std::string::npos) {
        EXPECT_NE(refusal("a.vtk", text.substr(0, at)), "was not refused") << at;
      }
      for (const char c : {'\0', '9', '\xff', '-'}) {
        std::string damaged = text;
        damaged[at] = c;
        if (at > body) refusal("b.vtk", damaged);  // whatever it is
      }
    }
  }
}

}  // namespace
}  // namespace sbeh::studies
