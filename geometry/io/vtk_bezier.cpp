#include "geometry/io/vtk_bezier.hpp"

#include <fmt/format.h>
#include <vtkCellType.h>
#include <vtkHigherOrderHexahedron.h>

#include <algorithm>
#include <bit>
#include <cstdint>
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
  if (cells.cell_count < 0 || cells.points.cols() != count ||
      (cells.weights.size() != count && cells.weights.size() != 0))
    reject(fmt::format("{} points and {} weights for {} cells of degree {} x {} x {}, which need {}",
                       cells.points.cols(), cells.weights.size(), cells.cell_count, cells.degree[0],
                       cells.degree[1], cells.degree[2], count));
  if (!cells.points.allFinite()) reject("a point is not finite");
  if (!cells.weights.allFinite() || !(cells.weights.array() > 0).all()) reject("a weight is not positive");
  check_fields(cells.point_fields, count, "points");
  check_fields(cells.cell_fields, cells.cell_count, "cells");
}

// Fields of pieces must be those of the first.
void check_like(const BezierCells& first, const BezierCells& cells, int count) {
  const auto same = [](const std::vector<BezierField>& a, const std::vector<BezierField>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const BezierField& x, const BezierField& y) {
      return x.name == y.name && x.values.rows() == y.values.rows();
    });
  };
  if (cells.cell_count != count)
    reject(fmt::format("a piece of {} cells where {} were announced", cells.cell_count, count));
  if (cells.degree != first.degree || (cells.weights.size() > 0) != (first.weights.size() > 0) ||
      !same(cells.point_fields, first.point_fields) || !same(cells.cell_fields, first.cell_fields))
    reject("pieces of one file differ in degree or fields");
}

// Entry t: where the point at tensor index t of a cell stands in VTK's order (corners, edges, faces, inside).
std::vector<int> vtk_positions(const std::array<int, 3>& degree) {
  std::vector<int> result;
  for (int k = 0; k <= degree[2]; ++k)
    for (int j = 0; j <= degree[1]; ++j)
      for (int i = 0; i <= degree[0]; ++i)
        result.push_back(vtkHigherOrderHexahedron::PointIndexFromIJK(i, j, k, degree.data()));
  return result;
}

// One <DataArray> of every piece: how it is declared, and its values.
struct ArrayKind {
  std::string section;  // PointData, CellData, Points or Cells
  std::string name;
  std::string type;
  Eigen::Index components = 1;
  std::uint64_t bytes_per_cell = 0;
  std::function<void(const BezierCells&, std::string&)> append;
};

template <class T>
void append_value(T value, std::string& bytes) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

void append_numbers(const double* values, Eigen::Index count, Precision precision, std::string& bytes) {
  if (precision == Precision::full) {
    bytes.append(reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(double));
    return;
  }
  const Eigen::ArrayXf rounded = Eigen::Map<const Eigen::ArrayXd>(values, count).cast<float>();
  if (!rounded.allFinite()) reject("a value is too large for single precision");
  bytes.append(reinterpret_cast<const char*>(rounded.data()),
               static_cast<std::size_t>(count) * sizeof(float));
}

class VtuLayout {
 public:
  VtuLayout(const BezierCells& first, Precision precision)
      : precision_(precision), points_(points_per_cell(first)), positions_(vtk_positions(first.degree)) {
    if (first.weights.size() > 0)
      add_numbers("PointData", "RationalWeights", 1, points_,
                  [](const BezierCells& c) { return c.weights.data(); });
    for (std::size_t f = 0; f < first.point_fields.size(); ++f)
      add_numbers("PointData", first.point_fields[f].name, first.point_fields[f].values.rows(), points_,
                  [f](const BezierCells& c) { return c.point_fields[f].values.data(); });
    add_degrees();
    for (std::size_t f = 0; f < first.cell_fields.size(); ++f)
      add_numbers("CellData", first.cell_fields[f].name, first.cell_fields[f].values.rows(), 1,
                  [f](const BezierCells& c) { return c.cell_fields[f].values.data(); });
    add_numbers("Points", "Points", 3, points_, [](const BezierCells& c) { return c.points.data(); });
    add_cells();
  }

  // Everything before the pieces' bytes. The sizes are known beforehand, and so are the offsets.
  std::string head(const std::vector<int>& piece_cells) const {
    const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" byte_order=\"{}\" "
        "header_type=\"UInt64\">\n  <UnstructuredGrid>\n",
        order);
    std::uint64_t offset = 0;
    for (const int cells : piece_cells) {
      text += fmt::format("    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", cells * points_, cells);
      for (const char* section : {"PointData", "CellData", "Points", "Cells"})
        text += section_text(section, cells, offset);
      text += "    </Piece>\n";
    }
    return text + "  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
  }

  static std::string tail() { return "\n  </AppendedData>\n</VTKFile>\n"; }

  void append(const BezierCells& cells, std::string& bytes) const {
    for (const ArrayKind& array : arrays_) {
      append_value(array.bytes_per_cell * static_cast<std::uint64_t>(cells.cell_count), bytes);
      array.append(cells, bytes);
    }
  }

 private:
  std::string section_text(const std::string& section, int cells, std::uint64_t& offset) const {
    std::string active;
    std::string text;
    for (const ArrayKind& array : arrays_) {
      if (array.section != section) continue;
      if (array.name == "RationalWeights" || array.name == "HigherOrderDegrees")
        active = fmt::format(" {0}=\"{0}\"", array.name);
      pugi::xml_document document;
      pugi::xml_node node = document.append_child("DataArray");
      node.append_attribute("type") = array.type.c_str();
      node.append_attribute("Name") = array.name.c_str();
      node.append_attribute("NumberOfComponents") = static_cast<long long>(array.components);
      node.append_attribute("format") = "appended";
      node.append_attribute("offset") = static_cast<unsigned long long>(offset);
      std::ostringstream line;
      document.save(line, "", pugi::format_raw | pugi::format_no_declaration);
      text += "        " + line.str() + "\n";
      offset += sizeof(std::uint64_t) + array.bytes_per_cell * static_cast<std::uint64_t>(cells);
    }
    return fmt::format("      <{0}{1}>\n{2}      </{0}>\n", section, active, text);
  }

  void add_numbers(const std::string& section, const std::string& name, Eigen::Index components,
                   Eigen::Index per_cell, std::function<const double*(const BezierCells&)> data) {
    const bool full = precision_ == Precision::full;
    const Eigen::Index count = components * per_cell;
    arrays_.push_back(
        {section, name, full ? "Float64" : "Float32", components,
         static_cast<std::uint64_t>(count) * (full ? sizeof(double) : sizeof(float)),
         [count, data = std::move(data), precision = precision_](const BezierCells& c, std::string& bytes) {
           append_numbers(data(c), count * c.cell_count, precision, bytes);
         }});
  }

  void add_degrees() {
    arrays_.push_back({"CellData", "HigherOrderDegrees", "Float64", 3, 3 * sizeof(double),
                       [](const BezierCells& c, std::string& bytes) {
                         for (int cell = 0; cell < c.cell_count; ++cell)
                           for (const int degree : c.degree) append_value<double>(degree, bytes);
                       }});
  }

  // Points keep the tensor order; the cells list them in VTK's.
  void add_cells() {
    std::vector<int> order(positions_.size());
    for (std::size_t t = 0; t < order.size(); ++t)
      order[static_cast<std::size_t>(positions_[t])] = static_cast<int>(t);
    const Eigen::Index count = points_;
    arrays_.push_back({"Cells", "connectivity", "Int64", 1, order.size() * sizeof(std::int64_t),
                       [order, count](const BezierCells& c, std::string& bytes) {
                         for (std::int64_t cell = 0; cell < c.cell_count; ++cell)
                           for (const int t : order) append_value<std::int64_t>(cell * count + t, bytes);
                       }});
    arrays_.push_back({"Cells", "offsets", "Int64", 1, sizeof(std::int64_t),
                       [count](const BezierCells& c, std::string& bytes) {
                         for (std::int64_t cell = 1; cell <= c.cell_count; ++cell)
                           append_value<std::int64_t>(cell * count, bytes);
                       }});
    arrays_.push_back({"Cells", "types", "UInt8", 1, 1, [](const BezierCells& c, std::string& bytes) {
                         bytes.append(static_cast<std::size_t>(c.cell_count),
                                      static_cast<char>(VTK_BEZIER_HEXAHEDRON));
                       }});
  }

  Precision precision_;
  Eigen::Index points_;
  std::vector<int> positions_;
  std::vector<ArrayKind> arrays_;
};

}  // namespace

void write_vtu(const std::vector<int>& piece_cells, const std::function<BezierCells(std::size_t)>& piece,
               const ByteSink& sink, Precision precision) {
  if (piece_cells.empty()) reject("a file needs at least one piece");
  BezierCells first = piece(0);
  check(first);
  const VtuLayout layout(first, precision);
  sink(layout.head(piece_cells));
  std::string bytes;
  layout.append(first, bytes);
  check_like(first, first, piece_cells[0]);
  sink(bytes);
  for (std::size_t i = 1; i < piece_cells.size(); ++i) {
    const BezierCells cells = piece(i);
    check(cells);
    check_like(first, cells, piece_cells[i]);
    bytes.clear();
    layout.append(cells, bytes);
    sink(bytes);
  }
  sink(VtuLayout::tail());
}

std::string to_vtu(const BezierCells& cells, Precision precision) {
  std::string text;
  write_vtu(
      {cells.cell_count}, [&](std::size_t) { return cells; }, [&](std::string_view bytes) { text += bytes; },
      precision);
  return text;
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
