#include "geometry/io/read_ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/io/coordinate_grain.hpp"
#include "geometry/io/reader_limits.hpp"
#include "geometry/io/text_scanner.hpp"
#include "geometry/mesh/polygon_triangles.hpp"

namespace isopatch::geometry {
namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> count = {};  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  int count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyBytes { text, little, big };

PlyType type_of(std::string_view word, const TextScanner& scanner) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> names{{{"char", PlyType::int8},
                                                                        {"uchar", PlyType::uint8},
                                                                        {"short", PlyType::int16},
                                                                        {"ushort", PlyType::uint16},
                                                                        {"int", PlyType::int32},
                                                                        {"uint", PlyType::uint32},
                                                                        {"float", PlyType::float32},
                                                                        {"double", PlyType::float64},
                                                                        {"int8", PlyType::int8},
                                                                        {"uint8", PlyType::uint8},
                                                                        {"int16", PlyType::int16},
                                                                        {"uint16", PlyType::uint16},
                                                                        {"int32", PlyType::int32},
                                                                        {"uint32", PlyType::uint32},
                                                                        {"float32", PlyType::float32},
                                                                        {"float64", PlyType::float64}}};
  for (const auto& [name, type] : names)
    if (name == word) return type;
  scanner.fail(fmt::format("{} is no type of a property", quoted(word)));
}

class PlyReader {
 public:
  PlyReader(std::string_view text, const std::string& source)
      : source_(source),
        head_(text.substr(0, end_of_head(text, source))),
        body_(text.substr(head_.size())),
        words_(body_, source, 1 + static_cast<int>(std::count(head_.begin(), head_.end(), '\n'))) {
    read_head();
  }

  TriangleMesh read() {
    for (const PlyElement& element : elements_) require_axes(element);
    for (const PlyElement& element : elements_)
      for (int i = 0; !element.properties.empty() && i < element.count; ++i) read_item(element, i);
    TriangleMesh mesh;
    mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(numbers_.data(), 3,
                                                       static_cast<Eigen::Index>(numbers_.size() / 3));
    if (!mesh.vertices.allFinite()) fail("a coordinate is not finite");
    if (bytes_ == PlyBytes::text)
      mesh.grain = grain_.step();
    else if (floats_ && mesh.vertices.cols() > 0)
      mesh.grain = float_step(mesh.vertices.cwiseAbs().maxCoeff());
    add_triangles(mesh);
    return mesh;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw Error(ErrorCode::bad_format, source_ + ": " + what);
  }

  static std::size_t end_of_head(std::string_view text, const std::string& source) {
    constexpr std::string_view last = "end_header";
    const std::size_t at = text.find(last);
    const std::size_t line = at == std::string_view::npos ? at : text.find('\n', at);
    if (line == std::string_view::npos)
      throw Error(ErrorCode::bad_format, source + ": the line 'end_header' is missing");
    return line + 1;
  }

  void read_head() {
    TextScanner scanner(head_, source_);
    scanner.expect("ply");
    scanner.expect("format");
    const std::string_view format = scanner.word("the format");
    if (format == "ascii")
      bytes_ = PlyBytes::text;
    else if (format == "binary_little_endian" || format == "binary_big_endian")
      bytes_ = format == "binary_little_endian" ? PlyBytes::little : PlyBytes::big;
    else
      scanner.fail(fmt::format("{} is no format", quoted(format)));
    scanner.rest_of_line();
    for (std::string_view word = scanner.word("end_header"); word != "end_header";
         word = scanner.word("end_header"))
      if (word == "element") {
        const std::string name(scanner.word("the element's name"));
        elements_.push_back({name, scanner.integer("the number of elements", 0, max_control_points), {}});
      } else if (word == "property") {
        if (elements_.empty()) scanner.fail("a property before the first element");
        elements_.back().properties.push_back(property(scanner));
      } else {
        scanner.rest_of_line();
      }
  }

  void require_axes(const PlyElement& element) const {
    if (element.name != "vertex") return;
    for (const char* axis : {"x", "y", "z"})
      if (std::none_of(element.properties.begin(), element.properties.end(),
                       [&](const PlyProperty& p) { return p.name == axis && !p.count; }))
        fail(fmt::format("vertices have no {}", axis));
  }

  static PlyProperty property(TextScanner& scanner) {
    PlyProperty result;
    std::string_view word = scanner.word("a type");
    if (word == "list") {
      result.count = type_of(scanner.word("the type of the list's length"), scanner);
      word = scanner.word("a type");
    }
    result.type = type_of(word, scanner);
    result.name = scanner.word("the property's name");
    return result;
  }

  void read_item(const PlyElement& element, int number) {
    const bool vertex = element.name == "vertex";
    std::array<double, 3> place{NAN, NAN, NAN};
    for (const PlyProperty& property : element.properties) {
      if (property.count) {
        read_list(element, property, number);
        continue;
      }
      const std::size_t axis = property.name == "x"   ? 0
                               : property.name == "y" ? 1
                               : property.name == "z" ? 2
                                                      : 3;
      const double value = read_number(property.type, vertex && axis < 3);
      if (!vertex || axis > 2) continue;
      place[axis] = value;
      floats_ = floats_ || property.type == PlyType::float32;
    }
    if (vertex) numbers_.insert(numbers_.end(), place.begin(), place.end());
  }

  void read_list(const PlyElement& element, const PlyProperty& property, int number) {
    const double length = read_number(*property.count, false);
    if (!(length >= 0) || length > double(body_.size()))
      fail(fmt::format("a list of {} numbers in {} {}", length, element.name, number));
    const bool corners =
        element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
    std::vector<int> polygon;
    for (int i = 0; i < int(length); ++i) {
      const double value = read_number(property.type, false);
      if (!(value >= 0) || !(value < double(max_control_points))) {
        if (corners) fail(fmt::format("face {} has a corner {}", number, value));
        continue;
      }
      if (corners) polygon.push_back(int(value));
    }
    if (corners && polygon.size() < 3) fail(fmt::format("face {} has fewer than three corners", number));
    if (corners) polygons_.push_back(std::move(polygon));
  }

  double read_number(PlyType type, bool coordinate) {
    if (bytes_ == PlyBytes::text) {
      const std::string_view word = words_.peek();
      const double value = words_.number("a number");
      if (coordinate) grain_.add(word, value);
      return value;
    }
    switch (type) {
      case PlyType::int8:
        return double(take<std::int8_t>());
      case PlyType::uint8:
        return double(take<std::uint8_t>());
      case PlyType::int16:
        return double(take<std::int16_t>());
      case PlyType::uint16:
        return double(take<std::uint16_t>());
      case PlyType::int32:
        return double(take<std::int32_t>());
      case PlyType::uint32:
        return double(take<std::uint32_t>());
      case PlyType::float32:
        return double(take<float>());
      case PlyType::float64:
        break;
    }
    return take<double>();
  }

  template <class Number>
  Number take() {
    std::array<char, sizeof(Number)> raw;
    if (body_.size() - position_ < raw.size()) fail("the file is cut off");
    std::copy_n(body_.data() + position_, raw.size(), raw.data());
    position_ += raw.size();
    if (bytes_ == PlyBytes::big) std::reverse(raw.begin(), raw.end());
    Number result;
    std::memcpy(&result, raw.data(), raw.size());
    return result;
  }

  void add_triangles(TriangleMesh& mesh) const {
    std::vector<Eigen::Matrix3Xi> parts;
    Eigen::Index count = 0;
    for (const std::vector<int>& polygon : polygons_) {
      for (const int corner : polygon)
        if (corner >= mesh.vertices.cols()) fail(fmt::format("there is no vertex {}", corner));
      try {
        parts.push_back(polygon_triangles(mesh.vertices, polygon));
      } catch (const Error& error) {
        fail(error.what());
      }
      count += parts.back().cols();
    }
    mesh.triangles.resize(3, count);
    Eigen::Index next = 0;
    for (const Eigen::Matrix3Xi& part : parts) {
      mesh.triangles.middleCols(next, part.cols()) = part;
      next += part.cols();
    }
  }

  std::string source_;
  std::string_view head_, body_;
  TextScanner words_;
  PlyBytes bytes_ = PlyBytes::text;
  std::size_t position_ = 0;
  std::vector<PlyElement> elements_;
  std::vector<double> numbers_;
  std::vector<std::vector<int>> polygons_;
  CoordinateGrain grain_;
  bool floats_ = false;
};

}  // namespace

TriangleMesh read_ply(std::string_view text, const std::string& source) {
  return PlyReader(text, source).read();
}

}  // namespace isopatch::geometry
