#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "geometry/brep/kernel.hpp"
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

/// What the module of the CAD library offers besides the solids themselves. Lengths in m.
class BrepModule {
 public:
  virtual ~BrepModule() = default;

  /// @param metres  that a unit of a .brep file measures
  virtual std::vector<KernelSolid> read(const std::filesystem::path& path, BrepFormat format, double metres,
                                        const SewOptions& options) const = 0;
  /// @param unit  "mm", "m" or "in", of the file's coordinates; a .brep file does not say it
  virtual void write(const std::filesystem::path& path, BrepFormat format, const BrepKernel& kernel,
                     const std::string& unit) const = 0;
  /// The faces as NURBS surfaces with NURBS loops.
  virtual std::vector<TrimmedSurface> trimmed_surfaces(const BrepKernel& kernel) const = 0;
  virtual KernelSolid sew(const std::vector<TrimmedSurface>& faces, const SewOptions& options) const = 0;
  virtual KernelSolid polyhedron(const Polyhedron& polyhedron, const SewOptions& options) const = 0;
};

/// The module, loaded at the first call and for good.
/// @throws Error unsupported  it is missing or belongs to another version
const BrepModule& brep_module();

}  // namespace isopatch::geometry

/// The function of the module file that gives it.
extern "C" const isopatch::geometry::BrepModule* isopatch_brep_module();
