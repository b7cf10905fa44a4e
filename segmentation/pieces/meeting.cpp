#include "segmentation/pieces/internal/meeting.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/pieces/internal/socket.hpp"
#include "segmentation/sweeps/stack.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::PlaneSurface;

bool is_floor(const Piece& piece, const PlaneSurface& plane) {
  return piece.turned || std::abs(piece.frame.along.dot(plane.normal())) > 0.5;
}

double tolerance_of(const std::vector<Piece>& pieces) {
  double size = 0;
  for (const Piece& piece : pieces) size = std::max(size, piece.brep.size());
  return 1e-6 * size;
}

/// Whether faces in one plane have a common area, as far as their boxes tell.
bool overlap(const Brep& a, FaceId face_a, const Brep& b, FaceId face_b, const PlaneSurface& plane,
             double tolerance) {
  const auto box = [&](const Brep& brep, FaceId face) {
    Eigen::AlignedBox2d result;
    for (const auto& loop : brep.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (int i = 0; i <= 8; ++i) result.extend(plane.domain_point(brep.point(use.edge, i / 8.0)));
    return result;
  };
  const Eigen::AlignedBox2d both = box(a, face_a).intersection(box(b, face_b));
  return !both.isEmpty() && both.sizes().minCoeff() > tolerance;
}

/// With x along a piece that has it as a wall, if there is one.
PlaneSurface ruled(const PlaneSurface& plane, const Piece& first, const Piece& second) {
  const bool of_first = !is_floor(first, plane);
  if (!of_first && is_floor(second, plane)) return plane;
  const Eigen::Vector3d x = of_first ? first.frame.along : second.frame.along;
  PlaneSurface result{plane.origin, x, plane.normal().cross(x)};
  if (of_first && !is_floor(second, plane)) {
    const double turn = std::abs(x.dot(second.frame.along));
    if (turn > 1e-7 && turn < 1 - 1e-7)
      throw Error(ErrorCode::unsupported, "pieces meet that are swept in directions at no right angle");
  }
  return result;
}

/// Straight edges in a plane between two faces there.
std::vector<Line> lines_on(const geometry::CellComplex& complex, const PlaneSurface& plane,
                           double tolerance) {
  const auto is_on = [&](const Eigen::Vector3d& point) {
    return std::abs((point - plane.origin).dot(plane.normal())) < tolerance;
  };
  std::map<EdgeId, int> uses;
  for (const geometry::CellFace& face : complex.faces) {
    const bool is_in_plane = std::all_of(face.loop.begin(), face.loop.end(), [&](const auto& use) {
      const auto& curve = std::get<geometry::NurbsCurve>(complex.curve(complex.edge(use.edge).curve).shape);
      return is_on(curve.point(curve.low())) && is_on(curve.point((curve.low() + curve.high()) / 2));
    });
    if (is_in_plane)
      for (const geometry::EdgeUse& use : face.loop) ++uses[use.edge];
  }
  std::vector<Line> result;
  for (const auto& [edge, count] : uses) {
    const auto& curve = std::get<geometry::NurbsCurve>(complex.curve(complex.edge(edge).curve).shape);
    if (count == 2 && curve.degree(0) == 1)
      result.push_back({complex.vertex(complex.edge(edge).start), complex.vertex(complex.edge(edge).end)});
  }
  return result;
}

/// A line in a plane along its x (axis 0) or y (axis 1), at a value of the other.
struct Segment {
  int axis;
  double at, low, high;
};

class Settler {
 public:
  Settler(const std::vector<Piece>& pieces, std::vector<Meeting> places, bool with_sockets)
      : pieces_(pieces), places_(std::move(places)), tolerance_(tolerance_of(pieces)) {
    stacks_.resize(pieces.size());
    turned_.resize(pieces.size());
    boxes_.resize(pieces.size());
    divided_by_.resize(pieces.size());
    for (const Piece& piece : pieces) sockets_.push_back(with_sockets ? socket_of(piece) : std::nullopt);
  }

  std::vector<MetPiece> make() {
    constexpr int most_rounds = 4;
    for (int round = 0; round == 0 || (round < most_rounds && !share_chords()); ++round)
      for (const int number : order()) divide(number);
    settle();
    std::vector<MetPiece> result;
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      result.push_back(boxes_[p]    ? MetPiece{std::move(*boxes_[p]), sockets_[p]->top.normal()}
                       : turned_[p] ? MetPiece{std::move(turned_[p]->complex), turned_[p]->about}
                                    : MetPiece{stacks_[p]->complex(), stacks_[p]->frame().along});
    return result;
  }

 private:
  const Piece& piece(int number) const { return pieces_[static_cast<std::size_t>(number)]; }
  bool is_socket(int number) const { return sockets_[static_cast<std::size_t>(number)].has_value(); }
  Stack& stack(int number) { return *stacks_[static_cast<std::size_t>(number)]; }

  void divide(int number) {
    const auto n = static_cast<std::size_t>(number);
    const Piece& made = pieces_[n];
    const std::vector<Line> lines = lines_on(number);
    if (divided_by_[n] == lines) return;
    divided_by_[n] = lines;
    if (is_socket(number)) {
      boxes_[n] = socket_cells(made, *sockets_[n], lines);
      return;
    }
    if (made.turned) {
      turned_[n] = turned_cells(made.brep, lines);
      return;
    }
    stacks_[n].emplace(made.brep, made.frame, lines);
    settle_outlines(number);
  }

  /// Whether pieces that meet with floors have the same chords there.
  bool share_chords() {
    const auto has = [&](const std::vector<Line>& lines, const Line& line) {
      std::vector<Line> others = lines;
      add_line(line, others);
      return others.size() == lines.size();
    };
    return std::all_of(places_.begin(), places_.end(), [&](const Meeting& place) {
      if (!is_floor(piece(place.first), place.plane) || !is_floor(piece(place.second), place.plane))
        return true;
      const std::vector<Line> first = shared_chords(place.first, place),
                              second = shared_chords(place.second, place);
      return first.size() == second.size() &&
             std::all_of(first.begin(), first.end(), [&](const Line& line) { return has(second, line); });
    });
  }

  /// Of one piece, inside what both have of the plane.
  std::vector<Line> shared_chords(int number, const Meeting& place) {
    const int other = place.first == number ? place.second : place.first;
    std::vector<Line> result;
    for (const Line& line : chords_of(number, place.plane)) {
      const Eigen::Vector3d middle = (line[0] + line[1]) / 2;
      if (is_inside_cut(piece(number), middle) && is_inside_cut(piece(other), middle)) result.push_back(line);
    }
    return result;
  }

  /// Turned pieces, then stacks, walls before floors.
  std::vector<int> order() const {
    std::vector<int> result;
    std::vector<bool> done(pieces_.size(), false);
    const auto waits = [&](int number) {
      if (piece(number).turned) return false;
      return std::any_of(places_.begin(), places_.end(), [&](const Meeting& place) {
        if (place.first != number && place.second != number) return false;
        const int other = place.first == number ? place.second : place.first;
        // What stands on a socket takes its lines over.
        if (is_socket(number) && is_floor(piece(other), place.plane)) return false;
        return !done[static_cast<std::size_t>(other)] && is_floor(piece(number), place.plane);
      });
    };
    while (std::count(done.begin(), done.end(), false) > 0) {
      int next = -1;
      for (int p = 0; p < static_cast<int>(pieces_.size()); ++p)
        if (!done[static_cast<std::size_t>(p)] && (next < 0 || (waits(next) && !waits(p)))) next = p;
      done[static_cast<std::size_t>(next)] = true;
      result.push_back(next);
    }
    return result;
  }

  /// Sides of pieces that stand on a floor of this one.
  std::vector<Line> lines_on(int number) {
    std::vector<Line> result;
    for (const Meeting& place : places_) {
      if (place.first != number && place.second != number) continue;
      const int other = place.first == number ? place.second : place.first;
      if (!is_done(other) || !is_floor(piece(number), place.plane)) continue;
      if (is_floor(piece(other), place.plane)) {
        if (is_socket(number)) continue;
        for (const Line& line : shared_chords(other, place)) add_line(line, result);
        continue;
      }
      for (const StackSide& side : stack(other).sides_on(place.plane, tolerance_)) {
        if (!is_cut(piece(other), place.plane.point((side.low + side.high) / 2))) continue;
        const std::array<Eigen::Vector2d, 4> corners = {
            side.low, Eigen::Vector2d(side.high.x(), side.low.y()), side.high,
            Eigen::Vector2d(side.low.x(), side.high.y())};
        for (std::size_t k = 0; k < 4; ++k)
          add_line({place.plane.point(corners[k]), place.plane.point(corners[(k + 1) % 4])}, result);
      }
    }
    return result;
  }

  bool is_done(int number) const {
    const auto n = static_cast<std::size_t>(number);
    return stacks_[n] || turned_[n] || boxes_[n];
  }

  std::vector<Line> chords_of(int number, const PlaneSurface& plane) {
    if (const auto& box = boxes_[static_cast<std::size_t>(number)])
      return segmentation::lines_on(*box, plane, tolerance_);
    const auto& turned = turned_[static_cast<std::size_t>(number)];
    return turned ? segmentation::lines_on(turned->complex, plane, tolerance_)
                  : stack(number).lines_on(plane, tolerance_);
  }

  void add_line(const Line& line, std::vector<Line>& lines) const {
    const auto same = [&](const Line& a, const Line& b) {
      return (a[0] - b[0]).norm() < tolerance_ && (a[1] - b[1]).norm() < tolerance_;
    };
    if (std::none_of(lines.begin(), lines.end(), [&](const Line& known) {
          return same(known, line) || same(known, {line[1], line[0]});
        }))
      lines.push_back(line);
  }

  bool is_cut(const Piece& of, const Eigen::Vector3d& point) const {
    const std::vector<FaceId> faces = cut_faces(of);
    return std::any_of(faces.begin(), faces.end(), [&](FaceId face) {
      const geometry::FaceProjection nearest = of.brep.project(face, point);
      return nearest.distance < tolerance_ && of.brep.contains(face, nearest.uv);
    });
  }

  bool is_inside_cut(const Piece& of, const Eigen::Vector3d& point) const {
    if (!is_cut(of, point)) return false;
    for (const FaceId face : cut_faces(of))
      for (const auto& loop : of.brep.face(face).loops)
        for (const geometry::EdgeUse& use : loop)
          if (of.brep.project(use.edge, point).distance < 10 * tolerance_) return false;
    return true;
  }

  std::optional<Segment> segment(const PlaneSurface& plane, const Line& line) const {
    for (const Eigen::Vector3d& end : line)
      if (std::abs((end - plane.origin).dot(plane.normal())) > tolerance_) return std::nullopt;
    const Eigen::Vector2d a = plane.domain_point(line[0]), b = plane.domain_point(line[1]);
    for (const int axis : {0, 1})
      if (std::abs(a[1 - axis] - b[1 - axis]) < tolerance_)
        return Segment{axis, a[1 - axis], std::min(a[axis], b[axis]), std::max(a[axis], b[axis])};
    return std::nullopt;
  }

  std::vector<Segment> outlines(const Piece& of, const PlaneSurface& plane) const {
    std::vector<Segment> result;
    for (const FaceId face : cut_faces(of))
      for (const auto& loop : of.brep.face(face).loops)
        for (const geometry::EdgeUse& use : loop)
          if (of.brep.edge(use.edge).kind == geometry::CurveKind::line)
            if (const auto made = segment(plane, {of.brep.point(use.edge, 0), of.brep.point(use.edge, 1)}))
              result.push_back(*made);
    return result;
  }

  static std::vector<Segment> outlines(const std::vector<StackSide>& sides) {
    std::vector<Segment> result;
    for (const StackSide& side : sides)
      for (const int axis : {0, 1})
        for (const Eigen::Vector2d& at : {side.low, side.high})
          result.push_back({axis, at[1 - axis], side.low[axis], side.high[axis]});
    return result;
  }

  /// Divides one side that a segment crosses.
  /// @return  whether there was one
  bool divide_once(int number, const PlaneSurface& plane, const std::vector<Segment>& by) {
    for (const StackSide& side : stack(number).sides_on(plane, tolerance_))
      for (const Segment& segment : by) {
        const int axis = 1 - segment.axis;  // what it divides
        if (segment.at < side.low[axis] + tolerance_ || segment.at > side.high[axis] - tolerance_ ||
            segment.high < side.low[1 - axis] + tolerance_ || segment.low > side.high[1 - axis] - tolerance_)
          continue;
        stack(number).divide(plane, side, axis,
                             (segment.at - side.low[axis]) / (side.high[axis] - side.low[axis]));
        if (++divisions_ > most_divisions)
          throw Error(ErrorCode::unsupported,
                      "pieces could not be made to meet: divisions of one call for "
                      "divisions of the other without end");
        return true;
      }
    return false;
  }

  /// Sides end where faces that were cut end.
  void settle_outlines(int number) {
    for (const Meeting& place : places_)
      if (place.first == number || place.second == number) {
        const std::vector<Segment> by = outlines(piece(number), place.plane);
        while (divide_once(number, place.plane, by)) continue;
      }
  }

  void settle() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const Meeting& place : places_)
        for (const auto& [number, other] :
             {std::pair(place.first, place.second), std::pair(place.second, place.first)}) {
          if (piece(number).turned || piece(other).turned || is_socket(number) || is_socket(other)) continue;
          const std::vector<Segment> by = outlines(stack(other).sides_on(place.plane, tolerance_));
          while (divide_once(number, place.plane, by)) changed = true;
        }
    }
  }

  static constexpr int most_divisions = 300;
  const std::vector<Piece>& pieces_;
  std::vector<Meeting> places_;
  double tolerance_;
  std::vector<std::optional<Stack>> stacks_;
  std::vector<std::optional<TurnedCells>> turned_;
  std::vector<std::optional<std::vector<Line>>> divided_by_;
  std::vector<std::optional<Socket>> sockets_;
  std::vector<std::optional<geometry::CellComplex>> boxes_;  // of sockets
  int divisions_ = 0;
};

}  // namespace

std::vector<Meeting> meetings(const std::vector<Piece>& pieces) {
  const double tolerance = tolerance_of(pieces);
  std::vector<Meeting> result;
  const auto known = [&](int a, int b, const PlaneSurface& plane) {
    return std::any_of(result.begin(), result.end(), [&](const Meeting& other) {
      return other.first == a && other.second == b &&
             std::abs(other.plane.normal().dot(plane.normal())) > 0.5 &&
             std::abs((plane.origin - other.plane.origin).dot(plane.normal())) < tolerance;
    });
  };
  for (int a = 0; a < static_cast<int>(pieces.size()); ++a)
    for (int b = a + 1; b < static_cast<int>(pieces.size()); ++b) {
      const Piece &first = pieces[static_cast<std::size_t>(a)], &second = pieces[static_cast<std::size_t>(b)];
      for (const FaceId face_a : cut_faces(first))
        for (const FaceId face_b : cut_faces(second)) {
          const PlaneSurface here = plane_of(first.brep, face_a), there = plane_of(second.brep, face_b);
          if (here.normal().dot(there.normal()) > -1 + 1e-9 ||
              std::abs((there.origin - here.origin).dot(here.normal())) > tolerance || known(a, b, here) ||
              !overlap(first.brep, face_a, second.brep, face_b, here, tolerance))
            continue;
          result.push_back({ruled(here, first, second), a, b});
        }
    }
  return result;
}

std::vector<MetPiece> met_pieces(const std::vector<Piece>& pieces, bool with_sockets) {
  return Settler(pieces, meetings(pieces), with_sockets).make();
}

}  // namespace isopatch::segmentation
