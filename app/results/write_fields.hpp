#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/base/warning.hpp"
#include "app/results/run_summary.hpp"
#include "app/study/study.hpp"
#include "geometry/base/progress.hpp"
#include "iga/output/fitted_grids.hpp"
#include "iga/output/plane_fields.hpp"

namespace isopatch::app {

/// Faces of a model under the names of a study's supports and loads, or those of the model's own boundaries.
struct FaceGroup {
  std::string name;  ///< "supports", "loads" or "boundaries"
  std::vector<geometry::Boundary> members;
};

/// Of a run, or of stored results.
/// @throws Error invalid_argument  for faces that the model does not have
std::vector<FaceGroup> face_groups(const geometry::MultiPatch& model, const RunSummary& summary);

/// What was written of the fields.
struct WrittenFields {
  std::vector<std::string> collections;  ///< results.vtm and others beside it, the one to open first
  int files = 0;                         ///< with these
  iga::BorrowedStress borrowed;          ///< points whose stress means nothing
  std::optional<iga::FitReport> fit;     ///< of the hexahedra, where their number is chosen
};

/// Writes the fields for ParaView, each file as it is computed, into fields/, and collections of them:
/// results.vtm (straight hexahedra), results_boundaries.vtm (quadrilaterals of `groups`) and
/// results_exact.vtm (Bezier cells, if asked for). Those of an earlier run are removed before.
///
/// Blocks are patches, in groups by material; of more than 100 patches the materials, because a file for each
/// of many small patches takes longer than its content, and ParaView is slow with many blocks.
/// @throws Error io
WrittenFields write_fields(const iga::ElasticField& field, const geometry::MultiPatch& model,
                           const std::vector<FaceGroup>& groups, const FieldOptions& options,
                           const std::filesystem::path& directory, const Progress& progress = {});

/// Says how many points have no stress of their own, and where the worst is; nothing if there are none.
std::optional<Warning> borrowed_warning(const iga::BorrowedStress& borrowed, double model_size);

/// Says how far von Mises stress is off between the nodes, and where; nothing if it is within the tolerance.
std::optional<Warning> fit_warning(const std::optional<iga::FitReport>& fit, double model_size);

}  // namespace isopatch::app
