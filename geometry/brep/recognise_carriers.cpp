#include "geometry/brep/recognise_carriers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/module.hpp"

namespace isopatch::geometry {
namespace {

std::string plural(SurfaceKind kind) {
  return kind == SurfaceKind::torus ? "tori" : std::string(name(kind)) + "s";
}

bool may_be_recognised(SurfaceKind kind) {
  return kind == SurfaceKind::spline || kind == SurfaceKind::other;
}

}  // namespace

std::string RecognisedBrep::text() const {
  int count = 0;
  std::vector<std::string> kinds;
  for (const auto& [kind, number] : faces) {
    count += number;
    kinds.push_back(number == 1 && faces.size() == 1 ? std::string("a ") + name(kind) : plural(kind));
  }
  if (count == 0) return "";
  std::string all = kinds.back();
  kinds.pop_back();
  if (!kinds.empty()) all = fmt::format("{} and {}", fmt::join(kinds, ", "), all);
  return fmt::format("{} spline {} {}", count, count == 1 ? "face is" : "faces are", all);
}

RecognisedBrep recognise_carriers(const Brep& brep, double tolerance) {
  if (!(tolerance >= 0 && tolerance <= 1e-3))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("tolerance is {}; its range is 0 to 1e-3", tolerance));
  RecognisedBrep result{brep, {}, 0};
  const KernelSolid found = brep_module().with_carriers(brep.kernel(), tolerance * brep.size());
  if (!found.kernel) return result;
  result.brep = Brep(found.kernel);
  for (std::size_t f = 0; f < brep.faces().size(); ++f)
    if (may_be_recognised(brep.faces()[f].kind) && !may_be_recognised(result.brep.faces()[f].kind))
      ++result.faces[result.brep.faces()[f].kind];
  for (std::size_t e = 0; e < brep.edges().size(); ++e)
    result.edges += brep.edges()[e].kind != result.brep.edges()[e].kind;
  return result;
}

}  // namespace isopatch::geometry
