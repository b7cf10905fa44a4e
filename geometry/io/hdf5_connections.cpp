#include "geometry/io/hdf5_connections.hpp"

#include "geometry/io/internal/hdf5_faces.hpp"

namespace isopatch::geometry {

void write_connections(Hdf5Writer& file, const std::string& group, const PatchConnections& connections) {
  std::vector<StatedInterface> interfaces;
  std::vector<double> gaps;
  for (const Interface& interface : connections.interfaces) {
    interfaces.push_back({interface.first, interface.second, interface.orientation});
    gaps.push_back(interface.gap);
  }
  const Tolerance& tolerance = connections.tolerance;
  file.write(group + "/reversed",
             std::vector<std::int64_t>(connections.reversed.begin(), connections.reversed.end()));
  write_interfaces(file, group + "/interfaces", interfaces);
  file.write(group + "/interface_gaps", gaps);
  file.write(group + "/tolerance",
             std::vector<double>{tolerance.same_point, tolerance.near_miss, tolerance.same_knot});
  if (tolerance.keep_non_matching) file.write(group + "/keep_non_matching", std::vector<std::int64_t>{1});
  file.write(group + "/size", connections.size);
  write_boundaries(file, group, connections.boundaries);
}

PatchConnections read_connections(const Hdf5Reader& file, const std::string& group) {
  PatchConnections result;
  for (const std::int64_t flag : file.integers(group + "/reversed")) result.reversed.push_back(flag != 0);
  const std::vector<StatedInterface> interfaces = read_interfaces(file, group + "/interfaces");
  const Eigen::VectorXd gaps =
      file.vector(group + "/interface_gaps", static_cast<std::int64_t>(interfaces.size()));
  for (std::size_t i = 0; i < interfaces.size(); ++i)
    result.interfaces.push_back({interfaces[i].first, interfaces[i].second, interfaces[i].orientation,
                                 gaps[static_cast<Eigen::Index>(i)]});
  const Eigen::VectorXd tolerance = file.vector(group + "/tolerance", 3);
  result.tolerance = {tolerance[0], tolerance[1], tolerance[2], file.contains(group + "/keep_non_matching")};
  result.size = file.number(group + "/size");
  result.boundaries = read_boundaries(file, group);
  return result;
}

}  // namespace isopatch::geometry
