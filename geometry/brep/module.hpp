#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/brep/carrier_solid.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "geometry/brep/drill_tip.hpp"
#include "geometry/brep/kernel.hpp"
#include "geometry/brep/redrawn.hpp"
#include "geometry/brep/sew_options.hpp"
#include "geometry/polyhedron.hpp"
#include "geometry/trimmed_surface.hpp"

namespace isopatch::geometry {

enum class BrepFormat { step, iges, brep };

/// A solid as the module makes it; whether it is closed is left to the caller.
struct KernelSolid {
  std::shared_ptr<const BrepKernel> kernel;
  std::string name;
  double largest_correction = 0;  ///< m
};

/// What the library says about an entity of a file.
struct EntityRemark {
  std::int64_t entity = 0;  ///< number of the STEP instance or IGES entity; 0 where it is none
  std::string text;
};

/// What came of a file.
struct KernelFile {
  std::vector<KernelSolid> bodies;
  int listed = 0;  ///< bodies that the file lists and the library delivered, each where it is placed
  std::size_t loose_faces = 0;        ///< that belong to no body of the file
  std::vector<EntityRemark> lost;     ///< bodies and faces that the library could not make
  std::vector<EntityRemark> remarks;  ///< what else it could not read of shapes
};

/// A file to be read.
struct KernelSource {
  std::filesystem::path path;
  BrepFormat format = BrepFormat::step;
  std::string_view text = {};  ///< of a STEP file, made ready; the path's content otherwise
  double metres =
      1e-3;  ///< that a unit of the shapes measures: a millimetre of STEP and IGES, a unit of a .brep file
};

/// As `Overlay`.
struct KernelOverlay {
  std::shared_ptr<const BrepKernel> sheet;
  std::vector<std::vector<int>> covered_by;
};

/// As `CutPart`.
struct KernelPart {
  KernelSolid solid;
  std::vector<std::optional<FaceId>> origin;
};

/// What the module of the CAD library offers besides the solids themselves. Lengths in m.
class BrepModule {
 public:
  virtual ~BrepModule() = default;

  /// In this very process, which the library may end or keep for ever if the file is damaged.
  virtual KernelFile read(const KernelSource& source, const SewOptions& options) const = 0;
  /// Bodies of `read` as bytes that another process of the same build can take up, bit for bit.
  virtual std::string to_bytes(const std::vector<KernelSolid>& bodies) const = 0;
  virtual std::vector<KernelSolid> from_bytes(const std::string& bytes) const = 0;
  /// @param unit  "mm", "m" or "in", of the file's coordinates; a .brep file does not say it
  virtual void write(const std::filesystem::path& path, BrepFormat format, const BrepKernel& kernel,
                     const std::string& unit) const = 0;
  /// The faces as NURBS surfaces with NURBS loops.
  virtual std::vector<TrimmedSurface> trimmed_surfaces(const BrepKernel& kernel) const = 0;
  virtual KernelSolid sew(const std::vector<TrimmedSurface>& faces, const SewOptions& options) const = 0;
  virtual KernelSolid polyhedron(const Polyhedron& polyhedron, const SewOptions& options) const = 0;
  /// As `cell_solids`.
  virtual std::vector<KernelSolid> cells(const BrepKernel& source, const CellComplex& complex,
                                         const std::vector<CellId>& cells) const = 0;
  /// As `overlay`.
  virtual KernelOverlay overlay(const BrepKernel& source, const std::vector<FaceId>& faces,
                                const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                                const Redrawn& redrawn,
                                const std::vector<std::array<Eigen::Vector3d, 2>>& lines) const = 0;
  /// As `cut_by_plane`; what comes of it is to be checked.
  virtual std::vector<KernelPart> cut_by_plane(const BrepKernel& source, const Eigen::Vector3d& point,
                                               const Eigen::Vector3d& normal) const = 0;
  /// As `without_faces`; what comes of it is to be checked.
  virtual KernelSolid without_faces(const BrepKernel& source, const std::vector<FaceId>& faces) const = 0;
  /// As `with_flat_tips`; what comes of it is to be checked.
  virtual KernelSolid with_flat_tips(const BrepKernel& source, const std::vector<DrillTip>& tips,
                                     double share) const = 0;
  /// As `recognise_carriers`; no kernel where nothing is recognised.
  /// @param tolerance  m
  virtual KernelSolid with_carriers(const BrepKernel& kernel, double tolerance) const = 0;
  /// As `make_brep` of a CarrierSolid.
  virtual KernelSolid on_carriers(const CarrierSolid& solid, double tolerance) const = 0;
};

/// The module, loaded at the first call and for good.
/// @throws Error unsupported  it is missing or belongs to another version
const BrepModule& brep_module();
/// Its file.
/// @throws Error unsupported  it is missing
std::filesystem::path brep_module_file();

}  // namespace isopatch::geometry

/// The function of the module file that gives it.
extern "C" const isopatch::geometry::BrepModule* isopatch_brep_module();
