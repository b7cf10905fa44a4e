#include "segmentation/parameterization/internal/edge_samples.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace isopatch::segmentation {

std::vector<double> turned(std::vector<double> shares) {
  for (double& x : shares) x = 1 - x;
  return shares;
}

namespace {

// Largest distance of the surfaces' own points from a point.
double spread(const Eigen::Vector3d& point, const std::vector<NearSurface>& surfaces) {
  double largest = 0;
  for (const NearSurface& near : surfaces)
    largest = std::max(largest, (near.map->face().surface(near.start) - point).norm());
  return largest;
}

}  // namespace

Eigen::Vector2d project(const FaceMap& map, const Eigen::Vector3d& point, const Eigen::Vector2d& start) {
  const DomainSurface& surface = map.face().surface;
  const double step = 1e-6 * map.domain_size();
  Eigen::Vector2d at = start;
  Eigen::Vector3d here = surface(at);
  double distance = (here - point).norm();
  constexpr int most = 8;
  for (int i = 0; i < most; ++i) {
    Eigen::Matrix<double, 3, 2> slopes;
    for (int d = 0; d < 2; ++d) {
      const Eigen::Vector2d h = step * Eigen::Vector2d::Unit(d);
      slopes.col(d) = (surface(at + h) - surface(at - h)) / (2 * step);
    }
    const Eigen::Matrix2d normal = slopes.transpose() * slopes;
    // Outside the surface's own parameters, or at a pole, there is no way on.
    if (!(normal.determinant() > 1e-12 * normal.trace() * normal.trace())) break;
    const Eigen::Vector2d next = at + normal.inverse() * (slopes.transpose() * (point - here));
    const Eigen::Vector3d there = surface(next);
    const double now = (there - point).norm();
    if (!(now < distance)) break;
    const bool settled = distance - now < 1e-6 * distance;
    at = next;
    here = there;
    distance = now;
    if (settled) break;
  }
  return at;
}

CommonPoint common_point(const Eigen::Vector3d& near, std::vector<NearSurface> surfaces, double size) {
  constexpr int most_rounds = 12;
  Eigen::Vector3d point = near;
  if (const double already = spread(point, surfaces); already < 1e-9 * size) return {point, already};
  for (int round = 0; round < most_rounds; ++round) {
    const Eigen::Vector3d before = point;
    for (NearSurface& surface : surfaces) {
      surface.start = project(*surface.map, point, surface.start);
      point = surface.map->face().surface(surface.start);
    }
    if ((point - before).norm() < 1e-8 * size) break;
  }
  // The last projection was on one of them: the mean of all is fair where they do not meet.
  Eigen::Vector3d sum(0, 0, 0);
  for (NearSurface& surface : surfaces) {
    surface.start = project(*surface.map, point, surface.start);
    sum += surface.map->face().surface(surface.start);
  }
  const Eigen::Vector3d mean = sum / static_cast<double>(surfaces.size());
  return {mean, spread(mean, surfaces)};
}

namespace {

/// A face's outline along an edge.
struct Source {
  const FaceMap* map;
  Eigen::Matrix2Xd domain;
  Eigen::Matrix3Xd points;
};

std::vector<Source> sources_of(const HexComplex& complex, std::size_t edge,
                               const std::vector<double>& shares) {
  std::vector<Source> sources;
  for (const HexEdgeUse& use : complex.topology.edges[edge].uses)
    for (const Side side : geometry::all_sides) {
      const auto edges = geometry::side_edges(side);
      const auto found = std::find(edges.begin(), edges.end(), use.edge.edge);
      if (found == edges.end()) continue;
      const int k = static_cast<int>(found - edges.begin());
      const FaceMap& map = complex.map({use.edge.block, side});
      const std::vector<double> own = use.reversed ? turned(shares) : shares;
      sources.push_back({&map, map.side_domain(k, own), map.side_points(k, own)});
    }
  return sources;
}

std::vector<NearSurface> near(const std::vector<Source>& sources, Eigen::Index i) {
  std::vector<NearSurface> surfaces;
  for (const Source& source : sources) surfaces.push_back({source.map, source.domain.col(i)});
  return surfaces;
}

// The mean of the outlines, moved so that it goes from vertex to vertex.
Eigen::Matrix3Xd mean_outline(const HexComplex& complex, std::size_t edge, const std::vector<double>& shares,
                              const std::vector<Source>& sources) {
  const auto mean = [](const std::vector<Source>& of) {
    Eigen::Matrix3Xd sum = of.front().points;
    for (std::size_t i = 1; i < of.size(); ++i) sum += of[i].points;
    return Eigen::Matrix3Xd(sum / static_cast<double>(of.size()));
  };
  Eigen::Matrix3Xd points = mean(sources);
  const Eigen::Matrix3Xd ends = mean(sources_of(complex, edge, {0, 1}));
  const auto& ends_of_edge = complex.topology.edges[edge].vertices;
  const Eigen::Vector3d first = complex.vertex(ends_of_edge[0]), last = complex.vertex(ends_of_edge[1]);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const double x = shares[static_cast<std::size_t>(i)];
    points.col(i) += (1 - x) * (first - ends.col(0)) + x * (last - ends.col(1));
    if (x == 0) points.col(i) = first;
    if (x == 1) points.col(i) = last;
  }
  return points;
}

// Whether surfaces meet all along an edge, near its mean outline.
bool surfaces_meet(const HexComplex& complex, std::size_t edge) {
  std::vector<double> shares;
  for (int i = 1; i < 32; ++i) shares.push_back(i / 32.0);
  const std::vector<Source> sources = sources_of(complex, edge, shares);
  const Eigen::Matrix3Xd points = mean_outline(complex, edge, shares, sources);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const std::vector<NearSurface> surfaces = near(sources, i);
    const CommonPoint found = common_point(points.col(i), surfaces, complex.size);
    const double way = (found.point - points.col(i)).norm();
    if (found.miss > 1e-5 * complex.size || way > 3 * spread(points.col(i), surfaces) + 1e-9 * complex.size)
      return false;
  }
  return true;
}

}  // namespace

EdgeSamples sample_edge(const HexComplex& complex, std::size_t edge, const std::vector<double>& shares) {
  const std::vector<Source> sources = sources_of(complex, edge, shares);
  EdgeSamples result{mean_outline(complex, edge, shares, sources), 0};
  for (Eigen::Index i = 0; i < result.points.cols(); ++i) {
    const double share = shares[static_cast<std::size_t>(i)];
    if (complex.edges[edge].surfaces_meet && share > 0 && share < 1)
      result.points.col(i) = common_point(result.points.col(i), near(sources, i), complex.size).point;
    for (const Source& source : sources)
      result.gap = std::max(result.gap, (source.points.col(i) - result.points.col(i)).norm());
  }
  return result;
}

void locate_vertices(HexComplex& complex) {
  std::vector<std::vector<NearSurface>> around(complex.vertices.size());
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (const Side side : geometry::all_sides)
      for (int s = 0; s < 2; ++s)
        for (int t = 0; t < 2; ++t) {
          const BlockId block(static_cast<int>(b));
          const FaceMap& map = complex.map({block, side});
          const auto vertex = complex.topology.at(BlockCorner{block, geometry::side_corner(side, s, t)});
          around[static_cast<std::size_t>(vertex.value)].push_back({&map, map.domain_point(s, t)});
        }
  for (std::size_t v = 0; v < around.size(); ++v) {
    const CommonPoint found = common_point(complex.vertices[v], around[v], complex.size);
    if (found.miss < 1e-5 * complex.size) complex.vertices[v] = found.point;
  }
  for (std::size_t e = 0; e < complex.edges.size(); ++e)
    complex.edges[e].surfaces_meet = surfaces_meet(complex, e);
}

}  // namespace isopatch::segmentation
