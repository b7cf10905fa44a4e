#include "geometry/splines/refine.hpp"

#include <utility>

#include "geometry/splines/tensor.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::geometry {

template <int D>
Nurbs<D> refined(const Nurbs<D>& spline, const typename Nurbs<D>::KnotVectors& fine) {
  Eigen::Matrix4Xd coefficients = spline.homogeneous();
  std::array<int, D> sizes = spline.sizes();
  for (int d = 0; d < D; ++d) {
    const KnotVector& target = fine[static_cast<std::size_t>(d)];
    if (target == spline.knots(d)) continue;
    coefficients = apply_along<D>(coefficients, sizes, d, transfer(spline.knots(d), target));
    sizes[static_cast<std::size_t>(d)] = target.size();
  }
  // Without this a B-spline would come back with weights like 1 + 1e-16 and count as rational.
  if (!spline.is_rational()) {
    const double weight = spline.weights()[0];
    return Nurbs<D>(fine, coefficients.template topRows<3>() / weight,
                    Eigen::VectorXd::Constant(coefficients.cols(), weight));
  }
  return Nurbs<D>::from_homogeneous(fine, coefficients);
}

template <int D>
Nurbs<D> insert_knots(const Nurbs<D>& spline, int direction, const std::vector<double>& knots) {
  auto fine = spline.knots();
  fine[static_cast<std::size_t>(direction)] = with_knots(spline.knots(direction), knots);
  return refined(spline, fine);
}

template <int D>
Nurbs<D> elevate_degree(const Nurbs<D>& spline, int direction, int times) {
  auto fine = spline.knots();
  fine[static_cast<std::size_t>(direction)] = with_degree_raised(spline.knots(direction), times);
  return refined(spline, fine);
}

template <int D>
Nurbs<D> reversed(const Nurbs<D>& spline, int direction) {
  auto knots = spline.knots();
  auto& turned = knots[static_cast<std::size_t>(direction)];
  turned = reversed(turned);
  const int n = turned.size();
  int inner = 1;
  for (int d = 0; d < direction; ++d) inner *= spline.size(d);
  Eigen::Matrix3Xd points(3, spline.size());
  Eigen::VectorXd weights(spline.size());
  for (int i = 0; i < spline.size(); ++i) {
    const int along = (i / inner) % n;
    const int source = i + (n - 1 - 2 * along) * inner;
    points.col(i) = spline.control_points().col(source);
    weights[i] = spline.weights()[source];
  }
  return Nurbs<D>(std::move(knots), std::move(points), std::move(weights));
}

template <int D>
std::vector<Nurbs<D>> bezier_pieces(const Nurbs<D>& spline) {
  typename Nurbs<D>::KnotVectors fine;
  std::array<std::vector<double>, D> breaks;
  int pieces = 1;
  for (std::size_t d = 0; d < D; ++d) {
    fine[d] = bezier_knots(spline.knots()[d]);
    breaks[d] = fine[d].breaks();
    pieces *= static_cast<int>(breaks[d].size()) - 1;
  }
  const Nurbs<D> split = refined(spline, fine);
  std::vector<Nurbs<D>> result;
  result.reserve(static_cast<std::size_t>(pieces));
  for (int piece = 0; piece < pieces; ++piece) {
    typename Nurbs<D>::KnotVectors knots;
    std::array<int, D> start;
    int rest = piece;
    int count = 1;
    for (std::size_t d = 0; d < D; ++d) {
      const int elements = static_cast<int>(breaks[d].size()) - 1;
      const int e = rest % elements;
      rest /= elements;
      const int p = fine[d].degree();
      knots[d] = KnotVector::bezier(p, breaks[d][static_cast<std::size_t>(e)],
                                    breaks[d][static_cast<std::size_t>(e) + 1]);
      start[d] = e * p;
      count *= p + 1;
    }
    Eigen::Matrix3Xd points(3, count);
    Eigen::VectorXd weights(count);
    for (int i = 0; i < count; ++i) {
      int source = 0;
      int stride = 1;
      int local = i;
      for (std::size_t d = 0; d < D; ++d) {
        const int order = knots[d].degree() + 1;
        source += (start[d] + local % order) * stride;
        local /= order;
        stride *= fine[d].size();
      }
      points.col(i) = split.control_points().col(source);
      weights[i] = split.weights()[source];
    }
    result.emplace_back(std::move(knots), std::move(points), std::move(weights));
  }
  return result;
}

#define ISOPATCH_REFINE(D)                                                          \
  template Nurbs<D> refined(const Nurbs<D>&, const Nurbs<D>::KnotVectors&);         \
  template Nurbs<D> insert_knots(const Nurbs<D>&, int, const std::vector<double>&); \
  template Nurbs<D> elevate_degree(const Nurbs<D>&, int, int);                      \
  template Nurbs<D> reversed(const Nurbs<D>&, int);                                 \
  template std::vector<Nurbs<D>> bezier_pieces(const Nurbs<D>&)
ISOPATCH_REFINE(1);
ISOPATCH_REFINE(2);
ISOPATCH_REFINE(3);
#undef ISOPATCH_REFINE

}  // namespace isopatch::geometry
