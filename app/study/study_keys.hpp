#pragma once

#include <optional>
#include <string>

#include "app/study/keys.hpp"
#include "app/study/study.hpp"

namespace isopatch::app {

/// Degree 1 does not bend, so that it has to be asked for.
struct DiscretizationKeys {
  std::optional<ConfigValue> patch;
  iga::DiscretizationOptions options = {.degree = {2, 2, 2}};
  int points = 0;
};

struct ProbeKeys {
  std::string name;
  std::optional<Eigen::Vector3d> point;
  std::optional<int> patch;
  std::optional<Eigen::Vector3d> parameter;
};

/// One table of [[discretization.patch]].
struct PatchDiscretizationKeys {
  std::optional<PatchSelection> patches;
  FaceSelection reach;  ///< only its `part`
  iga::PatchRefinement refinement;
};

/// [coupling].
struct CouplingKeys {
  iga::Coupling method = iga::Coupling::elimination;
  /// How faces are coupled that do not match; refused if nothing.
  std::optional<iga::NonMatchingCoupling> non_matching;
  iga::MortarSide mortar_side = iga::MortarSide::automatic;
};

/// The whole file: each section is read with its own keys.
struct StudyKeys {
  std::string title;
  std::optional<ConfigValue> model;
  std::optional<ConfigValue> parameterization;
  std::optional<ConfigValue> segmentation;
  std::optional<ConfigValue> reconstruction;
  std::optional<ConfigValue> discretization;
  std::optional<ConfigValue> material;
  std::optional<ConfigValue> support;
  std::optional<ConfigValue> load;
  std::optional<ConfigValue> combination;
  std::optional<ConfigValue> coupling;
  std::optional<ConfigValue> solver;
  std::optional<ConfigValue> probe;
  std::optional<ConfigValue> section;
  std::optional<ConfigValue> modes;
  std::optional<ConfigValue> accuracy;
  std::optional<ConfigValue> output;
};

/// The keys of the file and of its smaller sections: the parser reads by them and the documentation is
/// printed from them. Larger sections have headers of their own: model_keys, material_keys, support_keys,
/// load_keys.
const Keys<StudyKeys>& study_keys();
const Keys<DiscretizationKeys>& discretization_keys();
const Keys<PatchDiscretizationKeys>& patch_discretization_keys();
const Keys<CouplingKeys>& coupling_keys();
const Keys<solvers::SolverOptions>& solver_keys();
const Keys<ProbeKeys>& probe_keys();
const Keys<OutputInput>& output_keys();

}  // namespace isopatch::app
