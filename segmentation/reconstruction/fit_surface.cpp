#include "segmentation/reconstruction/internal/fit_surface.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "geometry/base/sparse_lu.hpp"
#include "geometry/splines/basis.hpp"
#include "segmentation/reconstruction/internal/nearest_on_spline.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::KnotVector;
using geometry::NurbsSurface;

constexpr int surface_degree = 3;
constexpr int most_surface_rounds = 40;
// Of the domain's side, beyond the points on each end: edges stay inside when their places move.
constexpr double margin = 0.04;
// Places move by this share of the domain's diagonal at most: farther they would fold.
constexpr double farthest_move = 0.02;
// Weight of the bending energy for each unit of the points' weights, where lengths are shares of the domain's
// diagonal. Arcs over a tenth of it come out to 1e-6 of their radius.
constexpr double most_bending = 1e-5, least_bending = 1e-11, less_bending = 0.1;
// A round of the fit counts as progress if the error falls to this share; after so many without, it ends.
constexpr double helpful = 0.7;
constexpr int most_in_vain = 3;
// Knots are halved across a direction in which a surface bends at least this share of what it does across the
// other.
constexpr double bends_too = 0.3;
// Control points that a basis function meets on one side, itself among them.
constexpr int reach = surface_degree + 1, band = 2 * surface_degree + 1;

/// Integrals of products of derivatives of the basis functions, by their distance.
struct BasisProducts {
  std::array<Eigen::MatrixXd, 3> of_order;  ///< (n, band): of order 0, 1 and 2 with the same
};

BasisProducts basis_products(const KnotVector& knots) {
  // Exact for the squares of cubics.
  constexpr std::array<double, 4> places{-0.8611363115940526, -0.3399810435848563, 0.3399810435848563,
                                         0.8611363115940526};
  constexpr std::array<double, 4> weights{0.3478548451374538, 0.6521451548625461, 0.6521451548625461,
                                          0.3478548451374538};
  BasisProducts result;
  for (Eigen::MatrixXd& products : result.of_order) products = Eigen::MatrixXd::Zero(knots.size(), band);
  const std::vector<double> breaks = knots.breaks();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k)
    for (std::size_t q = 0; q < 4; ++q) {
      const double half = (breaks[k + 1] - breaks[k]) / 2;
      const geometry::BasisValues at = geometry::basis(knots, breaks[k] + half * (1 + places[q]), 2);
      for (std::size_t order = 0; order < 3; ++order)
        for (int i = 0; i < reach; ++i)
          for (int j = 0; j < reach; ++j)
            result.of_order[order](at.first + i, j - i + surface_degree) +=
                half * weights[q] * at.values(static_cast<Eigen::Index>(order), i) *
                at.values(static_cast<Eigen::Index>(order), j);
    }
  return result;
}

KnotVector knots_between(const std::set<double>& breaks) {
  std::vector<double> knots(surface_degree, *breaks.begin());
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), surface_degree, *breaks.rbegin());
  return KnotVector(surface_degree, std::move(knots));
}

class SurfaceFitter {
 public:
  SurfaceFitter(const PlacedPoints& given, double tolerance, int most)
      : places_(given.places),
        weights_(given.weights),
        most_(std::min(most, 3 * static_cast<int>(given.points.cols()))) {
    const Eigen::Vector2d low = places_.rowwise().minCoeff(), high = places_.rowwise().maxCoeff();
    scale_ = (high - low).norm();
    middle_ = given.points.rowwise().mean();
    points_ = (given.points.colwise() - middle_) / scale_;
    places_ /= scale_;
    tolerance_ = tolerance / scale_;
    for (Eigen::Index d = 0; d < 2; ++d) {
      const double more = margin * (high[d] - low[d]);
      breaks_[static_cast<std::size_t>(d)] = {(low[d] - more) / scale_, (high[d] + more) / scale_};
    }
  }

  FittedSurface fit() {
    double before = 1e300, least = 1e300;
    bool stiffness_helps = true;
    for (int round = 0, in_vain = 0; round < most_surface_rounds; ++round) {
      const NurbsSurface next = solved();
      move_places(next);
      const double largest = off_.maxCoeff();
      if (largest < least) best_ = {next, nearest_, off_};
      if (largest <= tolerance_) break;
      // What did not help the last time is not tried again before the other has been.
      in_vain = largest < helpful * least ? 0 : in_vain + 1;
      if (largest > helpful * before) stiffness_helps = !stiffness_helps;
      if (in_vain > most_in_vain) break;
      before = largest;
      least = std::min(least, largest);
      if (stiffness_helps && bending_ > least_bending)
        bending_ *= less_bending;
      else if (!halve(next)) {
        if (bending_ <= least_bending) break;
        bending_ *= less_bending;
      }
    }
    return in_metres();
  }

 private:
  int size(std::size_t direction) const { return knots_[direction].size(); }

  NurbsSurface solved() {
    for (const std::size_t d : {0u, 1u}) knots_[d] = knots_between(breaks_[d]);
    const Eigen::Index count = Eigen::Index(size(0)) * size(1);
    bands_ = Eigen::MatrixXd::Zero(Eigen::Index(band) * band, count);
    right_ = Eigen::MatrixXd::Zero(count, 3);
    add_bending();
    add_points();
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(static_cast<std::size_t>(bands_.size()));
    for (int j = 0; j < size(1); ++j)
      for (int i = 0; i < size(0); ++i)
        for (int b = 0; b < band; ++b)
          for (int a = 0; a < band; ++a) {
            const int k = i + a - surface_degree, l = j + b - surface_degree;
            if (k < 0 || l < 0 || k >= size(0) || l >= size(1)) continue;
            entries.emplace_back(i + size(0) * j, k + size(0) * l, bands_(a + band * b, i + size(0) * j));
          }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const auto control = solve_by_lu(matrix, right_);
    return {knots_, control ? Eigen::Matrix3Xd(control->transpose()) : Eigen::Matrix3Xd::Zero(3, count)};
  }

  /// The integral of S_uu^2 + 2 S_uv^2 + S_vv^2.
  void add_bending() {
    const BasisProducts u = basis_products(knots_[0]), v = basis_products(knots_[1]);
    const double weight = bending_ * weights_.sum();
    for (int j = 0; j < size(1); ++j)
      for (int i = 0; i < size(0); ++i)
        for (int b = 0; b < band; ++b)
          for (int a = 0; a < band; ++a)
            bands_(a + band * b, i + size(0) * j) += weight * (u.of_order[2](i, a) * v.of_order[0](j, b) +
                                                               2 * u.of_order[1](i, a) * v.of_order[1](j, b) +
                                                               u.of_order[0](i, a) * v.of_order[2](j, b));
  }

  void add_points() {
    for (Eigen::Index p = 0; p < points_.cols(); ++p) {
      const geometry::BasisValues u = geometry::basis(knots_[0], places_(0, p)),
                                  v = geometry::basis(knots_[1], places_(1, p));
      for (int j = 0; j < reach; ++j)
        for (int i = 0; i < reach; ++i) {
          const Eigen::Index row = u.first + i + size(0) * Eigen::Index(v.first + j);
          const double share = weights_[p] * u.values(0, i) * v.values(0, j);
          right_.row(row) += share * points_.col(p).transpose();
          for (int l = 0; l < reach; ++l)
            for (int k = 0; k < reach; ++k)
              bands_(k - i + surface_degree + band * (l - j + surface_degree), row) +=
                  share * u.values(0, k) * v.values(0, l);
        }
    }
  }

  void move_places(const NurbsSurface& surface) {
    const NearestOnSpline nearest(surface);
    off_.resize(points_.cols());
    nearest_ = places_;
    if (start_.cols() == 0) start_ = places_;
    for (Eigen::Index p = 0; p < points_.cols(); ++p) {
      nearest_.col(p) = nearest.parameters(points_.col(p), places_.col(p));
      off_[p] = (surface.point(nearest_.col(p)) - points_.col(p)).norm();
      const Eigen::Vector2d way = nearest_.col(p) - start_.col(p);
      places_.col(p) = start_.col(p) + way * std::min(1.0, farthest_move / std::max(1e-300, way.norm()));
    }
  }

  /// New knots in the middle of spans with points that are off; none if that would be too many.
  bool halve(const NurbsSurface& surface) {
    std::array<std::set<double>, 2> added = breaks_;
    std::vector<int> inside(static_cast<std::size_t>(knots_[0].knots().size() * knots_[1].knots().size()), 0);
    const auto cell = [&](Eigen::Index p) {
      return static_cast<std::size_t>(knots_[0].span(places_(0, p))) +
             knots_[0].knots().size() * static_cast<std::size_t>(knots_[1].span(places_(1, p)));
    };
    for (Eigen::Index p = 0; p < points_.cols(); ++p) ++inside[cell(p)];
    for (Eigen::Index p = 0; p < points_.cols(); ++p) {
      if (!(off_[p] > tolerance_) || inside[cell(p)] < 2) continue;
      std::array<std::pair<double, double>, 2> span;
      std::array<double, 2> bend{};
      for (const std::size_t d : {0u, 1u}) {
        const auto k = static_cast<std::size_t>(knots_[d].span(places_(static_cast<Eigen::Index>(d), p)));
        span[d] = {knots_[d].knots()[k], knots_[d].knots()[k + 1]};
        const double width = span[d].second - span[d].first;
        bend[d] = width * width *
                  surface.derivative(places_.col(p), d == 0 ? std::array{2, 0} : std::array{0, 2}).norm();
      }
      for (const std::size_t d : {0u, 1u})
        if (bend[d] >= bends_too * std::max(bend[0], bend[1]))
          added[d].insert((span[d].first + span[d].second) / 2);
    }
    if (added == breaks_) return false;
    const auto count = [](const std::set<double>& breaks) { return breaks.size() + surface_degree - 1; };
    if (count(added[0]) * count(added[1]) > static_cast<std::size_t>(most_)) return false;
    breaks_ = std::move(added);
    return true;
  }

  FittedSurface in_metres() const {
    const NurbsSurface& found = best_.surface;
    return {NurbsSurface(found.knots(), (scale_ * found.control_points()).colwise() + middle_), best_.places,
            scale_ * best_.off};
  }

  Eigen::Matrix3Xd points_;
  Eigen::Matrix2Xd places_, nearest_, start_;
  Eigen::VectorXd weights_, off_;
  Eigen::Vector3d middle_;
  int most_;
  double scale_ = 1, tolerance_ = 0, bending_ = most_bending;
  std::array<std::set<double>, 2> breaks_;
  NurbsSurface::KnotVectors knots_;
  Eigen::MatrixXd bands_;  ///< the equations: a column for each control point, by the distances of the other
  Eigen::MatrixXd right_;
  FittedSurface best_;
};

}  // namespace

FittedSurface fit_surface(const PlacedPoints& points, double tolerance, int most) {
  return SurfaceFitter(points, tolerance, most).fit();
}

}  // namespace isopatch::segmentation
