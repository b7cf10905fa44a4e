#include "segmentation/sweeps/internal/layers.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace isopatch::segmentation {
namespace {

/// A slab over a quadrilateral, and where it is divided: numbers of levels, its ends among them.
struct Stretch {
  Slab slab;
  std::set<int> cuts;
  int low() const { return *cuts.begin(); }
  int high() const { return *cuts.rbegin(); }
};
using Column = std::vector<Stretch>;

/// Pairs of quadrilaterals with a common edge.
std::vector<std::pair<std::size_t, std::size_t>> neighbours(const Quadrangulation& drawing) {
  std::vector<std::vector<std::size_t>> at(drawing.edges.size());
  for (std::size_t q = 0; q < drawing.quads.size(); ++q)
    for (const geometry::EdgeUse& side : drawing.quads[q].sides)
      at[static_cast<std::size_t>(side.edge.value)].push_back(q);
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (const auto& quads : at)
    if (quads.size() == 2) result.emplace_back(quads[0], quads[1]);
  return result;
}

/// Divides what stands beside the cuts of another.
/// @return  whether it did anything
bool divide(Column& column, const Column& by) {
  bool changed = false;
  for (Stretch& here : column)
    for (const Stretch& there : by) {
      if (there.low() >= here.high() || there.high() <= here.low()) continue;
      for (const int cut : there.cuts)
        if (cut > here.low() && cut < here.high()) changed |= here.cuts.insert(cut).second;
    }
  return changed;
}

/// Ascending; those that differ by less than a tolerance are one.
std::vector<double> levels(const Quadrangulation& drawing, const std::vector<std::vector<Slab>>& slabs,
                           const MovingDrawing& moving, const std::vector<std::vector<double>>& asked,
                           double tolerance) {
  std::vector<double> all;
  for (const std::vector<double>& heights : asked) all.insert(all.end(), heights.begin(), heights.end());
  for (const auto& at : slabs)
    for (const Slab& slab : at) all.insert(all.end(), {slab.low, slab.high});
  for (int e = 0; e < static_cast<int>(drawing.edges.size()); ++e) {
    const std::vector<double> kinks = moving.kinks(e);
    all.insert(all.end(), kinks.begin(), kinks.end());
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end(), [&](double a, double b) { return b - a < tolerance; }),
            all.end());
  return all;
}

}  // namespace

Layers layers(const Quadrangulation& drawing, const std::vector<std::vector<Slab>>& slabs,
              const MovingDrawing& moving, const std::vector<std::vector<double>>& asked, double tolerance) {
  Layers result;
  result.levels = levels(drawing, slabs, moving, asked, tolerance);
  const auto level = [&](double height) {
    return static_cast<int>(std::lower_bound(result.levels.begin(), result.levels.end(), height - tolerance) -
                            result.levels.begin());
  };
  std::vector<Column> columns;
  for (std::size_t q = 0; q < drawing.quads.size(); ++q) {
    const Quad& quad = drawing.quads[q];
    Column& column = columns.emplace_back();
    for (const Slab& slab : slabs[static_cast<std::size_t>(quad.region)]) {
      Stretch stretch{slab, {level(slab.low), level(slab.high)}};
      const auto cut_at = [&](double height) {
        if (height > slab.low + tolerance && height < slab.high - tolerance)
          stretch.cuts.insert(level(height));
      };
      if (!asked.empty()) std::for_each(asked[q].begin(), asked[q].end(), cut_at);
      for (const geometry::EdgeUse& side : quad.sides)
        for (const double kink : moving.kinks(side.edge.value)) cut_at(kink);
      column.push_back(std::move(stretch));
    }
  }
  const auto pairs = neighbours(drawing);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& [a, b] : pairs) {
      changed |= divide(columns[a], columns[b]);
      changed |= divide(columns[b], columns[a]);
    }
  }
  for (const Column& column : columns) {
    std::vector<Layer>& made = result.columns.emplace_back();
    for (const Stretch& stretch : column)
      for (auto cut = stretch.cuts.begin(); std::next(cut) != stretch.cuts.end(); ++cut) {
        made.push_back({*cut, *std::next(cut), {}, {}});
        if (*cut == stretch.low()) made.back().bottom = stretch.slab.bottom;
        if (*std::next(cut) == stretch.high()) made.back().top = stretch.slab.top;
      }
  }
  return result;
}

}  // namespace isopatch::segmentation
