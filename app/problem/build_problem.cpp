#include "app/problem/build_problem.hpp"

#include <fmt/format.h>

#include "app/base/engineering_units.hpp"
#include "app/base/place_outside.hpp"
#include "app/base/place_tolerance.hpp"
#include "app/problem/edge_selection.hpp"
#include "app/problem/loose_bodies.hpp"
#include "app/problem/plausibility.hpp"
#include "app/problem/read_model_file.hpp"
#include "geometry/attach.hpp"
#include "geometry/io/read_patches.hpp"
#include "iga/problem/loads.hpp"
#include "iga/solution/solver_choice.hpp"
#include "iga/spaces/solution_knots.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;

geometry::PatchSet scaled(geometry::PatchSet set, double factor) {
  if (factor == 1) return set;
  for (auto& patch : set.patches)
    patch = geometry::NurbsVolume(patch.knots(), patch.control_points() * factor, patch.weights());
  return set;
}

std::vector<iga::Material> assign_materials(const Study& study, const MultiPatch& model) {
  const int patch_count = model.patch_count();
  std::vector<const MaterialInput*> owner(static_cast<std::size_t>(patch_count), nullptr);
  for (const MaterialInput& input : study.materials)
    for (const PatchId id : select_patches(model, input.patches)) {
      const MaterialInput*& slot = owner[static_cast<std::size_t>(id.value)];
      if (slot)
        throw error_at(input.place,
                       fmt::format("patch {} already has the material at {}; a patch can have one only",
                                   id.value, to_string(slot->place)));
      slot = &input;
    }
  std::vector<iga::Material> result;
  for (std::size_t i = 0; i < owner.size(); ++i) {
    if (!owner[i])
      throw error_at({study.source, 0, 0},
                     fmt::format("patch {} has no material; add it to the patches of a [[material]]", i));
    result.push_back(owner[i]->material);
  }
  return result;
}

/// The faces of a support or a load, with its share of the report and a warning if some are missed by little.
std::vector<geometry::PatchFace> caught_faces(const FaceSelection& selection, const std::string& name,
                                              std::string_view kind, BuiltProblem& built,
                                              std::vector<AppliedRegion>& regions) {
  const MultiPatch& model = built.problem.discretization.model;
  SelectedFaces selected = select_faces(model, selection);
  regions.push_back(region_of(name, kind, selected.faces, built.report));
  const std::string warning = near_miss_warning(model, selection, name, selected);
  if (!warning.empty()) built.warnings.push_back({warning});
  return std::move(selected.faces);
}

void add_volume_load(const LoadInput& load, BuiltProblem& built) {
  iga::ElasticityProblem& problem = built.problem;
  const auto patches = select_patches(problem.discretization.model, load.patches);
  built.loads.push_back(region_of(load.name, name(load.kind), patches, built.report));
  const auto volume = [&](PatchId id) {
    return built.report.patches[static_cast<std::size_t>(id.value)].volume;
  };
  Eigen::Vector3d& total = built.loads.back().total;
  if (load.kind == LoadKind::body_force) {
    for (const PatchId id : patches) total += volume(id) * load.vector;
    problem.volume_loads.push_back(
        {load.name, patches, [f = load.vector](const Eigen::Vector3d&) { return f; }});
    return;
  }
  try {
    for (auto& weight : iga::gravity(load.name, patches, load.vector, problem.materials))
      problem.volume_loads.push_back(std::move(weight));
  } catch (const Error& error) {
    throw error_at(load.selection.place, error.what(), error.code());
  }
  for (const PatchId id : patches)
    total += volume(id) * problem.materials[static_cast<std::size_t>(id.value)].density * load.vector;
}

Eigen::Vector3d total_of(const iga::SurfaceLoad& load, const iga::Discretization& discretization) {
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const geometry::PatchFace& face : load.faces)
    total += iga::face_load(discretization.patches[static_cast<std::size_t>(face.patch.value)], face.side,
                            load.traction)
                 .rowwise()
                 .sum();
  return total;
}

void add_load(const LoadInput& load, BuiltProblem& built) {
  if (load.kind == LoadKind::body_force || load.kind == LoadKind::gravity)
    return add_volume_load(load, built);
  auto faces = caught_faces(load.selection, load.name, name(load.kind), built, built.loads);
  auto& loads = built.problem.surface_loads;
  if (load.kind == LoadKind::traction)
    loads.push_back(iga::constant_traction(load.name, std::move(faces), load.vector));
  else if (load.kind == LoadKind::pressure)
    loads.push_back(iga::pressure_load(load.name, std::move(faces), load.pressure));
  else
    loads.push_back(iga::total_force(load.name, std::move(faces), load.vector, built.problem.discretization));
  built.loads.back().total = total_of(loads.back(), built.problem.discretization);
}

// The names of the blocks that the patches were, if they were any.
std::vector<std::string> patch_names(const std::optional<segmentation::ParameterizationReport>& solids) {
  std::vector<std::string> names;
  if (solids)
    for (const auto& patch : solids->patches) names.push_back(patch.name);
  return names;
}

LocatedProbe locate_probe(const ProbeInput& probe, const iga::ElasticityProblem& problem) {
  const MultiPatch& model = problem.discretization.model;
  if (probe.patch) {
    if (*probe.patch >= model.patch_count())
      throw error_at(probe.place, fmt::format("patch {} does not exist: the model has patches 0 to {}",
                                              *probe.patch, model.patch_count() - 1));
    const auto& patch = model.patch(PatchId(*probe.patch));
    const auto parameter = model.from_input(PatchId(*probe.patch), probe.parameter);
    if (((parameter - patch.low()).array() < 0).any() || ((patch.high() - parameter).array() < 0).any())
      throw error_at(probe.place,
                     fmt::format("the parameter lies outside the patch's knots, ({}, {}, {}) to ({}, {}, {})",
                                 patch.low()[0], patch.low()[1], patch.low()[2], patch.high()[0],
                                 patch.high()[1], patch.high()[2]));
    return {probe.name, *probe.patch, parameter};
  }
  iga::ElasticField undeformed;
  undeformed.patches = model.patches();
  for (const auto& patch : model.patches())
    undeformed.displacement.emplace_back(Eigen::Matrix3Xd::Zero(3, patch.size()));
  undeformed.materials = problem.materials;
  const iga::Location location = iga::locate(undeformed, *probe.point);
  if (location.distance > place_tolerance * model.size())
    throw error_at(probe.place, outside_text(model, *probe.point, location));
  return {probe.name, location.patch, location.parameter};
}

}  // namespace

LoadedModel load_model(const ModelInput& input, const Progress& progress) {
  if (input.blocks) {
    segmentation::Parameterization found = parameterized(*input.blocks, progress);
    geometry::PatchSet set = attached(std::move(found.patches), input.attachments);
    return {geometry::connect(std::move(set), input.tolerance), std::move(found.report)};
  }
  geometry::PatchSet set = input.generator ? input.generator() : read_model_file(input.file);
  set = attached(std::move(set), input.attachments);
  return {geometry::connect(scaled(std::move(set), input.length_unit), input.tolerance), std::nullopt};
}

BuiltProblem build_problem(const Study& study, const Progress& progress) {
  progress("reading the model", 0);
  const LoadedModel loaded = load_model(study.model, progress);
  // Before the report, which takes longer.
  assign_materials(study, loaded.model);
  return build_problem(study, loaded, report(loaded.model, progress), progress);
}

BuiltProblem build_problem(const Study& study, const LoadedModel& loaded, const ModelReport& seen,
                           const Progress& progress) {
  const MultiPatch& model = loaded.model;
  const std::vector<iga::Material> materials = assign_materials(study, model);
  progress("refining", 0);
  iga::require_memory(model, iga::solution_knots(model, study.discretization), materials,
                      study.options.coupling, study.options.solver, study.options.processes);
  BuiltProblem built{{iga::discretize(model, study.discretization), materials, {}, {}, {}},
                     seen,
                     {},
                     {},
                     {},
                     certificate_warnings(model, seen)};
  built.parameterization = loaded.parameterization;
  if (built.parameterization)
    for (const std::string& complaint : built.parameterization->complaints())
      built.warnings.push_back({complaint});
  progress("looking for loose bodies", 0);
  for (Warning& warning : loose_body_warnings(model, patch_names(built.parameterization)))
    built.warnings.push_back(std::move(warning));
  for (Warning& warning : input_warnings(study)) built.warnings.push_back(std::move(warning));
  for (const SupportInput& support : study.supports) {
    auto faces = caught_faces(support.selection, support.name, name(support.kind), built, built.supports);
    std::vector<iga::SupportedEdge> edges;
    if (support.edges) {
      edges =
          select_edges(built.problem.discretization.model, faces, *support.edges, support.selection.place);
      built.supports.back() =
          region_of(support.name, name(support.kind), edges, built.problem.discretization.model);
      faces.clear();
    }
    built.supports.back().key = support.key;
    built.problem.supports.push_back({support.name, std::move(faces), support.condition, std::move(edges)});
  }
  for (const LoadInput& load : study.loads) {
    add_load(load, built);
    built.loads.back().key = load.key;
  }
  for (const ProbeInput& probe : study.probes) built.probes.push_back(locate_probe(probe, built.problem));
  if (study.loads.empty())
    built.warnings.push_back({"the study has no load; only prescribed displacements can move the part"});
  return built;
}

}  // namespace isopatch::app
