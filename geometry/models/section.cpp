#include "geometry/models/section.hpp"

#include "geometry/splines/permute.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {

NurbsSurface section_between(const NurbsCurve& inner, const NurbsCurve& outer) {
  return permuted(ruled(inner, outer), {1, 0});
}

}  // namespace isopatch::geometry
