#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "geometry/base/tolerance.hpp"
#include "geometry/interface.hpp"
#include "geometry/non_matching.hpp"
#include "geometry/patch_face.hpp"
#include "geometry/patch_set.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// Volume patches and how they meet.
///
/// Invariant: every patch is right-handed as far as the sign of its Jacobian at its middle tells; every face
/// is in exactly one of: one interface, the boundary, the degenerate faces, the faces that non-matching
/// interfaces cover; those that they cover in part are of the boundary.
class MultiPatch {
 public:
  const std::vector<NurbsVolume>& patches() const { return patches_; }
  const NurbsVolume& patch(PatchId id) const { return patches_[static_cast<std::size_t>(id.value)]; }
  int patch_count() const { return static_cast<int>(patches_.size()); }
  const std::vector<Interface>& interfaces() const { return interfaces_; }
  /// Where patches meet without agreeing point by point; none unless the tolerance asks to keep them.
  const std::vector<NonMatchingInterface>& non_matching() const { return non_matching_; }
  /// Boundary faces of which other faces cover a part.
  const std::vector<PatchFace>& partly_covered() const { return partly_covered_; }
  /// Faces with an area that no other patch shares, or only in part, ordered by patch and side.
  const std::vector<PatchFace>& boundary_faces() const { return boundary_faces_; }
  /// Faces collapsed to a curve or a point: no interface, no boundary.
  const std::vector<PatchFace>& degenerate_faces() const { return degenerate_faces_; }
  const std::vector<Boundary>& boundaries() const { return boundaries_; }
  /// Diagonal of the box of all control points, model units.
  double size() const { return size_; }
  const Tolerance& tolerance() const { return tolerance_; }

  /// Whether the patch was left-handed as given, so that its first direction has been turned around.
  bool was_reversed(PatchId id) const { return reversed_[static_cast<std::size_t>(id.value)]; }
  /// The face, or the parameter, of `patches()` that the input names so: another one where a patch was
  /// reversed.
  PatchFace from_input(PatchFace face) const;
  Parameter<3> from_input(PatchId id, const Parameter<3>& parameter) const;
  /// What the input calls a face, or a parameter, of `patches()`: turning around twice changes nothing.
  PatchFace to_input(PatchFace face) const { return from_input(face); }
  Parameter<3> to_input(PatchId id, const Parameter<3>& parameter) const { return from_input(id, parameter); }
  /// What the input calls the patch; "" where it has no name for it.
  std::string patch_name(PatchId id) const;
  /// "3:north", in the input's names: for messages and reports.
  std::string label(PatchFace face) const;

  /// The same model with some interfaces kept as non-matching ones: what lies on both sides of them may have
  /// other functions.
  /// @param apart  for each of `interfaces()` whether it is one of them
  MultiPatch with_apart(const std::vector<bool>& apart) const;

  /// Connected components over all interfaces: the bodies, each an increasing list of patches.
  std::vector<std::vector<PatchId>> bodies() const;

 private:
  friend MultiPatch connect(PatchSet patches, const Tolerance& tolerance);
  MultiPatch() = default;

  std::vector<NurbsVolume> patches_;
  std::vector<Interface> interfaces_;
  std::vector<NonMatchingInterface> non_matching_;
  std::vector<PatchFace> partly_covered_;
  std::vector<PatchFace> boundary_faces_;
  std::vector<PatchFace> degenerate_faces_;
  std::vector<Boundary> boundaries_;
  std::vector<bool> reversed_;
  std::vector<std::string> names_;
  Tolerance tolerance_;
  double size_ = 0;
};

/// Bounding box of all control points.
Eigen::AlignedBox3d box(const MultiPatch& model);

/// Verifies the interfaces that are stated and finds the others from the geometry.
///
/// Left-handed patches are turned around first. Two faces are an interface if they agree to
/// `tolerance.same_point` times the model's size at their corners and on a grid of inner points that sees
/// every knot span (equal corners alone do not make an interface): in the orientation that is stated, or in
/// one of the eight where none is. The model is the same whether interfaces are stated or not.
///
/// @throws Error invalid_argument  no patch, a named boundary or a stated interface with a face that does not
/// exist
/// @throws Error not_conforming    faces that nearly meet (a gap or an overlap, saying which and how far),
/// more than
///                                 two faces in one place, a stated interface that the geometry refutes
/// @cost   O(faces log faces) for the search, O(control points) per candidate
MultiPatch connect(PatchSet patches, const Tolerance& tolerance = {});

}  // namespace isopatch::geometry
