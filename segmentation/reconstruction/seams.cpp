#include "segmentation/reconstruction/internal/seams.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/base/error.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/carrier_domain.hpp"
#include "segmentation/reconstruction/internal/meeting_point.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::EdgeUse;
using geometry::SurfaceKind;

constexpr double whole_turn = 2 * std::numbers::pi;
constexpr int seam_points = 33;

double turns_between(double from, double to) {
  const double way = to - from;
  return way - whole_turn * std::round(way / whole_turn);
}

/// A place where a loop crosses a line of the domain.
struct Crossing {
  int edge = 0;
  std::size_t segment = 0;
  double share = 0;  ///< of the segment
};

class SeamMaker {
 public:
  SeamMaker(Wireframe& wires, Regions& regions, const geometry::TriangleMesh& mesh, double size)
      : wires_(wires), regions_(regions), mesh_(mesh), size_(size) {}

  void make(int number) {
    region_ = number;
    Region& region = regions_.regions[static_cast<std::size_t>(number)];
    if (!region.carrier || region.carrier->kind == SurfaceKind::plane) return;
    if (region.carrier->kind == SurfaceKind::sphere) set_axis(region);
    const CarrierDomain domain(*region.carrier);
    domain_ = &domain;
    if (loops().empty()) return add_whole(*region.carrier);
    for (const Eigen::Index row : {0, 1}) {
      if (row == 1 && region.carrier->kind != SurfaceKind::torus) break;
      std::vector<std::size_t> around;
      for (std::size_t l = 0; l < loops().size(); ++l)
        if (winding(loops()[l], row) != 0) around.push_back(l);
      if (around.empty()) continue;
      if (around.size() == 1 && row == 0 && region.carrier->kind != SurfaceKind::torus &&
          region.carrier->kind != SurfaceKind::cylinder)
        return join_pole(around[0]);
      if (around.size() != 2 || winding(loops()[around[0]], row) + winding(loops()[around[1]], row) != 0)
        refuse("its loops go around it in a way without a rule");
      return join(around[0], around[1], row);
    }
  }

 private:
  std::vector<std::vector<EdgeUse>>& loops() { return wires_.loops[static_cast<std::size_t>(region_)]; }
  const Region& region() const { return regions_.regions[static_cast<std::size_t>(region_)]; }
  const Carrier& carrier() const { return *region().carrier; }
  WireEdge& edge(EdgeId id) { return wires_.edges[static_cast<std::size_t>(id.value)]; }

  [[noreturn]] void refuse(const std::string& why) const {
    const Eigen::Vector3d p = mesh_.vertices.col(mesh_.triangles(0, region().triangles.front()));
    throw Error(ErrorCode::unsupported,
                fmt::format("the {} near ({:.6g}, {:.6g}, {:.6g}) cannot be bounded: {}",
                            geometry::name(carrier().kind), p.x(), p.y(), p.z(), why));
  }

  std::vector<Eigen::Vector3d> points_of(const std::vector<EdgeUse>& loop) {
    std::vector<Eigen::Vector3d> result;
    for (const EdgeUse& use : loop) {
      std::vector<Eigen::Vector3d> points = edge(use.edge).points;
      if (use.reversed) std::reverse(points.begin(), points.end());
      result.insert(result.end(), points.begin(), points.end());
    }
    return result;
  }

  int winding(const std::vector<EdgeUse>& loop, Eigen::Index row) {
    const std::vector<Eigen::Vector3d> points = points_of(loop);
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      sum += turns_between(domain_->parameters(points[i])[row],
                           domain_->parameters(points[(i + 1) % points.size()])[row]);
    return static_cast<int>(std::lround(sum / whole_turn));
  }

  /// At right angles to where the face is, if it is less than half the sphere; else through its middle or its
  /// holes.
  void set_axis(Region& region) {
    Carrier& sphere = *region.carrier;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int t : region.triangles) {
      const double area = geometry::area_vector(mesh_, t).norm();
      for (int i = 0; i < 3; ++i)
        sum += area * (mesh_.vertices.col(mesh_.triangles(i, t)) - sphere.origin).normalized();
    }
    if (loops().size() > 1 || sum.norm() < 1e-6 * region.area) {
      sphere.axis = Eigen::Vector3d::UnitZ();
      if (loops().empty()) return;
      Eigen::Vector3d hole = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& p : points_of(loops().front())) hole += p - sphere.origin;
      if (hole.norm() > 0) sphere.axis = hole.normalized();
      return;
    }
    const Eigen::Vector3d middle = sum.normalized();
    double least = 1;
    for (const int t : region.triangles)
      for (int i = 0; i < 3; ++i)
        least = std::min(
            least, middle.dot((mesh_.vertices.col(mesh_.triangles(i, t)) - sphere.origin).normalized()));
    sphere.axis = least > 0.1 ? any_normal(middle) : middle;
  }

  /// Where a loop crosses a line of equal parameter.
  std::vector<Crossing> crossings(const std::vector<EdgeUse>& loop, Eigen::Index row, double at) {
    std::vector<Crossing> result;
    for (const EdgeUse& use : loop) {
      const auto& points = edge(use.edge).points;
      for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double before = turns_between(at, domain_->parameters(points[i])[row]);
        const double after = turns_between(at, domain_->parameters(points[i + 1])[row]);
        // The other half of the turn is crossed with a jump.
        if ((before < 0) == (after < 0) || std::abs(after - before) > std::numbers::pi) continue;
        result.push_back({use.edge.value, i, before / (before - after)});
      }
    }
    return result;
  }

  struct SeamPlace {
    double at;
    Crossing first, second;
  };

  /// A line that crosses both loops once and no other.
  SeamPlace place_between(std::size_t a, std::optional<std::size_t> b, Eigen::Index row) {
    std::vector<double> candidates;
    for (const std::size_t l : {a, b.value_or(a)})
      for (const EdgeUse& use : loops()[l])
        candidates.push_back(domain_->parameters(edge(use.edge).points.front())[row]);
    for (int i = 0; i < 64; ++i) candidates.push_back(whole_turn * (i + 0.37) / 64);
    for (const double at : candidates) {
      const auto first = crossings(loops()[a], row, at);
      if (first.size() != 1) continue;
      bool free = true;
      SeamPlace result{at, first.front(), {}};
      for (std::size_t l = 0; l < loops().size() && free; ++l) {
        if (l == a) continue;
        const auto other = crossings(loops()[l], row, at);
        free = other.size() == (b && l == *b ? 1u : 0u);
        if (free && b && l == *b) result.second = other.front();
      }
      if (free) return result;
    }
    refuse("no line from one loop to the other misses its holes");
  }

  /// The vertex where a line of equal parameter crosses an edge, made where there is none.
  int vertex_at(const Crossing& crossing, Eigen::Index row, double at) {
    WireEdge& crossed = wires_.edges[static_cast<std::size_t>(crossing.edge)];
    const Eigen::Vector3d from = crossed.points[crossing.segment], to = crossed.points[crossing.segment + 1];
    std::vector<Carrier> carriers;
    for (const int r : crossed.regions)
      if (regions_.regions[static_cast<std::size_t>(r)].carrier)
        carriers.push_back(*regions_.regions[static_cast<std::size_t>(r)].carrier);
    carriers.push_back(row == 0 ? domain_->meridian(at) : domain_->parallel(at));
    const Eigen::Vector3d point = meeting_point(carriers, from + crossing.share * (to - from), size_);
    if (!crossed.free_start)
      for (const int end : {crossed.start, crossed.end})
        if ((wires_.vertices[static_cast<std::size_t>(end)] - point).norm() < 1e-5 * size_) return end;
    return split(wires_, crossing.edge, crossing.segment, point);
  }

  /// The loop from the vertex on.
  std::vector<EdgeUse> from_vertex(std::vector<EdgeUse> loop, int vertex) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const WireEdge& first = edge(loop.front().edge);
      if ((loop.front().reversed ? first.end : first.start) == vertex) return loop;
      std::rotate(loop.begin(), loop.begin() + 1, loop.end());
    }
    refuse("a seam misses its loop");
  }

  EdgeId add_seam(int start, int end, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    WireEdge seam;
    seam.start = start;
    seam.end = end;
    seam.regions = {region_, region_};
    for (int i = 0; i < seam_points; ++i)
      seam.points.push_back(domain_->point(from + (to - from) * i / (seam_points - 1)));
    seam.points.front() = wires_.vertices[static_cast<std::size_t>(start)];
    seam.points.back() = wires_.vertices[static_cast<std::size_t>(end)];
    wires_.edges.push_back(std::move(seam));
    return EdgeId(static_cast<int>(wires_.edges.size()) - 1);
  }

  void join(std::size_t a, std::size_t b, Eigen::Index row) {
    const SeamPlace place = place_between(a, b, row);
    const int first = vertex_at(place.first, row, place.at);
    const int second = vertex_at(place.second, row, place.at);
    const Eigen::Vector2d from = domain_->parameters(wires_.vertices[static_cast<std::size_t>(first)]);
    Eigen::Vector2d to = domain_->parameters(wires_.vertices[static_cast<std::size_t>(second)]);
    to[row] = from[row];
    if (carrier().kind == SurfaceKind::torus) {
      // The face is to the left of its loops.
      const bool up = (winding(loops()[a], row) > 0) != region().reversed;
      const bool rising = row == 0 ? up : !up;
      const double way = to[1 - row] - from[1 - row];
      to[1 - row] =
          from[1 - row] + way - whole_turn * std::floor(way / whole_turn) - (rising ? 0 : whole_turn);
    }
    const EdgeId seam = add_seam(first, second, from, to);
    std::vector<EdgeUse> whole = from_vertex(loops()[a], first);
    const std::vector<EdgeUse> other = from_vertex(loops()[b], second);
    whole.push_back({seam, false});
    whole.insert(whole.end(), other.begin(), other.end());
    whole.push_back({seam, true});
    loops()[a] = whole;
    loops().erase(loops().begin() + static_cast<std::ptrdiff_t>(b));
  }

  int add_vertex(const Eigen::Vector3d& point) {
    wires_.vertices.push_back(point);
    wires_.regions_at.push_back({region_});
    return static_cast<int>(wires_.vertices.size()) - 1;
  }
  EdgeId add_pole(int vertex) {
    WireEdge pole;
    pole.start = pole.end = vertex;
    pole.regions = {region_, region_};
    wires_.edges.push_back(std::move(pole));
    return EdgeId(static_cast<int>(wires_.edges.size()) - 1);
  }

  void join_pole(std::size_t loop) {
    const bool up = (winding(loops()[loop], 0) > 0) != region().reversed;
    const SeamPlace place = place_between(loop, std::nullopt, 0);
    const int first = vertex_at(place.first, 0, place.at);
    const Eigen::Vector2d from = domain_->parameters(wires_.vertices[static_cast<std::size_t>(first)]);
    Eigen::Vector2d to = from;
    if (carrier().kind == SurfaceKind::sphere) {
      to.y() = up ? std::numbers::pi / 2 : -std::numbers::pi / 2;
    } else {
      to.y() = -carrier().radius / std::tan(carrier().half_angle.radians());
      if ((to.y() > from.y()) != up) refuse("it opens away from its apex without an end");
    }
    const int pole = add_vertex(domain_->point(to));
    const EdgeId seam = add_seam(first, pole, from, to), end = add_pole(pole);
    std::vector<EdgeUse> whole = from_vertex(loops()[loop], first);
    whole.push_back({seam, false});
    whole.push_back({end, false});
    whole.push_back({seam, true});
    loops()[loop] = whole;
  }

  /// A whole sphere or torus.
  void add_whole(const Carrier& whole) {
    if (whole.kind == SurfaceKind::sphere) {
      const double quarter = std::numbers::pi / 2;
      const int south = add_vertex(domain_->point({0, -quarter})),
                north = add_vertex(domain_->point({0, quarter}));
      const EdgeId seam = add_seam(south, north, {0, -quarter}, {0, quarter}), top = add_pole(north),
                   bottom = add_pole(south);
      loops().push_back({{seam, false}, {top, false}, {seam, true}, {bottom, false}});
    } else if (whole.kind == SurfaceKind::torus) {
      const int corner = add_vertex(domain_->point({0, 0}));
      const EdgeId long_way = add_seam(corner, corner, {0, 0}, {whole_turn, 0}),
                   short_way = add_seam(corner, corner, {0, 0}, {0, whole_turn});
      std::vector<EdgeUse> loop{{long_way, false}, {short_way, false}, {long_way, true}, {short_way, true}};
      if (region().reversed)
        loop = {{short_way, false}, {long_way, false}, {short_way, true}, {long_way, true}};
      loops().push_back(loop);
    } else {
      refuse("it has no edge");
    }
  }

  Wireframe& wires_;
  Regions& regions_;
  const geometry::TriangleMesh& mesh_;
  double size_;
  int region_ = 0;
  const CarrierDomain* domain_ = nullptr;
};

}  // namespace

void add_seams(Wireframe& wires, Regions& regions, const geometry::TriangleMesh& mesh, double size) {
  SeamMaker maker(wires, regions, mesh, size);
  for (int r = 0; r < static_cast<int>(regions.regions.size()); ++r) maker.make(r);
}

}  // namespace isopatch::segmentation
