#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "app/study/accuracy_input.hpp"
#include "app/study/applied_load.hpp"
#include "app/study/combination_input.hpp"
#include "app/study/config_value.hpp"
#include "app/study/face_selection.hpp"
#include "app/study/model_input.hpp"
#include "app/study/modes_input.hpp"
#include "app/study/section_input.hpp"
#include "app/study/support_input.hpp"
#include "iga/material/material.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::app {

/// A material and its patches.
struct MaterialInput {
  PatchSelection patches;
  iga::Material material;
  Place place;
  bool operator==(const MaterialInput&) const = default;
};

/// What some patches have beyond [discretization]: [[discretization.patch]].
struct PatchDiscretizationInput {
  PatchSelection patches;
  FaceSelection reach;              ///< only its `part`: those of the patches that reach into it
  iga::PatchRefinement refinement;  ///< of no patch yet; max_size in m
  Place place;
  bool operator==(const PatchDiscretizationInput&) const = default;
};

/// A parameter of a patch, in the input's naming.
struct PatchParameter {
  int patch = 0;
  Eigen::Vector3d parameter = Eigen::Vector3d::Zero();
  bool operator==(const PatchParameter&) const = default;
};

/// A place whose values are wanted: a point (m), or a patch with a parameter.
struct ProbeInput {
  std::string name;
  std::variant<Eigen::Vector3d, PatchParameter> where;
  Place place;
  bool operator==(const ProbeInput&) const = default;
};

/// Digits of the numbers of results_exact.vtm; automatic takes single where full would need more than 1 GB.
enum class FieldPrecision { automatic, full, single };

/// What is written of the fields.
struct FieldOptions {
  /// Straight hexahedra per element and direction at least, 1 .. 32; 0: 4, of more than 100,000 elements 2,
  /// of more than a million 1, halved where von Mises stress between nodes needs it.
  int pieces = 0;
  bool exact = true;  ///< whether Bezier cells are written as well
  FieldPrecision precision = FieldPrecision::automatic;
  bool operator==(const FieldOptions&) const = default;
};

/// What is written, and where.
struct OutputInput {
  std::filesystem::path directory = "results";  ///< resolved against the study's folder
  bool fields = true;
  FieldOptions field_options;
  bool hdf5 = true;
  bool report = true;
  bool stages = true;  ///< whether solids, hexahedra and patches are kept in the folder `stages` there
  bool error_estimate = true;
  Eigen::Vector3d moments_about = Eigen::Vector3d::Zero();  ///< of reactions, m
  bool operator==(const OutputInput&) const = default;
};

/// A study: everything that the file says, in SI units. STUDY.md documents the keys.
struct Study {
  std::string title;
  ModelInput model;
  iga::DiscretizationOptions discretization;  ///< max_size in m
  std::vector<PatchDiscretizationInput> patch_discretizations = {};
  std::vector<MaterialInput> materials;
  std::vector<SupportInput> supports;
  std::vector<AppliedLoad> loads;
  std::vector<CombinationInput> combinations = {};
  iga::ElasticityOptions options;
  std::vector<ProbeInput> probes;
  std::vector<SectionInput> sections = {};
  ModesInput modes = {};
  AccuracyInput accuracy = {};
  OutputInput output;
  std::string source;  ///< path of the file, for messages
  std::string text;    ///< the file as it was read, stored with the results
  bool operator==(const Study&) const = default;
};

}  // namespace isopatch::app
