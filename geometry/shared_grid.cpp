#include "geometry/shared_grid.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/quadrature.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/surface_foot.hpp"

namespace isopatch::geometry {
namespace {

using Point = Parameter<2>;

// Parameters that are equal, as a share of the face's.
constexpr double same_parameter = 1e-9;
// How far a point may be from the nearest point of the other face along it, as a share of the face's size:
// no error of the integrals is then seen.
constexpr double same_place = 1e-11;

Point range(const NurbsSurface& surface) {
  return surface.high() - surface.low();
}

// One point on both faces.
struct Seed {
  Point first, second;
};

bool is_near(const SurfaceFoot& foot, double same_point) {
  return foot.distance <= 10 * same_point;
}

// Where a point of one face lies on another; nothing where it does not.
std::optional<Point> place_on(const NurbsSurface& surface, const Eigen::Vector3d& point, const Point& start,
                              double same_point) {
  SurfaceFoot foot = surface_foot(surface, point, start);
  if (!is_near(foot, same_point)) foot = surface_foot(surface, point, same_point);
  return is_near(foot, same_point) ? std::optional(foot.parameter) : std::nullopt;
}

std::optional<Seed> seed(const NurbsSurface& first, const NurbsSurface& second, double same_point) {
  const auto at = [](const NurbsSurface& surface, double s, double t) {
    return Point(surface.low() + Point(s, t).cwiseProduct(range(surface)));
  };
  for (const double s : {0.5, 0.23, 0.77})
    for (const double t : {0.5, 0.23, 0.77}) {
      const Point on_first = at(first, s, t), on_second = at(second, s, t);
      if (const auto foot = place_on(second, first.point(on_first), at(second, 0.5, 0.5), same_point))
        return Seed{on_first, *foot};
      if (const auto foot = place_on(first, second.point(on_second), at(first, 0.5, 0.5), same_point))
        return Seed{*foot, on_second};
    }
  return std::nullopt;
}

double cosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::abs(a.normalized().dot(b.normalized()));
}

// The lines of both faces through a seed along one direction of the first.
class LinesThrough {
 public:
  LinesThrough(const DividedSurface& first, const DividedSurface& second, const Seed& seed, int of_first,
               int of_second, double same_point)
      : first_(first), second_(second), seed_(seed), d_(of_first), e_(of_second), same_point_(same_point) {}

  // Parameters of one place along the two lines.
  struct Place {
    double first = 0, second = 0;
  };

  // Where elements of either face end, within both; nothing if a line of one face is none of the other.
  std::optional<std::vector<Place>> ends() const {
    std::vector<Place> result;
    bool agree = true;
    for (const double at : first_.breaks[static_cast<std::size_t>(d_)]) {
      const auto foot =
          along(*first_.surface, *second_.surface, seed_.first, seed_.second, {d_, e_}, at, agree);
      if (foot) result.push_back({at, *foot});
    }
    for (const double at : second_.breaks[static_cast<std::size_t>(e_)]) {
      const auto foot =
          along(*second_.surface, *first_.surface, seed_.second, seed_.first, {e_, d_}, at, agree);
      if (foot) result.push_back({*foot, at});
    }
    if (!agree) return std::nullopt;
    std::sort(result.begin(), result.end(), [](const Place& a, const Place& b) { return a.first < b.first; });
    const double same = same_parameter * range(*first_.surface)[d_];
    const auto end = std::unique(result.begin(), result.end(),
                                 [&](const Place& a, const Place& b) { return b.first - a.first <= same; });
    result.erase(end, result.end());
    return result.size() > 1 ? std::optional(result) : std::nullopt;
  }

  // Gauss's points between the ends, with parameters of the second face in proportion to the first's.
  SharedLine line(const std::vector<Place>& ends, int points) const {
    const QuadratureRule rule = gauss_legendre(points);
    SharedLine result;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      const double length = ends[i + 1].first - ends[i].first;
      const double of_second = ends[i + 1].second - ends[i].second;
      for (Eigen::Index q = 0; q < rule.nodes.size(); ++q) {
        result.first.push_back(ends[i].first + rule.nodes[q] * length);
        result.second.push_back(ends[i].second + rule.nodes[q] * of_second);
        result.weights.push_back(rule.weights[q] * length);
        result.first_element.push_back(element(first_, d_, result.first.back()));
        result.second_element.push_back(element(second_, e_, result.second.back()));
      }
    }
    return result;
  }

  // With parameters of the second face found point by point; false if some cannot be found.
  bool find_second(SharedLine& line) const {
    for (std::size_t q = 0; q < line.size(); ++q) {
      bool agree = true;
      const auto foot =
          along(*first_.surface, *second_.surface, seed_.first, seed_.second, {d_, e_}, line.first[q], agree);
      if (!foot || !agree) return false;
      line.second[q] = *foot;
    }
    return true;
  }

 private:
  // The parameter along the line of `to` of the point `at` on the line of `from`; nothing beyond the face.
  std::optional<double> along(const NurbsSurface& from, const NurbsSurface& to, Point at_from, Point at_to,
                              std::array<int, 2> directions, double at, bool& agree) const {
    at_from[directions[0]] = at;
    const SurfaceFoot foot = surface_foot(to, from.point(at_from), at_to);
    if (!is_near(foot, same_point_)) return std::nullopt;
    const int across = 1 - directions[1];
    if (std::abs(foot.parameter[across] - at_to[across]) > same_parameter * range(to)[across]) agree = false;
    return foot.parameter[directions[1]];
  }

  static int element(const DividedSurface& face, int direction, double parameter) {
    const std::vector<double>& breaks = face.breaks[static_cast<std::size_t>(direction)];
    const auto above = std::upper_bound(breaks.begin(), breaks.end(), parameter) - breaks.begin();
    return std::clamp(static_cast<int>(above) - 1, 0, static_cast<int>(breaks.size()) - 2);
  }

  const DividedSurface& first_;
  const DividedSurface& second_;
  Seed seed_;
  int d_, e_;
  double same_point_;
};

// Whether the two faces have the same point at every point of the grid.
bool is_same_grid(const NurbsSurface& first, const NurbsSurface& second, const SharedGrid& grid,
                  double same_point) {
  const auto& [u, v] = grid.lines;
  const Eigen::Matrix3Xd of_first = points_on_grid(first, {u.first, v.first});
  const Eigen::Matrix3Xd of_second = grid.swapped ? points_on_grid(second, {v.second, u.second})
                                                  : points_on_grid(second, {u.second, v.second});
  const auto count_u = static_cast<Eigen::Index>(u.size()), count_v = static_cast<Eigen::Index>(v.size());
  const double size =
      (first.control_points().rowwise().maxCoeff() - first.control_points().rowwise().minCoeff()).norm();
  for (Eigen::Index j = 0; j < count_v; ++j)
    for (Eigen::Index i = 0; i < count_u; ++i) {
      const Eigen::Vector3d apart =
          of_first.col(i + count_u * j) - of_second.col(grid.swapped ? j + count_v * i : i + count_u * j);
      const double distance = apart.norm();
      if (distance <= same_place * size) continue;
      if (!(distance <= 10 * same_point)) return false;
      const auto tangents =
          first.jacobian(Point(u.first[static_cast<std::size_t>(i)], v.first[static_cast<std::size_t>(j)]));
      for (int d = 0; d < 2; ++d)
        if (std::abs(apart.dot(Eigen::Vector3d(tangents.col(d)).normalized())) > same_place * size)
          return false;
    }
  return true;
}

}  // namespace

std::optional<SharedGrid> shared_grid(const DividedSurface& first, const DividedSurface& second,
                                      const std::array<int, 2>& points, double same_point) {
  const std::optional<Seed> common = seed(*first.surface, *second.surface, same_point);
  if (!common) return std::nullopt;
  const auto of_first = first.surface->jacobian(common->first);
  const auto of_second = second.surface->jacobian(common->second);
  SharedGrid grid;
  grid.swapped = cosine(of_first.col(0), of_second.col(1)) > cosine(of_first.col(0), of_second.col(0));
  std::vector<LinesThrough> lines;
  for (int d = 0; d < 2; ++d) {
    lines.emplace_back(first, second, *common, d, grid.second_direction(d), same_point);
    const auto ends = lines.back().ends();
    if (!ends) return std::nullopt;
    grid.lines[static_cast<std::size_t>(d)] = lines.back().line(*ends, points[static_cast<std::size_t>(d)]);
  }
  if (is_same_grid(*first.surface, *second.surface, grid, same_point)) return grid;
  for (std::size_t d = 0; d < 2; ++d)
    if (!lines[d].find_second(grid.lines[d])) return std::nullopt;
  return is_same_grid(*first.surface, *second.surface, grid, same_point) ? std::optional(grid) : std::nullopt;
}

}  // namespace isopatch::geometry
