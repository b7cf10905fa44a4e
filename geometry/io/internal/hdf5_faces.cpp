#include "geometry/io/internal/hdf5_faces.hpp"

#include <fmt/format.h>

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

constexpr std::size_t interface_width = 7;

}  // namespace

void write_interfaces(Hdf5Writer& file, const std::string& path,
                      const std::vector<StatedInterface>& interfaces) {
  Integers numbers;
  for (const StatedInterface& interface : interfaces) {
    append(numbers, interface.first);
    append(numbers, interface.second);
    const FaceOrientation& o = interface.orientation;
    for (const bool flag : {o.swapped, o.flip_first, o.flip_second}) numbers.push_back(flag);
  }
  file.write(path, numbers);
}

std::vector<StatedInterface> read_interfaces(const Hdf5Reader& file, const std::string& path) {
  const Integers numbers = records(file, path, interface_width);
  std::vector<StatedInterface> interfaces;
  for (std::size_t at = 0; at < numbers.size(); at += interface_width)
    interfaces.push_back({face_at(numbers, at),
                          face_at(numbers, at + 2),
                          {numbers[at + 4] != 0, numbers[at + 5] != 0, numbers[at + 6] != 0}});
  return interfaces;
}

void write_boundaries(Hdf5Writer& file, const std::string& group, const std::vector<Boundary>& boundaries) {
  file.write(group + "/boundary_count", static_cast<std::int64_t>(boundaries.size()));
  for (std::size_t b = 0; b < boundaries.size(); ++b) {
    file.write(boundary_group(group, b) + "/name", boundaries[b].name);
    file.write(boundary_group(group, b) + "/faces", numbers_of(boundaries[b].faces));
  }
}

std::vector<Boundary> read_boundaries(const Hdf5Reader& file, const std::string& group) {
  std::vector<Boundary> result;
  const std::int64_t count = file.integer(group + "/boundary_count");
  for (std::int64_t b = 0; b < count; ++b) {
    const std::string path = boundary_group(group, static_cast<std::size_t>(b));
    result.push_back({file.text(path + "/name"), faces_of(file, path + "/faces")});
  }
  return result;
}

}  // namespace isopatch::geometry
