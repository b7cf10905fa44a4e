#include "segmentation/reconstruction/reconstruction_options.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::segmentation {
namespace {

TEST(ReconstructionOptions, NameWhatIsOutOfRange) {
  validate(ReconstructionOptions{});
  const auto refused = [](auto set, const char* words) {
    ReconstructionOptions options;
    set(options);
    EXPECT_ERROR(validate(options), ErrorCode::invalid_argument, words);
  };
  refused([](auto& o) { o.tolerance = 0.02; }, "tolerance is 0.02; its range is (0, 0.01]");
  refused([](auto& o) { o.smooth = Angle::degrees(90); }, "smooth is 90; its range is (0, 90) degrees");
  refused([](auto& o) { o.most_failures = 0; }, "most_failures is 0; its range is at least 1");
  refused([](auto& o) { o.time_limit = 0; }, "time_limit is 0; its range is (0, 1e7] seconds");
  refused([](auto& o) { o.cutoff = Angle::degrees(180); }, "cutoff is 180; its range is (0, 180) degrees");
  refused([](auto& o) { o.inner_cutoff = Angle::degrees(0); }, "inner_cutoff is 0; its range is");
  refused([](auto& o) { o.large = -1; }, "large is -1; its range is [0, 1e6]");
  refused([](auto& o) { o.small = std::numeric_limits<double>::quiet_NaN(); }, "small is nan; its range is");
}

}  // namespace
}  // namespace isopatch::segmentation
