#include "geometry/io/read_stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/io/coordinate_grain.hpp"
#include "geometry/io/reader_limits.hpp"
#include "geometry/io/text_scanner.hpp"

namespace isopatch::geometry {
namespace {

constexpr std::size_t stl_header = 80, stl_record = 50;

static_assert(std::endian::native == std::endian::little);

std::uint32_t count_at(std::string_view text) {
  std::uint32_t count = 0;
  std::memcpy(&count, text.data() + stl_header, sizeof count);
  return count;
}

bool begins_with_solid(std::string_view text) {
  const std::string_view bare = without_byte_order_mark(text);
  const std::size_t start = bare.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos || bare.size() - start < 5) return false;
  std::string word(bare.substr(start, 5));
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return word == "solid";
}

TriangleMesh read_binary(std::string_view text, const std::string& source) {
  const std::uint32_t count = count_at(text);
  if (count > static_cast<std::uint32_t>(max_control_points))
    throw Error(ErrorCode::bad_format,
                fmt::format("{}: {} triangles; at most {} are read", source, count, max_control_points));
  TriangleMesh mesh;
  const auto triangles = static_cast<Eigen::Index>(count);
  mesh.vertices.resize(3, 3 * triangles);
  mesh.triangles.resize(3, triangles);
  for (Eigen::Index t = 0; t < triangles; ++t) {
    float numbers[9];
    std::memcpy(numbers, text.data() + stl_header + 4 + static_cast<std::size_t>(t) * stl_record + 12,
                sizeof numbers);
    for (int i = 0; i < 3; ++i) {
      for (int d = 0; d < 3; ++d) mesh.vertices(d, 3 * t + i) = static_cast<double>(numbers[3 * i + d]);
      mesh.triangles(i, t) = static_cast<int>(3 * t) + i;
    }
    if (!mesh.vertices.middleCols<3>(3 * t).allFinite())
      throw Error(ErrorCode::bad_format,
                  fmt::format("{}: a coordinate of triangle {} is not finite", source, t));
  }
  if (triangles > 0) mesh.grain = float_step(mesh.vertices.cwiseAbs().maxCoeff());
  return mesh;
}

/// Reads words in whatever case.
class TextStl {
 public:
  TextStl(std::string_view text, const std::string& source) : scanner_(text, source) {}

  TriangleMesh read() {
    expect("solid");
    scanner_.rest_of_line();
    while (!scanner_.at_end()) {
      if (is("endsolid")) {
        scanner_.word("endsolid");
        scanner_.rest_of_line();
      } else if (is("solid")) {
        scanner_.word("solid");
        scanner_.rest_of_line();
      } else {
        facet();
      }
    }
    TriangleMesh mesh;
    const auto count = static_cast<Eigen::Index>(numbers_.size() / 3);
    mesh.vertices = Eigen::Map<const Eigen::Matrix3Xd>(numbers_.data(), 3, count);
    mesh.triangles.resize(3, count / 3);
    for (Eigen::Index i = 0; i < count; ++i) mesh.triangles(i % 3, i / 3) = static_cast<int>(i);
    mesh.grain = grain_.step();
    return mesh;
  }

 private:
  static bool same(std::string_view word, std::string_view lower) {
    return word.size() == lower.size() &&
           std::equal(word.begin(), word.end(), lower.begin(),
                      [](unsigned char a, char b) { return static_cast<char>(std::tolower(a)) == b; });
  }
  bool is(std::string_view lower) { return same(scanner_.peek(), lower); }
  void expect(std::string_view lower) {
    const std::string_view word = scanner_.word(fmt::format("'{}'", lower));
    if (!same(word, lower)) scanner_.fail(fmt::format("{} where '{}' was expected", quoted(word), lower));
  }
  void facet() {
    expect("facet");
    expect("normal");
    // Some programs write "nan" for triangles without area.
    for (int d = 0; d < 3; ++d) scanner_.word("a number of the normal");
    expect("outer");
    expect("loop");
    for (int i = 0; i < 3; ++i) {
      expect("vertex");
      for (int d = 0; d < 3; ++d) {
        const std::string_view word = scanner_.peek();
        numbers_.push_back(scanner_.number("a coordinate"));
        grain_.add(word, numbers_.back());
      }
    }
    expect("endloop");
    expect("endfacet");
  }

  TextScanner scanner_;
  std::vector<double> numbers_;
  CoordinateGrain grain_;
};

}  // namespace

TriangleMesh read_stl(std::string_view text, const std::string& source) {
  const bool long_enough = text.size() >= stl_header + 4;
  if (long_enough && text.size() == stl_header + 4 + stl_record * std::size_t{count_at(text)})
    return read_binary(text, source);
  if (begins_with_solid(text)) return TextStl(text, source).read();
  if (long_enough && text.size() > stl_header + 4 + stl_record * std::size_t{count_at(text)} &&
      count_at(text) > 0)
    return read_binary(text, source);  // some programs append what is theirs
  throw Error(ErrorCode::bad_format,
              fmt::format("{}: neither text that begins with 'solid' nor as long as its number of triangles "
                          "says; the file is cut off, or no STL",
                          source));
}

std::string to_stl(const TriangleMesh& mesh) {
  std::string text(stl_header, ' ');
  const auto put = [&](const void* data, std::size_t size) {
    text.append(static_cast<const char*>(data), size);
  };
  const auto count = static_cast<std::uint32_t>(mesh.triangles.cols());
  put(&count, sizeof count);
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const Eigen::Vector3f normal = area_vector(mesh, t).stableNormalized().cast<float>();
    put(normal.data(), 12);
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3f point = mesh.vertices.col(mesh.triangles(i, t)).cast<float>();
      put(point.data(), 12);
    }
    const std::uint16_t attribute = 0;
    put(&attribute, sizeof attribute);
  }
  return text;
}

}  // namespace isopatch::geometry
