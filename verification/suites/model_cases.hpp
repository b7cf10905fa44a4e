#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::verification {

/// A generated model, as a study names it.
struct ModelCase {
  std::string name;                    ///< "sphere"
  std::vector<std::string> overrides;  ///< of a study's [model]: "model.generate=sphere", ...
  std::string held;                    ///< boundary that simple load cases hold
  std::string loaded;                  ///< boundary that they load
};

/// One of every kind that isopatch generates with several patches.
const std::vector<ModelCase>& model_cases();
/// These and the twisted beam, which is one patch.
const std::vector<ModelCase>& every_model_case();
/// @throws std::out_of_range for an unknown name
const ModelCase& model_case(const std::string& name);

/// The study `verification/studies/pulled.toml` on a model: held on one boundary, pulled at another.
std::vector<std::string> pulled_overrides(const ModelCase& model);

geometry::PatchSet patches_of(const ModelCase& model);

/// Faces of a named boundary.
/// @throws std::out_of_range if there is none
std::vector<geometry::PatchFace> faces_of(const geometry::MultiPatch& model, const std::string& boundary);

/// All patches of a model.
std::vector<PatchId> all_patches(const geometry::MultiPatch& model);

}  // namespace isopatch::verification
