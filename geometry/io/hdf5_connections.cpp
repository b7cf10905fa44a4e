#include "geometry/io/hdf5_connections.hpp"

#include <fmt/format.h>

#include <array>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

using Integers = std::vector<std::int64_t>;

void append(Integers& numbers, const PatchFace& face) {
  numbers.push_back(face.patch.value);
  numbers.push_back(static_cast<std::int64_t>(face.side));
}

Integers numbers_of(const std::vector<PatchFace>& faces) {
  Integers numbers;
  for (const PatchFace& face : faces) append(numbers, face);
  return numbers;
}

// What no face can have becomes -1, which `connected` refuses.
int small(std::int64_t number) {
  return number < 0 || number > 1'000'000'000 ? -1 : static_cast<int>(number);
}

PatchFace face_at(const Integers& numbers, std::size_t first) {
  return {PatchId(small(numbers[first])), static_cast<Side>(small(numbers[first + 1]))};
}

Integers records(const Hdf5Reader& file, const std::string& path, std::size_t width) {
  Integers numbers = file.integers(path);
  if (numbers.size() % width != 0)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}' has {} numbers, which are no records of {}", path, numbers.size(), width));
  return numbers;
}

std::vector<PatchFace> faces_of(const Hdf5Reader& file, const std::string& path) {
  const Integers numbers = records(file, path, 2);
  std::vector<PatchFace> faces;
  for (std::size_t i = 0; i < numbers.size(); i += 2) faces.push_back(face_at(numbers, i));
  return faces;
}

std::string boundary_group(const std::string& group, std::size_t boundary) {
  return fmt::format("{}/boundaries/{:05}", group, boundary);
}

// Of an interface: two faces of two numbers, and three flags.
constexpr std::size_t interface_width = 7;

}  // namespace

void write_connections(Hdf5Writer& file, const std::string& group, const PatchConnections& connections) {
  Integers reversed(connections.reversed.begin(), connections.reversed.end());
  Integers interfaces;
  std::vector<double> gaps;
  for (const Interface& interface : connections.interfaces) {
    append(interfaces, interface.first);
    append(interfaces, interface.second);
    const FaceOrientation& o = interface.orientation;
    for (const bool flag : {o.swapped, o.flip_first, o.flip_second}) interfaces.push_back(flag);
    gaps.push_back(interface.gap);
  }
  const Tolerance& tolerance = connections.tolerance;
  file.write(group + "/reversed", reversed);
  file.write(group + "/interfaces", interfaces);
  file.write(group + "/interface_gaps", gaps);
  file.write(group + "/tolerance",
             std::vector<double>{tolerance.same_point, tolerance.near_miss, tolerance.same_knot});
  file.write(group + "/size", connections.size);
  file.write(group + "/boundary_count", static_cast<std::int64_t>(connections.boundaries.size()));
  for (std::size_t b = 0; b < connections.boundaries.size(); ++b) {
    file.write(boundary_group(group, b) + "/name", connections.boundaries[b].name);
    file.write(boundary_group(group, b) + "/faces", numbers_of(connections.boundaries[b].faces));
  }
}

PatchConnections read_connections(const Hdf5Reader& file, const std::string& group) {
  PatchConnections result;
  for (const std::int64_t flag : file.integers(group + "/reversed")) result.reversed.push_back(flag != 0);
  const Integers interfaces = records(file, group + "/interfaces", interface_width);
  const std::size_t count = interfaces.size() / interface_width;
  const Eigen::VectorXd gaps = file.vector(group + "/interface_gaps", static_cast<std::int64_t>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * interface_width;
    const FaceOrientation orientation{interfaces[at + 4] != 0, interfaces[at + 5] != 0,
                                      interfaces[at + 6] != 0};
    result.interfaces.push_back({face_at(interfaces, at), face_at(interfaces, at + 2), orientation,
                                 gaps[static_cast<Eigen::Index>(i)]});
  }
  const Eigen::VectorXd tolerance = file.vector(group + "/tolerance", 3);
  result.tolerance = {tolerance[0], tolerance[1], tolerance[2]};
  result.size = file.number(group + "/size");
  const std::int64_t boundaries = file.integer(group + "/boundary_count");
  for (std::int64_t b = 0; b < boundaries; ++b) {
    const std::string path = boundary_group(group, static_cast<std::size_t>(b));
    result.boundaries.push_back({file.text(path + "/name"), faces_of(file, path + "/faces")});
  }
  return result;
}

}  // namespace isopatch::geometry
