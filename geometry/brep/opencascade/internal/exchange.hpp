#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "geometry/brep/module.hpp"
#include "geometry/brep/opencascade/internal/shape_kernel.hpp"

namespace isopatch::geometry {

/// A shape of a file, with what the file says about it.
struct FileShape {
  TopoDS_Shape shape;  ///< millimetres from STEP and IGES
  std::string name;
  std::function<std::string(const TopoDS_Face&)> name_of;              ///< may be empty
  std::function<std::optional<Colour>(const TopoDS_Face&)> colour_of;  ///< may be empty
};

/// @throws Error io, bad_format
std::vector<FileShape> read_step(const std::filesystem::path& path);
std::vector<FileShape> read_iges(const std::filesystem::path& path);
std::vector<FileShape> read_native(const std::filesystem::path& path);

/// The solids among shapes; where there are none, what their faces make when sewn.
/// @param metres  that a unit of the shapes measures
/// @throws Error unsupported if there are no faces at all
std::vector<KernelSolid> solids_of(const std::vector<FileShape>& shapes, double metres,
                                   const SewOptions& options, const std::string& source);

/// @param unit  "mm", "m", "in"
void write_step(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit);
void write_iges(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit);
void write_native(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit);

}  // namespace isopatch::geometry
