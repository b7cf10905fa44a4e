#pragma once

#include <filesystem>

namespace isopatch::app {

/// What a file holds, as far as commands and studies tell files apart.
enum class FileKind {
  study,         ///< .toml
  results,       ///< .h5, but for blocks
  blocks,        ///< .h5 as `isopatch segment` writes it
  patches,       ///< .g2, .mesh, and .xml without solids
  cad,           ///< solids that the CAD library reads: STEP, IGES, .brep
  gismo_solids,  ///< .xml with solids
  polyhedra,     ///< .off
  triangles,     ///< .stl, .obj, .ply, .3mf
  unknown,       ///< any other ending; readers of patches look at the content
};

/// By the ending, in whatever case; of .xml and .h5 files the content decides, and those that cannot be read
/// count as patches and results, whose readers say why.
FileKind kind_of(const std::filesystem::path& path);

/// Group of HDF5 files that hold blocks.
inline constexpr const char* blocks_group = "/isopatch_blocks";

/// Whether it is one of the three kinds of solids.
bool holds_solids(FileKind kind);
inline bool holds_solids(const std::filesystem::path& path) {
  return holds_solids(kind_of(path));
}

}  // namespace isopatch::app
