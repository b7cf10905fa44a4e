#include "segmentation/decomposition/star_pieces.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "geometry/base/larger.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/cut_by_plane.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/splines/arc.hpp"
#include "segmentation/decomposition/star_cells.hpp"
#include "segmentation/decomposition/templates.hpp"
#include "segmentation/pieces/joined_complex.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

struct StarPiece {
  Brep brep;
  std::vector<std::optional<FaceId>> origin;  ///< by face: that of the solid
};

/// Points with normal . x <= offset for each column.
struct HalfSpaces {
  Eigen::Matrix3Xd normals;
  Eigen::VectorXd offsets;
};

Eigen::Matrix3Xd corners(const Brep& solid, const std::vector<geometry::EdgeUse>& loop) {
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(loop.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i) {
    const geometry::EdgeUse use = loop[static_cast<std::size_t>(i)];
    result.col(i) = solid.vertex(use.reversed ? solid.edge(use.edge).end : solid.edge(use.edge).start);
  }
  return result;
}

/// Twice the area of a polygon, along its normal.
Eigen::Vector3d turned_area(const Eigen::Matrix3Xd& polygon) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 1; i + 1 < polygon.cols(); ++i)
    sum += (polygon.col(i) - polygon.col(0)).cross(polygon.col(i + 1) - polygon.col(0));
  return sum;
}

/// Below the faces that have a corner with `along` . x < `height`, and below that plane.
HalfSpaces below(const Brep& solid, const Eigen::Vector3d& along, double height) {
  std::vector<Eigen::Vector4d> rows = {{along.x(), along.y(), along.z(), height}};
  for (const geometry::BrepFace& face : solid.faces()) {
    const Eigen::Matrix3Xd polygon = corners(solid, face.loops.front());
    if (!((along.transpose() * polygon).minCoeff<Eigen::PropagateNaN>() < height)) continue;
    const Eigen::Vector3d normal = turned_area(polygon).normalized();
    rows.emplace_back(normal.x(), normal.y(), normal.z(), normal.dot(polygon.col(0)));
  }
  HalfSpaces result{Eigen::Matrix3Xd(3, rows.size()), Eigen::VectorXd(rows.size())};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.normals.col(static_cast<Eigen::Index>(i)) = rows[i].head<3>();
    result.offsets[static_cast<Eigen::Index>(i)] = rows[i][3];
  }
  return result;
}

/// The middle of a ball within half spaces that is nearly the largest; its radius is negative where nothing
/// is within all of them.
struct InnerBall {
  Eigen::Vector3d centre;
  double radius;
};

/// By steps away from the nearest plane, which become smaller.
InnerBall inner_ball(const HalfSpaces& spaces, const Eigen::Vector3d& start, double size) {
  constexpr int steps = 1500;
  constexpr double shorter = 0.994;  // the last is 3e-5 of the size
  InnerBall best{start, -size};
  Eigen::Vector3d at = start;
  double step = size / 4;
  for (int i = 0; i < steps; ++i, step *= shorter) {
    Eigen::Index nearest = 0;
    const double radius = (spaces.offsets - spaces.normals.transpose() * at).minCoeff(&nearest);
    if (radius > best.radius) best = {at, radius};
    at -= step * spaces.normals.col(nearest);
  }
  return best;
}

InnerBall inner_ball(const Brep& solid) {
  const auto [low, high] = solid.box();
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  return inner_ball(below(solid, up, high.z() + solid.size()), (low + high) / 2, solid.size());
}

struct Cut {
  Eigen::Vector3d normal;
  double height;
  double radius;  ///< of the smaller inner ball on both sides, m
};

/// The middles of the widest gaps between vertices along an axis: a plane beside a vertex would make slivers.
std::vector<double> heights_between_vertices(const Brep& solid, int axis) {
  constexpr std::size_t most = 12;
  std::vector<double> places;
  for (Eigen::Index v = 0; v < solid.vertices().cols(); ++v) places.push_back(solid.vertices()(axis, v));
  std::sort(places.begin(), places.end());
  std::vector<std::pair<double, double>> gaps;  // less their widths, with their middles
  for (std::size_t i = 1; i < places.size(); ++i)
    gaps.emplace_back(places[i - 1] - places[i], (places[i - 1] + places[i]) / 2);
  std::sort(gaps.begin(), gaps.end());
  std::vector<double> result;
  for (std::size_t i = 0; i < std::min(most, gaps.size()); ++i) result.push_back(gaps[i].second);
  return result;
}

/// Across the coordinate axes, the best first.
std::vector<Cut> promising_cuts(const Brep& solid) {
  const auto [low, high] = solid.box();
  const Eigen::Vector3d middle = (low + high) / 2;
  std::vector<Cut> result;
  for (int axis = 0; axis < 3; ++axis)
    for (const double height : heights_between_vertices(solid, axis)) {
      const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
      const double one = inner_ball(below(solid, along, height), middle, solid.size()).radius,
                   other = inner_ball(below(solid, -along, -height), middle, solid.size()).radius;
      result.push_back({along, height, smaller(one, other)});
    }
  std::stable_sort(result.begin(), result.end(),
                   [](const Cut& a, const Cut& b) { return a.radius > b.radius; });
  return result;
}

std::vector<StarPiece> cut(const StarPiece& piece, const Cut& by) {
  std::vector<StarPiece> result;
  for (geometry::CutPart& part : geometry::cut_by_plane(piece.brep, by.height * by.normal, by.normal)) {
    for (std::optional<FaceId>& origin : part.origin)
      if (origin) origin = piece.origin[static_cast<std::size_t>(origin->value)];
    result.push_back({std::move(part.brep), std::move(part.origin)});
  }
  return result;
}

bool faces_are_discs(const Brep& solid) {
  return std::all_of(solid.faces().begin(), solid.faces().end(),
                     [](const geometry::BrepFace& face) { return face.loops.size() == 1; });
}

/// The two pieces of the best cut that comes to faces with one outline; nothing if there is none.
std::vector<StarPiece> cut_in_two(const StarPiece& piece) {
  constexpr std::size_t most_tries = 4;
  const std::vector<Cut> cuts = promising_cuts(piece.brep);
  for (std::size_t c = 0; c < std::min(most_tries, cuts.size()); ++c) {
    std::vector<StarPiece> made = cut(piece, cuts[c]);
    if (made.size() > 1 && std::all_of(made.begin(), made.end(),
                                       [](const StarPiece& part) { return faces_are_discs(part.brep); }))
      return made;
  }
  return {};
}

/// The tetrahedra of a piece around a point, as cells with plane sides and straight edges.
ComplexOfPiece tetrahedra(const StarPiece& piece, const Eigen::Vector3d& centre) {
  CellComplex whole = geometry::one_cell(piece.brep);
  for (geometry::CellEdge& edge : whole.edges)
    whole.curves[static_cast<std::size_t>(edge.curve.value)].shape =
        geometry::segment(whole.vertex(edge.start), whole.vertex(edge.end));
  for (std::size_t f = 0; f < whole.faces.size(); ++f) {
    const Eigen::Matrix3Xd polygon = corners(piece.brep, whole.faces[f].loop);
    const Eigen::Vector3d x = (polygon.col(1) - polygon.col(0)).normalized();
    whole.surfaces[f] = geometry::PlaneSurface{polygon.col(0), x, turned_area(polygon).normalized().cross(x)};
  }
  return {star_cells(piece.brep, std::move(whole), {centre}), piece.origin};
}

}  // namespace

bool is_of_triangles(const Brep& solid) {
  constexpr std::size_t many = 200;
  const auto& faces = solid.faces();
  const auto triangles = std::count_if(faces.begin(), faces.end(), [](const geometry::BrepFace& face) {
    return face.loops.size() == 1 && face.loops.front().size() == 3;
  });
  const bool plane = std::all_of(faces.begin(), faces.end(), [](const geometry::BrepFace& face) {
    return face.kind == geometry::SurfaceKind::plane && face.loops.size() == 1;
  });
  return plane && faces.size() >= many && 10 * static_cast<std::size_t>(triangles) >= 9 * faces.size();
}

std::optional<StarPieces> star_pieces(const Brep& solid) {
  if (!is_of_triangles(solid)) return std::nullopt;
  constexpr double least_radius = 0.005;  // of the size: flatter tetrahedra are of no use
  constexpr std::size_t most_pieces = 8;
  StarPiece whole{solid, {}};
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f) whole.origin.emplace_back(FaceId(f));
  std::vector<StarPiece> open = {std::move(whole)};
  std::vector<ComplexOfPiece> done;
  while (!open.empty()) {
    const StarPiece piece = std::move(open.back());
    open.pop_back();
    const InnerBall ball = inner_ball(piece.brep);
    if (ball.radius > least_radius * solid.size()) {
      done.push_back(tetrahedra(piece, ball.centre));
      continue;
    }
    std::vector<StarPiece> parts = cut_in_two(piece);
    if (parts.empty() || open.size() + done.size() + parts.size() > most_pieces) return std::nullopt;
    std::move(parts.begin(), parts.end(), std::back_inserter(open));
  }
  const int pieces = static_cast<int>(done.size());
  return StarPieces{joined_complex(done, 1e-7 * solid.size()), pieces};
}

std::optional<Decomposition> kept_triangles(const Brep& solid, const DecompositionOptions& options) {
  const Stopwatch watch;
  std::optional<StarPieces> stars = star_pieces(solid);
  if (!stars) return std::nullopt;
  CellComplex complex = hexahedral(solid, std::move(stars->complex), options.cut.tolerance * solid.size());
  if (!(geometry::least_quality(complex) > 0)) return std::nullopt;
  Decomposition result{complex, complex, {}, {}};
  result.report.cells = result.report.hexahedra = static_cast<int>(complex.cells.size());
  result.report.by_tetrahedra = true;
  result.report.seen_as = fmt::format(
      "its triangles as they are, around {} point{}, many and poor (a smooth body takes few, once isopatch "
      "reconstruct "
      "has found its faces)",
      stars->pieces, stars->pieces == 1 ? "" : "s");
  result.report.seconds = watch.seconds();
  return result;
}

}  // namespace isopatch::segmentation
