#include "segmentation/sweeps/internal/filleted_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/without_faces.hpp"
#include "geometry/splines/refine.hpp"
#include "segmentation/sweeps/internal/column_complex.hpp"
#include "segmentation/sweeps/internal/column_volume.hpp"
#include "segmentation/sweeps/internal/divided_drawing.hpp"
#include "segmentation/sweeps/internal/fillet_rings.hpp"
#include "segmentation/sweeps/internal/fillets.hpp"
#include "segmentation/sweeps/internal/halved_rings.hpp"
#include "segmentation/sweeps/internal/offset_curve.hpp"
#include "segmentation/sweeps/piece_of_curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::KnotVector;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::Parameter;

/// A piece of a round's section as a rational quadratic arc: (away from the sharp edge, from the floor), m.
struct Section {
  std::array<Eigen::Vector2d, 3> points;
  double middle_weight;
};

/// Angles about the centre, rad: 0 where the round ends on the wall, half pi where it ends on the floor.
Section section(double radius, double from, double to) {
  const double half = (to - from) / 2;
  const auto at = [&](double angle, double distance) -> Eigen::Vector2d {
    return radius * (Eigen::Vector2d::Ones() - distance * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  };
  return {{at(from, 1), at(from + half, 1 / std::cos(half)), at(to, 1)}, std::cos(half)};
}
constexpr double on_wall = 0, middle = std::numbers::pi / 4, on_floor = std::numbers::pi / 2;

/// A round over a piece of the drawing.
struct FilletOver {
  int edge;
  bool left;
  const Fillet* fillet;
  NurbsCurve sharp;  // at the floor
};

class FilletedStack {
 public:
  FilletedStack(const Brep& solid, const Brep& sharp, const SweepFrame& frame, std::vector<Fillet> fillets,
                const QuadrangulationOptions& options)
      : solid_(solid),
        sharp_(sharp),
        frame_(frame),
        fillets_(std::move(fillets)),
        divided_(divided_drawing(sharp, frame, {}, options,
                                 [&](const SweptDrawing& drawing) { return widened_profile(drawing); })) {
    find_pieces(divided_.quads);
    rings_ = fillet_rings(drawing_.profile, divided_.quads, ring_pieces(), tolerance());
    divide_rings(rings_, on_rims(), mitre);
  }

  SweptCells make() {
    const MovingDrawing moving(sharp_, frame_, drawing_, rings_.quads, rings_.offsets);
    Layers found = layers(rings_.quads, drawing_.slabs, moving, asked(), 1e-7 * solid_.size());
    require_whole(sharp_, frame_, rings_.quads, moving, found);
    for (const FilletOver& over : overs_)
      if (over.fillet->convex)
        round_rim(over, found);
      else
        round(over, found);
    require_all_rounds();
    SweptCells result{column_complex(sharp_, frame_, rings_.quads, moving, found, rounding_), frame_.along,
                      static_cast<int>(rings_.quads.quads.size()), static_cast<int>(found.levels.size()),
                      static_cast<int>(fillets_.size())};
    name_faces(result.complex);
    return result;
  }

 private:
  double tolerance() const { return 1e-6 * solid_.size(); }
  double side(const FilletOver& over) const { return over.left ? 1 : -1; }
  double rise(const Fillet& fillet) const { return fillet.rises ? 1 : -1; }
  double floor_of(const Fillet& fillet) const {
    return frame_.height(fillet.tube) - rise(fillet) * fillet.radius;
  }

  /// The curve beside a sharp edge at a point of a round's section.
  std::optional<NurbsCurve> curve_at(const FilletOver& over, const Eigen::Vector2d& at) const {
    std::optional<NurbsCurve> beside = offset_curve(over.sharp, frame_.along, side(over) * at[0]);
    if (!beside) return std::nullopt;
    return NurbsCurve(beside->knots(),
                      beside->control_points().colwise() + rise(*over.fillet) * at[1] * frame_.along,
                      beside->weights());
  }

  bool lies_on(const NurbsCurve& curve, FaceId face) const {
    return std::all_of(std::begin(probes), std::end(probes), [&](double t) {
      const geometry::FaceProjection nearest = solid_.project(face, curve.point(Parameter<1>(t)));
      return nearest.distance < tolerance() && solid_.contains(face, nearest.uv);
    });
  }

  /// By which an edge of the drawing is to be moved to its left so that it is where the round over it ends on
  /// the floor.
  std::optional<double> offset_of(const Brep& sheet, EdgeId edge) const {
    constexpr int parts = 3;  // of a whole circle: below 170 degrees
    std::optional<double> found;
    for (int i = 0; i < parts; ++i) {
      const NurbsCurve piece =
          piece_of_curve(sheet, edge, static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts);
      std::optional<double> here;
      for (const Fillet& fillet : fillets_)
        for (const bool left : {true, false}) {
          const FilletOver over{0, left, &fillet, lifted(piece, floor_of(fillet))};
          const auto halfway = curve_at(over, section(fillet.radius, middle, on_floor).points[0]);
          if (halfway && lies_on(*halfway, fillet.face)) here = side(over) * fillet.radius;
        }
      if (!here || (i > 0 && std::abs(*here - *found) > tolerance())) return std::nullopt;
      found = here;
    }
    return found;
  }

  NurbsCurve lifted(const NurbsCurve& curve, double height) const {
    const double by = height - frame_.height(curve.control_points().col(0));
    return NurbsCurve(curve.knots(), curve.control_points().colwise() + by * frame_.along, curve.weights());
  }

  /// The drawing with outlines under rounds where those end on floors: what is divided, so that there is room
  /// for the rings.
  Profile widened_profile(const SweptDrawing& drawing) const {
    Profile result = drawing.profile;
    std::map<int, Eigen::Vector2d> moved;
    for (std::size_t e = 0; e < result.edges.size(); ++e) {
      const EdgeId edge(static_cast<int>(e));
      ProfileEdge& drawn = result.edges[e];
      const std::optional<double> offset = offset_of(drawing.sheet, edge);
      if (!offset) continue;
      const auto last = drawn.points.size() - 1;
      for (std::size_t i = 0; i < last; ++i) {
        const auto beside = offset_curve(
            piece_of_curve(drawing.sheet, edge, static_cast<double>(i) / static_cast<double>(last),
                           static_cast<double>(i + 1) / static_cast<double>(last)),
            frame_.along, *offset);
        if (!beside) return drawing.profile;
        drawn.points[i] = frame_.flat(beside->point(beside->low()));
        drawn.points[i + 1] = frame_.flat(beside->point(beside->high()));
      }
      if (drawn.start < 0) continue;
      moved.insert_or_assign(drawn.start, drawn.points.front());
      moved.insert_or_assign(drawn.end, drawn.points.back());
    }
    for (const auto& [vertex, place] : moved) result.vertices[static_cast<std::size_t>(vertex)] = place;
    for (ProfileEdge& drawn : result.edges) {
      if (drawn.start < 0) continue;
      drawn.points.front() = result.vertices[static_cast<std::size_t>(drawn.start)];
      drawn.points.back() = result.vertices[static_cast<std::size_t>(drawn.end)];
    }
    return result;
  }

  /// Which pieces of the drawing are under which rounds, and on which side.
  void find_pieces(const Quadrangulation& quads) {
    const MovingDrawing at(sharp_, frame_, drawing_, quads);
    for (int e = 0; e < static_cast<int>(quads.edges.size()); ++e) {
      if (quads.edges[static_cast<std::size_t>(e)].profile_edge < 0) continue;
      for (const Fillet& fillet : fillets_)
        for (const bool left : {true, false}) {
          FilletOver over{e, left, &fillet, at.curve(e, floor_of(fillet))};
          const auto halfway = curve_at(over, section(fillet.radius, middle, on_floor).points[0]);
          if (halfway && lies_on(*halfway, fillet.face)) overs_.push_back(std::move(over));
        }
    }
  }

  std::vector<FilletPiece> ring_pieces() const {
    std::map<int, FilletPiece> result;
    for (const FilletOver& over : overs_) {
      const double width = over.fillet->radius;
      const auto beside = curve_at(over, {width, 0});
      if (!beside)
        throw Error(ErrorCode::unsupported,
                    fmt::format("{} is as wide as its outline", describe(solid_, over.fillet->face)));
      const FilletPiece piece{
          over.edge,
          over.left,
          width,
          {frame_.flat(beside->point(beside->low())), frame_.flat(beside->point(beside->high()))}};
      const FilletPiece& known = result.try_emplace(over.edge, piece).first->second;
      if (known.left != piece.left || std::abs(known.width - piece.width) > tolerance())
        throw Error(ErrorCode::unsupported,
                    fmt::format("{} has a round of another radius or on the other side over it",
                                describe(solid_, over.fillet->face)));
    }
    std::vector<FilletPiece> pieces;
    for (const auto& [edge, piece] : result) pieces.push_back(piece);
    return pieces;
  }

  /// Edges under rounds on rims.
  std::vector<int> on_rims() const {
    std::set<int> result, others;
    for (const FilletOver& over : overs_) (over.fillet->convex ? result : others).insert(over.edge);
    for (const int edge : result)
      if (others.contains(edge))
        throw Error(ErrorCode::unsupported, "an outline has rounds both on its rim and in its corner");
    return {result.begin(), result.end()};
  }

  /// The quadrilateral on the wall's side of a piece under a round.
  int wall_quad(int edge) const {
    for (int q = 0; q < static_cast<int>(rings_.quads.quads.size()); ++q)
      for (const geometry::EdgeUse& use : rings_.quads.quads[static_cast<std::size_t>(q)].sides)
        if (use.edge.value == edge && q != rings_.rings.at(edge)) return q;
    throw Error(ErrorCode::unsupported, "a round without a wall");
  }

  /// Walls are divided where rounds end.
  std::vector<std::vector<double>> asked() const {
    std::vector<std::vector<double>> result(rings_.quads.quads.size());
    for (const FilletOver& over : overs_) {
      const Fillet& fillet = *over.fillet;
      const int beside = fillet.convex ? rings_.rings.at(over.edge) : wall_quad(over.edge);
      std::vector<double>& heights = result[static_cast<std::size_t>(beside)];
      heights.push_back(height_from_floor(fillet, 1));
      if (fillet.convex) heights.push_back(height_from_floor(fillet, mitre));
    }
    return result;
  }

  /// @param share  of its radius
  double height_from_floor(const Fillet& fillet, double share) const {
    return floor_of(fillet) + rise(fillet) * share * fillet.radius;
  }

  static int level_at(const Layers& layers, double height) {
    const auto nearest =
        std::min_element(layers.levels.begin(), layers.levels.end(),
                         [&](double a, double b) { return std::abs(a - height) < std::abs(b - height); });
    return static_cast<int>(nearest - layers.levels.begin());
  }

  /// u along the sharp edge, v along the section.
  NurbsSurface surface_over(const FilletOver& over, double from, double to) {
    const Section across = section(over.fillet->radius, from, to);
    std::vector<Eigen::Matrix4Xd> rows;
    for (const Eigen::Vector2d& point : across.points)
      rows.push_back(curve_at(over, point).value().homogeneous());
    rows[1] *= across.middle_weight;
    Eigen::Matrix4Xd net(4, 3 * rows[0].cols());
    net << rows[0], rows[1], rows[2];
    NurbsSurface made = NurbsSurface::from_homogeneous({over.sharp.knots(0), KnotVector::bezier(2)}, net);
    areas_[over.fillet->face] += area_of(made);
    return made;
  }

  static double area_of(const NurbsSurface& surface) {
    constexpr int steps = 24;  // midpoints: about 1e-4 of the area
    double area = 0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps; ++j) {
        const Eigen::Matrix<double, 3, 2> d = surface.jacobian({(i + 0.5) / steps, (j + 0.5) / steps});
        area += d.col(0).cross(d.col(1)).norm() / (steps * steps);
      }
    return area;
  }

  /// The curve of a round's cross-section at one end of its edge.
  static NurbsCurve section_at(const NurbsSurface& surface, bool at_end) {
    const Eigen::Index n = surface.size(0), column = at_end ? n - 1 : 0;
    const Eigen::Matrix4Xd net = surface.homogeneous();
    Eigen::Matrix4Xd points(4, 3);
    for (Eigen::Index j = 0; j < 3; ++j) points.col(j) = net.col(column + n * j);
    return NurbsCurve::from_homogeneous({surface.knots(1)}, points);
  }

  /// Of the column on the wall's side, from the floor to where the round ends.
  std::vector<int> levels_along(const FilletOver& over, const Layers& layers) const {
    const Fillet& fillet = *over.fillet;
    const int level = level_at(layers, floor_of(fillet)),
              far = level_at(layers, floor_of(fillet) + rise(fillet) * fillet.radius);
    std::vector<int> result;
    for (const Layer& layer : layers.columns[static_cast<std::size_t>(wall_quad(over.edge))])
      if (layer.low >= std::min(level, far) && layer.high <= std::max(level, far))
        result.push_back(fillet.rises ? layer.low : layer.high);
    result.push_back(far);
    if (!fillet.rises) std::sort(result.begin(), result.end(), std::greater<>());
    if (result.size() < 2 || result.front() != level)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} has no wall beside it", describe(solid_, fillet.face)));
    return result;
  }

  void round(const FilletOver& over, const Layers& layers) {
    const Fillet& fillet = *over.fillet;
    const QuadEdge& drawn = rings_.quads.edges[static_cast<std::size_t>(over.edge)];
    const FaceId origin(static_cast<int>(sharp_.faces().size()) +
                        static_cast<int>(&fillet - fillets_.data()));
    const std::vector<int> levels = levels_along(over, layers);
    const NurbsSurface down = surface_over(over, middle, on_floor);
    rounding_.floors.insert_or_assign({rings_.rings.at(over.edge), levels.front()},
                                      Rounding::Side{{over.edge, levels.front()}, down, origin});
    for (const bool at_end : {false, true}) {
      const int vertex = at_end ? drawn.end : drawn.start, radial = rings_.radials.at(vertex);
      const NurbsCurve curve = section_at(down, at_end);
      const bool outwards = rings_.quads.edges[static_cast<std::size_t>(radial)].start == vertex;
      rounding_.level_edges.insert_or_assign({radial, levels.front()}, outwards ? curve : reversed(curve, 0));
    }
    const auto pieces = static_cast<double>(levels.size() - 1);
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
      round_wall(over, levels[i], levels[i + 1], middle * (1 - static_cast<double>(i) / pieces),
                 middle * (1 - static_cast<double>(i + 1) / pieces), origin);
  }

  /// Between two levels, of which the first goes to the round.
  void round_wall(const FilletOver& over, int level, int next, double from, double to, FaceId origin) {
    const QuadEdge& drawn = rings_.quads.edges[static_cast<std::size_t>(over.edge)];
    const int low = std::min(level, next), high = std::max(level, next);
    const NurbsSurface surface = surface_over(over, from, to);
    rounding_.walls.insert_or_assign({over.edge, low, high},
                                     Rounding::Side{{over.edge, level}, surface, origin});
    rounding_.level_edges.insert_or_assign(
        {over.edge, level}, curve_at(over, section(over.fillet->radius, from, to).points[0]).value());
    for (const bool at_end : {false, true}) {
      const int vertex = at_end ? drawn.end : drawn.start;
      const NurbsCurve curve = section_at(surface, at_end);
      rounding_.vertices[{vertex, level}] = curve.point(curve.low());
      rounding_.upright_edges.insert_or_assign({vertex, low, high},
                                               low == level ? curve : reversed(curve, 0));
    }
  }

  /// Divides the hexahedra along a rounded rim: in cross-section a quarter of a disc, which takes three of
  /// them around one line inside. The fourth, which has the sharp edge, is left out, and its left and lower
  /// sides become one face from that line to the middle of the round.
  void round_rim(const FilletOver& over, Layers& layers) {
    const Fillet& fillet = *over.fillet;
    const FilletRings::Halves& halves = rings_.halves.at(over.edge);
    const QuadEdge& drawn = rings_.quads.edges[static_cast<std::size_t>(over.edge)];
    const FaceId origin(static_cast<int>(sharp_.faces().size()) +
                        static_cast<int>(&fillet - fillets_.data()));
    const int floor = level_at(layers, floor_of(fillet)),
              far = level_at(layers, height_from_floor(fillet, 1)),
              inside = level_at(layers, height_from_floor(fillet, mitre));
    leave_out(layers.columns[static_cast<std::size_t>(halves.outer)], floor, inside, far, fillet);
    const auto between = [](int a, int b) { return std::pair(std::min(a, b), std::max(a, b)); };
    const auto [wall_low, wall_high] = between(far, inside);
    const auto [low, high] = between(inside, floor);
    const NurbsSurface up = surface_over(over, on_wall, middle), in = surface_over(over, middle, on_floor);
    const NurbsCurve along = curve_at(over, section(fillet.radius, on_wall, middle).points[2]).value();
    rounding_.walls.insert_or_assign({over.edge, wall_low, wall_high},
                                     Rounding::Side{{over.edge, far}, up, origin});
    rounding_.floors.insert_or_assign({halves.inner, floor},
                                      Rounding::Side{{halves.between, floor}, in, origin});
    rounding_.level_edges.insert_or_assign({over.edge, inside}, along);
    rounding_.same_level_edges[{halves.between, floor}] = {over.edge, inside};
    rounding_.leaning_walls[{halves.between, low, high}] = {{halves.outer, inside}, !fillet.rises};
    for (const bool at_end : {false, true}) {
      const int vertex = at_end ? drawn.end : drawn.start, middle_vertex = rings_.middles.at(vertex),
                radial = rings_.radials.at(vertex), rest = rings_.inner_radials.at(vertex);
      const NurbsCurve rising = section_at(up, at_end), leading_in = section_at(in, at_end);
      const Eigen::Vector3d place = rising.point(rising.high());
      rounding_.vertices[{vertex, inside}] = rounding_.vertices[{middle_vertex, floor}] = place;
      rounding_.same_vertices[{middle_vertex, floor}] = {vertex, inside};
      rounding_.upright_edges.insert_or_assign({vertex, wall_low, wall_high},
                                               wall_low == far ? rising : reversed(rising, 0));
      const bool outwards = rings_.quads.edges[static_cast<std::size_t>(radial)].start == vertex;
      rounding_.level_edges.insert_or_assign({rest, floor}, outwards ? leading_in : reversed(leading_in, 0));
      rounding_.leaning_edges[{middle_vertex, low, high}] = {{radial, inside}, outwards != fillet.rises};
    }
  }

  /// The hexahedron at a sharp edge.
  void leave_out(std::vector<Layer>& column, int floor, int inside, int far, const Fillet& fillet) const {
    const auto is_between = [](int a, int b) {
      return
          [a, b](const Layer& layer) { return layer.low == std::min(a, b) && layer.high == std::max(a, b); };
    };
    const auto at_edge = std::find_if(column.begin(), column.end(), is_between(floor, inside));
    if (at_edge == column.end() || std::none_of(column.begin(), column.end(), is_between(inside, far)))
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} is beside something else that begins or ends at its height",
                              describe(solid_, fillet.face)));
    column.erase(at_edge);
  }

  void require_all_rounds() {
    for (const Fillet& fillet : fillets_)
      if (!(std::abs(areas_[fillet.face] - solid_.area(fillet.face)) < 1e-3 * solid_.area(fillet.face)))
        throw Error(ErrorCode::unsupported,
                    fmt::format("{} is no round along one outline", describe(solid_, fillet.face)));
  }

  /// Names of the sharp solid's faces, in whose order rounds are left out, become those of the solid's.
  void name_faces(geometry::CellComplex& complex) const {
    std::vector<FaceId> names;
    for (int f = 0; f < static_cast<int>(solid_.faces().size()); ++f)
      if (std::none_of(fillets_.begin(), fillets_.end(),
                       [&](const Fillet& fillet) { return fillet.face == FaceId(f); }))
        names.emplace_back(f);
    for (const Fillet& fillet : fillets_) names.push_back(fillet.face);
    for (geometry::CellFace& face : complex.faces)
      if (face.origin) face.origin = names[static_cast<std::size_t>(face.origin->value)];
  }

  static constexpr double probes[] = {0.1, 0.5, 0.9};
  /// Distance of the line inside of a round on a rim from both ends of its cross-section, as a share of the
  /// radius.
  static constexpr double mitre = 0.6;
  const Brep& solid_;
  const Brep& sharp_;
  SweepFrame frame_;
  std::vector<Fillet> fillets_;
  DividedDrawing divided_;
  const SweptDrawing& drawing_ = divided_.drawing;
  std::vector<FilletOver> overs_;
  FilletRings rings_;
  Rounding rounding_;
  std::map<FaceId, double> areas_;
};

/// Nothing where the faces around the rounds do not meet.
std::optional<Brep> sharp_solid(const Brep& solid, const std::vector<FaceId>& rounds) {
  try {
    return geometry::without_faces(solid, rounds);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    return std::nullopt;
  }
}

/// Once more within closer bounds where rounds leave little of a drawing's quality; the better.
SweptCells filleted(const Brep& solid, const Brep& sharp, const SweepFrame& frame,
                    QuadrangulationOptions options) {
  constexpr double poor = 0.15, good = 0.25;  // scaled Jacobians
  const auto made = [&] {
    return FilletedStack(solid, sharp, frame, fillets(solid, frame.along).value(), options).make();
  };
  SweptCells first = made();
  const double least = geometry::least_quality(first.complex);
  if (least >= poor) return first;
  options.smallest_jacobian = std::max(options.smallest_jacobian, good);
  try {
    SweptCells second = made();
    return geometry::least_quality(second.complex) > least ? second : first;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    return first;
  }
}

std::optional<SweptCells> along_direction(const Brep& solid, const Eigen::Vector3d& along,
                                          const QuadrangulationOptions& options) {
  const auto found = fillets(solid, along);
  if (!found) return std::nullopt;
  std::vector<FaceId> faces;
  for (const Fillet& fillet : *found) faces.push_back(fillet.face);
  const std::optional<Brep> without = sharp_solid(solid, faces);
  if (!without) return std::nullopt;
  const Brep& sharp = *without;
  for (const SweepFrame& frame : sweep_frames(sharp))
    if (frame.along.cross(along).norm() < 1e-6) return filleted(solid, sharp, frame, options);
  return std::nullopt;
}

}  // namespace

std::optional<SweptCells> filleted_cells(const Brep& solid, const QuadrangulationOptions& options) {
  std::optional<SweptCells> best;
  std::optional<Error> refusal;
  for (const Eigen::Vector3d& along : floor_directions(solid)) {
    try {
      std::optional<SweptCells> made = along_direction(solid, along, options);
      if (made && (!best || made->complex.cells.size() < best->complex.cells.size())) best = std::move(made);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      refusal = error;
    }
  }
  if (!best && refusal) throw *refusal;
  return best;
}

}  // namespace isopatch::segmentation
