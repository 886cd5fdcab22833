// Reading VTK's XML files with VTK's own readers: all their encodings and compressions.
#include "studies/io/errors.h"
#include "studies/mesh_files/formats.h"
#include "studies/mesh_files/vtk_cells.h"

#include <fmt/format.h>
#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <algorithm>
#include <vector>

namespace sbeh::studies {

namespace {

Eigen::Matrix3Xd points_of(vtkDataSet& data) {
  Eigen::Matrix3Xd points(3, data.GetNumberOfPoints());
  for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) data.GetPoint(i, points.col(i).data());
  return points;
}

std::vector<VtkCell> cells_of(vtkDataSet& data) {
  std::vector<VtkCell> cells(std::size_t(data.GetNumberOfCells()));
  vtkNew<vtkIdList> ids;
  for (std::size_t t = 0; t < cells.size(); ++t) {
    data.GetCellPoints(vtkIdType(t), ids);
    cells[t] = {data.GetCellType(vtkIdType(t)), {ids->begin(), ids->end()}};
  }
  return cells;
}

// By name: components x tuples.
NodeFields arrays_of(vtkFieldData& data) {
  NodeFields fields;
  for (int a = 0; a < data.GetNumberOfArrays(); ++a) {
    vtkDataArray* array = data.GetArray(a);
    if (!array || !array->GetName()) continue;
    Eigen::MatrixXd values(array->GetNumberOfComponents(), array->GetNumberOfTuples());
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      array->GetTuple(i, values.col(i).data());
    fields[array->GetName()] = values;
  }
  return fields;
}

// Throws with the first error VTK reports, and keeps VTK from printing it.
template <class Reader>
MeshFile read(const std::string& file) {
  vtkNew<Reader> reader;
  std::string first_error;
  vtkNew<vtkCallbackCommand> remember;
  remember->SetClientData(&first_error);
  remember->SetCallback([](vtkObject*, unsigned long, void* data, void* text) {
    auto& error = *static_cast<std::string*>(data);
    if (error.empty() && text) error = static_cast<const char*>(text);
  });
  reader->AddObserver(vtkCommand::ErrorEvent, remember);
  vtkOutputWindow::GetInstance()->SetDisplayModeToNever();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  reader->SetFileName(file.c_str());
  reader->Update();
  if (!first_error.empty() || reader->GetErrorCode() != 0)
    throw InputError(fmt::format("{}: is damaged or cut off: VTK cannot read it", file));
  vtkDataSet& data = *reader->GetOutput();
  MeshFile result = mesh_of(points_of(data), cells_of(data), file);
  if (auto* curved = std::get_if<CurvedCellsFile>(&result.mesh)) {
    curved->fields = arrays_of(*data.GetPointData());
    curved->globals = arrays_of(*data.GetFieldData());
  }
  return result;
}

// Of the attribute `type` of the outermost element.
std::string_view type_of(std::string_view text, std::size_t element) {
  constexpr std::string_view begin = "type=\"";
  text = text.substr(element, text.find('>', element) - element);
  const std::size_t at = text.find(begin);
  if (at == std::string_view::npos) return {};
  text.remove_prefix(at + begin.size());
  return text.substr(0, text.find('"'));
}

}  // namespace

MeshFile parse_vtk_xml(std::string_view text, const std::string& file) {
  const std::size_t element = text.find("<VTKFile");
  if (element == std::string_view::npos)
    throw InputError(fmt::format("{}: is no file of VTK: neither XML nor a legacy one", file));
  constexpr std::size_t end = 100;
  if (text.find("</VTKFile>", text.size() - std::min(text.size(), end)) == std::string_view::npos)
    throw InputError(fmt::format("{}: is cut off: does not end with </VTKFile>", file));
  const std::string_view type = type_of(text, element);
  if (type == "PolyData") return read<vtkXMLPolyDataReader>(file);
  if (type == "UnstructuredGrid") return read<vtkXMLUnstructuredGridReader>(file);
  throw InputError(
      fmt::format("{}: holds \"{}\", not PolyData or UnstructuredGrid: export the surface alone",
                  file, type.substr(0, 40)));
}

}  // namespace sbeh::studies
