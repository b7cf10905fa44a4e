#include "iga/output/part_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/base/error.hpp"
#include "iga/output/internal/grid_fields.hpp"
#include "iga/output/internal/sample_pieces.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;

void check(bool good, const char* field, const auto& value, const char* range) {
  if (!good)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("SamplingOptions: {} is {}, and must be {}", field, value, range));
}

// The grid of a patch with so many pieces in each interval between chosen ends of elements.
std::array<std::vector<double>, 3> grid(const NurbsVolume& patch, const PatchPieces& pieces,
                                        std::array<std::vector<int>, 3>& ends) {
  std::array<std::vector<double>, 3> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::vector<double> breaks = patch.knots(static_cast<int>(d)).breaks();
    const DirectionPieces& along = pieces[d];
    for (std::size_t i = 0; i < along.counts.size(); ++i) {
      const double low = breaks[static_cast<std::size_t>(along.ends[i])];
      const double high = breaks[static_cast<std::size_t>(along.ends[i + 1])];
      ends[d].push_back(static_cast<int>(result[d].size()));
      for (int piece = 0; piece < along.counts[i]; ++piece)
        result[d].push_back(low + (high - low) * piece / along.counts[i]);
    }
    ends[d].push_back(static_cast<int>(result[d].size()));
    result[d].push_back(breaks.back());
  }
  return result;
}

PartSamples sample(const geometry::MultiPatch& model, const std::vector<NurbsVolume>& patches,
                   const ElasticField* field, const SamplingOptions& options) {
  validate(options);
  std::vector<SampledPatch> sampled;
  for (std::size_t p = 0; p < patches.size(); ++p)
    sampled.push_back({&patches[p], field, static_cast<int>(p)});
  PartSamples result;
  const std::vector<PatchPieces> pieces = choose_pieces(model, sampled, options, result.is_coarse);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    std::array<std::vector<int>, 3> ends;
    const auto parameters = grid(patches[p], pieces[p], ends);
    result.patches.push_back(fields_on_grid(sampled[p], parameters));
    result.patches.back().element_ends = std::move(ends);
  }
  return result;
}

}  // namespace

void validate(const SamplingOptions& options) {
  check(options.chord > 0, "chord", options.chord, "above 0");
  check(options.field > 0, "field", options.field, "above 0");
  check(options.most_per_element >= 1 && options.most_per_element <= 64, "most_per_element",
        options.most_per_element, "1 to 64");
  check(options.most_points >= 8, "most_points", options.most_points, "at least 8");
}

PartSamples sample_part(const geometry::MultiPatch& model, const std::vector<NurbsVolume>& patches,
                        const SamplingOptions& options) {
  return sample(model, patches, nullptr, options);
}

PartSamples sample_part(const geometry::MultiPatch& model, const ElasticField& field,
                        const SamplingOptions& options) {
  return sample(model, field.patches, &field, options);
}

}  // namespace isopatch::iga
