#pragma once

#include <optional>
#include <vector>

#include "geometry/io/byte_sink.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/output/fitted_grids.hpp"
#include "iga/output/output_grid.hpp"
#include "iga/output/plane_fields.hpp"
#include "iga/output/surface_points.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {

/// The number of each patch's material, in the order in which materials first appear.
std::vector<int> material_numbers(const ElasticField& field);

/// Writes a field as straight-edged hexahedra for VTK and ParaView, whose filters all support them; the error
/// of what they show is that of the cells' size.
///
/// Each element is cut into pieces as `straight_pieces` says, and as `fit_grids` does if that is asked for.
/// All fields are evaluated at the nodes: `displacement` (m), `strain`, `stress` (Pa), both xx yy zz xy yz
/// xz, `von_mises`, `principal_stress` (three, the largest first), `tresca` (Pa) and `scaled_jacobian` (-1 ..
/// 1), in single precision; cells have `patch` and `material`, from 0, and where the error is estimated that
/// of their element: `error_energy` (of the whole element, J), `stress_error` (Pa). A patch's cells share
/// their nodes; those on interfaces, edges and corners have the same coordinates to the last bit in all
/// patches, so merged patches are closed. Which points have stress from beside them is said by `PlaneFields`.
class HexahedraOutput {
 public:
  /// @param field  must outlive this
  /// @param model  how its patches meet
  /// @param least  pieces per element and direction, 1 .. 32
  /// @param fit    how exact von Mises stress shall be between nodes; none: as the pieces are
  HexahedraOutput(const ElasticField& field, const geometry::MultiPatch& model, int least,
                  const std::optional<FitOptions>& fit = {});

  /// What came of it, if it was asked for.
  const std::optional<FitReport>& fit() const { return fit_; }

  /// Some patches as a .vtu file. Large ones are in memory a plane of nodes at a time, with the nodes of
  /// their faces; small ones some at a time.
  /// @return  the nodes whose stress means nothing
  /// @cost    some 0.3 us and 150 bytes of the file per node; in parallel
  BorrowedStress write(const std::vector<int>& patches, const geometry::PlacedByteSink& sink) const;

  /// Faces as a .vtu file of quadrilaterals with the same nodes and fields, their normals outward.
  void write_faces(const std::vector<geometry::PatchFace>& faces, const geometry::PlacedByteSink& sink) const;

 private:
  const ElasticField& field_;
  std::vector<int> materials_;
  std::vector<geometry::GridParameters<3>> grids_;
  std::optional<FitReport> fit_;  // changes the grids
  SurfacePoints surface_;
};

}  // namespace isopatch::iga
