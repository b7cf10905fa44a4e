#include "segmentation/pieces/internal/hex_assembly.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/splines/arc.hpp"
#include "geometry/splines/coons.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::EdgeUse;
using geometry::NurbsCurve;

/// Corners of the sides, each counterclockwise as seen from outside.
constexpr std::array<std::array<std::size_t, 4>, 6> sides_of_hexahedron = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

class Assembler {
 public:
  Assembler(const std::vector<Eigen::Vector3d>& places,
            const std::map<std::pair<int, int>, NurbsCurve>& curves, double tolerance)
      : curves_(curves), tolerance_(tolerance) {
    made_.vertices = places;
  }

  void add(const std::array<int, 8>& corners) {
    geometry::Cell cell;
    for (const auto& side : sides_of_hexahedron) {
      std::array<int, 4> at;
      for (std::size_t k = 0; k < 4; ++k) at[k] = corners[side[k]];
      std::array<int, 4> key = at;
      std::sort(key.begin(), key.end());
      const auto known = faces_.find(key);
      const bool fresh = known == faces_.end();
      const FaceId face = fresh ? faces_[key] = add_face(at) : known->second;
      uses_.resize(made_.faces.size());
      ++uses_[static_cast<std::size_t>(face.value)];
      cell.faces.push_back({face, !fresh, static_cast<int>(cell.faces.size())});
    }
    made_.cells.push_back(std::move(cell));
  }

  CellComplex make(const std::function<std::optional<FaceId>(const Eigen::Vector3d&)>& origin) {
    for (std::size_t f = 0; f < made_.faces.size(); ++f) {
      if (uses_[f] != 1) continue;
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const EdgeUse& use : made_.faces[f].loop)
        middle += use_curve(use).point(geometry::Parameter<1>(0.5)) / 4;
      made_.faces[f].origin = origin(middle);
    }
    return std::move(made_);
  }

 private:
  EdgeUse edge(int from, int to) {
    const auto key = std::minmax(from, to);
    const auto known = edges_.find(key);
    if (known != edges_.end()) return {known->second, made_.edge(known->second).start.value != from};
    const auto given = curves_.find(key);
    const VertexId low(key.first), high(key.second);
    const EdgeId id = given != curves_.end() ? made_.add_edge({given->second}, low, high)
                                             : made_.add_straight_edge(low, high);
    edges_[key] = id;
    return {id, key.first != from};
  }

  NurbsCurve use_curve(const EdgeUse& use) const {
    const auto& shape = std::get<NurbsCurve>(made_.curve(made_.edge(use.edge).curve).shape);
    return use.reversed ? reversed(shape, 0) : shape;
  }

  FaceId add_face(const std::array<int, 4>& at) {
    std::vector<EdgeUse> loop;
    for (std::size_t k = 0; k < 4; ++k) loop.push_back(edge(at[k], at[(k + 1) % 4]));
    const std::array<NurbsCurve, 4> sides = {use_curve(loop[0]), use_curve(loop[1]), use_curve(loop[2]),
                                             use_curve(loop[3])};
    if (const auto plane = plane_through(sides)) return made_.add_face({made_.add_surface(*plane), loop, {}});
    const geometry::SurfaceId surface = made_.add_surface(geometry::coons_surface(sides));
    const std::array<Eigen::Vector3d, 4> corners = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1, 0, 0),
                                                    Eigen::Vector3d(1, 1, 0), Eigen::Vector3d(0, 1, 0)};
    for (std::size_t k = 0; k < 4; ++k)
      made_.add_trace(loop[k], surface, geometry::segment(corners[k], corners[(k + 1) % 4]));
    return made_.add_face({surface, loop, {}});
  }

  /// Looks as the sides run.
  std::optional<geometry::PlaneSurface> plane_through(const std::array<NurbsCurve, 4>& sides) const {
    const Eigen::Vector3d a = sides[0].control_points().col(0), c = sides[2].control_points().col(0);
    const Eigen::Vector3d b = sides[1].control_points().col(0), d = sides[3].control_points().col(0);
    const Eigen::Vector3d normal = (c - a).cross(d - b).normalized(), x = (c - a).normalized();
    for (const NurbsCurve& side : sides)
      if (((side.control_points().colwise() - a).transpose() * normal).cwiseAbs().maxCoeff() > tolerance_)
        return std::nullopt;
    return geometry::PlaneSurface{a, x, normal.cross(x)};
  }

  const std::map<std::pair<int, int>, NurbsCurve>& curves_;
  double tolerance_;
  CellComplex made_;
  std::map<std::pair<int, int>, EdgeId> edges_;
  std::map<std::array<int, 4>, FaceId> faces_;
  std::vector<int> uses_;
};

}  // namespace

int HexAssembly::add_vertex(const Eigen::Vector3d& place) {
  places_.push_back(place);
  return static_cast<int>(places_.size()) - 1;
}

void HexAssembly::set_edge(int from, int to, NurbsCurve curve) {
  curves_.insert_or_assign(std::minmax(from, to), from < to ? std::move(curve) : reversed(curve, 0));
}

void HexAssembly::add(const std::array<int, 8>& corners) {
  cells_.push_back(corners);
}

CellComplex HexAssembly::make(
    const std::function<std::optional<FaceId>(const Eigen::Vector3d& place)>& origin) const {
  Assembler assembler(places_, curves_, tolerance_);
  for (const std::array<int, 8>& corners : cells_) assembler.add(corners);
  return assembler.make(origin);
}

}  // namespace isopatch::segmentation
