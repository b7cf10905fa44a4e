#include "geometry/splines/knot_vector.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

[[noreturn]] void reject(const std::string& reason) {
  throw Error(ErrorCode::invalid_argument, "knot vector: " + reason);
}

void check_ends(int degree, const std::vector<double>& knots) {
  const auto count = knots.size();
  const auto p = static_cast<std::size_t>(degree);
  if (knots[0] != knots[p] || knots[count - 1] != knots[count - 1 - p])
    reject(fmt::format("not clamped: for degree {} the first and the last {} knots must be equal", degree,
                       p + 1));
  if (knots[p] == knots[p + 1] || knots[count - 1 - p] == knots[count - 2 - p])
    reject(fmt::format("an end knot is repeated more than degree + 1 = {} times", p + 1));
}

// Spans so short, or a range so extreme, that derivatives overflow.
void check_lengths(const std::vector<double>& knots) {
  const double length = knots.back() - knots.front();
  if (!(length > 1e-100 && length < 1e100))
    reject(fmt::format("its range, {} to {}, is too small or too large; scale it, to [0, 1] say",
                       knots.front(), knots.back()));
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i] > knots[i - 1] && knots[i] - knots[i - 1] < 1e-15 * length)
      reject(fmt::format("knots {} and {} differ, but are closer than 1e-15 of the range; make them equal",
                         i - 1, i));
}

void check_degree(int degree) {
  if (degree < 1 || degree > KnotVector::max_degree)
    reject(fmt::format("degree {} is outside 1 .. {}", degree, KnotVector::max_degree));
}

}  // namespace

KnotVector::KnotVector(int degree, std::vector<double> knots) : degree_(degree), knots_(std::move(knots)) {
  check_degree(degree_);
  const auto p = static_cast<std::size_t>(degree_);
  if (knots_.size() < 2 * (p + 1))
    reject(fmt::format("{} knots are too few for degree {}, which needs at least {}", knots_.size(), degree_,
                       2 * (p + 1)));
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    if (!std::isfinite(knots_[i])) reject(fmt::format("knot {} is {}", i, knots_[i]));
    if (i > 0 && knots_[i] < knots_[i - 1])
      reject(fmt::format("knot {} ({}) is smaller than the one before ({})", i, knots_[i], knots_[i - 1]));
  }
  if (knots_.front() == knots_.back()) reject("all knots are equal");
  check_lengths(knots_);
  check_ends(degree_, knots_);
  for (std::size_t i = p + 1; i + 2 * p + 2 <= knots_.size(); ++i)
    if (knots_[i] == knots_[i + p])
      reject(
          fmt::format("inner knot {} ({}) is repeated more than degree = {} times", i, knots_[i], degree_));
}

KnotVector KnotVector::bezier(int degree, double first, double last) {
  check_degree(degree);
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, first);
  knots.resize(2 * knots.size(), last);
  return KnotVector(degree, std::move(knots));
}

KnotVector KnotVector::uniform(int degree, int elements, int multiplicity) {
  check_degree(degree);
  if (multiplicity < 1 || multiplicity > degree)
    reject(fmt::format("multiplicity {} of inner knots is outside 1 .. degree = {}", multiplicity, degree));
  if (elements < 1) reject(fmt::format("{} elements, at least 1 is needed", elements));
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  for (int e = 1; e < elements; ++e)
    knots.insert(knots.end(), static_cast<std::size_t>(multiplicity), double(e) / elements);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
  return KnotVector(degree, std::move(knots));
}

std::vector<double> KnotVector::breaks() const {
  std::vector<double> result = knots_;
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<int> KnotVector::multiplicities() const {
  std::vector<int> result;
  for (std::size_t i = 0; i < knots_.size(); ++i) {
    if (i == 0 || knots_[i] != knots_[i - 1]) result.push_back(0);
    ++result.back();
  }
  return result;
}

int KnotVector::span(double t) const {
  if (!(t < last())) return size() - 1;
  const auto after = std::upper_bound(knots_.begin() + degree_ + 1, knots_.begin() + size(), t);
  return static_cast<int>(after - knots_.begin()) - 1;
}

std::vector<double> KnotVector::greville() const {
  std::vector<double> result(static_cast<std::size_t>(size()));
  for (int i = 0; i < size(); ++i) {
    double sum = 0;
    for (int k = 1; k <= degree_; ++k) sum += knots_[static_cast<std::size_t>(i + k)];
    result[static_cast<std::size_t>(i)] = std::clamp(sum / degree_, first(), last());
  }
  return result;
}

KnotVector reversed(const KnotVector& knots) {
  std::vector<double> turned(knots.knots().rbegin(), knots.knots().rend());
  for (double& t : turned) {
    // The ends stay exactly where they are, whatever the rounding of the sum.
    const double turned_t = std::min(knots.first() + (knots.last() - t), knots.last());
    t = t == knots.last() ? knots.first() : t == knots.first() ? knots.last() : turned_t;
  }
  return KnotVector(knots.degree(), std::move(turned));
}

KnotVector rescaled(const KnotVector& knots, double first, double last) {
  if (!(first < last)) reject(fmt::format("cannot scale to the empty range [{}, {}]", first, last));
  std::vector<double> scaled = knots.knots();
  for (double& t : scaled) {
    const double share = (t - knots.first()) / knots.length();
    t = t == knots.last() ? last : std::min(first + share * (last - first), last);
  }
  return KnotVector(knots.degree(), std::move(scaled));
}

bool same_space(const KnotVector& a, const KnotVector& b, double tolerance) {
  if (a.degree() != b.degree() || a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.knots().size(); ++i) {
    const double share_a = (a.knots()[i] - a.first()) / a.length();
    const double share_b = (b.knots()[i] - b.first()) / b.length();
    if (std::abs(share_a - share_b) > tolerance) return false;
  }
  return true;
}

}  // namespace isopatch::geometry
