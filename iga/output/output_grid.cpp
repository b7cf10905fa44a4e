#include "iga/output/output_grid.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/base/error.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/spaces/internal/element_numbers.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;

constexpr int most_pieces = 32;
constexpr double turn_of_a_piece = 9 * M_PI / 180;
constexpr double slack = 0.25;   // of a piece: the turn of a quarter arc is measured as 91.2 degrees
constexpr int chords = 4;        // of an element, by which its turn is measured
constexpr int lines_across = 5;  // of a direction, on which lines are looked at

std::vector<double> spread(double low, double high) {
  std::vector<double> result;
  for (int i = 0; i < lines_across; ++i) result.push_back(low + (high - low) * i / (lines_across - 1));
  return result;
}

// How far a line turns from its first to its last chord; chords without length turn nothing.
double turn(const Eigen::Matrix3Xd& points, Eigen::Index first, Eigen::Index stride, double least_length) {
  double result = 0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  for (int i = 0; i < chords; ++i) {
    const Eigen::Vector3d chord = points.col(first + (i + 1) * stride) - points.col(first + i * stride);
    if (chord.norm() <= least_length) continue;
    if (before.squaredNorm() > 0) result += std::atan2(before.cross(chord).norm(), before.dot(chord));
    before = chord;
  }
  return result * chords / (chords - 1);
}

// The largest turn in each element along one direction.
std::vector<double> turns(const NurbsVolume& patch, int direction, double size) {
  const auto d = static_cast<std::size_t>(direction);
  geometry::GridParameters<3> grid;
  for (std::size_t e = 0; e < 3; ++e)
    if (e != d) grid[e] = spread(patch.knots()[e].first(), patch.knots()[e].last());
  const std::vector<double> breaks = patch.knots()[d].breaks();
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    for (int i = 0; i < chords; ++i) grid[d].push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * i / chords);
  grid[d].push_back(breaks.back());
  const Eigen::Matrix3Xd points = geometry::points_on_grid(patch, grid);
  Eigen::Index stride = 1;
  for (std::size_t e = 0; e < d; ++e) stride *= static_cast<Eigen::Index>(grid[e].size());
  const auto along = static_cast<Eigen::Index>(grid[d].size());
  std::vector<double> result(breaks.size() - 1, 0.0);
  for (Eigen::Index line = 0; line < points.cols() / along; ++line) {
    const Eigen::Index start = line % stride + line / stride * stride * along;
    for (std::size_t e = 0; e < result.size(); ++e)
      result[e] = std::max(result[e], turn(points, start + static_cast<Eigen::Index>(e) * chords * stride,
                                           stride, 1e-9 * size));
  }
  return result;
}

}  // namespace

std::vector<ElementPieces> straight_pieces(const geometry::MultiPatch& model,
                                           const std::vector<NurbsVolume>& patches, int least) {
  if (least < 1 || least > most_pieces)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("straight_pieces: least is {}, and must be 1 to {}", least, most_pieces));
  std::vector<ElementNumbers> wanted(patches.size());
  parallel_for(static_cast<std::int64_t>(patches.size()), [&](std::int64_t p, int) {
    for (int d = 0; d < 3; ++d) {
      auto& numbers = wanted[static_cast<std::size_t>(p)][static_cast<std::size_t>(d)];
      numbers = turns(patches[static_cast<std::size_t>(p)], d, model.size());
      for (double& number : numbers)
        number = std::clamp(std::ceil(number / turn_of_a_piece - slack), double(least), double(most_pieces));
    }
  });
  share_along_interfaces(model, wanted);
  std::vector<ElementPieces> result(patches.size());
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (std::size_t d = 0; d < 3; ++d) result[p][d].assign(wanted[p][d].begin(), wanted[p][d].end());
  return result;
}

geometry::GridParameters<3> grid_of(const NurbsVolume& patch, const ElementPieces& pieces) {
  geometry::GridParameters<3> result;
  for (std::size_t d = 0; d < 3; ++d) {
    const std::vector<double> breaks = patch.knots()[d].breaks();
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (int i = 0; i < pieces[d][e]; ++i)
        result[d].push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * i / pieces[d][e]);
    result[d].push_back(breaks.back());
  }
  return result;
}

}  // namespace isopatch::iga
