#include "geometry/jacobian_certificate.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/collapse.hpp"
#include "geometry/element_bounds.hpp"
#include "geometry/jacobian_grid.hpp"
#include "geometry/jacobian_piece.hpp"

namespace isopatch::geometry {
namespace {

/// Where one direction of a box is: at its low end, anywhere, at its high end. Three of them name one of the
/// 27 corners, edges and faces of a box and the box itself.
enum Place { at_low, anywhere, at_high };
using Cell = std::array<Place, 3>;

Cell cell_of(const PatchEdge& edge) {
  const auto across = tangents(side_of(edge.along, false));
  Cell cell{anywhere, anywhere, anywhere};
  for (std::size_t k = 0; k < 2; ++k)
    cell[static_cast<std::size_t>(across[k])] = edge.high[k] ? at_high : at_low;
  return cell;
}

Cell cell_of(Side side) {
  Cell cell{anywhere, anywhere, anywhere};
  cell[static_cast<std::size_t>(direction(side))] = is_high(side) ? at_high : at_low;
  return cell;
}

bool contains(const Cell& outer, const Cell& inner) {
  for (std::size_t d = 0; d < 3; ++d)
    if (outer[d] != anywhere && outer[d] != inner[d]) return false;
  return true;
}

/// Edges and faces of a centred volume that are collapsed to round-off.
std::vector<Cell> collapsed_cells(const NurbsVolume& unit) {
  constexpr double tolerance = 16 * std::numeric_limits<double>::epsilon();
  std::vector<Cell> cells;
  for (const PatchEdge& edge : all_edges())
    if (is_collapsed(unit, edge, tolerance)) cells.push_back(cell_of(edge));
  for (const Side side : all_sides)
    if (is_collapsed(unit, side, tolerance)) cells.push_back(cell_of(side));
  return cells;
}

/// Keeps the time bounded where det J is zero on a whole curve or surface.
constexpr int max_pieces = 20000;
/// And where very many elements may hold the lowest or highest coefficient: for each of the two, how many are
/// expanded, and how many are looked at one by one.
constexpr int max_expanded = 2000;
constexpr int max_looked_at = 100000;
/// Bounds this close, as a share of themselves, are not told apart.
constexpr double same_bound = 1e-9;

/// How well an element is known.
enum class Known { from_patch, from_element, expanded };

class Certifier {
 public:
  Certifier(const NurbsVolume& volume, const CertificateOptions& options, const Progress& progress)
      : volume_(volume),
        options_(options),
        progress_(progress),
        unit_(centred(volume)),
        elements_(unit_.volume) {
    certificate_.smallest = certificate_.lower = std::numeric_limits<double>::infinity();
    certificate_.upper = -std::numeric_limits<double>::infinity();
  }

  JacobianCertificate run() {
    collapsed_ = collapsed_cells(unit_.volume);
    progress_("bounding det J", 0);
    bounds_ = element_bounds(unit_);
    known_.assign(bounds_.size(), Known::from_patch);
    note_corners();
    examine_unclear();
    sharpen(Lowest{});
    progress_("bounding det J", 0.9);
    sharpen(Highest{});
    int pieces = 0;
    while (!negative_ && !undecided_.empty() && undecided_.top().piece.depth < 3 * options_.max_depth &&
           pieces < max_pieces) {
      const JacobianPiece worst = undecided_.top().piece;
      undecided_.pop();
      for (JacobianPiece& part : worst.halved()) examine(std::move(part));
      pieces += 2;
    }
    certificate_.sign = negative_             ? JacobianSign::negative
                        : !undecided_.empty() ? JacobianSign::undecided
                        : zero_               ? JacobianSign::nonnegative
                                              : JacobianSign::positive;
    for (; !undecided_.empty(); undecided_.pop()) widen_bounds(undecided_.top().piece);
    certificate_.place = volume_.point(certificate_.parameter);
    return certificate_;
  }

 private:
  struct Undecided {
    double lower = 0;
    JacobianPiece piece;
    bool operator<(const Undecided& other) const {
      return lower > other.lower;
    }  // the worst on top of the heap
  };

  /// Which end of det J is being sharpened: a cost is larger the farther out an element may be.
  struct Lowest {
    static double reach(const Bounds& bounds) { return -bounds.low; }
    static double& found(JacobianCertificate& certificate) { return certificate.lower; }
    static double end(double reach) { return -reach; }
  };
  struct Highest {
    static double reach(const Bounds& bounds) { return bounds.high; }
    static double& found(JacobianCertificate& certificate) { return certificate.upper; }
    static double end(double reach) { return reach; }
  };

  /// The values at the corners of the elements.
  void note_corners() {
    const GridParameters<3> breaks = {volume_.knots(0).breaks(), volume_.knots(1).breaks(),
                                      volume_.knots(2).breaks()};
    double smallest = std::numeric_limits<double>::infinity();
    Parameter<3> where = volume_.low();
    for_each_line(volume_, breaks, [&](const JacobianLine& line) {
      Eigen::Index at = 0;
      const double value = line.determinants().minCoeff(&at);
      if (!(value < smallest)) return;
      smallest = value;
      where = {breaks[0][static_cast<std::size_t>(line.first)], breaks[1][static_cast<std::size_t>(at)],
               breaks[2][static_cast<std::size_t>(line.third)]};
    });
    note_value(where);
  }

  /// Expands all elements whose sign is not clear from their control points.
  void examine_unclear() {
    for (int e = 0; e < elements_.count(); ++e) {
      const auto k = static_cast<std::size_t>(e);
      if (e % 4096 == 0) progress_("bounding det J", 0.1 + 0.6 * e / elements_.count());
      if (bounds_[k].low > 0) continue;
      know_better(k);
      if (!(bounds_[k].low > 0)) know_better(k);
    }
  }

  void know_better(std::size_t e) {
    const NurbsVolume element = elements_[static_cast<int>(e)];
    if (known_[e] == Known::from_patch) {
      const Bounds found = element_bounds(element, unit_.radius);
      bounds_[e] = {std::max(bounds_[e].low, found.low), std::min(bounds_[e].high, found.high)};
      known_[e] = Known::from_element;
    } else {
      known_[e] = Known::expanded;
      examine(jacobian_piece(element, unit_.radius));
    }
  }

  // Expands the elements that may reach farthest until none of the others can reach farther.
  template <class End>
  void sharpen(End) {
    using Reach = std::pair<double, std::size_t>;
    std::vector<Reach> all;
    for (std::size_t e = 0; e < bounds_.size(); ++e)
      if (known_[e] != Known::expanded) all.emplace_back(End::reach(bounds_[e]), e);
    std::priority_queue<Reach> open(std::less<Reach>{}, std::move(all));
    double& found = End::found(certificate_);
    int expanded = 0, looked_at = 0;
    const auto settled = [&] {
      const double best = End::reach({found, found});
      return open.top().first <= best + same_bound * std::abs(best) || expanded == max_expanded ||
             looked_at == max_looked_at;
    };
    while (!open.empty() && !settled()) {
      const std::size_t e = open.top().second;
      open.pop();
      ++(known_[e] == Known::from_element ? expanded : looked_at);
      know_better(e);
      if (known_[e] != Known::expanded) open.emplace(End::reach(bounds_[e]), e);
    }
    if (!open.empty()) found = End::end(std::max(End::reach({found, found}), open.top().first));
  }

  void examine(JacobianPiece piece) {
    const int corner = piece.lowest_corner();
    const double numerator = piece.corner_numerator(corner);
    const Parameter<3> parameter = piece.corner_parameter(corner);
    note_value(parameter);
    negative_ = negative_ || numerator < -piece.error;
    const double smallest = piece.numerator.coefficients.minCoeff();
    if (smallest > piece.error) return widen_bounds(piece);
    if (smallest >= -piece.error && is_zero_only_where_collapsed(piece)) {
      zero_ = true;
      return widen_bounds(piece);
    }
    const double lower = piece.lower();
    undecided_.push({lower, std::move(piece)});
  }

  void note_value(const Parameter<3>& parameter) {
    const double determinant = volume_.jacobian(parameter).determinant();
    if (determinant >= certificate_.smallest) return;
    certificate_.smallest = determinant;
    certificate_.parameter = parameter;
  }

  void widen_bounds(const JacobianPiece& piece) {
    certificate_.lower = std::min(certificate_.lower, piece.lower());
    certificate_.upper = std::max(certificate_.upper, piece.upper());
  }

  // A polynomial with nonnegative coefficients is positive inside a corner, edge or face of its box, or
  // inside the box itself, as soon as one of the coefficients there is.
  bool is_zero_only_where_collapsed(const JacobianPiece& piece) const {
    bool some_zero = false;
    for (int i = 0; i < 27; ++i) {
      const Cell cell = {Place(i % 3), Place(i / 3 % 3), Place(i / 9)};
      if (has_positive_coefficient(piece, cell)) continue;
      some_zero = true;
      if (!is_collapsed_here(piece, cell)) return false;
    }
    return some_zero;
  }

  static bool has_positive_coefficient(const JacobianPiece& piece, const Cell& cell) {
    std::array<int, 3> first;
    std::array<int, 3> last;
    for (std::size_t d = 0; d < 3; ++d) {
      first[d] = cell[d] == at_high ? piece.numerator.degree[d] : 0;
      last[d] = cell[d] == at_low ? 0 : piece.numerator.degree[d];
    }
    const auto [n, m, unused] = piece.numerator.sizes();
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i)
          if (piece.numerator.coefficients[i + n * (j + m * k)] > piece.error) return true;
    return false;
  }

  // Whether a part of a piece's boundary lies on an edge or face of the patch that is collapsed.
  bool is_collapsed_here(const JacobianPiece& piece, Cell cell) const {
    for (int d = 0; d < 3; ++d) {
      Place& place = cell[static_cast<std::size_t>(d)];
      const double end = place == at_low ? volume_.knots(d).first() : volume_.knots(d).last();
      if (place != anywhere && (place == at_low ? piece.low : piece.high)[d] != end) place = anywhere;
    }
    return std::any_of(collapsed_.begin(), collapsed_.end(),
                       [&](const Cell& c) { return contains(c, cell); });
  }

  const NurbsVolume& volume_;
  CertificateOptions options_;
  const Progress& progress_;
  CentredVolume unit_;
  BezierElements elements_;
  std::vector<Bounds> bounds_;  ///< of each element
  std::vector<Known> known_;
  std::vector<Cell> collapsed_;
  std::priority_queue<Undecided> undecided_;
  JacobianCertificate certificate_;
  bool negative_ = false;
  bool zero_ = false;
};

}  // namespace

JacobianCertificate certify_jacobian(const NurbsVolume& volume, const CertificateOptions& options,
                                     const Progress& progress) {
  if (options.max_depth < 0 || options.max_depth > 30)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("max_depth is {}; its range is 0 .. 30", options.max_depth));
  return Certifier(volume, options, progress).run();
}

}  // namespace isopatch::geometry
