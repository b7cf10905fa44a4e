#include "segmentation/pieces/internal/socket.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "segmentation/pieces/internal/hex_assembly.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// A face whose only outline is a circle.
std::optional<EdgeId> circle_of(const Brep& brep, FaceId face) {
  const auto& loops = brep.face(face).loops;
  if (loops.size() != 1 || loops.front().size() != 1) return std::nullopt;
  const EdgeId edge = loops.front().front().edge;
  return brep.edge(edge).kind == geometry::CurveKind::circle ? std::optional(edge) : std::nullopt;
}

/// All vertices of a box lie in its corners or on its edges; so do all faces on its sides.
bool is_box(const Brep& brep, const Socket& socket) {
  const double tolerance = 1e-6 * brep.size();
  const Eigen::Vector2d size = socket.high - socket.low;
  double area = 0;
  for (int f = 0; f < static_cast<int>(brep.faces().size()); ++f) {
    const auto carrier = brep.carrier(FaceId(f));
    if (!carrier || carrier->kind != geometry::SurfaceKind::plane) return false;
    area += brep.area(FaceId(f));
  }
  const double whole = 2 * (size.x() * size.y() + size.x() * socket.depth + size.y() * socket.depth);
  return std::abs(area - whole) < tolerance * brep.size() &&
         std::abs(brep.volume() - size.x() * size.y() * socket.depth) < tolerance * area;
}

class SocketDivider {
 public:
  SocketDivider(const Piece& piece, const Socket& socket, const std::vector<Line>& lines)
      : piece_(piece),
        socket_(socket),
        tolerance_(1e-6 * piece.brep.size()),
        hexes_(1e-9 * piece.brep.size()) {
    for (const Line& line : lines) read(line);
    if (!cuts_[0].empty() && !cuts_[1].empty())
      throw Error(ErrorCode::unsupported, "lines of two directions meet behind something round");
    along_ = cuts_[1].empty() ? 0 : 1;
  }

  geometry::CellComplex make() {
    find_places();
    for (const int ring : {0, 1}) add_cup(ring);
    for (int i = 0; i + 1 < count(); ++i)
      add_hexahedron(node(2, 0, i, 0), node(2, 0, i + 1, 0), node(2, 0, i + 1, 1), node(2, 0, i, 1),
                     node(2, 1, i, 0), node(2, 1, i + 1, 0), node(2, 1, i + 1, 1), node(2, 1, i, 1));
    return hexes_.make([&](const Eigen::Vector3d& place) { return face_at(place); });
  }

 private:
  /// Lines on the far side, but its own sides.
  void read(const Line& line) {
    const Eigen::Vector2d a = socket_.top.domain_point(line[0]), b = socket_.top.domain_point(line[1]);
    for (const int axis : {0, 1}) {
      if (std::abs(a[axis] - b[axis]) > tolerance_) continue;
      if (a[axis] < socket_.low[axis] + tolerance_ || a[axis] > socket_.high[axis] - tolerance_) return;
      cuts_[static_cast<std::size_t>(axis)].insert(std::round(a[axis] / tolerance_) * tolerance_);
      return;
    }
    throw Error(ErrorCode::unsupported, "an inclined line meets a box that something round stands on");
  }

  int count() const { return static_cast<int>(cuts_[static_cast<std::size_t>(along_)].size()) + 2; }

  /// Of level 0 (the box), 1 (the disc's circle) and 2 (its core), above and where it ends below; i along the
  /// cuts, j across.
  int node(int level, int below, int i, int j) const {
    return nodes_[static_cast<std::size_t>(level)][static_cast<std::size_t>(below)]
                 [static_cast<std::size_t>(2 * i + j)];
  }

  Eigen::Vector3d place(double along, double across, double depth) const {
    const Eigen::Vector2d at = along_ == 0 ? Eigen::Vector2d(along, across) : Eigen::Vector2d(across, along);
    return socket_.top.point(at) - depth * socket_.top.normal();
  }

  void find_places() {
    const auto a = static_cast<Eigen::Index>(along_), c = static_cast<Eigen::Index>(1 - along_);
    std::vector<double> at = {socket_.low[a]};
    at.insert(at.end(), cuts_[static_cast<std::size_t>(along_)].begin(),
              cuts_[static_cast<std::size_t>(along_)].end());
    at.push_back(socket_.high[a]);
    const double core = core_share * socket_.radius, circle = std::sqrt(0.5) * socket_.radius;
    const std::array<double, 3> depths = {socket_.depth, 2 * socket_.depth / 3, socket_.depth / 3};
    for (std::size_t level = 0; level < 3; ++level)
      for (const int below : {0, 1})
        for (std::size_t i = 0; i < at.size(); ++i)
          for (const int j : {0, 1}) {
            const double share = static_cast<double>(i) / static_cast<double>(at.size() - 1);
            const double side = j == 0 ? -1 : 1, depth = below == 0 ? 0 : depths[level];
            double along = at[i], across = j == 0 ? socket_.low[c] : socket_.high[c];
            if (level > 0) {
              const double half = level == 1 ? circle : core;
              along = (2 * share - 1) * half;
              across = side * half;
            }
            if (level == 1 && below == 0) {  // straight outwards from the core: chamfers keep that
              const double out = socket_.radius / std::hypot(along, across);
              along *= out;
              across *= out;
            }
            nodes_[level][static_cast<std::size_t>(below)].push_back(
                hexes_.add_vertex(place(along, across, depth)));
          }
    for (int i = 0; i + 1 < count(); ++i)
      for (const int j : {0, 1}) arc(node(1, 0, i, j), node(1, 0, i + 1, j));
    for (const int i : {0, count() - 1}) arc(node(1, 0, i, 0), node(1, 0, i, 1));
  }

  void arc(int from, int to) {
    const Eigen::Vector3d a = hexes_.vertex(from) - socket_.top.origin,
                          b = hexes_.vertex(to) - socket_.top.origin;
    hexes_.set_edge(from, to,
                    geometry::arc_about(socket_.top.origin, a.cross(b), hexes_.vertex(from),
                                        Angle::radians(std::atan2(a.cross(b).norm(), a.dot(b)))));
  }

  /// Between a level and the next one inside.
  void add_cup(int ring) {
    const auto side = [&](int i, int j, int k, int l) {
      add_hexahedron(node(ring, 0, i, j), node(ring, 0, k, l), node(ring + 1, 0, k, l),
                     node(ring + 1, 0, i, j), node(ring, 1, i, j), node(ring, 1, k, l),
                     node(ring + 1, 1, k, l), node(ring + 1, 1, i, j));
    };
    const int last = count() - 1;
    side(0, 0, 0, 1);
    side(last, 0, last, 1);
    for (int i = 0; i < last; ++i) {
      side(i, 0, i + 1, 0);
      side(i, 1, i + 1, 1);
      add_hexahedron(node(ring + 1, 1, i, 0), node(ring + 1, 1, i + 1, 0), node(ring + 1, 1, i + 1, 1),
                     node(ring + 1, 1, i, 1), node(ring, 1, i, 0), node(ring, 1, i + 1, 0),
                     node(ring, 1, i + 1, 1), node(ring, 1, i, 1));
    }
  }

  /// Either way round.
  void add_hexahedron(int a, int b, int c, int d, int e, int f, int g, int h) {
    const auto at = [&](int number) { return hexes_.vertex(number); };
    const bool right = (at(b) - at(a)).cross(at(d) - at(a)).dot(at(e) - at(a)) > 0;
    hexes_.add(right ? std::array<int, 8>{a, b, c, d, e, f, g, h}
                     : std::array<int, 8>{a, d, c, b, e, h, g, f});
  }

  std::optional<FaceId> face_at(const Eigen::Vector3d& place) const {
    std::optional<FaceId> best;
    double least = 10 * tolerance_;
    for (int f = 0; f < static_cast<int>(piece_.brep.faces().size()); ++f) {
      const geometry::FaceProjection nearest = piece_.brep.project(FaceId(f), place);
      if (nearest.distance >= least || !piece_.brep.contains(FaceId(f), nearest.uv)) continue;
      best = FaceId(f);
      least = nearest.distance;
    }
    return best;
  }

  /// Half of a core's width, of the disc's radius.
  static constexpr double core_share = 0.42;
  const Piece& piece_;
  const Socket& socket_;
  double tolerance_;
  HexAssembly hexes_;
  int along_ = 0;
  std::array<std::set<double>, 2> cuts_;  // by axis of the plane
  std::array<std::array<std::vector<int>, 2>, 3> nodes_;
};

}  // namespace

std::optional<Socket> socket_of(const Piece& piece) {
  const Brep& brep = piece.brep;
  Socket result;
  std::optional<FaceId> disc;
  for (const FaceId face : cut_faces(piece))
    if (circle_of(brep, face)) {
      if (disc) return std::nullopt;
      disc = face;
    }
  if (!disc) return std::nullopt;
  const EdgeId circle = *circle_of(brep, *disc);
  result.top = plane_of(brep, *disc);
  result.top.origin = (brep.point(circle, 0) + brep.point(circle, 0.5)) / 2;
  result.radius = (brep.point(circle, 0) - result.top.origin).norm();
  for (std::size_t e = 0; e < brep.edges().size(); ++e)
    if (brep.edges()[e].kind == geometry::CurveKind::line) {
      const EdgeId edge(static_cast<int>(e));
      const Eigen::Vector3d way = brep.tangent(edge, 0).normalized();
      if (std::abs(way.dot(result.top.normal())) > 1e-7) continue;
      result.top = {result.top.origin, way, result.top.normal().cross(way)};
      break;
    }
  result.low = {1e300, 1e300};
  result.high = {-1e300, -1e300};
  for (const auto vertex : brep.vertices().colwise()) {
    const Eigen::Vector2d at = result.top.domain_point(vertex);
    result.low = result.low.cwiseMin(at);
    result.high = result.high.cwiseMax(at);
    result.depth = std::max(result.depth, -(vertex - result.top.origin).dot(result.top.normal()));
  }
  return is_box(brep, result) ? std::optional(result) : std::nullopt;
}

geometry::CellComplex socket_cells(const Piece& piece, const Socket& socket, const std::vector<Line>& lines) {
  return SocketDivider(piece, socket, lines).make();
}

}  // namespace isopatch::segmentation
