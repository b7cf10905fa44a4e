#include "geometry/element_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/splines/tensor.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::geometry {
namespace {

/// An element along one direction: the control points that reach it.
struct Span {
  int first = 0;
  double length = 0;
};

std::vector<Span> spans_of(const KnotVector& knots) {
  std::vector<Span> result;
  const auto& u = knots.knots();
  for (std::size_t m = 0; m + 1 < u.size(); ++m)
    if (u[m] < u[m + 1]) result.push_back({static_cast<int>(m) - knots.degree(), u[m + 1] - u[m]});
  return result;
}

/// Smallest and largest values.
struct Range {
  Eigen::ArrayXXd low, high;
  void include(const Eigen::ArrayXXd& values) {
    if (low.size() == 0) low = high = values;
    low = low.min(values);
    high = high.max(values);
  }
};

/// Over windows of rows: row i of the result is about rows first .. first + count - 1.
Range over_rows(const Range& range, const std::vector<Span>& spans, int count) {
  const auto rows = static_cast<Eigen::Index>(spans.size());
  Range result{Eigen::ArrayXXd(rows, range.low.cols()), Eigen::ArrayXXd(rows, range.low.cols())};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const int first = spans[static_cast<std::size_t>(i)].first;
    result.low.row(i) = range.low.middleRows(first, count).colwise().minCoeff();
    result.high.row(i) = range.high.middleRows(first, count).colwise().maxCoeff();
  }
  return result;
}

Range over_columns(const Range& range, const std::vector<Span>& spans, int count) {
  const auto columns = static_cast<Eigen::Index>(spans.size());
  Range result{Eigen::ArrayXXd(range.low.rows(), columns), Eigen::ArrayXXd(range.low.rows(), columns)};
  for (Eigen::Index j = 0; j < columns; ++j) {
    const int first = spans[static_cast<std::size_t>(j)].first;
    result.low.col(j) = range.low.col(first);
    result.high.col(j) = range.high.col(first);
    for (int i = 1; i < count; ++i) {
      result.low.col(j) = result.low.col(j).min(range.low.col(first + i));
      result.high.col(j) = result.high.col(j).max(range.high.col(first + i));
    }
  }
  return result;
}

/// Differences of rows or columns, as control points of a derivative: p / (u[j + p + 1] - u[j + 1]).
double slope(const KnotVector& knots, Eigen::Index j) {
  const auto k = static_cast<std::size_t>(j);
  const auto p = static_cast<std::size_t>(knots.degree());
  return knots.degree() / (knots.knots()[k + p + 1] - knots.knots()[k + 1]);
}

Eigen::ArrayXXd row_slopes(const Eigen::ArrayXXd& layer, const KnotVector& knots) {
  Eigen::ArrayXd factors(layer.rows() - 1);
  for (Eigen::Index j = 0; j < factors.size(); ++j) factors[j] = slope(knots, j);
  return (layer.bottomRows(factors.size()) - layer.topRows(factors.size())).colwise() * factors;
}

Eigen::ArrayXXd column_slopes(const Eigen::ArrayXXd& layer, const KnotVector& knots) {
  Eigen::ArrayXd factors(layer.cols() - 1);
  for (Eigen::Index j = 0; j < factors.size(); ++j) factors[j] = slope(knots, j);
  return (layer.rightCols(factors.size()) - layer.leftCols(factors.size())).rowwise() * factors.transpose();
}

/// det J from numerator / weight^4.
Bounds scaled(const Bounds& numerator, double scale, double lowest_weight, double highest_weight) {
  const auto fourth = [](double x) { return x * x * x * x; };
  return {numerator.low * scale / fourth(numerator.low < 0 ? lowest_weight : highest_weight),
          numerator.high * scale / fourth(numerator.high > 0 ? lowest_weight : highest_weight)};
}

/// What the coefficients of a centred volume of half width 1 are wrong by, with its Bezier extraction.
double coefficient_error(const NurbsVolume& volume) {
  return 16.0 * (volume.degree(0) + volume.degree(1) + volume.degree(2) + 3) * unit_roundoff;
}

/// The boxes of all elements, a layer of elements after the other. The columns are those of det[X_u, X_v,
/// X_w], or of det[H, H_u, H_v, H_w] if the volume is rational (N = 4), derivatives with respect to an
/// element's share.
template <int N>
class Layers {
 public:
  explicit Layers(const NurbsVolume& volume) : volume_(volume) {
    for (std::size_t d = 0; d < 3; ++d) spans_[d] = spans_of(volume.knots()[d]);
    const Eigen::Matrix4Xd homogeneous = volume.homogeneous() / (N == 4 ? 1.0 : volume.weights()[0]);
    const Eigen::Index layer = Eigen::Index(volume.size(0)) * volume.size(1);
    for (std::size_t c = 0; c < N; ++c) {
      const Eigen::RowVectorXd row = homogeneous.row(static_cast<Eigen::Index>(c));
      coordinates_[c] = row.reshaped(layer, volume.size(2));
    }
  }

  const std::array<std::vector<Span>, 3>& spans() const { return spans_; }

  /// Looks at a layer of elements.
  void enter(std::size_t third) {
    for (int column = 0; column < N; ++column)
      for (std::size_t c = 0; c < N; ++c)
        ranges_[static_cast<std::size_t>(column)][c] = range(c, column - (N - 3), third);
  }

  ColumnBoxes<N> boxes(Eigen::Index i, Eigen::Index j, std::size_t third) const {
    ColumnBoxes<N> result;
    const std::array<double, 3> lengths = {spans_[0][static_cast<std::size_t>(i)].length,
                                           spans_[1][static_cast<std::size_t>(j)].length,
                                           spans_[2][third].length};
    const double error = coefficient_error(volume_);
    for (int column = 0; column < N; ++column) {
      const int d = column - (N - 3);
      const double length = d < 0 ? 1 : lengths[static_cast<std::size_t>(d)];
      const double column_error = d < 0 ? error : 2 * volume_.degree(d) * error;
      for (int c = 0; c < N; ++c) {
        const Range& range = ranges_[static_cast<std::size_t>(column)][static_cast<std::size_t>(c)];
        const double low = length * range.low(i, j), high = length * range.high(i, j);
        result.centre(c, column) = (low + high) / 2;
        result.half(c, column) =
            (high - low) / 2 + column_error + 8 * unit_roundoff * std::max(std::abs(low), std::abs(high));
      }
    }
    return result;
  }

 private:
  /// Of a coordinate or of its derivative (none for d < 0), for each element of the layer.
  Range range(std::size_t coordinate, int d, std::size_t third) const {
    const int first = spans_[2][third].first, p = volume_.degree(2);
    Range all;
    for (int k = first; k <= first + p - (d == 2 ? 1 : 0); ++k) all.include(layer(coordinate, d, k));
    all = over_columns(all, spans_[1], volume_.degree(1) + (d == 1 ? 0 : 1));
    return over_rows(all, spans_[0], volume_.degree(0) + (d == 0 ? 0 : 1));
  }

  Eigen::ArrayXXd layer(std::size_t coordinate, int d, int k) const {
    const auto values = [&](int at) {
      return Eigen::ArrayXXd(
          coordinates_[coordinate].col(at).reshaped(volume_.size(0), volume_.size(1)).array());
    };
    if (d == 2) return (values(k + 1) - values(k)) * slope(volume_.knots(2), k);
    if (d == 1) return column_slopes(values(k), volume_.knots(1));
    return d == 0 ? row_slopes(values(k), volume_.knots(0)) : values(k);
  }

  const NurbsVolume& volume_;
  std::array<std::vector<Span>, 3> spans_;
  std::array<Eigen::MatrixXd, N> coordinates_;
  std::array<std::array<Range, N>, N> ranges_;
};

template <int N>
std::vector<Bounds> all_bounds(const CentredVolume& centred) {
  Layers<N> layers(centred.volume);
  const auto& spans = layers.spans();
  std::vector<Bounds> result;
  result.reserve(spans[0].size() * spans[1].size() * spans[2].size());
  const double cube = centred.radius * centred.radius * centred.radius;
  for (std::size_t k = 0; k < spans[2].size(); ++k) {
    layers.enter(k);
    for (std::size_t j = 0; j < spans[1].size(); ++j)
      for (std::size_t i = 0; i < spans[0].size(); ++i) {
        const auto boxes = layers.boxes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j), k);
        const Bounds numerator = determinant_bounds<N>(boxes);
        const double scale = cube / (spans[0][i].length * spans[1][j].length * spans[2][k].length);
        if constexpr (N == 4) {
          const double weight = boxes.centre(3, 0), half = boxes.half(3, 0);
          result.push_back(scaled({-numerator.high, -numerator.low}, scale, weight - half, weight + half));
        } else {
          result.push_back(scaled(numerator, scale, 1, 1));
        }
      }
  }
  return result;
}

/// Control points of a Bezier piece's derivative along d, over the unit cube; of the piece itself for d < 0.
template <int N>
Eigen::Matrix<double, N, Eigen::Dynamic> column_of(const Eigen::Matrix<double, N, Eigen::Dynamic>& points,
                                                   const std::array<int, 3>& sizes, int d) {
  if (d < 0) return points;
  const int p = sizes[static_cast<std::size_t>(d)] - 1;
  Eigen::MatrixXd difference = Eigen::MatrixXd::Zero(p, p + 1);
  difference.diagonal().setConstant(-p);
  difference.diagonal(1).setConstant(p);
  return apply_along<3>(points, sizes, d, difference);
}

template <int N>
Bounds bounds_of(const NurbsVolume& element, double radius) {
  std::array<Eigen::Matrix<double, N, Eigen::Dynamic>, N> hulls;
  std::array<double, N> errors;
  const Eigen::Matrix<double, N, Eigen::Dynamic> points =
      element.homogeneous().template topRows<N>() / (N == 4 ? 1.0 : element.weights()[0]);
  for (int column = 0; column < N; ++column) {
    const int d = column - (N - 3);
    const auto k = static_cast<std::size_t>(column);
    hulls[k] = column_of<N>(points, element.sizes(), d);
    errors[k] = (d < 0 ? 1 : 2 * element.degree(d)) * coefficient_error(element);
  }
  const Bounds numerator = determinant_bounds<N>(hulls, errors);
  const double scale = radius * radius * radius / (element.high() - element.low()).prod();
  if constexpr (N == 3) return scaled(numerator, scale, 1, 1);
  return scaled({-numerator.high, -numerator.low}, scale, element.weights().minCoeff(),
                element.weights().maxCoeff());
}

}  // namespace

std::vector<Bounds> element_bounds(const CentredVolume& volume) {
  return volume.volume.is_rational() ? all_bounds<4>(volume) : all_bounds<3>(volume);
}

Bounds element_bounds(const NurbsVolume& element, double radius) {
  return element.is_rational() ? bounds_of<4>(element, radius) : bounds_of<3>(element, radius);
}

BezierElements::BezierElements(const NurbsVolume& volume) : volume_(volume) {
  for (std::size_t d = 0; d < 3; ++d) {
    const KnotVector& knots = volume.knots()[d];
    const std::vector<Span> spans = spans_of(knots);
    const std::vector<double> breaks = knots.breaks();
    const int p = knots.degree();
    const TransferMatrix split = transfer(knots, bezier_knots(knots));
    for (std::size_t e = 0; e < spans.size(); ++e)
      pieces_[d].push_back({breaks[e], breaks[e + 1], spans[e].first,
                            Eigen::MatrixXd(split.middleRows(static_cast<Eigen::Index>(e) * p, p + 1))
                                .middleCols(spans[e].first, p + 1)});
    elements_[d] = static_cast<int>(spans.size());
  }
}

NurbsVolume BezierElements::operator[](int index) const {
  const std::array<const Piece*, 3> piece = {
      &pieces_[0][static_cast<std::size_t>(index % elements_[0])],
      &pieces_[1][static_cast<std::size_t>(index / elements_[0] % elements_[1])],
      &pieces_[2][static_cast<std::size_t>(index / elements_[0] / elements_[1])]};
  std::array<int, 3> sizes{};
  NurbsVolume::KnotVectors knots;
  for (std::size_t d = 0; d < 3; ++d) {
    sizes[d] = volume_.degree(static_cast<int>(d)) + 1;
    knots[d] = KnotVector::bezier(sizes[d] - 1, piece[d]->low, piece[d]->high);
  }
  Eigen::Matrix4Xd points(4, sizes[0] * sizes[1] * sizes[2]);
  Eigen::Index at = 0;
  for (int k = 0; k < sizes[2]; ++k)
    for (int j = 0; j < sizes[1]; ++j)
      for (int i = 0; i < sizes[0]; ++i, ++at) {
        const Eigen::Index source =
            piece[0]->first + i +
            Eigen::Index(volume_.size(0)) *
                (piece[1]->first + j + Eigen::Index(volume_.size(1)) * (piece[2]->first + k));
        const double weight = volume_.weights()[source];
        points.col(at) << weight * volume_.control_points().col(source), weight;
      }
  for (int d = 0; d < 3; ++d)
    points = apply_along<3>(points, sizes, d, piece[static_cast<std::size_t>(d)]->extraction);
  if (volume_.is_rational()) return NurbsVolume::from_homogeneous(std::move(knots), points);
  // Without this a B-spline would come back with weights like 1 + 1e-16 and count as rational.
  const double weight = volume_.weights()[0];
  return {std::move(knots), points.topRows<3>() / weight, Eigen::VectorXd::Constant(points.cols(), weight)};
}

}  // namespace isopatch::geometry
