#include "app/reports/block_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/base/engineering_units.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::app {
namespace {

/// One mesh of all faces, whose points stay apart, so that each is lit by its own normals.
void add_mesh(const geometry::Tessellation& mesh, BlockPiece& piece) {
  Eigen::Index points = 0, triangles = 0;
  for (const auto& face : mesh.faces) points += face.points.cols(), triangles += face.triangles.cols();
  piece.points.resize(3, points);
  piece.triangles.resize(3, triangles);
  points = triangles = 0;
  for (const auto& face : mesh.faces) {
    piece.points.middleCols(points, face.points.cols()) = face.points;
    piece.triangles.middleCols(triangles, face.triangles.cols()) =
        face.triangles.array() + static_cast<int>(points);
    points += face.points.cols();
    triangles += face.triangles.cols();
  }
  for (const auto& edge : mesh.edges) piece.edges.push_back(edge.points);
}

/// The points of some triangles, each once, and the triangles among them.
void add_triangles(const geometry::TriangleMesh& mesh, const std::vector<int>& triangles, BlockPiece& piece) {
  std::map<int, int> number;
  piece.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      const int vertex = mesh.triangles(c, triangles[t]);
      const auto found = number.emplace(vertex, static_cast<int>(number.size())).first;
      piece.triangles(c, static_cast<Eigen::Index>(t)) = found->second;
    }
  piece.points.resize(3, static_cast<Eigen::Index>(number.size()));
  for (const auto& [vertex, place] : number) piece.points.col(place) = mesh.vertices.col(vertex);
}

/// The edges that some triangles have alone, put together to lines.
std::vector<Eigen::Matrix3Xd> border_lines(const geometry::TriangleMesh& mesh,
                                           const std::vector<int>& triangles) {
  std::multimap<int, int> next;  // along the border
  for (const int t : triangles)
    for (int c = 0; c < 3; ++c) {
      const int from = mesh.triangles(c, t), to = mesh.triangles((c + 1) % 3, t);
      const auto [first, last] = next.equal_range(to);
      const auto back = std::find_if(first, last, [from](const auto& edge) { return edge.second == from; });
      if (back != last)
        next.erase(back);
      else
        next.emplace(from, to);
    }
  std::vector<Eigen::Matrix3Xd> lines;
  while (!next.empty()) {
    std::vector<int> line = {next.begin()->first};
    for (auto edge = next.begin(); edge != next.end(); edge = next.find(line.back())) {
      line.push_back(edge->second);
      next.erase(edge);
    }
    lines.emplace_back(mesh.vertices(Eigen::all, line));
  }
  return lines;
}

/// Parameters along a direction: all breaks, and places between them.
struct Samples {
  std::vector<double> at;
  std::vector<int> breaks;  // which of them are breaks
};

Samples samples_along(const geometry::KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  const int spans = static_cast<int>(breaks.size()) - 1;
  constexpr int most_a_span = 8, wanted = 16;
  const int pieces = std::clamp((wanted + spans - 1) / spans, 1, most_a_span);
  Samples samples;
  for (int s = 0; s < spans; ++s) {
    samples.breaks.push_back(static_cast<int>(samples.at.size()));
    for (int i = 0; i < pieces; ++i)
      samples.at.push_back(std::lerp(breaks[static_cast<std::size_t>(s)],
                                     breaks[static_cast<std::size_t>(s) + 1], double(i) / pieces));
  }
  samples.breaks.push_back(static_cast<int>(samples.at.size()));
  samples.at.push_back(breaks.back());
  return samples;
}

/// A side's points, first direction fastest, its triangles and the lines at breaks.
void add_side(const geometry::NurbsVolume& patch, geometry::Side side, BlockPiece& piece) {
  const auto across = static_cast<Eigen::Index>(direction(side));
  const auto [a, b] = geometry::tangents(side);
  const Samples first = samples_along(patch.knots(a)), second = samples_along(patch.knots(b));
  const auto m = static_cast<int>(first.at.size()), n = static_cast<int>(second.at.size());
  geometry::Parameter<3> parameter = geometry::is_high(side) ? patch.high() : patch.low();
  parameter[across] = geometry::is_high(side) ? patch.high()[across] : patch.low()[across];
  Eigen::Matrix3Xd points(3, m * n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i) {
      parameter[a] = first.at[static_cast<std::size_t>(i)];
      parameter[b] = second.at[static_cast<std::size_t>(j)];
      points.col(i + m * j) = patch.point(parameter);
    }
  const auto before = static_cast<int>(piece.points.cols());
  Eigen::Index t = piece.triangles.cols();
  piece.triangles.conservativeResize(3, t + 2 * Eigen::Index{m - 1} * (n - 1));
  for (int j = 0; j + 1 < n; ++j)
    for (int i = 0; i + 1 < m; ++i) {
      const int corner = before + i + m * j;
      piece.triangles.col(t++) << corner, corner + 1, corner + m + 1;
      piece.triangles.col(t++) << corner, corner + m + 1, corner + m;
    }
  piece.points.conservativeResize(3, before + m * n);
  piece.points.rightCols(m * n) = points;
  for (const int i : first.breaks) piece.edges.emplace_back(points(Eigen::all, Eigen::seqN(i, n, m)));
  for (const int j : second.breaks) piece.edges.emplace_back(points.middleCols(Eigen::Index{m} * j, m));
}

std::string name_of_face(const std::string& name, std::size_t face) {
  return name.empty() ? fmt::format("face {}", face) : name;
}

}  // namespace

std::optional<geometry::Tessellation> triangulated(const geometry::Brep& brep) {
  try {
    return tessellate(brep, {.chord = 2e-3});
  } catch (const Error&) {
    return std::nullopt;  // its edges are drawn
  }
}

BlockPiece piece_of(const geometry::Brep& brep, const std::string& name, const std::string& body) {
  BlockPiece piece{.name = name, .body = body, .volume = std::abs(brep.volume())};
  for (const geometry::BrepFace& face : brep.faces())
    if (!face.name.empty() &&
        std::find(piece.faces.begin(), piece.faces.end(), face.name) == piece.faces.end())
      piece.faces.push_back(face.name);
  if (const auto mesh = triangulated(brep)) {
    add_mesh(*mesh, piece);
    return piece;
  }
  for (std::size_t e = 0; e < brep.edges().size(); ++e)
    piece.edges.push_back(geometry::drawn(brep, EdgeId(static_cast<int>(e))).points);
  return piece;
}

std::vector<BlockPiece> face_pieces(const geometry::Brep& brep, const std::string& body) {
  std::vector<BlockPiece> pieces;
  const auto mesh = triangulated(brep);
  if (!mesh) return pieces;
  for (std::size_t f = 0; f < brep.faces().size(); ++f) {
    const geometry::BrepFace& face = brep.faces()[f];
    BlockPiece piece{.name = name_of_face(face.name, f), .body = body};
    piece.remark = fmt::format("{}, {}", geometry::name(face.kind),
                               with_unit(brep.area(FaceId(static_cast<int>(f))), "m^2"));
    piece.points = mesh->faces[f].points;
    piece.triangles = mesh->faces[f].triangles;
    for (const auto& loop : face.loops)
      for (const geometry::EdgeUse& use : loop)
        piece.edges.push_back(mesh->edges[static_cast<std::size_t>(use.edge.value)].points);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

BlockPiece patch_piece(const geometry::NurbsVolume& patch, const std::string& name) {
  BlockPiece piece{.name = name, .body = ""};
  for (const geometry::Side side : geometry::all_sides) add_side(patch, side, piece);
  piece.remark = fmt::format(
      "degree {} x {} x {}, {} elements, {} control points", patch.degree(0), patch.degree(1),
      patch.degree(2),
      patch.knots(0).element_count() * patch.knots(1).element_count() * patch.knots(2).element_count(),
      patch.size());
  return piece;
}

std::vector<BlockPiece> region_pieces(const SolidTriangles& triangles,
                                      const std::vector<std::string>& names) {
  int count = static_cast<int>(names.size());
  for (const int face : triangles.faces) count = std::max(count, face + 1);
  std::vector<std::vector<int>> of_face(static_cast<std::size_t>(count));
  for (std::size_t t = 0; t < triangles.faces.size(); ++t)
    if (triangles.faces[t] >= 0)
      of_face[static_cast<std::size_t>(triangles.faces[t])].push_back(static_cast<int>(t));
  std::vector<BlockPiece> pieces;
  for (std::size_t f = 0; f < of_face.size(); ++f) {
    if (of_face[f].empty()) continue;
    BlockPiece piece{.name = name_of_face(f < names.size() ? names[f] : "", f), .body = triangles.solid};
    piece.remark = fmt::format("{} triangles", with_separators(static_cast<std::int64_t>(of_face[f].size())));
    add_triangles(triangles.mesh, of_face[f], piece);
    piece.edges = border_lines(triangles.mesh, of_face[f]);
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

}  // namespace isopatch::app
