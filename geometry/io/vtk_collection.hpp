#pragma once

#include <string>
#include <vector>

namespace isopatch::geometry {

/// A file of a collection, and its name there.
struct VtkBlock {
  std::string name;
  std::string file;  ///< relative to the folder of the collection
};

/// Blocks under a common name.
struct VtkGroup {
  std::string name;
  std::vector<VtkBlock> blocks;
};

/// A multi-block file (.vtm) that opens several files as one model, in groups.
/// @throws Error invalid_argument  for an absolute path, which would not survive a move of the folder
std::string to_vtm(const std::vector<VtkGroup>& groups);

}  // namespace isopatch::geometry
