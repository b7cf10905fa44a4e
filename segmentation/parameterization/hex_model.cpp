#include "segmentation/parameterization/hex_model.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {

std::string label_of(const HexModel& model, geometry::BlockSide side) {
  return model.name(side.block) + ":" + model.face(side).name;
}

void validate(const HexModel& model) {
  const std::size_t blocks = model.topology.blocks.size();
  if (blocks == 0) throw Error(ErrorCode::invalid_argument, "a complex needs at least one hexahedron");
  if (model.solids.size() != blocks || model.faces.size() != blocks || model.bodies.size() != blocks)
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("a complex of {} blocks comes with {} solids, the faces of {} and the bodies of {}",
                    blocks, model.solids.size(), model.faces.size(), model.bodies.size()));
  geometry::validate(model.topology);
  for (std::size_t b = 0; b < blocks; ++b)
    for (const geometry::BlockFace& face : model.faces[b]) {
      if (face.solid != static_cast<int>(b))
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("block {} has a face of solid {}; it must be its own", b, face.solid));
      model.solids[b].brep.face(face.face);  // throws if there is none
    }
}

}  // namespace isopatch::segmentation
