#include "geometry/named_faces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>

#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"

namespace isopatch::geometry {

std::vector<PatchFace> named_faces(const MultiPatch& model, std::string_view name) {
  std::vector<std::string> known;
  for (const Boundary& boundary : model.boundaries()) {
    if (boundary.name == name) return boundary.faces;
    known.push_back(boundary.name);
  }
  throw Error(ErrorCode::invalid_argument,
              fmt::format("the model has no boundary '{}'{}; it has {}", name, did_you_mean(name, known),
                          known.empty() ? "none with a name" : fmt::format("{}", fmt::join(known, ", "))));
}

}  // namespace isopatch::geometry
