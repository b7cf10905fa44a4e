#include "iga/problem/internal/cut_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/splines/bernstein.hpp"

namespace isopatch::iga {
namespace {

using geometry::BernsteinPolynomial;

constexpr int most_halvings = 14;
constexpr int most_cells = 100000;
// Of the rim over the side of a cell, beside which lines are drawn across it.
constexpr double steepest = 2;

BernsteinPolynomial constant_times(double factor, BernsteinPolynomial p) {
  p.coefficients *= factor;
  return p;
}

// Numerator of a quadric on the element: the quadric times the square of the weight function, which is scaled
// to at most 1.
BernsteinPolynomial on_element(const Quadric& bound, const geometry::NurbsSurface& element) {
  const std::array<int, 3> degree = {element.degree(0), element.degree(1), 0};
  const double largest = element.weights().maxCoeff();
  const BernsteinPolynomial weight{degree, element.weights().transpose() / largest};
  std::array<BernsteinPolynomial, 3> r;
  for (int d = 0; d < 3; ++d)
    r[static_cast<std::size_t>(d)] = {degree, ((element.control_points().row(d).array() - bound.origin[d]) *
                                               element.weights().transpose().array() / largest)
                                                  .matrix()};
  BernsteinPolynomial linear = constant_times(bound.value, weight);
  for (int d = 0; d < 3; ++d)
    linear = linear + constant_times(bound.slope[d], r[static_cast<std::size_t>(d)]);
  BernsteinPolynomial result = linear * weight;
  if (bound.curvature.isZero(0)) return result;
  for (int i = 0; i < 3; ++i) {
    BernsteinPolynomial row{degree, Eigen::RowVectorXd::Zero(weight.coefficients.size())};
    for (int j = 0; j < 3; ++j)
      row = row + constant_times(bound.curvature(i, j), r[static_cast<std::size_t>(j)]);
    result = result + r[static_cast<std::size_t>(i)] * row;
  }
  return result;
}

double smallest_size(const BernsteinPolynomial& p) {
  const double low = p.coefficients.minCoeff(), high = p.coefficients.maxCoeff();
  return low > 0 ? low : high < 0 ? -high : 0;
}

// The polynomial on one side of the cell: along direction `along`, at the low or high end of the other one.
BernsteinPolynomial on_side(const BernsteinPolynomial& p, int along, bool high) {
  const auto [n0, n1, n2] = p.sizes();
  BernsteinPolynomial result{{p.degree[static_cast<std::size_t>(along)], 0, 0}, {}};
  result.coefficients.resize(along == 0 ? n0 : n1);
  for (int i = 0; i < result.coefficients.size(); ++i)
    result.coefficients[i] = along == 0 ? p.coefficients[i + n0 * (high ? n1 - 1 : 0)]
                                        : p.coefficients[(high ? n0 - 1 : 0) + n0 * i];
  return result;
}

double at(const BernsteinPolynomial& p, double t) {
  return geometry::value(p, {t, 0, 0});
}

// The zero of a function that changes its sign between two places.
template <class Function>
double zero_between(Function f, double a, double b) {
  double fa = f(a), fb = f(b);
  // Regula falsi with the Illinois step, which never leaves the bracket.
  for (int k = 0; k < 100 && b - a > 1e-15; ++k) {
    double t = std::clamp((a * fb - b * fa) / (fb - fa), a, b);
    if (k > 40) t = 0.5 * (a + b);
    const double ft = f(t);
    if (ft == 0) return t;
    if ((ft > 0) == (fb > 0)) {
      b = t;
      fb = ft;
      fa *= 0.5;
    } else {
      a = t;
      fa = ft;
      fb *= 0.5;
    }
  }
  return 0.5 * (a + b);
}

int sign_changes(const BernsteinPolynomial& p) {
  int count = 0;
  double last = 0;
  for (const double c : p.coefficients) {
    if (c == 0) continue;
    count += last != 0 && (c > 0) != (last > 0);
    last = c;
  }
  return count;
}

// The places in (0, 1) where a polynomial of one variable changes its sign.
void add_zeros(const BernsteinPolynomial& p, double low, double high, int depth, std::vector<double>& zeros) {
  const int changes = sign_changes(p);
  if (changes == 0) return;
  const double first = p.coefficients[0], last = p.coefficients[p.coefficients.size() - 1];
  if (changes == 1 && first * last < 0) {
    const double t = zero_between([&](double x) { return at(p, x); }, 0, 1);
    zeros.push_back(low + t * (high - low));
    return;
  }
  const double middle = 0.5 * (low + high);
  if (depth == 0) {
    zeros.push_back(middle);
    return;
  }
  const auto half = geometry::halves(p, 0);
  if (half[0].coefficients[half[0].coefficients.size() - 1] == 0) zeros.push_back(middle);
  add_zeros(half[0], low, middle, depth - 1, zeros);
  add_zeros(half[1], middle, high, depth - 1, zeros);
}

// A part of the element's parameters, as shares of it.
struct Cell {
  Eigen::Vector2d low = {0, 0};
  double size = 1;
};

class Cutting {
 public:
  Cutting(const geometry::NurbsSurface& element, int points)
      : low_(element.low()),
        extent_(element.high() - element.low()),
        rule_(geometry::gauss_legendre(points)) {}

  CutRule result;

  void cut(std::vector<BernsteinPolynomial> bounds, const Cell& cell, int halvings) {
    if (++cells_ > most_cells)
      throw Error(
          ErrorCode::unsupported,
          "the part of a face is too narrow to be integrated: it needs more than 100,000 cells in one "
          "element; widen the region");
    std::vector<BernsteinPolynomial> cutting;
    for (BernsteinPolynomial& bound : bounds) {
      if (bound.coefficients.minCoeff() >= 0) continue;
      if (bound.coefficients.maxCoeff() <= 0) return;
      cutting.push_back(std::move(bound));
    }
    if (cutting.empty()) {
      add_whole(cell);
    } else if (const int along = cutting.size() == 1 ? graph_direction(cutting.front()) : -1; along >= 0) {
      add_beside_graph(cutting.front(), along, cell);
    } else if (halvings == 0) {
      count_by_middle(cutting, cell);
    } else {
      quarter(cutting, cell, halvings);
    }
  }

 private:
  void add(const Cell& cell, const Eigen::Vector2d& in_cell, double weight) {
    const Eigen::Vector2d share = cell.low + cell.size * in_cell;
    result.points.push_back(
        {low_ + extent_.cwiseProduct(share), weight * cell.size * cell.size * extent_.prod()});
  }
  void add_whole(const Cell& cell) {
    for (Eigen::Index j = 0; j < rule_.nodes.size(); ++j)
      for (Eigen::Index i = 0; i < rule_.nodes.size(); ++i)
        add(cell, {rule_.nodes[i], rule_.nodes[j]}, rule_.weights[i] * rule_.weights[j]);
  }
  // The direction in which the quadric is everywhere steeper than across, or -1.
  static int graph_direction(const BernsteinPolynomial& bound) {
    const std::array<BernsteinPolynomial, 2> slope = {geometry::derivative(bound, 0),
                                                      geometry::derivative(bound, 1)};
    for (const int d : {0, 1}) {
      const double least = smallest_size(slope[static_cast<std::size_t>(d)]);
      const double most = slope[static_cast<std::size_t>(1 - d)].coefficients.cwiseAbs().maxCoeff();
      if (least > 0 && steepest * least >= most) return d;
    }
    return -1;
  }
  // Lines in the direction in which the quadric has at most one zero, between the places where that zero
  // comes to the cell's sides.
  void add_beside_graph(const BernsteinPolynomial& bound, int along, const Cell& cell) {
    const int over = 1 - along;
    const BernsteinPolynomial low = on_side(bound, over, false), high = on_side(bound, over, true);
    std::vector<double> ends = {0, 1};
    constexpr int most_halvings_of_side = 40;
    add_zeros(low, 0, 1, most_halvings_of_side, ends);
    add_zeros(high, 0, 1, most_halvings_of_side, ends);
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
      const double length = ends[k + 1] - ends[k];
      if (!(length > 0)) continue;
      for (Eigen::Index j = 0; j < rule_.nodes.size(); ++j) {
        const double t = ends[k] + length * rule_.nodes[j];
        add_line(bound, along, t, {at(low, t), at(high, t)}, length * rule_.weights[j], cell);
      }
    }
  }
  void add_line(const BernsteinPolynomial& bound, int along, double t, const std::array<double, 2>& at_ends,
                double weight, const Cell& cell) {
    double first = 0, last = 1;
    if (at_ends[0] < 0 && at_ends[1] < 0) return;
    const auto place = [&](double s) {
      return along == 0 ? Eigen::Vector3d(s, t, 0) : Eigen::Vector3d(t, s, 0);
    };
    if ((at_ends[0] < 0) != (at_ends[1] < 0))
      (at_ends[0] < 0 ? first : last) =
          zero_between([&](double s) { return geometry::value(bound, place(s)); }, 0, 1);
    for (Eigen::Index i = 0; i < rule_.nodes.size(); ++i)
      add(cell, place(first + (last - first) * rule_.nodes[i]).head<2>(),
          weight * (last - first) * rule_.weights[i]);
  }
  void count_by_middle(const std::vector<BernsteinPolynomial>& bounds, const Cell& cell) {
    const Eigen::Vector3d middle(0.5, 0.5, 0);
    if (std::all_of(bounds.begin(), bounds.end(),
                    [&](const BernsteinPolynomial& bound) { return geometry::value(bound, middle) >= 0; }))
      add(cell, middle.head<2>(), 1);
  }
  void quarter(const std::vector<BernsteinPolynomial>& bounds, const Cell& cell, int halvings) {
    const double size = 0.5 * cell.size;
    std::array<std::vector<BernsteinPolynomial>, 4> of;
    for (const BernsteinPolynomial& bound : bounds) {
      const auto lines = geometry::halves(bound, 1);
      for (std::size_t j = 0; j < 2; ++j) {
        auto cells = geometry::halves(lines[j], 0);
        for (std::size_t i = 0; i < 2; ++i) of[2 * j + i].push_back(std::move(cells[i]));
      }
    }
    for (std::size_t k = 0; k < 4; ++k)
      cut(std::move(of[k]),
          {cell.low + size * Eigen::Vector2d(static_cast<double>(k % 2), static_cast<double>(k / 2)), size},
          halvings - 1);
  }

  Eigen::Vector2d low_, extent_;
  geometry::QuadratureRule rule_;
  int cells_ = 0;
};

}  // namespace

CutRule cut_rule(const geometry::NurbsSurface& element, const Region& region, int points, double slack) {
  std::vector<BernsteinPolynomial> cutting;
  for (const Quadric& bound : region.bounds) {
    BernsteinPolynomial p = on_element(bound, element);
    if (p.coefficients.minCoeff() >= -slack) continue;
    if (p.coefficients.maxCoeff() <= 0) return {CutRule::Kind::outside};
    cutting.push_back(std::move(p));
  }
  if (cutting.empty()) return {CutRule::Kind::inside};
  Cutting cutter(element, points);
  cutter.cut(std::move(cutting), {}, most_halvings);
  cutter.result.kind = cutter.result.points.empty() ? CutRule::Kind::outside : CutRule::Kind::cut;
  return std::move(cutter.result);
}

}  // namespace isopatch::iga
