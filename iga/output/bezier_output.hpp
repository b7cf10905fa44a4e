#pragma once

#include <cstdint>
#include <vector>

#include "geometry/io/byte_sink.hpp"
#include "geometry/io/vtu_file.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {

/// Some patches as a .vtu file of rational Bezier cells, one for each element, sharing their points: the
/// smooth surface, without facets.
///
/// `displacement` (m) is exact. `stress` (Pa, xx yy zz xy yz xz) is interpolated at the (p + 1)^3 evenly
/// spread nodes of each element, where it is that of `PlaneFields`. All cells have weights, also where all
/// are equal: VTK drops those of all blocks if one has none. Cells have `patch` and `material`, from 0. One
/// layer of elements is in memory at a time.
/// @cost  O((p + 1)^4) per element
void write_bezier_cells(const ElasticField& field, const std::vector<int>& patches,
                        const geometry::PlacedByteSink& sink,
                        geometry::Precision precision = geometry::Precision::full);

/// What the points and fields of all patches' cells take in full precision, bytes.
std::int64_t bezier_bytes(const ElasticField& field);

}  // namespace isopatch::iga
