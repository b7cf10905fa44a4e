#pragma once

#include "app/study/keys.hpp"
#include "app/study/study.hpp"
#include "segmentation/parameterization/assemble_model.hpp"

namespace isopatch::app {

/// What [model] says before its generator's keys.
struct ModelKeys {
  std::optional<std::string> file;
  std::vector<std::string> blocks;
  std::optional<std::string> pairs;
  std::optional<std::string> generate;
  std::optional<ConfigValue> attach;
  double length_unit = 1;
  bool gives_length_unit = false;
  bool allow_partial = false;
  double cad_time_limit = 0;
  double cad_memory_limit = 0;
  double same_point = Tolerance{}.same_point;
  double near_miss = Tolerance{}.near_miss;
  double same_knot = Tolerance{}.same_knot;
};

struct LameKeys {
  double lambda = 0;
  double mu = 0;
};
struct MaterialKeys {
  std::optional<PatchSelection> patches;
  std::optional<std::string> name;
  std::optional<LameKeys> lame;
  std::optional<double> young;
  std::optional<double> poisson;
  std::optional<double> density;
};

struct SupportKeys {
  std::string name;
  std::vector<std::string> faces;
  std::optional<FaceConditions> where;
  std::optional<FaceConditions> edges;
  std::optional<std::array<std::optional<double>, 3>> displacement;
  std::optional<Eigen::Matrix3d> displacement_gradient;
  bool symmetry = false;
  bool roller = false;
  std::optional<double> normal_displacement;
};

struct LoadKeys {
  std::string name;
  std::vector<std::string> faces;
  std::optional<FaceConditions> where;
  std::optional<PatchSelection> patches;
  std::optional<Eigen::Vector3d> traction;
  std::optional<double> pressure;
  std::optional<Eigen::Vector3d> force;
  std::optional<Eigen::Vector3d> body_force;
  std::optional<Eigen::Vector3d> gravity;
};

/// Degree 1 does not bend, so that it has to be asked for.
struct DiscretizationKeys {
  iga::DiscretizationOptions options = {.degree = {2, 2, 2}};
  int points = 0;
};

struct ProbeKeys {
  std::string name;
  std::optional<Eigen::Vector3d> point;
  std::optional<int> patch;
  std::optional<Eigen::Vector3d> parameter;
};

struct OutputKeys {
  std::string directory = "results";
  bool fields = true;
  FieldOptions field_options;
  bool hdf5 = true;
  bool report = true;
};

struct ParameterizationKeys {
  segmentation::ParameterizationOptions options;
  double same_point = segmentation::AssemblyOptions{}.same_point;
};

/// The whole file: each section is read with its own keys.
struct StudyKeys {
  std::string title;
  std::optional<ConfigValue> model;
  std::optional<ConfigValue> parameterization;
  std::optional<ConfigValue> discretization;
  std::optional<ConfigValue> material;
  std::optional<ConfigValue> support;
  std::optional<ConfigValue> load;
  std::optional<ConfigValue> coupling;
  std::optional<ConfigValue> solver;
  std::optional<ConfigValue> probe;
  std::optional<ConfigValue> output;
};

/// The one table of keys: the parser reads by it and the documentation is printed from it.
const Keys<StudyKeys>& study_keys();
const Keys<ModelKeys>& model_keys();
const Keys<ParameterizationKeys>& parameterization_keys();
const Keys<DiscretizationKeys>& discretization_keys();
const Keys<MaterialKeys>& material_keys();
const Keys<LameKeys>& lame_keys();
const Keys<FaceConditions>& where_keys();
const Keys<FaceConditions>& edges_keys();
const Keys<PlaneCondition>& plane_keys();
const Keys<CylinderCondition>& cylinder_keys();
const Keys<SphereCondition>& sphere_keys();
const Keys<BoxCondition>& box_keys();
const Keys<SupportKeys>& support_keys();
const Keys<LoadKeys>& load_keys();
const Keys<iga::ElasticityOptions>& coupling_keys();
const Keys<solvers::SolverOptions>& solver_keys();
const Keys<ProbeKeys>& probe_keys();
const Keys<OutputKeys>& output_keys();

/// A generated model, seen from the study file: its keys, and how its options become patches.
struct GeneratedModel {
  std::string name;
  std::string meaning;
  std::vector<KeyText> keys;
  /// @param entries      of [model] that belong to the generator
  /// @param length_unit  m per model unit, for lengths with a unit
  std::function<std::function<geometry::PatchSet()>(const ConfigTable& entries, const Place& place,
                                                    double length_unit)>
      read;
};
const std::vector<GeneratedModel>& generated_models();

/// All sections in the order of the documentation.
std::vector<SectionText> study_sections();

/// The documentation of all keys as Markdown, or of the sections whose name contains `topic`.
/// @throws Error invalid_argument if no section or key has that name
std::string study_documentation(const std::string& topic = {});

}  // namespace isopatch::app
