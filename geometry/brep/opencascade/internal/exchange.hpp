#pragma once

#include <TopoDS_Shape.hxx>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "geometry/brep/module.hpp"
#include "geometry/brep/opencascade/internal/shape_kernel.hpp"

namespace isopatch::geometry {

/// What a file says about a face.
struct FaceWords {
  std::string name;
  std::optional<Colour> colour;
};

/// A shape of a file, where it is placed, with what the file says about it.
struct FileShape {
  TopoDS_Shape shape;  ///< millimetres from STEP and IGES
  std::string name = {};
  std::function<FaceWords(const TopoDS_Face&)> words_of = {};  ///< may be empty
};

/// What the readers find.
struct FileShapes {
  std::vector<FileShape> shapes;
  std::vector<EntityRemark> lost = {}, remarks = {};
};

/// @throws Error io, bad_format
FileShapes read_step(const KernelSource& source);
FileShapes read_iges(const KernelSource& source);
FileShapes read_native(const KernelSource& source);

/// Adds the bodies among shapes: solids, shells, and what loose faces make when sewn.
/// @param metres  that a unit of the shapes measures
void add_bodies(const std::vector<FileShape>& shapes, double metres, const SewOptions& options,
                KernelFile& result);

/// As of BrepModule.
std::string bytes_of(const std::vector<KernelSolid>& bodies);
std::vector<KernelSolid> bodies_of_bytes(const std::string& bytes);

/// @param unit  "mm", "m", "in"
void write_step(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit);
void write_iges(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit);
void write_native(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit);

}  // namespace isopatch::geometry
