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

constexpr int pieces_of_element = 4;  // along each direction

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
    const double distance = plane_.normal.dot(place - plane_.point);
    // Faces of elements in the plane have corners there, not on either side of it by round-off.
    const bool is_in_plane = std::abs(distance) <= 1e-12 * (place.norm() + plane_.point.norm());
    return {parameter, place, is_in_plane ? 0 : distance};
  }

  // Adds the cut of a box of parameters, in so many pieces along each direction.
  void cut(const Parameter3& low, const Parameter3& high, int pieces, std::vector<SectionPoint>& out) const {
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
            cut_tetrahedron(of, out);
          }
  }

 private:
  // Where a line from behind the plane to before it meets the plane.
  struct Crossing {
    GridPoint point;
    Parameter3 behind, before;
    double share = 0;  // of the way
  };

  // Regula falsi of Illinois.
  Crossing crossing(const GridPoint& behind, const GridPoint& before) const {
    GridPoint a = behind, b = before, middle = behind;
    const double enough = 1e-13 * (b.place - a.place).norm();
    for (int step = 0; step < 30; ++step) {
      const double share = a.distance / (a.distance - b.distance);
      middle = at(a.parameter + share * (b.parameter - a.parameter));
      if (std::abs(middle.distance) <= enough) break;
      if ((middle.distance < 0) == (b.distance < 0)) {
        a.distance *= 0.5;
      } else {
        a = b;
      }
      b = middle;
    }
    const Parameter3 way = before.parameter - behind.parameter;
    return {middle, behind.parameter, before.parameter,
            (middle.parameter - behind.parameter).dot(way) / way.squaredNorm()};
  }

  // The point of the plane in the middle of two, on the face of the tetrahedron on which they lie: so
  // outlines of the part stay on its faces.
  GridPoint middle(const Crossing& p, const Crossing& q) const {
    const Parameter3 straight = 0.5 * (p.point.parameter + q.point.parameter);
    const double before = p.share + q.share, behind = 2 - before;
    if (before > 0 && behind > 0) {
      const GridPoint from = at(((1 - p.share) * p.behind + (1 - q.share) * q.behind) / behind);
      const GridPoint to = at((p.share * p.before + q.share * q.before) / before);
      if (from.distance <= 0 && to.distance > 0) return crossing(from, to).point;
    }
    return at(straight);
  }

  // Corners in the plane count as behind it, so that a face in the plane belongs to one side alone.
  void cut_tetrahedron(const std::array<const GridPoint*, 4>& corners, std::vector<SectionPoint>& out) const {
    std::array<const GridPoint*, 4> behind{}, before{};
    std::size_t b = 0, f = 0;
    for (const GridPoint* corner : corners) (corner->distance <= 0 ? behind[b++] : before[f++]) = corner;
    if (b == 0 || f == 0) return;
    if (b == 2) {
      const Crossing p = crossing(*behind[0], *before[0]), q = crossing(*behind[0], *before[1]),
                     r = crossing(*behind[1], *before[1]), t = crossing(*behind[1], *before[0]);
      add_triangle(p, q, r, out);
      add_triangle(p, r, t, out);
    } else if (b == 1) {
      add_triangle(crossing(*behind[0], *before[0]), crossing(*behind[0], *before[1]),
                   crossing(*behind[0], *before[2]), out);
    } else {
      add_triangle(crossing(*behind[0], *before[0]), crossing(*behind[1], *before[0]),
                   crossing(*behind[2], *before[0]), out);
    }
  }

  // Quadratic in its corners and the middles of its edges; six points integrate polynomials of degree 4
  // (Dunavant 1985).
  void add_triangle(const Crossing& a, const Crossing& b, const Crossing& c,
                    std::vector<SectionPoint>& out) const {
    const Vector3d flat = (b.point.place - a.point.place).cross(c.point.place - a.point.place);
    if (!(flat.norm() > 0)) return;
    if (((a.point.place + b.point.place + c.point.place) / 3 - plane_.point).norm() > plane_.radius) return;
    const std::array<GridPoint, 6> nodes = {a.point,      b.point,      c.point,
                                            middle(a, b), middle(b, c), middle(c, a)};
    for (const auto& [share, corner, weight] :
         {std::array{0.109951743655322, 0.816847572980459, 0.091576213509771},
          std::array{0.223381589678011, 0.108103018168070, 0.445948490915965}})
      for (int turn = 0; turn < 3; ++turn) {
        Vector3d l = Vector3d::Constant(weight);
        l[turn] = corner;
        const Eigen::Matrix<double, 6, 1> values = {l[0] * (2 * l[0] - 1), l[1] * (2 * l[1] - 1),
                                                    l[2] * (2 * l[2] - 1), 4 * l[0] * l[1],
                                                    4 * l[1] * l[2],       4 * l[2] * l[0]};
        // Derivatives along the second and the third coordinate, the first being 1 less these.
        const Eigen::Matrix<double, 6, 1> along = {1 - 4 * l[0],      4 * l[1] - 1, 0,
                                                   4 * (l[0] - l[1]), 4 * l[2],     -4 * l[2]};
        const Eigen::Matrix<double, 6, 1> across = {1 - 4 * l[0], 0,        4 * l[2] - 1,
                                                    -4 * l[1],    4 * l[1], 4 * (l[0] - l[2])};
        SectionPoint point{patch_, Parameter3::Zero(), Vector3d::Zero(), 0};
        Vector3d first = Vector3d::Zero(), second = Vector3d::Zero();
        for (int i = 0; i < 6; ++i) {
          const GridPoint& node = nodes[static_cast<std::size_t>(i)];
          point.parameter += values[i] * node.parameter;
          point.place += values[i] * node.place;
          first += along[i] * node.place;
          second += across[i] * node.place;
        }
        point.area = 0.5 * share * first.cross(second).dot(flat.normalized());
        out.push_back(point);
      }
  }

  const NurbsVolume& volume_;
  int patch_;
  const CuttingPlane& plane_;
};

// Control points bound a patch.
bool may_cut(const NurbsVolume& volume, const CuttingPlane& plane) {
  const Eigen::RowVectorXd distance =
      plane.normal.transpose() * (volume.control_points().colwise() - plane.point);
  const double round_off = 1e-12 * (volume.control_points().norm() + plane.point.norm());
  return distance.minCoeff() <= round_off && distance.maxCoeff() > 0;
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
      cutter.cut(low, high, pieces_of_element, found[e]);
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
