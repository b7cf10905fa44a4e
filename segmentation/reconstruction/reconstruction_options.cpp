#include "segmentation/reconstruction/reconstruction_options.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

void require(bool fine, const std::string& field, double value, const std::string& range) {
  if (!fine)
    throw Error(ErrorCode::invalid_argument, fmt::format("{} is {:g}; its range is {}", field, value, range));
}

}  // namespace

void validate(const ReconstructionOptions& o) {
  const double right = Angle::degrees(90).radians();
  require(o.tolerance > 0 && o.tolerance <= 0.01, "tolerance", o.tolerance, "(0, 0.01]");
  require(o.smooth.radians() > 0 && o.smooth.radians() < right, "smooth", o.smooth.degrees(),
          "(0, 90) degrees");
  require(o.most_failures >= 1, "most_failures", o.most_failures, "at least 1");
  require(o.time_limit > 0 && o.time_limit <= 1e7, "time_limit", o.time_limit, "(0, 1e7] seconds");
  require(o.cutoff.radians() > 0 && o.cutoff.radians() < 2 * right, "cutoff", o.cutoff.degrees(),
          "(0, 180) degrees");
  require(o.inner_cutoff.radians() > 0 && o.inner_cutoff.radians() < 2 * right, "inner_cutoff",
          o.inner_cutoff.degrees(), "(0, 180) degrees");
  require(o.large >= 0 && o.large <= 1e6, "large", o.large, "[0, 1e6]");
  require(o.small >= 0 && o.small <= 1e6, "small", o.small, "[0, 1e6]");
}

}  // namespace isopatch::segmentation
