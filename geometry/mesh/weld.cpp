#include "geometry/mesh/weld.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"

namespace isopatch::geometry {
namespace {

/// Sweeps along x: only vertices within the tolerance there are compared.
UnionFind united(const Eigen::Matrix3Xd& points, double tolerance) {
  std::vector<int> order(static_cast<std::size_t>(points.cols()));
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (int d = 0; d < 3; ++d)
      if (points(d, a) != points(d, b)) return points(d, a) < points(d, b);
    return a < b;
  });
  UnionFind together(static_cast<int>(order.size()));
  // Equal ones first: files of triangles repeat each vertex some six times.
  std::vector<int> distinct;
  for (const int i : order)
    if (!distinct.empty() && points.col(distinct.back()) == points.col(i))
      together.unite(distinct.back(), i);
    else
      distinct.push_back(i);
  if (tolerance == 0) return together;
  for (std::size_t i = 0; i < distinct.size(); ++i)
    for (std::size_t j = i + 1; j < distinct.size(); ++j) {
      const int a = distinct[i], b = distinct[j];
      if (points(0, b) - points(0, a) > tolerance) break;
      if ((points.col(a) - points.col(b)).squaredNorm() <= tolerance * tolerance) together.unite(a, b);
    }
  return together;
}

}  // namespace

Welded weld(const TriangleMesh& mesh, double tolerance) {
  if (!(tolerance >= 0))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("tolerance is {}; it must not be negative", tolerance));
  UnionFind together = united(mesh.vertices, tolerance);
  Welded result;
  std::vector<int> number(static_cast<std::size_t>(mesh.vertices.cols()), -1);
  Eigen::Matrix3Xi triangles(3, mesh.triangles.cols());
  Eigen::Index kept = 0;
  int used = 0;
  std::vector<int> sources;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    Eigen::Vector3i corners;
    for (int i = 0; i < 3; ++i) corners[i] = together.find(mesh.triangles(i, t));
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
      ++result.degenerate;
      continue;
    }
    for (int& corner : corners) {
      int& known = number[static_cast<std::size_t>(corner)];
      if (known < 0) {
        known = used++;
        sources.push_back(corner);
      }
      corner = known;
    }
    triangles.col(kept++) = corners;
  }
  result.vertices = static_cast<int>(mesh.vertices.cols()) - used;
  result.mesh.grain = mesh.grain;
  result.mesh.triangles = triangles.leftCols(kept);
  result.mesh.vertices.resize(3, used);
  for (int i = 0; i < used; ++i)
    result.mesh.vertices.col(i) = mesh.vertices.col(sources[static_cast<std::size_t>(i)]);
  return result;
}

}  // namespace isopatch::geometry
