#include "iga/output/fitted_grids.hpp"

#include <algorithm>

#include "geometry/base/larger.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/output/internal/layer_errors.hpp"

namespace isopatch::iga {
namespace {

using geometry::GridParameters;

constexpr int most_rounds = 5;
constexpr double aim = 0.8;      // of the tolerance: errors are estimated at some points of a cell
constexpr double no_help = 0.9;  // of the error before a halving

std::int64_t count_cells(const std::vector<GridParameters<3>>& grids) {
  std::int64_t result = 0;
  for (const auto& grid : grids) {
    std::int64_t cells = 1;
    for (const auto& line : grid) cells *= static_cast<std::int64_t>(line.size()) - 1;
    result += cells;
  }
  return result;
}

// The grids with those layers halved whose error passes a limit.
std::vector<GridParameters<3>> halved_layers(const std::vector<GridParameters<3>>& grids,
                                             const std::vector<ElementNumbers>& errors, double limit) {
  std::vector<GridParameters<3>> result(grids.size());
  for (std::size_t p = 0; p < grids.size(); ++p)
    for (std::size_t d = 0; d < 3; ++d) {
      const std::vector<double>& line = grids[p][d];
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        result[p][d].push_back(line[i]);
        if (errors[p][d][i] > limit) result[p][d].push_back(0.5 * (line[i] + line[i + 1]));
      }
      result[p][d].push_back(line.back());
    }
  return result;
}

// Grids of all patches on their way, and what is known of each.
class Fit {
 public:
  Fit(const ElasticField& field, std::vector<GridParameters<3>>& grids)
      : field_(field),
        grids_(grids),
        errors_(grids.size()),
        changed_(grids.size(), 1),
        hopeless_(grids.size(), 0) {}

  void estimate() {
    parallel_for(static_cast<std::int64_t>(grids_.size()), [&](std::int64_t i, int) {
      const auto p = static_cast<std::size_t>(i);
      if (!changed_[p]) return;
      const double before = errors_[p].largest_error;
      errors_[p] = layer_errors(field_, static_cast<int>(i), grids_[p]);
      if (before > 0 && errors_[p].largest_error > no_help * before) hopeless_[p] = 1;
    });
  }

  double largest_stress() const {
    double result = 0;
    for (const LayerErrors& patch : errors_) result = larger(result, patch.largest_stress);
    return result;
  }

  FitReport report() const {
    FitReport result;
    result.cells = count_cells(grids_);
    const double stress = largest_stress();
    for (std::size_t p = 0; p < errors_.size(); ++p)
      if (const double off = errors_[p].largest_error / stress; stress > 0 && off > result.off) {
        result.off = off;
        result.patch = static_cast<int>(p);
        result.place = errors_[p].place;
      }
    return result;
  }

  // Whether anything was halved.
  bool halve(const geometry::MultiPatch& model, const FitOptions& options) {
    std::vector<ElementNumbers> layers;
    double largest_error = 0;
    for (std::size_t p = 0; p < errors_.size(); ++p) {
      layers.push_back(errors_[p].layers);
      largest_error = larger(largest_error, errors_[p].largest_error);
      if (hopeless_[p])
        for (std::vector<double>& along : layers.back()) std::fill(along.begin(), along.end(), 0.0);
    }
    share_along_interfaces(model, layers);
    double limit = aim * options.tolerance * largest_stress();
    auto next = halved_layers(grids_, layers, limit);
    while (count_cells(next) > options.most_cells && limit < largest_error)
      next = halved_layers(grids_, layers, limit *= 1.25);
    for (std::size_t p = 0; p < grids_.size(); ++p) changed_[p] = next[p] != grids_[p] ? 1 : 0;
    grids_ = std::move(next);
    return std::find(changed_.begin(), changed_.end(), 1) != changed_.end();
  }

 private:
  const ElasticField& field_;
  std::vector<GridParameters<3>>& grids_;
  std::vector<LayerErrors> errors_;
  std::vector<char> changed_, hopeless_;
};

}  // namespace

FitReport fit_grids(const ElasticField& field, const geometry::MultiPatch& model, const FitOptions& options,
                    std::vector<GridParameters<3>>& grids) {
  Fit fit(field, grids);
  fit.estimate();
  for (int round = 0; round < most_rounds && fit.report().off > aim * options.tolerance; ++round) {
    if (!fit.halve(model, options)) break;
    fit.estimate();
  }
  return fit.report();
}

}  // namespace isopatch::iga
