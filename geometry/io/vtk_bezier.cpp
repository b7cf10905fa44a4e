#include "geometry/io/vtk_bezier.hpp"

#include <fmt/format.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkHigherOrderHexahedron.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <filesystem>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "geometry/base/error.hpp"
#include "geometry/splines/knot_vector.hpp"

namespace isopatch::geometry {
namespace {

[[noreturn]] void reject(const std::string& message) {
  throw Error(ErrorCode::invalid_argument, "Bezier cells: " + message);
}

Eigen::Index points_per_cell(const BezierCells& cells) {
  Eigen::Index count = 1;
  for (const int p : cells.degree) {
    if (p < 1 || p > KnotVector::max_degree)
      reject(fmt::format("degree {} is outside 1 .. {}", p, KnotVector::max_degree));
    count *= p + 1;
  }
  return count;
}

void check_fields(const std::vector<BezierField>& fields, Eigen::Index count, const char* of) {
  std::set<std::string> names = {"RationalWeights", "HigherOrderDegrees"};
  for (const BezierField& field : fields) {
    if (field.name.empty()) reject("a field has no name");
    if (!names.insert(field.name).second) reject(fmt::format("the field name '{}' is taken", field.name));
    if (field.values.cols() != count || field.values.rows() < 1)
      reject(fmt::format("field '{}' has {} x {} values for {} {}", field.name, field.values.rows(),
                         field.values.cols(), count, of));
    if (!field.values.allFinite())
      reject(fmt::format("field '{}' has a value that is not finite", field.name));
  }
}

void check(const BezierCells& cells) {
  const Eigen::Index count = points_per_cell(cells) * cells.cell_count;
  if (cells.cell_count < 0 || cells.points.cols() != count || cells.weights.size() != count)
    reject(fmt::format("{} points and {} weights for {} cells of degree {} x {} x {}, which need {}",
                       cells.points.cols(), cells.weights.size(), cells.cell_count, cells.degree[0],
                       cells.degree[1], cells.degree[2], count));
  if (!cells.points.allFinite()) reject("a point is not finite");
  if (!cells.weights.allFinite() || !(cells.weights.array() > 0).all()) reject("a weight is not positive");
  check_fields(cells.point_fields, count, "points");
  check_fields(cells.cell_fields, cells.cell_count, "cells");
}

// Entry t: where the point at tensor index t of a cell stands in VTK's order (corners, edges, faces, inside).
std::vector<vtkIdType> vtk_positions(const std::array<int, 3>& degree) {
  std::vector<vtkIdType> result;
  for (int k = 0; k <= degree[2]; ++k)
    for (int j = 0; j <= degree[1]; ++j)
      for (int i = 0; i <= degree[0]; ++i)
        result.push_back(vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, degree.data()));
  return result;
}

vtkNew<vtkDoubleArray> array(const std::string& name, const Eigen::MatrixXd& values) {
  vtkNew<vtkDoubleArray> result;
  result->SetName(name.c_str());
  result->SetNumberOfComponents(static_cast<int>(values.rows()));
  result->SetNumberOfTuples(values.cols());
  std::copy(values.data(), values.data() + values.size(), result->GetPointer(0));
  return result;
}

// Points keep the tensor order; the cells list them in VTK's.
vtkNew<vtkCellArray> connectivity(const BezierCells& cells) {
  const std::vector<vtkIdType> positions = vtk_positions(cells.degree);
  const auto count = static_cast<vtkIdType>(positions.size());
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> points;
  offsets->SetNumberOfValues(cells.cell_count + 1);
  points->SetNumberOfValues(cells.cell_count * count);
  for (vtkIdType c = 0; c <= cells.cell_count; ++c) offsets->SetValue(c, c * count);
  for (vtkIdType c = 0; c < cells.cell_count; ++c)
    for (vtkIdType t = 0; t < count; ++t)
      points->SetValue(c * count + positions[static_cast<std::size_t>(t)], c * count + t);
  vtkNew<vtkCellArray> result;
  result->SetData(offsets, points);
  return result;
}

vtkNew<vtkUnstructuredGrid> grid(const BezierCells& cells) {
  vtkNew<vtkUnstructuredGrid> result;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(array("Points", cells.points));
  result->SetPoints(points);
  result->SetCells(VTK_BEZIER_HEXAHEDRON, connectivity(cells));
  result->GetPointData()->SetRationalWeights(array("RationalWeights", cells.weights.transpose()));
  const Eigen::Vector3d degree(cells.degree[0], cells.degree[1], cells.degree[2]);
  result->GetCellData()->SetHigherOrderDegrees(
      array("HigherOrderDegrees", degree.replicate(1, cells.cell_count)));
  for (const BezierField& field : cells.point_fields)
    result->GetPointData()->AddArray(array(field.name, field.values));
  for (const BezierField& field : cells.cell_fields)
    result->GetCellData()->AddArray(array(field.name, field.values));
  return result;
}

}  // namespace

std::string to_vtu(const BezierCells& cells) {
  check(cells);
  const vtkNew<vtkUnstructuredGrid> data = grid(cells);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(data);
  writer->WriteToOutputStringOn();
  writer->SetDataModeToAppended();
  writer->SetCompressorTypeToZLib();
  if (writer->Write() != 1) throw Error(ErrorCode::internal, "VTK could not write an unstructured grid");
  return writer->GetOutputString();
}

std::string to_vtm(const std::vector<std::pair<std::string, std::string>>& blocks) {
  pugi::xml_document document;
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = "vtkMultiBlockDataSet";
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = "LittleEndian";
  pugi::xml_node collection = file.append_child("vtkMultiBlockDataSet");
  int index = 0;
  for (const auto& [name, relative_file] : blocks) {
    if (relative_file.empty() || std::filesystem::path(relative_file).is_absolute())
      reject(fmt::format("block '{}' has the file '{}'; a relative path is needed", name, relative_file));
    pugi::xml_node block = collection.append_child("DataSet");
    block.append_attribute("index") = index++;
    block.append_attribute("name") = name.c_str();
    block.append_attribute("file") = relative_file.c_str();
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace isopatch::geometry
