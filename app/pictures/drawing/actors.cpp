#include "app/pictures/drawing/internal/actors.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace isopatch::app {
namespace {

vtkSmartPointer<vtkPoints> points_of(const Eigen::Matrix3Xd& columns) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(columns.cols());
  for (Eigen::Index i = 0; i < columns.cols(); ++i)
    points->SetPoint(i, columns(0, i), columns(1, i), columns(2, i));
  return points;
}

template <std::size_t Corners>
vtkSmartPointer<vtkCellArray> cells_of(const std::vector<std::array<int, Corners>>& all) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& corners : all) {
    cells->InsertNextCell(static_cast<int>(Corners));
    for (const int corner : corners) cells->InsertCellPoint(corner);
  }
  return cells;
}

vtkSmartPointer<vtkLookupTable> table_of(const std::vector<Colour>& palette) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(palette.size()));
  table->SetTableRange(0, 1);
  for (std::size_t i = 0; i < palette.size(); ++i)
    table->SetTableValue(static_cast<vtkIdType>(i), palette[i].red / 255.0, palette[i].green / 255.0,
                         palette[i].blue / 255.0);
  return table;
}

vtkSmartPointer<vtkPolyData> data_of(const Surface& surface) {
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(surface.normals.cols());
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfTuples(surface.values.size());
  for (Eigen::Index i = 0; i < surface.values.size(); ++i) {
    normals->SetTuple3(i, surface.normals(0, i), surface.normals(1, i), surface.normals(2, i));
    values->SetValue(i, surface.values[i]);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_of(surface.points));
  data->SetPolys(cells_of(surface.triangles));
  data->GetPointData()->SetNormals(normals);
  data->GetPointData()->SetScalars(values);
  return data;
}

}  // namespace

vtkSmartPointer<vtkActor> surface_actor(const Surface& surface, const std::vector<Colour>& palette) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data_of(surface));
  mapper->SetLookupTable(table_of(palette));
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOn();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToPhong();
  actor->GetProperty()->SetAmbient(0.55);
  actor->GetProperty()->SetDiffuse(0.58);
  actor->GetProperty()->SetSpecular(0.04);
  actor->GetProperty()->SetSpecularPower(20);
  return actor;
}

vtkSmartPointer<vtkActor> lines_actor(const Lines& lines, double width, const Colour& colour,
                                      const Eigen::Vector3d& shift) {
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_of(lines.points));
  data->SetLines(cells_of(lines.segments));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
  actor->SetPosition(shift.x(), shift.y(), shift.z());
  actor->GetProperty()->SetLineWidth(static_cast<float>(width));
  actor->GetProperty()->LightingOff();
  return actor;
}

vtkSmartPointer<vtkActor2D> polygons_actor(const std::vector<PicturePolygon>& polygons, double scale) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  for (const PicturePolygon& polygon : polygons) {
    cells->InsertNextCell(static_cast<int>(polygon.corners.size()));
    for (const Eigen::Vector2d& corner : polygon.corners)
      cells->InsertCellPoint(points->InsertNextPoint(scale * corner.x(), scale * corner.y(), 0));
    colours->InsertNextTuple3(polygon.colour.red, polygon.colour.green, polygon.colour.blue);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkCoordinate> pixels;
  pixels->SetCoordinateSystemToDisplay();
  mapper->SetTransformCoordinate(pixels);
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor2D> text_actor(const PictureText& text, double scale) {
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.text.c_str());
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetFontFamilyToArial();
  style->SetFontSize(static_cast<int>(std::lround(scale * text.font)));
  style->SetColor(text.colour.red / 255.0, text.colour.green / 255.0, text.colour.blue / 255.0);
  if (text.align == Align::left) style->SetJustificationToLeft();
  if (text.align == Align::centre) style->SetJustificationToCentered();
  if (text.align == Align::right) style->SetJustificationToRight();
  style->SetVerticalJustificationToCentered();
  actor->SetDisplayPosition(static_cast<int>(std::lround(scale * text.x)),
                            static_cast<int>(std::lround(scale * text.y)));
  return actor;
}

}  // namespace isopatch::app
