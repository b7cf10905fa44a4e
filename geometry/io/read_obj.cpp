#include "geometry/io/read_obj.hpp"

#include <fmt/format.h>

#include <charconv>
#include <vector>

#include "geometry/io/coordinate_grain.hpp"
#include "geometry/io/text_scanner.hpp"
#include "geometry/mesh/polygon_triangles.hpp"

namespace isopatch::geometry {
namespace {

struct ObjPolygon {
  int line;
  std::vector<int> corners;
};

/// "7", "7/1", "7//3", "-1": the vertex, from 0.
int corner_of(std::string_view word, int vertices, const TextScanner& scanner) {
  int number = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool whole = read.ptr == word.data() + word.size() || *read.ptr == '/';
  if (read.ec != std::errc{} || !whole || number == 0)
    scanner.fail(fmt::format("{} is no vertex", quoted(word)));
  const int vertex = number > 0 ? number - 1 : vertices + number;
  if (vertex < 0) scanner.fail(fmt::format("{} counts back beyond the first vertex", quoted(word)));
  return vertex;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t start = line.find_first_not_of(" \t\r\\", i);
    if (start == std::string_view::npos) break;
    const std::size_t end = std::min(line.find_first_of(" \t\r\\", start), line.size());
    words.push_back(line.substr(start, end - start));
    i = end;
  }
  return words;
}

/// Whether the line goes on in the next one.
bool goes_on(std::string_view line) {
  return !line.empty() && line.back() == '\\';
}

Eigen::Matrix3Xi all_triangles(const Eigen::Matrix3Xd& vertices, const std::vector<ObjPolygon>& polygons,
                               const std::string& source) {
  std::size_t count = 0;
  for (const ObjPolygon& polygon : polygons) count += polygon.corners.size() - 2;
  Eigen::Matrix3Xi result(3, static_cast<Eigen::Index>(count));
  Eigen::Index next = 0;
  for (const ObjPolygon& polygon : polygons) {
    for (const int corner : polygon.corners)
      if (corner >= vertices.cols())
        throw Error(ErrorCode::bad_format,
                    fmt::format("{}:{}: there is no vertex {}", source, polygon.line, corner + 1));
    const Eigen::Matrix3Xi triangles =
        located(source, polygon.line, "face", [&] { return polygon_triangles(vertices, polygon.corners); });
    result.middleCols(next, triangles.cols()) = triangles;
    next += triangles.cols();
  }
  return result;
}

}  // namespace

TriangleMesh read_obj(std::string_view text, const std::string& source) {
  TextScanner scanner(text, source, 1, '#');
  std::vector<double> numbers;
  std::vector<ObjPolygon> polygons;
  CoordinateGrain grain;
  while (!scanner.at_end()) {
    const std::string_view word = scanner.word("a line");
    if (word == "v") {
      for (int d = 0; d < 3; ++d) {
        const std::string_view number = scanner.peek();
        numbers.push_back(scanner.number("a coordinate"));
        grain.add(number, numbers.back());
      }
      scanner.rest_of_line();
    } else if (word == "f") {
      ObjPolygon polygon{scanner.line(), {}};
      for (std::string_view line = scanner.rest_of_line();; line = scanner.rest_of_line()) {
        for (const std::string_view corner : words_of(line))
          polygon.corners.push_back(corner_of(corner, static_cast<int>(numbers.size() / 3), scanner));
        if (!goes_on(line) || scanner.at_end()) break;
      }
      if (polygon.corners.size() < 3) scanner.fail("a face of fewer than three corners");
      polygons.push_back(std::move(polygon));
    } else {
      while (goes_on(scanner.rest_of_line()) && !scanner.at_end()) continue;
    }
  }
  TriangleMesh mesh;
  mesh.vertices =
      Eigen::Map<const Eigen::Matrix3Xd>(numbers.data(), 3, static_cast<Eigen::Index>(numbers.size() / 3));
  mesh.grain = grain.step();
  mesh.triangles = all_triangles(mesh.vertices, polygons, source);
  return mesh;
}

}  // namespace isopatch::geometry
