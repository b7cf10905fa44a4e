#include "geometry/brep/module.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>
#include <mutex>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/exchange.hpp"
#include "geometry/brep/opencascade/internal/solid_shapes.hpp"

namespace isopatch::geometry {
namespace {

/// Its exceptions as ours.
template <class Work>
auto guarded(const std::string& what, Work work) {
  try {
    return work();
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: OpenCASCADE cannot do this ({}: {})", what, failure.DynamicType()->Name(),
                            failure.GetMessageString()));
  }
}

/// The readers and writers share settings that belong to the whole process, so they take turns.
class OpenCascade final : public BrepModule {
 public:
  // It would print to the standard output.
  OpenCascade() { Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer)); }

  KernelFile read(const KernelSource& source, const SewOptions& options) const override {
    const std::lock_guard<std::mutex> lock(files_);
    return guarded(source.path.string(), [&] {
      FileShapes found = shapes_of(source);
      KernelFile result;
      result.lost = std::move(found.lost);
      result.remarks = std::move(found.remarks);
      add_bodies(found.shapes, source.metres, options, result);
      return result;
    });
  }

  std::string to_bytes(const std::vector<KernelSolid>& bodies) const override {
    return guarded("handing solids on", [&] { return bytes_of(bodies); });
  }

  std::vector<KernelSolid> from_bytes(const std::string& bytes) const override {
    return guarded("taking solids up", [&] { return bodies_of_bytes(bytes); });
  }

  void write(const std::filesystem::path& path, BrepFormat format, const BrepKernel& kernel,
             const std::string& unit) const override {
    const std::lock_guard<std::mutex> lock(files_);
    const auto& shape = dynamic_cast<const ShapeKernel&>(kernel);
    guarded(path.string(), [&] {
      switch (format) {
        case BrepFormat::step:
          return write_step(path, shape, unit);
        case BrepFormat::iges:
          return write_iges(path, shape, unit);
        case BrepFormat::brep:
          break;
      }
      return write_native(path, shape, unit);
    });
  }

  std::vector<TrimmedSurface> trimmed_surfaces(const BrepKernel& kernel) const override {
    return guarded("making NURBS surfaces of faces",
                   [&] { return surfaces_of(dynamic_cast<const ShapeKernel&>(kernel)); });
  }

  KernelSolid sew(const std::vector<TrimmedSurface>& faces, const SewOptions& options) const override {
    return guarded("sewing trimmed surfaces", [&] { return sewn_solid(faces, options); });
  }

  KernelSolid polyhedron(const Polyhedron& polyhedron, const SewOptions& options) const override {
    return guarded("making a polyhedron", [&] { return polyhedral_solid(polyhedron, options); });
  }

  std::vector<KernelSolid> cells(const BrepKernel& source, const CellComplex& complex,
                                 const std::vector<CellId>& cells) const override {
    return guarded("making solids of cells",
                   [&] { return solids_of_cells(dynamic_cast<const ShapeKernel&>(source), complex, cells); });
  }

  KernelOverlay overlay(const BrepKernel& source, const std::vector<FaceId>& faces,
                        const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                        const Redrawn& redrawn,
                        const std::vector<std::array<Eigen::Vector3d, 2>>& lines) const override {
    return guarded("laying faces over each other", [&] {
      return overlay_of(dynamic_cast<const ShapeKernel&>(source), faces, origin, direction, redrawn, lines);
    });
  }

  std::vector<KernelPart> cut_by_plane(const BrepKernel& source, const Eigen::Vector3d& point,
                                       const Eigen::Vector3d& normal) const override {
    return guarded("cutting by a plane", [&] {
      return parts_cut_by_plane(dynamic_cast<const ShapeKernel&>(source), point, normal);
    });
  }

  KernelSolid without_faces(const BrepKernel& source, const std::vector<FaceId>& faces) const override {
    return guarded("removing faces",
                   [&] { return solid_without_faces(dynamic_cast<const ShapeKernel&>(source), faces); });
  }

  KernelSolid with_flat_tips(const BrepKernel& source, const std::vector<DrillTip>& tips,
                             double share) const override {
    return guarded("making drill tips flat", [&] {
      return solid_with_flat_tips(dynamic_cast<const ShapeKernel&>(source), tips, share);
    });
  }

  KernelSolid with_carriers(const BrepKernel& kernel, double tolerance) const override {
    return guarded("recognising planes and cylinders",
                   [&] { return solid_with_carriers(dynamic_cast<const ShapeKernel&>(kernel), tolerance); });
  }

  KernelSolid on_carriers(const CarrierSolid& solid, double tolerance) const override {
    return guarded("making a solid of surfaces", [&] { return solid_on_carriers(solid, tolerance); });
  }

 private:
  static FileShapes shapes_of(const KernelSource& source) {
    switch (source.format) {
      case BrepFormat::step:
        return read_step(source);
      case BrepFormat::iges:
        return read_iges(source);
      case BrepFormat::brep:
        break;
    }
    return read_native(source);
  }

  mutable std::mutex files_;
};

}  // namespace
}  // namespace isopatch::geometry

extern "C" const isopatch::geometry::BrepModule* isopatch_brep_module() {
  static const isopatch::geometry::OpenCascade module;
  return &module;
}
