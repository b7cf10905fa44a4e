#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

namespace isopatch {

/// Where to integrate: from one parameter to another, on one of several curves.
struct Stretch {
  int curve = 0;
  double from = 0, to = 0;  ///< in either order
};

/// An integral of N components, with an estimate of the error of each.
template <int N>
struct IntegralEstimate {
  Eigen::Array<double, N, 1> value = Eigen::Array<double, N, 1>::Zero();
  Eigen::Array<double, N, 1> error = Eigen::Array<double, N, 1>::Zero();
  int evaluations = 0;
};

/// Integrates functions of one variable until the errors are as small as asked.
///
/// Three nested rules of 3, 7 and 15 points, exact for polynomials of degree 5, 11 and 23; what a rule
/// differs from the one before it is the estimate of its error, which is that of the worse of the two. A
/// stretch where it is too large gets the next rule, and after the last is halved.
/// @source Patterson, The optimum addition of points to quadrature formulae, Math. Comp. 22 (1968)
template <int N>
class AdaptiveIntegral {
 public:
  using Values = Eigen::Array<double, N, 1>;

  /// @param integrand  of (curve, t), gives N values
  /// @param stretches  in whose interior the integrand is smooth; otherwise it takes longer
  /// @param allowed    of the integral's present value: the largest errors
  /// @param most_evaluations  after which the estimate is returned as it is
  template <class Integrand, class Allowed>
  IntegralEstimate<N> operator()(const Integrand& integrand, const std::vector<Stretch>& stretches,
                                 const Allowed& allowed, int most_evaluations) {
    evaluations_ = 0;
    pieces_.clear();
    for (const Stretch& stretch : stretches) pieces_.push_back(started(integrand, stretch));
    for (;;) {
      const IntegralEstimate<N> total = sum();
      const Values enough = allowed(total.value);
      if ((total.error <= enough).all() || evaluations_ >= most_evaluations) return total;
      if (!refine(integrand, enough / static_cast<double>(pieces_.size()))) return total;
    }
  }

 private:
  static constexpr std::size_t pairs = 8;
  /// Positive nodes, those of each rule before those that the next one adds.
  static constexpr std::array<double, pairs> nodes = {0,
                                                      0.7745966692414833770358531,
                                                      0.9604912687080202834235071,
                                                      0.4342437493468025580020715,
                                                      0.9938319632127550222085128,
                                                      0.8884592328722569988904202,
                                                      0.6211029467372264029406874,
                                                      0.2233866864289668816282040};
  struct Rule {
    std::size_t pairs;
    std::array<double, AdaptiveIntegral::pairs> weights;
  };
  static constexpr std::array<Rule, 3> rules = {
      Rule{2, {0.8888888888888888888888889, 0.5555555555555555555555556}},
      Rule{4,
           {0.4509165386584741423451101, 0.2684880898683334407285693, 0.1046562260264672651938239,
            0.4013974147759622229050518}},
      Rule{8,
           {0.2255104997982066873864225, 0.1344152552437842203599688, 0.05160328299707973969692012,
            0.2006285293769890210339319, 0.01700171962994026033902742, 0.09292719531512453768589422,
            0.1715119091363913807873532, 0.2191568584015874964036932}}};

  struct Piece {
    Stretch stretch;
    std::array<Values, pairs> sums;  ///< of the integrand at a node and its mirror image
    std::size_t rule = 0;
    Values value, error;
  };

  template <class Integrand>
  Piece started(const Integrand& integrand, const Stretch& stretch) {
    Piece piece;
    piece.stretch = stretch;
    evaluate(integrand, piece, 0);
    apply(piece, 0);
    improve(integrand, piece);
    return piece;
  }

  template <class Integrand>
  void improve(const Integrand& integrand, Piece& piece) {
    const Values before = piece.value;
    evaluate(integrand, piece, rules[piece.rule].pairs);
    apply(piece, piece.rule + 1);
    piece.error = (piece.value - before).abs();
  }

  template <class Integrand>
  void evaluate(const Integrand& integrand, Piece& piece, std::size_t known) {
    const std::size_t end = known == 0 ? rules[0].pairs : rules[piece.rule + 1].pairs;
    const auto& [curve, from, to] = piece.stretch;
    const double middle = (from + to) / 2, half = (to - from) / 2;
    for (std::size_t i = known; i < end; ++i) {
      piece.sums[i] = integrand(curve, middle + half * nodes[i]);
      if (i > 0) piece.sums[i] += integrand(curve, middle - half * nodes[i]);
      evaluations_ += i > 0 ? 2 : 1;
    }
  }

  static void apply(Piece& piece, std::size_t rule) {
    piece.rule = rule;
    piece.value = Values::Zero();
    for (std::size_t i = 0; i < rules[rule].pairs; ++i) piece.value += rules[rule].weights[i] * piece.sums[i];
    piece.value *= (piece.stretch.to - piece.stretch.from) / 2;
  }

  IntegralEstimate<N> sum() const {
    IntegralEstimate<N> total;
    for (const Piece& piece : pieces_) {
      total.value += piece.value;
      total.error += piece.error;
    }
    total.evaluations = evaluations_;
    return total;
  }

  // Whether there was anything to refine. No piece has its share of an error that is not a number.
  template <class Integrand>
  bool refine(const Integrand& integrand, const Values& share) {
    bool refined = false;
    const std::size_t count = pieces_.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!(pieces_[i].error > share).any()) continue;
      if (pieces_[i].rule + 1 < rules.size()) {
        improve(integrand, pieces_[i]);
        refined = true;
      } else if (const Stretch whole = pieces_[i].stretch; can_be_halved(whole)) {
        const double middle = (whole.from + whole.to) / 2;
        pieces_[i] = started(integrand, {whole.curve, whole.from, middle});
        pieces_.push_back(started(integrand, {whole.curve, middle, whole.to}));
        refined = true;
      }
    }
    return refined;
  }

  static bool can_be_halved(const Stretch& s) {
    return std::abs(s.to - s.from) > 1e-12 * (std::abs(s.from) + std::abs(s.to));
  }

  std::vector<Piece> pieces_;
  int evaluations_ = 0;
};

}  // namespace isopatch
