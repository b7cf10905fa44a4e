#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "geometry/brep/read_brep.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/hex_model.hpp"

namespace isopatch::segmentation {

/// Files of topological hexahedra, and how they meet.
struct BlockFiles {
  std::vector<std::filesystem::path> files =
      {};  ///< any format of `read_breps`; several solids in a file are several blocks
  std::optional<std::filesystem::path> pairs = {};  ///< without it, pairs are found from the geometry
  std::optional<double> length_unit = {};           ///< as of `geometry::ReadBrepOptions`
  bool allow_partial = false;                       ///< likewise
  GuardLimits limits = {.seconds = 0, .bytes = 0};  ///< likewise
  AssemblyOptions assembly = {};
  bool operator==(const BlockFiles&) const = default;
};

/// Solids, and what the files gave cause to say.
struct ReadSolids {
  std::vector<geometry::BrepFile> solids;
  std::vector<std::string> warnings;
};

/// The solids of the files, whatever they are; lengths are metres. Called as by `read_blocks`.
/// @throws Error as `read_breps` does; SolidError for one whose geometry contradicts itself
ReadSolids read_solids(const BlockFiles& files, const Progress& progress = {});

/// Whether a solid has the graph of a cube, whatever its shape.
bool is_hexahedron(const geometry::Brep& solid);

/// Blocks put together, and what the files gave cause to say.
struct ReadBlocks {
  HexModel model;
  std::vector<std::string> warnings;
};

/// Reads hexahedra and puts them together; lengths are metres.
///
/// Blocks are called as `geometry::read_breps` calls the bodies; further ones of a name have "#1", "#2", ...
/// behind it.
/// @throws Error as `read_breps` and `hex_model` do; SolidError where it is known which
/// faces, edges and places are wrong
ReadBlocks read_blocks(const BlockFiles& files, const Progress& progress = {});

/// How `read_blocks` reads a file.
geometry::ReadBrepOptions block_reading(const BlockFiles& files);

/// Gives bodies of several files the names that `read_blocks` does, one after the other.
class BlockNames {
 public:
  std::string add(const std::string& body);

 private:
  std::map<std::string, int> count_;
};

/// A list of pairs, one a line: block, number of its face, block, number of its face.
/// @param source  of the text, for messages
/// @param blocks  their names
/// @throws Error bad_format        a line that is not so, with "source:line: "
/// @throws Error invalid_argument  a block that there is not
std::vector<ListedPair> parse_pairs(const std::string& text, const std::string& source,
                                    const std::vector<std::string>& blocks);

}  // namespace isopatch::segmentation
