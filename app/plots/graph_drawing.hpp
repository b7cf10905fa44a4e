#pragma once

#include <array>
#include <string>
#include <vector>

namespace isopatch::app {

/// A graph drawn with straight edges, such as that of a solid's edges.
struct GraphDrawing {
  struct Edge {
    int from = 0, to = 0;
    std::size_t series = 0;  ///< index into `series`
  };
  /// A text in the plane.
  struct Label {
    std::array<double, 2> at{};
    std::string text;
  };
  std::string title;
  std::string description;                      ///< for those who cannot see it
  std::vector<std::array<double, 2>> vertices;  ///< in [-1, 1] x [-1, 1], y upwards; their numbers are drawn
  std::vector<Edge> edges;
  std::vector<std::string> series;  ///< names of kinds of edges, for the legend
  std::vector<Label> labels;        ///< quiet ones, such as numbers of faces
};

/// The drawing as an SVG picture.
std::string to_svg(const GraphDrawing& drawing);

}  // namespace isopatch::app
