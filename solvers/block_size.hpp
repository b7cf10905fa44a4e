#pragma once

namespace isopatch::solvers {

/// Unknowns that belong together, and so rows and columns of a matrix's blocks: the components of a
/// displacement.
inline constexpr int block_size = 3;
inline constexpr int block_entries = block_size * block_size;

}  // namespace isopatch::solvers
