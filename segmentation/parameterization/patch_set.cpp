#include "segmentation/parameterization/internal/patch_set.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

namespace isopatch::segmentation {
namespace {

geometry::PatchFace patch_face(geometry::BlockSide side) {
  return {PatchId(side.block.value), side.side};
}

void add_face(std::vector<geometry::Boundary>& boundaries, const std::string& name,
              geometry::BlockSide side) {
  auto found = std::find_if(boundaries.begin(), boundaries.end(),
                            [&](const auto& boundary) { return boundary.name == name; });
  if (found == boundaries.end()) found = boundaries.insert(boundaries.end(), {name, {}});
  found->faces.push_back(patch_face(side));
}

// "#ff0000".
bool is_colour_text(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

// Outer faces under the names of the solids' faces, with the body's in front where there are several, or
// "face:" in front of names that are those of colours; then under their colours.
std::vector<geometry::Boundary> boundaries_of(const HexModel& model) {
  std::vector<geometry::BlockSide> outer;
  for (const geometry::HexFace& face : model.topology.faces)
    if (face.uses.size() == 1) outer.push_back(face.uses.front().side);
  std::vector<geometry::Boundary> result;
  const bool several = std::set<std::string>(model.bodies.begin(), model.bodies.end()).size() > 1;
  for (const geometry::BlockSide side : outer) {
    const std::string& body = model.bodies[static_cast<std::size_t>(side.block.value)];
    const std::string name = several ? body + ":" + model.face(side).name : model.face(side).name;
    add_face(result, is_colour_text(name) ? "face:" + name : name, side);
  }
  for (const geometry::BlockSide side : outer) {
    const geometry::BlockFace& face = model.face(side);
    if (!face.colour.empty()) add_face(result, face.colour, side);
  }
  return result;
}

}  // namespace

geometry::PatchSet patch_set(const HexModel& model, std::vector<geometry::NurbsVolume> patches) {
  geometry::PatchSet set;
  set.patches = std::move(patches);
  set.boundaries = boundaries_of(model);
  set.names = model.bodies;
  for (const geometry::HexFace& face : model.topology.faces) {
    if (face.uses.size() < 2) continue;
    const geometry::HexFaceUse &first = face.uses[0], &second = face.uses[1];
    set.interfaces.push_back({patch_face(first.side), patch_face(second.side),
                              composed(inverse(first.orientation), second.orientation)});
  }
  return set;
}

}  // namespace isopatch::segmentation
