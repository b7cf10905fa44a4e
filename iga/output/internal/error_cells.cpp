#include "iga/output/internal/error_cells.hpp"

#include <algorithm>
#include <array>
#include <memory>

namespace isopatch::iga {
namespace {

// The element along one direction that each cell lies in.
std::vector<int> elements_along(const geometry::KnotVector& knots, const std::vector<double>& ends) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<int> result;
  for (std::size_t c = 0; c + 1 < ends.size(); ++c) {
    const double middle = 0.5 * (ends[c] + ends[c + 1]);
    const auto after = std::upper_bound(breaks.begin(), breaks.end(), middle);
    result.push_back(std::clamp(static_cast<int>(after - breaks.begin()) - 1, 0, knots.element_count() - 1));
  }
  return result;
}

// The elements of a grid's cells.
class CellElements {
 public:
  CellElements(const geometry::NurbsVolume& patch, const geometry::GridParameters<3>& grid)
      : counts_{patch.knots(0).element_count(), patch.knots(1).element_count()} {
    for (std::size_t d = 0; d < 3; ++d) along_[d] = elements_along(patch.knots()[d], grid[d]);
  }
  Eigen::Index of(std::int64_t cell) const {
    std::array<Eigen::Index, 3> element{};
    for (std::size_t d = 0; d < 3; ++d) {
      const auto count = static_cast<std::int64_t>(along_[d].size());
      element[d] = along_[d][static_cast<std::size_t>(cell % count)];
      cell /= count;
    }
    return element[0] + counts_[0] * (element[1] + counts_[1] * element[2]);
  }

 private:
  std::array<Eigen::Index, 2> counts_;
  std::array<std::vector<int>, 3> along_;
};

}  // namespace

std::vector<geometry::VtuCellField> error_cells(const ElasticField& field, const std::vector<int>& patches,
                                                const std::vector<geometry::GridParameters<3>>& grids) {
  if (field.errors.empty()) return {};
  const auto cells = std::make_shared<std::vector<CellElements>>();
  for (std::size_t g = 0; g < grids.size(); ++g)
    cells->emplace_back(field.patches[static_cast<std::size_t>(patches[g])], grids[g]);
  const auto errors = [&field, patches, cells](Eigen::VectorXd ElementErrors::*what) {
    return [&field, patches, cells, what](std::size_t grid, std::int64_t cell) {
      const ElementErrors& of_patch = field.errors[static_cast<std::size_t>(patches[grid])];
      return static_cast<float>((of_patch.*what)[(*cells)[grid].of(cell)]);
    };
  };
  return {{"error_energy", errors(&ElementErrors::energy)}, {"stress_error", errors(&ElementErrors::stress)}};
}

geometry::GridParameters<3> element_grid(const geometry::NurbsVolume& patch) {
  return {patch.knots(0).breaks(), patch.knots(1).breaks(), patch.knots(2).breaks()};
}

}  // namespace isopatch::iga
