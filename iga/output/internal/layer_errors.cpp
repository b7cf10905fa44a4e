#include "iga/output/internal/layer_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <limits>

#include "geometry/base/larger.hpp"
#include "iga/output/plane_fields.hpp"

namespace isopatch::iga {
namespace {

// Of a cell's largest stress: no need to know an error better.
constexpr double negligible = 1e-3;

using StressDeviator = Eigen::Matrix<double, 6, 1>;
using FaceCorners = std::array<Eigen::Index, 4>;

/// A plane of nodes: deviators whose length is the von Mises stress, and the length of their second
/// derivative along each direction, 0 at the ends of elements.
struct DeviatorPlane {
  Eigen::Matrix<double, 6, Eigen::Dynamic> deviators;
  Eigen::Array3Xd curved;
  std::vector<char> is_borrowed;
  Eigen::Matrix3Xd points;
};

DeviatorPlane deviator_plane(const FieldPlane& fields) {
  DeviatorPlane plane{fields.stress, Eigen::Array3Xd::Zero(3, fields.stress.cols()), fields.is_borrowed,
                      fields.points};
  plane.deviators.topRows<3>().rowwise() -= fields.stress.topRows<3>().colwise().mean().eval();
  plane.deviators.topRows<3>() *= std::sqrt(1.5);
  plane.deviators.bottomRows<3>() *= std::sqrt(3.0);
  return plane;
}

// The nodes of one direction.
struct NodeLine {
  NodeLine(const geometry::KnotVector& knots, const std::vector<double>& parameters) : nodes(parameters) {
    const std::vector<double> breaks = knots.breaks();
    for (const double node : nodes)
      inside.push_back(std::binary_search(breaks.begin(), breaks.end(), node) ? 0 : 1);
  }
  double step(std::size_t i) const { return nodes[i + 1] - nodes[i]; }
  // Second derivative at node i of values at i - 1, i and i + 1.
  double second_derivative(std::size_t i, const auto& before, const auto& at, const auto& after) const {
    const double left = step(i - 1), right = step(i);
    return 2 / (left + right) * ((after - at) / right - (at - before) / left).norm();
  }

  std::vector<double> nodes;
  std::vector<char> inside;  // of an element
};

// A cell's eight corners, the first direction fastest.
struct StressCell {
  std::array<StressDeviator, 8> deviators;
  std::array<double, 8> norms{};
};

// By how much the mean of norms passes the norm of the mean.
double norm_excess(const StressCell& cell, const std::array<double, 8>& weights) {
  StressDeviator sum = StressDeviator::Zero();
  double norms = 0;
  for (std::size_t c = 0; c < 8; ++c) {
    sum += weights[c] * cell.deviators[c];
    norms += weights[c] * cell.norms[c];
  }
  return norms - sum.norm();
}

// No excess of the cell is larger: with e along the middle m and all corners within r of m, the norm of a
// mean is at least its part along e, and that of a corner passes its own part along e by r^2 / (2 (|m| - r))
// at most.
double excess_bound(const StressCell& cell) {
  StressDeviator middle = StressDeviator::Zero();
  for (const StressDeviator& s : cell.deviators) middle += 0.125 * s;
  double radius = 0;
  for (const StressDeviator& s : cell.deviators) radius = std::max(radius, (s - middle).norm());
  const double length = middle.norm();
  return length > radius ? radius * radius / (2 * (length - radius))
                         : std::numeric_limits<double>::infinity();
}

// The largest excess on the four edges along a direction.
double excess_along(const StressCell& cell, std::size_t direction) {
  const std::size_t bit = std::size_t{1} << direction;
  double result = 0;
  for (std::size_t c = 0; c < 8; ++c)
    if (!(c & bit))
      for (const double share : {0.25, 0.5, 0.75}) {
        std::array<double, 8> weights{};
        weights[c] = 1 - share;
        weights[c | bit] = share;
        result = std::max(result, norm_excess(cell, weights));
      }
  return result;
}

// The largest excess in the middle of faces and of the cell.
double excess_inside(const StressCell& cell) {
  std::array<double, 8> weights;
  weights.fill(0.125);
  double result = norm_excess(cell, weights);
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t c = 0; c < 8; ++c) weights[c] = (c >> d & 1) == side ? 0.25 : 0;
      result = std::max(result, norm_excess(cell, weights));
    }
  return result;
}

class LayerEstimate {
 public:
  LayerEstimate(const geometry::NurbsVolume& patch, const geometry::GridParameters<3>& grid)
      : lines_{NodeLine(patch.knots(0), grid[0]), NodeLine(patch.knots(1), grid[1]),
               NodeLine(patch.knots(2), grid[2])} {
    for (std::size_t d = 0; d < 3; ++d) result_.layers[d].assign(grid[d].size() - 1, 0.0);
  }

  void add(const FieldPlane& fields) {
    result_.largest_stress =
        isopatch::larger(result_.largest_stress, fields.von_mises.maxCoeff<Eigen::PropagateNaN>());
    planes_.push_back(deviator_plane(fields));
    curve_within(planes_.back());
    ++seen_;
    if (planes_.size() >= 3 && lines_[2].inside[seen_ - 2]) curve_across();
    if (planes_.size() == 4) planes_.pop_front();
    if (planes_.size() == 3) estimate_layer(seen_ - 3, planes_[0], planes_[1]);
  }

  LayerErrors finish() {
    const std::size_t last = planes_.size() - 1;
    estimate_layer(seen_ - 2, planes_[last - 1], planes_[last]);
    return std::move(result_);
  }

 private:
  Eigen::Index at(std::size_t i, std::size_t j) const {
    return static_cast<Eigen::Index>(i + j * lines_[0].nodes.size());
  }

  void curve_within(DeviatorPlane& plane) const {
    for (std::size_t j = 0; j < lines_[1].nodes.size(); ++j)
      for (std::size_t i = 0; i < lines_[0].nodes.size(); ++i) {
        const auto& s = plane.deviators;
        if (lines_[0].inside[i])
          plane.curved(0, at(i, j)) =
              lines_[0].second_derivative(i, s.col(at(i - 1, j)), s.col(at(i, j)), s.col(at(i + 1, j)));
        if (lines_[1].inside[j])
          plane.curved(1, at(i, j)) =
              lines_[1].second_derivative(j, s.col(at(i, j - 1)), s.col(at(i, j)), s.col(at(i, j + 1)));
      }
  }

  // Of the last plane but one.
  void curve_across() {
    const std::size_t last = planes_.size() - 1;
    for (Eigen::Index n = 0; n < planes_[last].deviators.cols(); ++n)
      planes_[last - 1].curved(2, n) =
          lines_[2].second_derivative(seen_ - 2, planes_[last - 2].deviators.col(n),
                                      planes_[last - 1].deviators.col(n), planes_[last].deviators.col(n));
  }

  void estimate_layer(std::size_t k, const DeviatorPlane& low, const DeviatorPlane& high) {
    for (std::size_t j = 0; j + 1 < lines_[1].nodes.size(); ++j)
      for (std::size_t i = 0; i + 1 < lines_[0].nodes.size(); ++i) estimate_cell({i, j, k}, low, high);
  }

  void estimate_cell(const std::array<std::size_t, 3>& index, const DeviatorPlane& low,
                     const DeviatorPlane& high) {
    const auto [i, j, k] = index;
    const FaceCorners corners = {at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)};
    StressCell cell;
    Eigen::Array3d error = Eigen::Array3d::Zero();
    for (std::size_t c = 0; c < 8; ++c) {
      const DeviatorPlane& plane = c < 4 ? low : high;
      if (plane.is_borrowed[static_cast<std::size_t>(corners[c % 4])]) return;
      cell.deviators[c] = plane.deviators.col(corners[c % 4]);
      cell.norms[c] = cell.deviators[c].norm();
      error = error.max(plane.curved.col(corners[c % 4]));
    }
    for (std::size_t d = 0; d < 3; ++d)
      error[static_cast<Eigen::Index>(d)] *= lines_[d].step(index[d]) * lines_[d].step(index[d]) / 8;
    const double curved = error.sum();
    double most = excess_bound(cell);
    if (most > negligible * *std::max_element(cell.norms.begin(), cell.norms.end())) {
      most = excess_inside(cell);
      for (std::size_t d = 0; d < 3; ++d) {
        const double edges = excess_along(cell, d);
        most = std::max(most, edges);
        error[static_cast<Eigen::Index>(d)] += edges;
      }
    }
    const double all = curved + most;
    if (all > result_.largest_error) {
      result_.largest_error = all;
      result_.place = 0.5 * (low.points.col(corners[0]) + high.points.col(corners[3]));
    }
    for (std::size_t d = 0; d < 3; ++d)
      if (error[static_cast<Eigen::Index>(d)] >= 0.5 * error.maxCoeff())
        result_.layers[d][index[d]] = std::max(result_.layers[d][index[d]], all);
  }

  std::array<NodeLine, 3> lines_;
  std::deque<DeviatorPlane> planes_;  // the last three
  std::size_t seen_ = 0;
  LayerErrors result_;
};

}  // namespace

LayerErrors layer_errors(const ElasticField& field, int patch, const geometry::GridParameters<3>& grid) {
  PlaneFields planes(field, patch, grid);
  LayerEstimate estimate(field.patches[static_cast<std::size_t>(patch)], grid);
  for (int k = 0; k < planes.sizes()[2]; ++k) estimate.add(planes.plane(k));
  return estimate.finish();
}

}  // namespace isopatch::iga
