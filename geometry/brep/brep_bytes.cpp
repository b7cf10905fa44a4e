#include "geometry/brep/brep_bytes.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "geometry/base/content_hash.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"

namespace isopatch::geometry {
namespace {

// The CAD library may die of damaged bytes, so they come with their checksum.
std::string heading(const std::string& content) {
  return fmt::format("isopatch solids 1 {:016x}\n", content_hash(content));
}

}  // namespace

std::string to_bytes(const std::vector<BrepFile>& bodies) {
  std::vector<KernelSolid> solids;
  for (const BrepFile& body : bodies) {
    // The module looks at the kernel during the call only.
    const std::shared_ptr<const BrepKernel> kernel(std::shared_ptr<const void>(), &body.brep.kernel());
    solids.push_back({kernel, body.name, body.largest_correction});
  }
  const std::string content = brep_module().to_bytes(solids);
  return heading(content) + content;
}

std::vector<BrepFile> bodies_from_bytes(const std::string& bytes) {
  const std::size_t end = bytes.find('\n');
  const std::string content = end == std::string::npos ? "" : bytes.substr(end + 1);
  if (end == std::string::npos || bytes.substr(0, end + 1) != heading(content))
    throw Error(
        ErrorCode::bad_format,
        "these bytes hold no solids of this version of isopatch, or have changed since they were written; "
        "make the solids again");
  std::vector<BrepFile> bodies;
  for (KernelSolid& solid : brep_module().from_bytes(content))
    bodies.push_back({Brep(std::move(solid.kernel)), std::move(solid.name), solid.largest_correction});
  return bodies;
}

}  // namespace isopatch::geometry
