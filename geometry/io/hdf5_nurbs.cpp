#include "geometry/io/hdf5_nurbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/base/error.hpp"
#include "geometry/io/packed_numbers.hpp"

namespace isopatch::geometry {

void write_volumes(Hdf5Writer& file, const std::string& group, const std::vector<NurbsVolume>& volumes) {
  std::vector<std::int64_t> degrees, knot_counts;
  PackedNumbers knots, weights, points;
  for (const NurbsVolume& volume : volumes) {
    for (const KnotVector& along : volume.knots()) {
      degrees.push_back(along.degree());
      knot_counts.push_back(static_cast<std::int64_t>(along.knots().size()));
      knots.add(along.knots());
    }
    weights.add(volume.weights());
    points.add(volume.control_points());
  }
  file.write(group + "/degrees", degrees);
  file.write(group + "/knot_counts", knot_counts);
  knots.write(file, group + "/knots", 1);
  weights.write(file, group + "/weights", 1);
  points.write(file, group + "/control_points", 3);
}

std::vector<NurbsVolume> read_volumes(const Hdf5Reader& file, const std::string& group) {
  const std::vector<std::int64_t> degrees = file.integers(group + "/degrees");
  const std::vector<std::int64_t> knot_counts = file.integers(group + "/knot_counts");
  if (degrees.size() % 3 != 0 || knot_counts.size() != degrees.size())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} has {} degrees and {} numbers of knots: a volume has three of each", group,
                            degrees.size(), knot_counts.size()));
  UnpackedNumbers all_knots(file, group + "/knots", 1), weights(file, group + "/weights", 1),
      points(file, group + "/control_points", 3);
  std::vector<NurbsVolume> volumes;
  for (std::size_t at = 0; at < degrees.size(); at += 3) {
    std::array<KnotVector, 3> knots;
    Eigen::Index size = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      const Eigen::MatrixXd values = all_knots.take(std::max<std::int64_t>(knot_counts[at + d], 0));
      knots[d] = KnotVector(
          static_cast<int>(std::clamp<std::int64_t>(degrees[at + d], -1, KnotVector::max_degree + 1)),
          {values.data(), values.data() + values.size()});
      size *= knots[d].size();
      points.require(size);  // before the product can overflow
    }
    const Eigen::Matrix3Xd net = points.take(size);
    volumes.emplace_back(knots, net, Eigen::VectorXd(weights.take(size).transpose()));
  }
  for (const UnpackedNumbers* each : {&all_knots, &weights, &points}) each->require_end();
  return volumes;
}

}  // namespace isopatch::geometry
