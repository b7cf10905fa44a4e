#include "segmentation/decomposition/cutting/vertex_on_chain.hpp"

#include <algorithm>

#include "segmentation/decomposition/cutting/cell_shapes.hpp"
#include "segmentation/decomposition/cutting/divide.hpp"

namespace isopatch::segmentation {

using geometry::Brep;
using geometry::CellComplex;
using geometry::EdgeUse;

VertexId vertex_on_chain(const Brep& source, CellComplex& complex, const std::vector<EdgeUse>& chain,
                         const Eigen::Vector3d& point, double same_point) {
  for (const EdgeUse& use : chain)
    for (const VertexId end : {complex.from(use), complex.to(use)})
      if ((complex.vertex(end) - point).norm() <= same_point) return end;
  const CellShapes shapes(source, complex);
  EdgeId best;
  double at = 0, nearest = 1e300;
  for (const EdgeUse& use : chain) {
    const auto distance = [&](double t) { return (shapes.point(use.edge, t) - point).norm(); };
    double low = 0, high = 1;
    constexpr int samples = 32;
    int first = 0;
    for (int i = 1; i <= samples; ++i)
      if (distance(double(i) / samples) < distance(double(first) / samples)) first = i;
    low = std::max(0.0, double(first - 1) / samples), high = std::min(1.0, double(first + 1) / samples);
    for (int i = 0; i < 80; ++i) {
      const double a = low + (high - low) / 3, b = high - (high - low) / 3;
      (distance(a) < distance(b) ? high : low) = distance(a) < distance(b) ? b : a;
    }
    if (const double here = distance((low + high) / 2); here < nearest)
      nearest = here, at = (low + high) / 2, best = use.edge;
  }
  return divide_edge(complex, best, at, shapes.point(best, at));
}

}  // namespace isopatch::segmentation
