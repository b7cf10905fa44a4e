#include "app/render/solid_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/base/engineering_units.hpp"
#include "app/pictures/annotations.hpp"
#include "app/plots/graph_drawing.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/tessellation.hpp"
#include "geometry/topology/planar_drawing.hpp"

namespace isopatch::app {
namespace {

using geometry::Brep;
using geometry::Convexity;
using geometry::Tessellation;

/// A kind of edge in both pictures; the order is that of the colours of app/plots.
struct EdgeKind {
  Convexity convexity;
  Colour colour;
  double width;  ///< in lines of the picture
};
constexpr std::array<EdgeKind, 6> edge_kinds = {{{Convexity::convex, {0, 82, 148}, 1.2},
                                                 {Convexity::non_convex, {213, 60, 0}, 2.2},
                                                 {Convexity::flat, {120, 130, 120}, 1},
                                                 {Convexity::seam, {200, 140, 170}, 1},
                                                 {Convexity::free, {240, 0, 240}, 3},
                                                 {Convexity::overused, {150, 0, 200}, 3}}};

std::size_t kind_index(Convexity convexity) {
  const auto* found = std::find_if(edge_kinds.begin(), edge_kinds.end(),
                                   [&](const EdgeKind& kind) { return kind.convexity == convexity; });
  return static_cast<std::size_t>(found - edge_kinds.begin());
}

/// Triangles of each solid.
using Meshes = std::vector<Tessellation>;

Meshes meshes_of(const std::vector<SolidReport>& solids) {
  Meshes result;
  for (const SolidReport& solid : solids) result.push_back(tessellate(solid.file.brep, {.chord = 2e-4}));
  return result;
}

/// Of all faces of all solids, one after the other.
std::vector<Colour> face_colours(const std::vector<SolidReport>& solids) {
  std::vector<geometry::BrepFace> faces;
  for (const SolidReport& solid : solids)
    faces.insert(faces.end(), solid.file.brep.faces().begin(), solid.file.brep.faces().end());
  std::vector<Colour> colours = patch_colours(static_cast<int>(faces.size()));
  const auto byte = [](double x) { return static_cast<std::uint8_t>(std::clamp(x, 0.0, 1.0) * 255 + 0.5); };
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (const auto& own = faces[i].colour) colours[i] = {byte((*own)[0]), byte((*own)[1]), byte((*own)[2])};
  return colours;
}

/// A solid's faces; values are their numbers.
Surface surface_of(const Brep& brep, const Tessellation& mesh) {
  Eigen::Index points = 0;
  for (const auto& face : mesh.faces) points += face.points.cols();
  Surface surface;
  surface.points.resize(3, points);
  surface.normals.resize(3, points);
  surface.values.resize(points);
  Eigen::Index first = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    for (Eigen::Index i = 0; i < face.points.cols(); ++i) {
      surface.points.col(first + i) = face.points.col(i);
      surface.normals.col(first + i) = brep.outward_normal(FaceId(static_cast<int>(f)), face.uv.col(i));
      surface.values(first + i) = static_cast<double>(f);
    }
    const int base = static_cast<int>(first);
    for (const auto& triangle : face.triangles.colwise())
      surface.triangles.push_back({base + triangle(0), base + triangle(1), base + triangle(2)});
    first += face.points.cols();
  }
  surface.undeformed = surface.points;
  return surface;
}

/// Values put each face into the middle of its colour.
Surface surface_of(const std::vector<SolidReport>& solids, const Meshes& meshes, bool coloured) {
  Surface all;
  double faces = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    Surface one = surface_of(solids[i].file.brep, meshes[i]);
    one.values.array() += faces;
    all = i == 0 ? one : joined(all, one);
    faces += static_cast<double>(meshes[i].faces.size());
  }
  if (coloured)
    all.values = (all.values.array() + 0.5) / faces;
  else
    all.values.setConstant(0.5);
  return all;
}

Lines lines_of(const SolidReport& solid, const Tessellation& mesh, Convexity convexity) {
  Lines lines;
  lines.points.resize(3, 0);
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (solid.report.angles[e].convexity != convexity) continue;
    const Eigen::Matrix3Xd& points = mesh.edges[e].points;
    const Eigen::Index first = lines.points.cols();
    lines.points.conservativeResize(3, first + points.cols());
    lines.points.rightCols(points.cols()) = points;
    for (int i = 0; i + 1 < points.cols(); ++i)
      lines.segments.push_back({static_cast<int>(first) + i, static_cast<int>(first) + i + 1});
  }
  lines.undeformed = lines.points;
  return lines;
}

Lines lines_of(const std::vector<SolidReport>& solids, const Meshes& meshes, Convexity convexity) {
  Lines all = lines_of(solids[0], meshes[0], convexity);
  for (std::size_t i = 1; i < solids.size(); ++i)
    all = joined(all, lines_of(solids[i], meshes[i], convexity));
  return all;
}

/// Whether a triangle hides a point from an eye far away.
bool hides(const Surface& surface, const std::array<int, 3>& triangle, const Eigen::Vector3d& point,
           const Eigen::Vector3d& toward_eye, double nearest) {
  const Eigen::Vector3d a = surface.points.col(triangle[0]);
  const Eigen::Vector3d u = Eigen::Vector3d(surface.points.col(triangle[1])) - a;
  const Eigen::Vector3d v = Eigen::Vector3d(surface.points.col(triangle[2])) - a;
  const Eigen::Vector3d p = toward_eye.cross(v);
  const double determinant = u.dot(p);
  if (std::abs(determinant) < 1e-300) return false;
  const Eigen::Vector3d s = point - a;
  const double x = s.dot(p) / determinant;
  const Eigen::Vector3d q = s.cross(u);
  const double y = toward_eye.dot(q) / determinant;
  return x >= 0 && y >= 0 && x + y <= 1 && v.dot(q) / determinant > nearest;
}

bool is_visible(const Surface& surface, const Eigen::Vector3d& point, const Eigen::Vector3d& toward_eye,
                double size) {
  return std::none_of(surface.triangles.begin(), surface.triangles.end(),
                      [&](const std::array<int, 3>& triangle) {
                        return hides(surface, triangle, point, toward_eye, 1e-3 * size);
                      });
}

PicturePolygon disc(const Eigen::Vector2d& middle, double radius, const Colour& colour) {
  PicturePolygon result;
  result.colour = colour;
  for (int i = 0; i < 16; ++i) {
    const double angle = std::numbers::pi * i / 8;
    result.corners.push_back(middle + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return result;
}

/// Numbers of the visible vertices, a little away from the middle of the picture.
void add_vertices(Picture& picture, const Brep& brep, const std::optional<Cut>& cut, double font) {
  constexpr Colour ink = {20, 20, 20};
  const Eigen::Vector2d middle = 0.5 * Eigen::Vector2d(picture.size.width, picture.size.height);
  for (Eigen::Index i = 0; i < brep.vertices().cols(); ++i) {
    const Eigen::Vector3d at = brep.vertices().col(i);
    if (cut && at[cut->axis] > cut->position) continue;
    if (!is_visible(picture.surface, at, picture.camera.view.toward_eye, brep.size())) continue;
    const Eigen::Vector2d there = pixel(picture.camera, at, picture.size);
    const Eigen::Vector2d place = there + 0.75 * font * (there - middle).stableNormalized();
    picture.polygons.push_back(disc(there, 0.16 * font, ink));
    picture.texts.push_back({std::to_string(i), place.x(), place.y(), 0.75 * font, Align::centre, ink});
  }
}

void add_legend(Picture& picture, const std::vector<SolidReport>& solids, const Layout& places) {
  double y = picture.size.height - 1.6 * places.font;
  const double right = picture.size.width - places.margin;
  for (const EdgeKind& kind : edge_kinds) {
    int count = 0;
    for (const SolidReport& solid : solids) count += solid.report.count(kind.convexity);
    if (count == 0) continue;
    const std::string text = fmt::format("{} {}", count, name(kind.convexity));
    picture.texts.push_back({text, right, y, 0.9 * places.font, Align::right, kind.colour});
    y -= 1.3 * places.font;
  }
}

std::string counted(const std::vector<SolidReport>& solids) {
  std::size_t faces = 0, edges = 0;
  Eigen::Index vertices = 0;
  for (const SolidReport& solid : solids) {
    faces += solid.file.brep.faces().size();
    edges += solid.file.brep.edges().size();
    vertices += solid.file.brep.vertices().cols();
  }
  return fmt::format("{}{} faces, {} edges, {} vertices",
                     solids.size() == 1 ? "" : fmt::format("{} solids, ", solids.size()), faces, edges,
                     vertices);
}

void require_field(const PictureOptions& options) {
  if (options.field != PictureField::patch && options.field != PictureField::none)
    throw Error(ErrorCode::invalid_argument,
                "--field: a solid has only its faces to show; patch and none are known");
}

}  // namespace

PartPicture solids_picture(const std::vector<SolidReport>& solids, const PictureOptions& options,
                           const std::string& title) {
  require_field(options);
  PartPicture result;
  Picture& picture = result.picture;
  picture.size = options.size;
  picture.transparent = options.transparent;
  const Meshes meshes = meshes_of(solids);
  const bool coloured = options.field == PictureField::patch;
  picture.surface = surface_of(solids, meshes, coloured);
  picture.palette = coloured ? face_colours(solids) : std::vector<Colour>{{176, 190, 204}};
  if (options.cut) picture.surface = clipped(picture.surface, *options.cut);
  if (picture.surface.triangles.empty())
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("--clip: nothing of the solid{} is left below {} = {}", solids.size() == 1 ? "" : "s",
                    "xyz"[options.cut->axis], with_unit(options.cut->position, "m")));
  const std::string caption = options.caption.value_or(title);
  const Layout places = layout(options.size, {.bar = false, .caption = !caption.empty()});
  picture.camera = fitted(options.view, picture.surface.points, places, options.zoom);
  picture.line_width = 0.06 * places.font;
  if (options.edges != PictureEdges::none) {
    for (const EdgeKind& kind : edge_kinds) {
      Lines lines = lines_of(solids, meshes, kind.convexity);
      if (options.cut) lines = clipped(lines, *options.cut);
      picture.coloured_lines.push_back(
          {std::move(lines), kind.colour, 1.6 * kind.width * picture.line_width});
    }
    if (solids.size() == 1) add_vertices(picture, solids[0].file.brep, options.cut, places.font);
    add_legend(picture, solids, places);
  }
  add_axes(picture, places);
  if (!caption.empty()) add_caption(picture, places, caption);
  result.description = counted(solids);
  return result;
}

std::string solid_graph_svg(const SolidReport& solid, const std::string& title) {
  const auto graph = geometry::edge_graph(solid.file.brep);
  if (!solid.report.connectivity.three_connected)
    throw Error(ErrorCode::not_three_connected,
                fmt::format("the edge graph has no drawing with straight edges: {}",
                            fmt::join(solid.report.findings, "; ")));
  const Eigen::Matrix2Xd at = geometry::planar_drawing(graph, solid.report.connectivity);
  GraphDrawing drawing;
  drawing.title = title;
  drawing.description = fmt::format("Edge graph with {} vertices, {} edges and {} faces", graph.vertex_count,
                                    graph.edges.size(), graph.faces.size());
  for (const auto& column : at.colwise()) drawing.vertices.push_back({column.x(), column.y()});
  for (const EdgeKind& kind : edge_kinds) {
    const int count = solid.report.count(kind.convexity);
    drawing.series.push_back(count > 0 ? fmt::format("{} {}", count, name(kind.convexity)) : "");
  }
  for (std::size_t e = 0; e < graph.edges.size(); ++e)
    drawing.edges.push_back(
        {graph.edges[e].start.value, graph.edges[e].end.value, kind_index(solid.report.angles[e].convexity)});
  for (std::size_t f = 0; f < graph.faces.size(); ++f) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    const auto around = corners(graph, graph.faces[f].loops.front());
    for (const VertexId vertex : around) middle += at.col(vertex.value) / static_cast<double>(around.size());
    const bool outer = std::all_of(around.begin(), around.end(),
                                   [&](VertexId vertex) { return at.col(vertex.value).norm() > 1 - 1e-9; });
    if (outer) middle << 0.95, -1;
    drawing.labels.push_back({{middle.x(), middle.y()}, fmt::format("f{}{}", f, outer ? " outside" : "")});
  }
  return to_svg(drawing);
}

}  // namespace isopatch::app
