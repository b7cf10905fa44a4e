#pragma once

#include <string>
#include <vector>

#include "app/problem/applied_region.hpp"
#include "app/problem/built_problem.hpp"
#include "app/problem/model_report.hpp"
#include "app/problem/stage_folder.hpp"
#include "app/study/study.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// A model, and how its solids became patches if it is made of solids.
struct LoadedModel {
  geometry::MultiPatch model;
  std::optional<segmentation::ParameterizationReport> parameterization;
  std::vector<StageReport> stages = {};  ///< of a model made of solids
};

/// Reads or generates the patches, or makes them of solids, attaches more, scales them to metres and finds
/// how they meet.
/// @throws Error as the readers, `parameterize` and `connect` do, and invalid_argument for a generated
/// model's dimensions and for attachments
LoadedModel load_model(const ModelInput& input, const Progress& progress = {});

/// A model and what is to be said of it, for any number of problems on it.
struct ReportedModel {
  LoadedModel loaded;
  ModelReport report;
};
/// The model of a study, whose patches have one material each.
/// @throws Error as `load_model`, and invalid_argument for a patch without material or with two
ReportedModel reported_model(const Study& study, const Progress& progress = {});

/// Builds the problem that a study describes. Nothing is assembled yet, and no file but the model's is
/// touched.
///
/// Warnings name the patches that fail the certificate of the Jacobian's sign (the assembly refuses those
/// that are folded at a Gauss point) and the faces that a selection leaves out by little.
///
/// The memory that all will take is forecast before the model is refined.
///
/// @throws Error out_of_memory     if it is more than there is, or than the study allows
/// @throws Error invalid_argument  a patch without material or with two, selections that match nothing, faces
///     that do not exist, probes outside the part; all with file, line and column
BuiltProblem build_problem(const Study& study, const Progress& progress = {});
/// The same of a model that is there already.
/// @param model   as `load_model` gives it for the study
/// @param report  of this model
BuiltProblem build_problem(const Study& study, const LoadedModel& model, const ModelReport& report,
                           const Progress& progress = {});

/// Adds the warning of a study without loads to what is solved for displacements; modes need none.
void warn_of_no_load(const Study& study, BuiltProblem& built);

}  // namespace isopatch::app
