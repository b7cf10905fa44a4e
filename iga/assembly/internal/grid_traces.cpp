#include "iga/assembly/internal/grid_traces.hpp"

#include <Eigen/Geometry>

#include "geometry/splines/grid.hpp"
#include "iga/assembly/internal/grid_integrals.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;

// The area that belongs to each point of the grid, the first direction fastest, m^2.
Eigen::VectorXd areas(const SideFunctions& own, const geometry::SharedGrid& grid) {
  const auto& [u, v] = grid.lines;
  const geometry::KnotVector& across =
      own.space().knots[static_cast<std::size_t>(geometry::direction(own.side()))];
  const Sheet at = sheet(*own.space().geometry, own.side(),
                         geometry::is_high(own.side()) ? across.last() : across.first(), {u.first, v.first});
  Eigen::VectorXd result(at.across.cols());
  for (Index q = 0; q < result.size(); ++q) {
    const auto i = static_cast<std::size_t>(q) % u.size(), j = static_cast<std::size_t>(q) / u.size();
    result[q] = u.weights[i] * v.weights[j] *
                Eigen::Vector3d(at.along[0].col(q)).cross(Eigen::Vector3d(at.along[1].col(q))).norm();
  }
  return result;
}

// With the functions of one of the two sides.
class WithSide {
 public:
  // @param places  parameters on the side of the points of each of the grid's lines
  // @param swapped  whether the grid's line 0 runs along the side's direction 1
  WithSide(const SideFunctions& side, const std::array<std::vector<double>, 2>& places, bool swapped)
      : side_(side), places_(places), swapped_(swapped) {}

  std::vector<Eigen::Triplet<double>> integrals(const std::array<LineTable, 2>& splines,
                                                const Eigen::VectorXd& areas) const {
    std::array<LineTable, 2> at;
    for (std::size_t d = 0; d < 2; ++d)
      at[d] = geometry::collocation(side_.knots(direction(static_cast<int>(d))), places_[d]);
    const std::array<FunctionPairs, 2> pairs = {FunctionPairs(splines[0], at[0]),
                                                FunctionPairs(splines[1], at[1])};
    const Rows sums = grid_integrals(pairs[0].products(splines[0], at[0]),
                                     pairs[1].products(splines[1], at[1]), field(areas));
    std::vector<Eigen::Triplet<double>> result;
    result.reserve(pairs[0].size() * pairs[1].size());
    for (std::size_t q = 0; q < pairs[1].size(); ++q)
      for (std::size_t p = 0; p < pairs[0].size(); ++p) {
        const auto [i, k] = pairs[0][p];
        const auto [j, l] = pairs[1][q];
        const std::array<int, 2> of = swapped_ ? std::array{l, k} : std::array{k, l};
        result.emplace_back(
            i + static_cast<int>(splines[0].cols()) * j, side_.node(of[0], of[1], 0),
            side_.weight(of[0], of[1], 0) * sums(static_cast<Index>(q), static_cast<Index>(p)));
      }
    return result;
  }

 private:
  int direction(int of_grid) const { return swapped_ ? 1 - of_grid : of_grid; }

  // The area over W of the side's functions.
  GridFields field(const Eigen::VectorXd& areas) const {
    const auto u = static_cast<Index>(places_[0].size()), v = static_cast<Index>(places_[1].size());
    Eigen::MatrixXd weights;
    if (side_.space().is_rational())
      weights = weight_sums(side_, swapped_ ? std::array{places_[1], places_[0]} : places_, false);
    GridFields result(u, v, 1);
    for (Index j = 0; j < v; ++j)
      for (Index i = 0; i < u; ++i)
        result.at(0, i, j) =
            areas[i + u * j] / (weights.size() == 0 ? 1 : weights(0, swapped_ ? j + v * i : i + u * j));
    return result;
  }

  const SideFunctions& side_;
  std::array<std::vector<double>, 2> places_;
  bool swapped_;
};

}  // namespace

TraceIntegrals grid_traces(const SideFunctions& own, const SideFunctions& other,
                           const geometry::SharedGrid& grid) {
  const auto& [u, v] = grid.lines;
  const std::array<LineTable, 2> splines = {geometry::collocation(own.knots(0), u.first),
                                            geometry::collocation(own.knots(1), v.first)};
  const Eigen::VectorXd of_points = areas(own, grid);
  return {WithSide(own, {u.first, v.first}, false).integrals(splines, of_points),
          WithSide(other, {u.second, v.second}, grid.swapped).integrals(splines, of_points)};
}

}  // namespace isopatch::iga
