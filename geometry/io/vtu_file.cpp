#include "geometry/io/vtu_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <limits>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "geometry/base/error.hpp"
#include "geometry/io/vtk_cell_points.hpp"
#include "geometry/splines/knot_vector.hpp"

namespace isopatch::geometry {
namespace {

constexpr std::size_t waiting_bytes = std::size_t{256} << 10;

[[noreturn]] void reject(const std::string& message) {
  throw Error(ErrorCode::invalid_argument, "file for VTK: " + message);
}

std::array<std::int64_t, 3> cells_along(const VtuGrid& grid) {
  std::array<std::int64_t, 3> result{};
  for (std::size_t d = 0; d < 3; ++d) result[d] = std::max(1, (grid.points[d] - 1) / grid.degree[d]);
  return result;
}

void check_grid(const VtuGrid& grid, VtuCell cell) {
  for (std::size_t d = 0; d < 3; ++d) {
    const int n = grid.points[d], p = grid.degree[d];
    if (p < 1 || p > (cell == VtuCell::bezier_hexahedron ? KnotVector::max_degree : 1))
      reject(fmt::format("cells of degree {}", p));
    const bool flat = cell == VtuCell::quadrilateral && d == 2;
    if (flat ? n != 1 : n < p + 1 || (n - 1) % p != 0)
      reject(fmt::format("{} points along direction {} for cells of degree {}", n, d + 1, p));
  }
}

// The points of a grid's first cell, in VTK's order, as numbers in the grid.
std::vector<std::int64_t> first_cell(const VtuGrid& grid, VtuCell cell) {
  const std::int64_t row = grid.points[0], plane = row * grid.points[1];
  if (cell == VtuCell::quadrilateral)
    return grid.turned ? std::vector<std::int64_t>{0, row, row + 1, 1}
                       : std::vector<std::int64_t>{0, 1, row + 1, row};
  if (cell == VtuCell::hexahedron)
    return {0, 1, row + 1, row, plane, plane + 1, plane + row + 1, plane + row};
  const auto [p, q, r] = grid.degree;
  std::vector<std::int64_t> result(static_cast<std::size_t>((p + 1) * (q + 1) * (r + 1)));
  for (int k = 0; k <= r; ++k)
    for (int j = 0; j <= q; ++j)
      for (int i = 0; i <= p; ++i)
        result[static_cast<std::size_t>(vtk_cell_point({i, j, k}, grid.degree))] = i + row * j + plane * k;
  return result;
}

// The numbers of vtkCellType.h.
int vtk_type(VtuCell cell) {
  return cell == VtuCell::quadrilateral ? 9 : cell == VtuCell::hexahedron ? 12 : 79;
}

// One <DataArray>: how it is declared, where it lies in the file, and bytes that wait to be written.
struct Array {
  std::string section;  // PointData, CellData, Points or Cells
  std::string name;
  std::string type;
  int components = 1;
  std::uint64_t bytes = 0;  // without the count before them
  std::uint64_t place = 0;  // of the first value
  std::uint64_t waiting_from = 0;
  std::string waiting = {};
};

std::uint64_t size_of(const std::string& type) {
  return type == "UInt8" ? 1 : type.ends_with("64") ? 8 : 4;
}

const char* real(Precision precision) {
  return precision == Precision::full ? "Float64" : "Float32";
}

std::string declaration(const Array& array, std::uint64_t offset) {
  pugi::xml_document document;
  pugi::xml_node node = document.append_child("DataArray");
  node.append_attribute("type") = array.type.c_str();
  node.append_attribute("Name") = array.name.c_str();
  node.append_attribute("NumberOfComponents") = array.components;
  node.append_attribute("format") = "appended";
  node.append_attribute("offset") = static_cast<unsigned long long>(offset);
  std::ostringstream line;
  document.save(line, "", pugi::format_raw | pugi::format_no_declaration);
  return "        " + line.str() + "\n";
}

}  // namespace

std::int64_t VtuGrid::point_count() const {
  return std::int64_t{points[0]} * points[1] * points[2];
}

std::int64_t VtuGrid::cell_count() const {
  const auto [m, n, o] = cells_along(*this);
  return m * n * o;
}

struct VtuFile::State {
  VtuCell cell;
  std::vector<VtuGrid> grids;
  std::vector<VtuLabel> labels;
  std::vector<VtuCellField> cell_fields;
  PlacedByteSink sink;
  std::int64_t point_count = 0, cell_count = 0, corner_count = 0;
  std::vector<Array> arrays;  // points first, then the fields
  std::uint64_t end = 0;

  void add(const std::string& section, const std::string& name, const std::string& type, int components,
           std::int64_t tuples) {
    arrays.push_back(
        {section, name, type, components,
         size_of(type) * static_cast<std::uint64_t>(components) * static_cast<std::uint64_t>(tuples)});
  }

  Array& named(const std::string& name) {
    for (Array& array : arrays)
      if (array.name == name) return array;
    throw Error(ErrorCode::internal, "file for VTK: no array " + name);
  }

  std::string head() const {
    const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
    std::string text = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"2.2\" byte_order=\"{}\" "
        "header_type=\"UInt64\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"{}\" "
        "NumberOfCells=\"{}\">\n",
        order, point_count, cell_count);
    for (const char* section : {"PointData", "CellData", "Points", "Cells"}) {
      std::string active, lines;
      std::uint64_t offset = 0;
      for (const Array& array : arrays) {
        if (array.section == section) {
          lines += declaration(array, offset);
          if (array.name == "RationalWeights" || array.name == "HigherOrderDegrees")
            active = fmt::format(" {0}=\"{0}\"", array.name);
        }
        offset += sizeof(std::uint64_t) + array.bytes;
      }
      text += fmt::format("      <{0}{1}>\n{2}      </{0}>\n", section, active, lines);
    }
    return text + "    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_";
  }

  void write_head() {
    const std::string text = head();
    sink(0, text);
    std::uint64_t place = text.size();
    for (Array& array : arrays) {
      sink(place, {reinterpret_cast<const char*>(&array.bytes), sizeof array.bytes});
      array.place = array.waiting_from = place + sizeof array.bytes;
      place = array.place + array.bytes;
    }
    end = place;
  }

  void flush(Array& array) {
    if (!array.waiting.empty()) sink(array.waiting_from, array.waiting);
    array.waiting_from += array.waiting.size();
    array.waiting.clear();
  }

  void give(Array& array, std::uint64_t from, std::string_view bytes) {
    if (array.place + from != array.waiting_from + array.waiting.size()) {
      flush(array);
      array.waiting_from = array.place + from;
    }
    array.waiting += bytes;
    if (array.waiting.size() >= waiting_bytes) flush(array);
  }

  template <class T>
  void append(Array& array, T value) {
    array.waiting.append(reinterpret_cast<const char*>(&value), sizeof value);
    if (array.waiting.size() >= waiting_bytes) flush(array);
  }

  void numbers(Array& array, std::int64_t first, const double* values, Eigen::Index count) {
    const Eigen::Map<const Eigen::ArrayXd> given(values, count);
    if (!given.allFinite()) reject(fmt::format("'{}' has a value that is not finite", array.name));
    const std::uint64_t from =
        static_cast<std::uint64_t>(first) * static_cast<std::uint64_t>(array.components);
    if (array.type == "Float64") {
      give(array, from * sizeof(double),
           {reinterpret_cast<const char*>(values), static_cast<std::size_t>(count) * sizeof(double)});
      return;
    }
    const Eigen::ArrayXf rounded = given.cast<float>();
    if (!rounded.allFinite())
      reject(fmt::format("'{}' has a value that is too large for single precision", array.name));
    give(array, from * sizeof(float),
         {reinterpret_cast<const char*>(rounded.data()), static_cast<std::size_t>(count) * sizeof(float)});
  }

  // Calls visit(points of the cell in VTK's order) for every cell of a grid whose points begin at `first`.
  template <class Visit>
  void for_each_cell(const VtuGrid& grid, std::int64_t first, Visit visit) const {
    const std::vector<std::int64_t> pattern = first_cell(grid, cell);
    const auto [m, n, o] = cells_along(grid);
    for (std::int64_t k = 0; k < o; ++k)
      for (std::int64_t j = 0; j < n; ++j)
        for (std::int64_t i = 0; i < m; ++i)
          visit(pattern, first + grid.degree[0] * i +
                             grid.points[0] *
                                 (grid.degree[1] * j + std::int64_t{grid.points[1]} * grid.degree[2] * k));
  }

  template <class Index>
  void write_cells() {
    Array& connectivity = named("connectivity");
    Array& offsets = named("offsets");
    Array& types = named("types");
    std::int64_t first = 0, corners = 0;
    for (const VtuGrid& grid : grids) {
      for_each_cell(grid, first, [&](const std::vector<std::int64_t>& pattern, std::int64_t corner) {
        for (const std::int64_t point : pattern) append(connectivity, static_cast<Index>(corner + point));
        corners += static_cast<std::int64_t>(pattern.size());
        append(offsets, static_cast<Index>(corners));
        append(types, static_cast<std::uint8_t>(vtk_type(cell)));
      });
      first += grid.point_count();
    }
  }

  void write_labels() {
    for (const VtuLabel& label : labels) {
      Array& array = named(label.name);
      for (std::size_t g = 0; g < grids.size(); ++g)
        for (std::int64_t c = 0; c < grids[g].cell_count(); ++c)
          append(array, std::int32_t{label.of_grid[g]});
    }
  }

  void write_cell_fields() {
    for (const VtuCellField& field : cell_fields) {
      Array& array = named(field.name);
      for (std::size_t g = 0; g < grids.size(); ++g)
        for (std::int64_t c = 0; c < grids[g].cell_count(); ++c) {
          const float value = field.value(g, c);
          if (!std::isfinite(value)) reject(fmt::format("'{}' has a value that is not finite", field.name));
          append(array, value);
        }
    }
  }

  void write_degrees() {
    Array& array = named("HigherOrderDegrees");
    for (const VtuGrid& grid : grids)
      for (std::int64_t c = 0; c < grid.cell_count(); ++c)
        for (const int degree : grid.degree) append(array, static_cast<double>(degree));
  }
};

VtuFile::VtuFile(VtuCell cell, std::vector<VtuGrid> grids, std::vector<VtuField> fields,
                 std::vector<VtuLabel> labels, PlacedByteSink sink, Precision places,
                 std::vector<VtuCellField> cell_fields)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  if (grids.empty()) reject("no grid");
  std::set<std::string> names = {"HigherOrderDegrees", "Points", "connectivity", "offsets", "types"};
  const auto take = [&](const std::string& name) {
    if (name.empty()) reject("a field has no name");
    if (!names.insert(name).second) reject(fmt::format("the field name '{}' is taken", name));
  };
  for (const VtuField& field : fields) take(field.name);
  for (const VtuCellField& field : cell_fields) take(field.name);
  for (const VtuLabel& label : labels) {
    take(label.name);
    if (label.of_grid.size() != grids.size())
      reject(fmt::format("label '{}' has {} values for {} grids", label.name, label.of_grid.size(),
                         grids.size()));
  }
  for (const VtuGrid& grid : grids) {
    check_grid(grid, cell);
    s.point_count += grid.point_count();
    s.cell_count += grid.cell_count();
    s.corner_count += grid.cell_count() * static_cast<std::int64_t>(first_cell(grid, cell).size());
  }
  s.cell = cell;
  s.grids = std::move(grids);
  s.labels = std::move(labels);
  s.cell_fields = std::move(cell_fields);
  s.sink = std::move(sink);
  s.add("Points", "Points", real(places), 3, s.point_count);
  for (const VtuField& field : fields)
    s.add("PointData", field.name, real(field.precision), field.components, s.point_count);
  for (const VtuLabel& label : s.labels) s.add("CellData", label.name, "Int32", 1, s.cell_count);
  for (const VtuCellField& field : s.cell_fields) s.add("CellData", field.name, "Float32", 1, s.cell_count);
  if (cell == VtuCell::bezier_hexahedron) s.add("CellData", "HigherOrderDegrees", "Float64", 3, s.cell_count);
  const bool small = std::max(s.point_count, s.corner_count) <= std::numeric_limits<std::int32_t>::max();
  s.add("Cells", "connectivity", small ? "Int32" : "Int64", 1, s.corner_count);
  s.add("Cells", "offsets", small ? "Int32" : "Int64", 1, s.cell_count);
  s.add("Cells", "types", "UInt8", 1, s.cell_count);
  s.write_head();
}

VtuFile::~VtuFile() = default;

void VtuFile::points(std::int64_t first, const Eigen::Matrix3Xd& values) {
  state_->numbers(state_->arrays[0], first, values.data(), values.size());
}

void VtuFile::field(std::size_t index, std::int64_t first, const Eigen::MatrixXd& values) {
  Array& array = state_->arrays[index + 1];
  if (values.rows() != array.components)
    reject(fmt::format("'{}' has {} components where {} were announced", array.name, values.rows(),
                       array.components));
  state_->numbers(array, first, values.data(), values.size());
}

void VtuFile::finish() {
  State& s = *state_;
  if (s.named("connectivity").type == "Int32")
    s.write_cells<std::int32_t>();
  else
    s.write_cells<std::int64_t>();
  s.write_labels();
  s.write_cell_fields();
  if (s.cell == VtuCell::bezier_hexahedron) s.write_degrees();
  for (Array& array : s.arrays) s.flush(array);
  s.sink(s.end, "\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace isopatch::geometry
