#include "iga/post/plane_section.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Vector3d;
using geometry::NurbsVolume;
using Parameter3 = geometry::Parameter<3>;

constexpr int coarse_pieces = 4;  // of an element along each direction

// A corner of the grid in an element: where it is, and how far from the plane.
struct GridPoint {
  Parameter3 parameter;
  Vector3d place;
  double distance = 0;
};

// Kuhn's six tetrahedra of a cube, whose diagonals agree with those of its neighbours: corners by bits.
constexpr std::array<std::array<int, 4>, 6> tetrahedra = {
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};

class Cutter {
 public:
  Cutter(const NurbsVolume& volume, int patch, const CuttingPlane& plane)
      : volume_(volume), patch_(patch), plane_(plane) {}

  GridPoint at(const Parameter3& parameter) const {
    const Vector3d place = volume_.point(parameter);
    return {parameter, place, plane_.normal.dot(place - plane_.point)};
  }

  // Adds the cut of a box of parameters, in so many pieces along each direction.
  void cut(const Parameter3& low, const Parameter3& high, int pieces, double weight,
           std::vector<SectionPoint>& out) const {
    const auto count = static_cast<std::size_t>(pieces) + 1;
    std::vector<GridPoint> grid(count * count * count);
    const auto index = [&](std::size_t i, std::size_t j, std::size_t k) {
      return i + count * (j + count * k);
    };
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t j = 0; j < count; ++j)
        for (std::size_t i = 0; i < count; ++i) {
          const Vector3d share =
              Vector3d(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)) / pieces;
          grid[index(i, j, k)] = at(low + share.cwiseProduct(high - low));
        }
    for (std::size_t k = 0; k + 1 < count; ++k)
      for (std::size_t j = 0; j + 1 < count; ++j)
        for (std::size_t i = 0; i + 1 < count; ++i)
          for (const auto& corners : tetrahedra) {
            std::array<const GridPoint*, 4> of;
            for (std::size_t c = 0; c < 4; ++c) {
              const auto bits = static_cast<std::size_t>(corners[c]);
              of[c] = &grid[index(i + (bits & 1), j + (bits >> 1 & 1), k + (bits >> 2 & 1))];
            }
            cut_tetrahedron(of, weight, out);
          }
  }

 private:
  // Where the line between two corners on different sides meets the plane: regula falsi of Illinois.
  GridPoint crossing(GridPoint a, GridPoint b) const {
    for (int step = 0; step < 30; ++step) {
      const double share = a.distance / (a.distance - b.distance);
      const GridPoint middle = at(a.parameter + share * (b.parameter - a.parameter));
      if (std::abs(middle.distance) <= 1e-13 * (b.place - a.place).norm() || middle.distance == 0)
        return middle;
      if ((middle.distance < 0) == (b.distance < 0)) {
        a.distance *= 0.5;
      } else {
        a = b;
      }
      b = middle;
    }
    return b;
  }

  // Corners in the plane count as behind it, so that a face in the plane belongs to one side alone.
  void cut_tetrahedron(const std::array<const GridPoint*, 4>& corners, double weight,
                       std::vector<SectionPoint>& out) const {
    std::array<const GridPoint*, 4> behind{}, before{};
    std::size_t b = 0, f = 0;
    for (const GridPoint* corner : corners) (corner->distance <= 0 ? behind[b++] : before[f++]) = corner;
    if (b == 0 || f == 0) return;
    if (b == 2) {
      const GridPoint p = crossing(*behind[0], *before[0]), q = crossing(*behind[0], *before[1]),
                      r = crossing(*behind[1], *before[1]), s = crossing(*behind[1], *before[0]);
      add_triangle(p, q, r, weight, out);
      add_triangle(p, r, s, weight, out);
      return;
    }
    const GridPoint& lone = b == 1 ? *behind[0] : *before[0];
    const auto& others = b == 1 ? before : behind;
    add_triangle(crossing(lone, *others[0]), crossing(lone, *others[1]), crossing(lone, *others[2]), weight,
                 out);
  }

  // The middles of the edges integrate quadratic functions.
  void add_triangle(const GridPoint& a, const GridPoint& b, const GridPoint& c, double weight,
                    std::vector<SectionPoint>& out) const {
    const double area = 0.5 * (b.place - a.place).cross(c.place - a.place).norm();
    if (!(area > 0)) return;
    if ((((a.place + b.place + c.place) / 3) - plane_.point).norm() > plane_.radius) return;
    const auto add = [&](const GridPoint& p, const GridPoint& q) {
      out.push_back(
          {patch_, 0.5 * (p.parameter + q.parameter), 0.5 * (p.place + q.place), weight * area / 3});
    };
    add(a, b);
    add(b, c);
    add(c, a);
  }

  const NurbsVolume& volume_;
  int patch_;
  const CuttingPlane& plane_;
};

// Control points bound a patch.
bool may_cut(const NurbsVolume& volume, const CuttingPlane& plane) {
  const Eigen::RowVectorXd distance =
      plane.normal.transpose() * (volume.control_points().colwise() - plane.point);
  return distance.minCoeff() <= 0 && distance.maxCoeff() > 0;
}

// Whether the plane passes through a box of parameters, by its corners and middle and how far they are apart.
bool may_cut(const Cutter& cutter, const Parameter3& low, const Parameter3& high) {
  Eigen::AlignedBox3d box;
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        const GridPoint point = cutter.at(low + 0.5 * Vector3d(i, j, k).cwiseProduct(high - low));
        least = std::min(least, point.distance);
        most = std::max(most, point.distance);
        box.extend(point.place);
      }
  const double margin = 0.5 * box.diagonal().norm();
  return least <= margin && most >= -margin;
}

}  // namespace

std::vector<SectionPoint> section_points(const std::vector<NurbsVolume>& patches, const CuttingPlane& plane) {
  std::vector<SectionPoint> result;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const NurbsVolume& volume = patches[p];
    if (!may_cut(volume, plane)) continue;
    const Cutter cutter(volume, static_cast<int>(p), plane);
    std::array<std::vector<double>, 3> breaks;
    for (int d = 0; d < 3; ++d) breaks[static_cast<std::size_t>(d)] = volume.knots(d).breaks();
    const std::array<std::size_t, 3> count = {breaks[0].size() - 1, breaks[1].size() - 1,
                                              breaks[2].size() - 1};
    std::vector<std::vector<SectionPoint>> found(count[0] * count[1] * count[2]);
    parallel_for(static_cast<std::int64_t>(found.size()), [&](std::int64_t element, int) {
      const auto e = static_cast<std::size_t>(element);
      const std::array<std::size_t, 3> at = {e % count[0], e / count[0] % count[1], e / count[0] / count[1]};
      Parameter3 low, high;
      for (int d = 0; d < 3; ++d) {
        const auto direction = static_cast<std::size_t>(d);
        low[d] = breaks[direction][at[direction]];
        high[d] = breaks[direction][at[direction] + 1];
      }
      if (!may_cut(cutter, low, high)) return;
      cutter.cut(low, high, coarse_pieces, -1.0 / 3, found[e]);
      cutter.cut(low, high, 2 * coarse_pieces, 4.0 / 3, found[e]);
    });
    for (const auto& of_element : found) result.insert(result.end(), of_element.begin(), of_element.end());
  }
  return result;
}

SectionForces section_forces(const ElasticField& field, const CuttingPlane& plane,
                             const std::vector<SectionPoint>& points) {
  std::vector<Vector3d> tractions(points.size());
  parallel_for(static_cast<std::int64_t>(points.size()), [&](std::int64_t i, int) {
    const SectionPoint& point = points[static_cast<std::size_t>(i)];
    tractions[static_cast<std::size_t>(i)] =
        evaluate(field, point.patch, point.parameter).stress * plane.normal;
  });
  SectionForces result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vector3d force = points[i].area * tractions[i];
    result.area += points[i].area;
    result.centre += points[i].area * points[i].place;
    result.force += force;
    result.moment += (points[i].place - plane.point).cross(force);
  }
  if (result.area > 0) result.centre /= result.area;
  return result;
}

}  // namespace isopatch::iga
