#include "segmentation/reconstruction/internal/freeform_faces.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "segmentation/reconstruction/internal/ruled_strip.hpp"

namespace isopatch::segmentation {
namespace {

[[noreturn]] void refuse_freeform(const geometry::TriangleMesh& mesh, const Region& region) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int t : region.triangles)
    middle += mesh.vertices.col(mesh.triangles(0, t)) / double(region.triangles.size());
  throw Error(
      ErrorCode::unsupported,
      fmt::format("a face of {} triangles and {:.4g} m^2 around ({:.6g}, {:.6g}, {:.6g}) m is no plane, "
                  "cylinder, cone, sphere or torus, and not straight between two parallel planes; other "
                  "freeform faces cannot be reconstructed yet",
                  region.triangles.size(), region.area, middle.x(), middle.y(), middle.z()));
}

}  // namespace

void add_freeform_faces(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                        Wireframe& wires, Regions& regions, double tolerance) {
  for (std::size_t r = 0; r < regions.regions.size(); ++r) {
    Region& region = regions.regions[r];
    if (region.carrier) continue;
    const auto strip = ruled_strip(mesh, neighbours, wires, regions, static_cast<int>(r), tolerance);
    if (!strip) refuse_freeform(mesh, region);
    region.spline = strip->surface;
    region.reversed = false;
    for (std::size_t i = 0; i < 4; ++i)
      wires.edges[static_cast<std::size_t>(strip->edges[i])].curve = strip->curves[i];
  }
}

}  // namespace isopatch::segmentation
