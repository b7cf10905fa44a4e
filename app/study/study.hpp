#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/study/attachment_input.hpp"
#include "app/study/blocks_input.hpp"
#include "app/study/config_value.hpp"
#include "app/study/face_selection.hpp"
#include "geometry/base/tolerance.hpp"
#include "geometry/multi_patch.hpp"
#include "iga/material/material.hpp"
#include "iga/solution/solve_elasticity.hpp"
#include "iga/spaces/discretization.hpp"
#include "solvers/solver_options.hpp"

namespace isopatch::app {

/// Where the patches come from: exactly one of file, blocks and generate.
struct ModelInput {
  std::filesystem::path
      file;  ///< G+Smo XML, GoTools .g2 or MFEM NURBS mesh; resolved against the study's folder
  std::optional<BlocksInput> blocks;  ///< solids to be made patches
  std::string generate;               ///< name of a generated model, or ""
  /// The generated model with the dimensions given, model units; empty for files.
  std::function<geometry::PatchSet()> generator;
  std::vector<AttachmentInput> attachments;
  double length_unit = 1;  ///< m per model unit; above 0
  Tolerance tolerance;
  Place place;
};

/// A material and its patches.
struct MaterialInput {
  PatchSelection patches;
  iga::Material material;
  Place place;
};

enum class SupportKind { displacement, symmetry, roller };

/// Supports: each component a value in m or free, plus a gradient; or a plane on which u.n is given.
struct SupportInput {
  std::string name;  ///< for messages: "support 1 (wall)"
  std::string key;   ///< what results call it: its name, or "support 1"
  FaceSelection selection;
  std::optional<FaceConditions> edges;  ///< holds edges of the faces selected and not the faces
  SupportKind kind = SupportKind::displacement;
  std::variant<iga::PrescribedDisplacement, iga::PlaneSupport> condition;
};

enum class LoadKind { traction, pressure, force, body_force, gravity };

/// A load on faces (traction Pa, pressure Pa, total force N) or in patches (body force N/m^3, gravity m/s^2).
struct LoadInput {
  std::string name;         ///< for messages: "load 1 (wind)"
  std::string key;          ///< what results call it: its name, or "load 1"
  FaceSelection selection;  ///< for traction, pressure, force
  PatchSelection patches;   ///< for body_force, gravity
  LoadKind kind = LoadKind::traction;
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  double pressure = 0;
};

/// A place whose values are wanted: a point (m), or a patch with a parameter in the input's naming.
struct ProbeInput {
  std::string name;
  std::optional<Eigen::Vector3d> point;
  std::optional<int> patch;
  Eigen::Vector3d parameter = Eigen::Vector3d::Zero();
  Place place;
};

/// Digits of the numbers of results_exact.vtm; automatic takes single where full would need more than 1 GB.
enum class FieldPrecision { automatic, full, single };

/// What is written of the fields.
struct FieldOptions {
  /// Straight hexahedra per element and direction at least, 1 .. 32; 0: 4, of more than 100,000 elements 2,
  /// of more than a million 1.
  int pieces = 0;
  bool exact = true;  ///< whether Bezier cells are written as well
  FieldPrecision precision = FieldPrecision::automatic;
};

/// What is written, and where.
struct OutputInput {
  std::filesystem::path directory = "results";  ///< resolved against the study's folder
  bool fields = true;
  FieldOptions field_options;
  bool hdf5 = true;
  bool report = true;
};

/// A study: everything that the file says, in SI units. STUDY.md documents the keys.
struct Study {
  std::string title;
  ModelInput model;
  iga::DiscretizationOptions discretization;  ///< max_size in m
  std::vector<MaterialInput> materials;
  std::vector<SupportInput> supports;
  std::vector<LoadInput> loads;
  iga::ElasticityOptions options;
  std::vector<ProbeInput> probes;
  OutputInput output;
  std::string source;  ///< path of the file, for messages
  std::string text;    ///< the file as it was read, stored with the results
};

/// Reads a study.
///
/// @param text         TOML
/// @param source_name  its path: messages name it, relative paths are resolved against its folder
/// @param overrides    "key=value" as in `with_override`, applied in order
/// @throws Error bad_format        broken TOML, with file, line and column
/// @throws Error invalid_argument  unknown keys (naming the nearest known one), wrong types, units and
/// ranges, missing
///                                 keys, with file, line and column
Study parse_study(const std::string& text, const std::filesystem::path& source_name,
                  const std::vector<std::string>& overrides = {});

/// Reads a study's file. @throws Error io as well
Study read_study(const std::filesystem::path& path, const std::vector<std::string>& overrides = {});

/// "${NAME}" and "${NAME:-default}" replaced by environment variables.
/// @throws Error invalid_argument for a variable that is not set and has no default, or a bracket left open
std::string expand_variables(const std::string& text);

}  // namespace isopatch::app
