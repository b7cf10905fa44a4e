#include "iga/output/internal/sample_pieces.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "iga/spaces/internal/element_numbers.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using geometry::NurbsVolume;

// The largest deviation from a straight line, in units of what is allowed.
using Deviations = ElementNumbers;

// Pieces of equal parameters are not equally curved.
constexpr double unevenness = 1.2;
constexpr int trial_pieces = 4;  // an S shape has no deviation at its middle, but at its quarters

std::array<std::vector<double>, 3> trial_grid(const NurbsVolume& patch) {
  std::array<std::vector<double>, 3> result;
  for (int d = 0; d < 3; ++d) {
    const std::vector<double> breaks = patch.knots(d).breaks();
    auto& grid = result[static_cast<std::size_t>(d)];
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (int i = 0; i < trial_pieces; ++i)
        grid.push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * i / trial_pieces);
    grid.push_back(breaks.back());
  }
  return result;
}

// What counts as the full range of the fields: the largest displacement, and a stress that all but a few
// points stay below, because singular corners would make the rest look flat.
struct Ranges {
  double displacement = 0;
  double stress = 0;
};

Ranges ranges(const std::vector<PatchSamples>& trials) {
  Ranges result;
  std::vector<double> stresses;
  for (const PatchSamples& trial : trials) {
    if (trial.displacements.cols() == 0) continue;
    result.displacement = std::max(result.displacement, trial.displacements.colwise().norm().maxCoeff());
    stresses.insert(stresses.end(), trial.von_mises.begin(), trial.von_mises.end());
  }
  if (stresses.empty()) return result;
  const auto high =
      stresses.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(stresses.size() - 1));
  std::nth_element(stresses.begin(), high, stresses.end());
  result.stress = *high;
  return result;
}

Deviations deviations(const PatchSamples& trial, const Ranges& range, double size,
                      const SamplingOptions& options) {
  const std::array<int, 3> n = trial.sizes();
  const std::array<Index, 3> stride = {1, n[0], Index{n[0]} * n[1]};
  const auto deviation = [&](const auto& f, Index low, Index at, Index high, double t, double allowed) {
    return allowed > 0 ? (f(at) - (1 - t) * f(low) - t * f(high)).norm() / allowed : 0.0;
  };
  using One = Eigen::Matrix<double, 1, 1>;
  const auto place = [&](Index i) -> Eigen::Vector3d { return trial.points.col(i); };
  const auto displacement = [&](Index i) -> Eigen::Vector3d { return trial.displacements.col(i); };
  const auto stress = [&](Index i) -> One { return One(std::min(trial.von_mises[i], range.stress)); };
  Deviations result;
  for (std::size_t d = 0; d < 3; ++d) {
    result[d].assign(static_cast<std::size_t>((n[d] - 1) / trial_pieces), 0.0);
    for (Index at = 0; at < trial.points.cols(); ++at) {
      const auto along = static_cast<int>(at / stride[d] % n[d]);
      const int inside = along % trial_pieces;
      if (inside == 0) continue;
      const Index low = at - inside * stride[d];
      const Index high = low + trial_pieces * stride[d];
      const double t = static_cast<double>(inside) / trial_pieces;
      double& worst = result[d][static_cast<std::size_t>(along / trial_pieces)];
      worst = std::max(worst, deviation(place, low, at, high, t, options.chord * size));
      if (range.displacement <= 0) continue;
      worst = std::max(worst, deviation(displacement, low, at, high, t, options.field * range.displacement));
      worst = std::max(worst, deviation(stress, low, at, high, t, options.field * range.stress));
    }
  }
  return result;
}

std::array<std::size_t, 3> elements_of(const NurbsVolume& patch) {
  return {static_cast<std::size_t>(patch.knots(0).element_count()),
          static_cast<std::size_t>(patch.knots(1).element_count()),
          static_cast<std::size_t>(patch.knots(2).element_count())};
}

// `elements` parted into about elements / stride intervals, the same seen from either end.
std::vector<int> chosen_ends(int elements, int stride) {
  int intervals = std::max(1, elements / stride);
  if (elements % 2 == 1 && intervals % 2 == 0) ++intervals;
  std::vector<int> result;
  for (int j = 0; j <= intervals; ++j)
    result.push_back(2 * j <= intervals ? j * elements / intervals
                                        : elements - (intervals - j) * elements / intervals);
  return result;
}

PatchPieces pieces(const Deviations& deviations, int stride, double tolerance_factor, int most) {
  PatchPieces result;
  for (std::size_t d = 0; d < 3; ++d) {
    DirectionPieces& along = result[d];
    along.ends = chosen_ends(static_cast<int>(deviations[d].size()), stride);
    for (std::size_t i = 0; i + 1 < along.ends.size(); ++i) {
      const double deviation = deviations[d][static_cast<std::size_t>(along.ends[i])];
      along.counts.push_back(
          stride > 1
              ? 1
              : std::clamp(static_cast<int>(std::ceil(std::sqrt(unevenness * deviation / tolerance_factor))),
                           1, most));
    }
  }
  return result;
}

std::int64_t points(const std::vector<PatchPieces>& all) {
  std::int64_t total = 0;
  for (const PatchPieces& patch : all) {
    std::int64_t product = 1;
    for (const DirectionPieces& along : patch) {
      std::int64_t count = 1;
      for (const int pieces : along.counts) count += pieces;
      product *= count;
    }
    total += product;
  }
  return total;
}

}  // namespace

std::vector<PatchPieces> choose_pieces(const geometry::MultiPatch& model,
                                       const std::vector<SampledPatch>& patches,
                                       const SamplingOptions& options, bool& is_coarse) {
  std::int64_t trial_points = 0;
  std::size_t most_elements = 1;
  for (const SampledPatch& p : patches) {
    std::int64_t product = 1;
    for (const std::size_t n : elements_of(*p.patch)) {
      product *= static_cast<std::int64_t>(trial_pieces * n + 1);
      most_elements = std::max(most_elements, n);
    }
    trial_points += product;
  }
  std::vector<Deviations> needed;
  const bool can_try = trial_points <= 8 * options.most_points;
  if (can_try) {
    std::vector<PatchSamples> trials;
    for (const SampledPatch& p : patches) trials.push_back(fields_on_grid(p, trial_grid(*p.patch)));
    const Ranges range = ranges(trials);
    for (const PatchSamples& trial : trials)
      needed.push_back(deviations(trial, range, model.size(), options));
  } else {
    for (const SampledPatch& p : patches) {
      const auto n = elements_of(*p.patch);
      needed.push_back({std::vector(n[0], 1.0), std::vector(n[1], 1.0), std::vector(n[2], 1.0)});
    }
  }
  share_along_interfaces(model, needed);
  const auto with = [&](int stride, double factor) {
    std::vector<PatchPieces> result;
    for (const Deviations& patch : needed)
      result.push_back(pieces(patch, stride, factor, options.most_per_element));
    return result;
  };
  std::vector<PatchPieces> result = with(1, 1);
  is_coarse = !can_try;
  for (double factor = 1.5; points(result) > options.most_points && factor < 1e6; factor *= 1.5) {
    is_coarse = true;
    result = with(1, factor);
  }
  for (int stride = 2; points(result) > options.most_points && stride <= static_cast<int>(most_elements);
       ++stride)
    result = with(stride, 1);
  return result;
}

}  // namespace isopatch::iga
