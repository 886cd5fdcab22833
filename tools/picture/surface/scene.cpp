#include "tools/picture/surface/scene.h"

#include "model/numerics/lagrange.h"

#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <vector>

namespace sbeh::picture {

using Eigen::Vector3d;

namespace {

// So many parts per edge of a curved triangle: enough for smooth outlines.
int parts_for(int triangles) { return triangles > 10'000 ? 3 : triangles > 2000 ? 5 : 10; }

struct Sample {
  Eigen::VectorXd phi;
  Eigen::MatrixX2d dphi;
};

Sample sample_at(const model::TriangleElement& element, double x, double y) {
  const Eigen::Vector2d at(x, y);
  return {element.values(at), element.derivatives(at).transpose()};
}

Vector3d normal_at(const Eigen::Matrix3Xd& X, const Sample& s) {
  const Eigen::Matrix<double, 3, 2> dX = X * s.dphi;
  return dX.col(0).cross(dX.col(1)).normalized();
}

// Small plain triangles with the normals and colours of the curved ones.
vtkSmartPointer<vtkPolyData> surface_of(const meshing::CurvedMesh& mesh,
                                        const Eigen::VectorXd& values, const ColourMap& colours) {
  const int n = parts_for(mesh.triangle_count());
  const model::TriangleElement element(mesh.order);
  std::vector<Sample> samples;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i)
      samples.push_back(sample_at(element, double(i) / n, double(j) / n));
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  for (const auto c : mesh.triangles.colwise()) {
    const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, c);
    const Eigen::VectorXd f = values(c);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Sample& s : samples) {
      const Vector3d x = X * s.phi, normal = normal_at(X, s);
      const Colour colour = colours(f.dot(s.phi));
      points->InsertNextPoint(x.data());
      normals->InsertNextTuple(normal.data());
      rgb->InsertNextTuple3(colour.red, colour.green, colour.blue);
    }
    vtkIdType row = first;
    for (int j = 0; j < n; ++j) {
      const vtkIdType above = row + n - j + 1;
      for (int i = 0; i + j < n; ++i) {
        cells->InsertNextCell({row + i, row + i + 1, above + i});
        if (i + j + 1 < n) cells->InsertNextCell({row + i + 1, above + i + 1, above + i});
      }
      row = above;
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->SetScalars(rgb);
  return data;
}

// The curved edges, lifted a little so that the surface does not hide them.
vtkSmartPointer<vtkPolyData> edges_of(const meshing::CurvedMesh& mesh, double lift) {
  const int n = parts_for(mesh.triangle_count());
  const model::TriangleElement element(mesh.order);
  std::vector<Sample> side[3];
  for (int i = 0; i <= n; ++i) {
    const double x = double(i) / n;
    side[0].push_back(sample_at(element, x, 0));
    side[1].push_back(sample_at(element, 1 - x, x));
    side[2].push_back(sample_at(element, 0, 1 - x));
  }
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const auto c : mesh.triangles.colwise()) {
    const Eigen::Matrix3Xd X = mesh.nodes(Eigen::all, c);
    for (int k = 0; k < 3; ++k) {
      if (c[k] > c[(k + 1) % 3]) continue;  // once
      lines->InsertNextCell(n + 1);
      for (const Sample& s : side[k]) {
        const Vector3d x = X * s.phi + lift * normal_at(X, s);
        lines->InsertCellPoint(points->InsertNextPoint(x.data()));
      }
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

void add_light(vtkRenderer* renderer, const Vector3d& from, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(from[0], from[1], from[2]);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

// Half way between the least and the largest coordinates.
Vector3d middle_of(const meshing::CurvedMesh& mesh) {
  return (mesh.nodes.rowwise().maxCoeff() + mesh.nodes.rowwise().minCoeff()) / 2;
}

void set_camera(vtkRenderer* renderer, const Vector3d& middle, const View& view, double half_width,
                double height_by_width) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const Vector3d eye = middle + 10 * half_width * view.from.normalized();
  camera->SetFocalPoint(middle[0], middle[1], middle[2]);
  camera->SetPosition(eye[0], eye[1], eye[2]);
  camera->SetViewUp(view.up[0], view.up[1], view.up[2]);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(half_width * height_by_width);
  renderer->ResetCameraClippingRange();
}

}  // namespace

double radius_of(const meshing::CurvedMesh& mesh) {
  return (mesh.nodes.colwise() - middle_of(mesh)).colwise().norm().maxCoeff();
}

void draw_surface(Canvas& canvas, const Rect& cell, const meshing::CurvedMesh& mesh,
                  const Eigen::VectorXd& values, const ColourMap& colours, const View& view,
                  double half_width, Edges show_edges) {
  require_room(cell, 40.0, 40.0);
  const int width = int(cell.width), height = int(cell.height);
  vtkNew<vtkPolyDataMapper> surface_mapper, edge_mapper;
  surface_mapper->SetResolveCoincidentTopologyToPolygonOffset();
  surface_mapper->SetInputData(surface_of(mesh, values, colours));
  edge_mapper->SetInputData(edges_of(mesh, 0.0015 * half_width));
  vtkNew<vtkActor> surface, edges;
  surface->SetMapper(surface_mapper);
  surface->GetProperty()->SetAmbient(0.42);
  surface->GetProperty()->SetDiffuse(0.66);
  surface->GetProperty()->SetSpecular(0.10);
  surface->GetProperty()->SetSpecularPower(25);
  edges->SetMapper(edge_mapper);
  edges->GetProperty()->SetColor(0, 0, 0);
  edges->GetProperty()->SetOpacity(mesh.triangle_count() > 10'000 ? 0.2 : 0.45);
  edges->GetProperty()->SetLineWidth(mesh.triangle_count() > 2000 ? 1.0f : 1.4f);
  edges->GetProperty()->LightingOff();

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->AddActor(surface);
  if (show_edges == Edges::shown) renderer->AddActor(edges);
  renderer->AutomaticLightCreationOff();
  add_light(renderer, {-0.5, 0.7, 1}, 0.85);
  add_light(renderer, {1, -0.2, 0.6}, 0.3);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(8);
  window->SetSize(width, height);
  window->AddRenderer(renderer);
  set_camera(renderer, middle_of(mesh), view, half_width, double(height) / width);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  image->Update();
  canvas.image(image->GetOutput(), cell.x, cell.y);
}

}  // namespace sbeh::picture
