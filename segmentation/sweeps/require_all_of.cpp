#include "segmentation/sweeps/require_all_of.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/brep/cell_solids.hpp"

namespace isopatch::segmentation {

void require_all_of(const geometry::Brep& solid, const geometry::CellComplex& cells) {
  double volume = 0;
  for (const geometry::Brep& cell : geometry::cell_solids(solid, cells)) volume += cell.volume();
  if (!(std::abs(volume - solid.volume()) <= 1e-5 * solid.volume()))
    throw Error(ErrorCode::unsupported, fmt::format("{:.3g} of {:.3g} m^3 are not among its hexahedra",
                                                    solid.volume() - volume, solid.volume()));
}

}  // namespace isopatch::segmentation
