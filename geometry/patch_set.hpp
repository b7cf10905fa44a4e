#pragma once

#include <string>
#include <vector>

#include "geometry/interface.hpp"
#include "geometry/patch_face.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// A named set of patch faces.
struct Boundary {
  std::string name;
  std::vector<PatchFace> faces;
  bool operator==(const Boundary&) const = default;
};

/// Patches and what their source knows of them: a file, a generated model, a complex of hexahedra. Plain
/// data, in the names of the source: nothing has been held against the geometry, left-handed patches are as
/// they are.
struct PatchSet {
  std::vector<NurbsVolume> patches;
  /// Named boundaries; may be empty.
  std::vector<Boundary> boundaries;
  /// Faces that meet, as far as the source states it: all, some or none. `connect` verifies these and finds
  /// the others.
  std::vector<StatedInterface> interfaces;
  /// What patches are called; as many as there are patches, fewer or none.
  std::vector<std::string> names = {};
  bool operator==(const PatchSet&) const = default;
};

}  // namespace isopatch::geometry
