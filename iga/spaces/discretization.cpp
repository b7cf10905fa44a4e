#include "iga/spaces/discretization.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/spaces/matching_spaces.hpp"
#include "iga/spaces/solution_knots.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;

void check_range(const char* field, double value, double low, double high) {
  if (!(value >= low && value <= high))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} is {}; its range is {} .. {}", field, value, low, high));
}

}  // namespace

void validate(const DiscretizationOptions& options) {
  for (const int p : options.degree) check_range("degree", p, 0, 10);
  check_range("refine", options.refine, 0, 10);
  for (const int n : options.elements_per_direction) check_range("elements_per_direction", n, 0, 10000);
  check_range("max_size", options.max_size, 0, 1e300);
  check_range("continuity", options.continuity, -1, 9);
  for (const PatchRefinement& own : options.patches) {
    for (const int p : own.degree) check_range("degree of some patches", p, 0, 10);
    for (const int n : own.elements_per_direction) check_range("elements of some patches", n, 0, 10000);
    check_range("max_size of some patches", own.max_size, 0, 1e300);
    check_range("refine of some patches", own.refine, 0, 10);
    check_range("refine with that of some patches", options.refine + own.refine, 0, 14);
  }
}

std::int64_t Discretization::element_count() const {
  std::int64_t count = 0;
  for (const NurbsVolume& patch : patches) {
    std::int64_t elements = 1;
    for (int d = 0; d < 3; ++d) elements *= patch.knots(d).element_count();
    count += elements;
  }
  return count;
}

Discretization discretize(const geometry::MultiPatch& model, const DiscretizationOptions& options) {
  const DirectionKnots knots = solution_knots(model, options);
  Discretization result{solution_model(model, knots), {}, {0}, {}};
  for (std::size_t i = 0; i < model.patches().size(); ++i) {
    const double nodes = result.first_node.back() +
                         1.0 * knots[3 * i].size() * knots[3 * i + 1].size() * knots[3 * i + 2].size();
    if (3 * nodes > 2e9)
      throw Error(
          ErrorCode::unsupported,
          fmt::format(
              "{:.3g} control points up to patch {} are more than 32-bit indices can count; refine less",
              nodes, i));
    result.first_node.push_back(static_cast<int>(nodes));
  }
  for (std::size_t i = 0; i < model.patches().size(); ++i)
    result.patches.push_back(
        geometry::refined(model.patches()[i], {knots[3 * i], knots[3 * i + 1], knots[3 * i + 2]}));
  result.gauss_points.resize(result.patches.size());
  parallel_for(static_cast<std::int64_t>(result.patches.size()), [&](std::int64_t i, int) {
    const auto patch = static_cast<std::size_t>(i);
    result.gauss_points[patch] = gauss_points(result.patches[patch]);
  });
  check_traces(result.model, result.patches);
  return result;
}

}  // namespace isopatch::iga
