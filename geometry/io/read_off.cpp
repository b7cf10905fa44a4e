#include "geometry/io/read_off.hpp"

#include <fmt/format.h>

#include "geometry/io/reader_limits.hpp"
#include "geometry/io/text_scanner.hpp"

namespace isopatch::geometry {

Polyhedron read_off(std::string_view text, const std::string& source) {
  TextScanner scanner(text, source, 1, '#');
  scanner.expect("OFF");
  const int vertices = scanner.integer("the number of vertices", 0, max_control_points);
  const int faces = scanner.integer("the number of faces", 0, max_control_points);
  scanner.integer("the number of edges", 0, 2 * max_control_points);
  scanner.require_room(3 * static_cast<std::size_t>(vertices) + 4 * static_cast<std::size_t>(faces),
                       fmt::format("{} vertices and {} faces", vertices, faces));
  Polyhedron result;
  result.vertices.resize(3, vertices);
  for (int i = 0; i < vertices; ++i)
    for (int d = 0; d < 3; ++d)
      result.vertices(d, i) = scanner.number(fmt::format("a coordinate of vertex {}", i));
  for (int i = 0; i < faces; ++i) {
    const std::string what = fmt::format("face {}", i);
    std::vector<int> face(static_cast<std::size_t>(scanner.integer("the corners of " + what, 3, vertices)));
    scanner.require_room(face.size(), what);
    for (int& corner : face) corner = scanner.integer("a corner of " + what, 0, vertices - 1);
    result.faces.push_back(std::move(face));
    scanner.rest_of_line();
  }
  scanner.expect_end("the last face");
  return result;
}

std::string to_off(const Polyhedron& polyhedron) {
  std::string text = fmt::format("OFF\n{} {} 0\n", polyhedron.vertices.cols(), polyhedron.faces.size());
  for (const auto& p : polyhedron.vertices.colwise())
    text += fmt::format("{:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
  for (const auto& face : polyhedron.faces) {
    text += fmt::format("{}", face.size());
    for (const int corner : face) text += fmt::format(" {}", corner);
    text += "\n";
  }
  return text;
}

}  // namespace isopatch::geometry
