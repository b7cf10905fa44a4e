#pragma once

#include <vector>

namespace isopatch::geometry {

/// A clamped knot vector with its degree: the space of piecewise polynomials it spans.
///
/// Invariant: degree >= 1; knots finite and nondecreasing, different ones at least 1e-15 of the range apart;
/// first and last knot with multiplicity degree + 1; inner knots with multiplicity at most degree (the
/// splines are continuous).
class KnotVector {
 public:
  /// Highest degree accepted; far above any use, it bounds what a broken file can ask for.
  static constexpr int max_degree = 20;

  /// The polynomials of degree 1 on [0, 1].
  KnotVector() : KnotVector(1, {0, 0, 1, 1}) {}

  /// @throws Error invalid_argument, naming the knot that breaks the invariant
  KnotVector(int degree, std::vector<double> knots);

  /// One polynomial piece on [first, last].
  static KnotVector bezier(int degree, double first = 0, double last = 1);

  /// `elements` equal spans on [0, 1] joined with continuity C^(degree - multiplicity).
  static KnotVector uniform(int degree, int elements, int multiplicity = 1);

  int degree() const { return degree_; }
  const std::vector<double>& knots() const { return knots_; }
  /// Number of basis functions.
  int size() const { return static_cast<int>(knots_.size()) - degree_ - 1; }
  double first() const { return knots_.front(); }
  double last() const { return knots_.back(); }
  double length() const { return last() - first(); }

  /// Distinct knots, increasing; the elements lie between them.
  std::vector<double> breaks() const;
  /// Multiplicity of each break.
  std::vector<int> multiplicities() const;
  int element_count() const { return static_cast<int>(breaks().size()) - 1; }

  /// Index m with knots[m] <= t < knots[m + 1]; the last nonempty span for t >= last().
  int span(double t) const;

  /// Averages of `degree` consecutive knots, one per basis function: where the control points sit.
  std::vector<double> greville() const;

  bool operator==(const KnotVector&) const = default;

 private:
  int degree_;
  std::vector<double> knots_;
};

/// The same space with the direction turned around: t becomes first + last - t.
KnotVector reversed(const KnotVector& knots);

/// The same space over [first, last].
KnotVector rescaled(const KnotVector& knots, double first, double last);

/// Same degree and breaks that agree to `tolerance` times the length, after scaling both to [0, 1].
bool same_space(const KnotVector& a, const KnotVector& b, double tolerance);

}  // namespace isopatch::geometry
