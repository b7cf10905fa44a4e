#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/read_brep.hpp"
#include "segmentation/parameterization/hex_complex.hpp"

namespace isopatch::segmentation {

/// Files of topological hexahedra, and how they meet.
struct BlockFiles {
  std::vector<std::filesystem::path>
      files;  ///< any format of `read_breps`; several solids in a file are several blocks
  std::optional<std::filesystem::path> pairs;  ///< without it, pairs are found from the geometry
  double length_unit = 1;                      ///< m that a unit of formats without one measures
  ComplexOptions complex;
};

/// Reads hexahedra and puts them together; lengths are metres.
///
/// Blocks are called by their files' names without ending; further solids of a file have "#1", "#2", ...
/// behind it.
/// @throws Error as `read_breps`, `hexahedron` and `hex_complex` do; SolidError where it is known which
/// faces, edges and places are wrong
HexComplex read_blocks(const BlockFiles& files);

/// How `read_blocks` reads a file.
/// @param length_unit  of formats that do not say it, m
geometry::ReadBrepOptions block_reading(const std::filesystem::path& path, double length_unit);
/// What `read_blocks` calls the n-th solid of a file, from 0.
std::string block_name(const std::filesystem::path& path, int solid);

/// A list of pairs, one a line: block, number of its face, block, number of its face.
/// @param source  of the text, for messages
/// @throws Error bad_format        a line that is not so, with "source:line: "
/// @throws Error invalid_argument  a block that there is not
std::vector<ListedPair> parse_pairs(const std::string& text, const std::string& source,
                                    const std::vector<Hexahedron>& blocks);

}  // namespace isopatch::segmentation
