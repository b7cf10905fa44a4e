#include "app/build_problem.hpp"

#include <fmt/format.h>

#include "app/engineering_units.hpp"
#include "geometry/io/read_patches.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;

geometry::PatchSet scaled(geometry::PatchSet set, double factor) {
  if (factor == 1) return set;
  for (auto& patch : set.patches)
    patch = geometry::NurbsVolume(patch.knots(), patch.control_points() * factor, patch.weights());
  return set;
}

std::vector<iga::Material> assign_materials(const Study& study, int patch_count) {
  std::vector<const MaterialInput*> owner(static_cast<std::size_t>(patch_count), nullptr);
  for (const MaterialInput& input : study.materials)
    for (const PatchId id : select_patches(patch_count, input.patches)) {
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

/// Negative Gauss points can only be in patches that the certificate did not accept.
void refuse_folds(const iga::Discretization& discretization, const ModelReport& report, int points) {
  for (std::size_t i = 0; i < report.patches.size(); ++i) {
    if (report.patches[i].certificate.accepted()) continue;
    const auto quality = geometry::quality(discretization.patches[i], points);
    if (quality.min_jacobian > 0) continue;
    const PatchId id(static_cast<int>(i));
    const auto parameter = discretization.model.renamed(id, quality.worst_parameter);
    throw Error(
        ErrorCode::fold_over,
        fmt::format(
            "patch {} is folded: its Jacobian determinant is {:.3g} m^3 at the Gauss point with parameter "
            "({:.4g}, {:.4g}, {:.4g}), {}. Repair the patch: move its inner control points, or split it",
            i, quality.min_jacobian, parameter[0], parameter[1], parameter[2],
            place_with_unit(discretization.patches[i].point(quality.worst_parameter),
                            discretization.model.size())));
  }
}

void add_load(const LoadInput& load, iga::ElasticityProblem& problem) {
  const MultiPatch& model = problem.discretization.model;
  if (load.kind == LoadKind::body_force || load.kind == LoadKind::gravity) {
    const auto patches = select_patches(model.patch_count(), load.patches);
    if (load.kind == LoadKind::body_force) {
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
    return;
  }
  auto faces = select_faces(model, load.selection);
  if (load.kind == LoadKind::traction)
    problem.surface_loads.push_back(iga::constant_traction(load.name, std::move(faces), load.vector));
  else if (load.kind == LoadKind::pressure)
    problem.surface_loads.push_back(iga::pressure_load(load.name, std::move(faces), load.pressure));
  else
    problem.surface_loads.push_back(iga::total_force(load.name, std::move(faces), load.vector, model));
}

LocatedProbe locate_probe(const ProbeInput& probe, const iga::ElasticityProblem& problem) {
  const MultiPatch& model = problem.discretization.model;
  if (probe.patch) {
    if (*probe.patch >= model.patch_count())
      throw error_at(probe.place, fmt::format("patch {} does not exist: the model has patches 0 to {}",
                                              *probe.patch, model.patch_count() - 1));
    const auto& patch = model.patch(PatchId(*probe.patch));
    const auto parameter = model.renamed(PatchId(*probe.patch), probe.parameter);
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
  if (location.distance > 1e-4 * model.size())
    throw error_at(probe.place, fmt::format("the point {} lies {} outside the part; the nearest patch is {}",
                                            place_with_unit(*probe.point, model.size()),
                                            with_unit(location.distance, "m"), location.patch));
  return {probe.name, location.patch, location.parameter};
}

}  // namespace

MultiPatch load_model(const ModelInput& input) {
  geometry::PatchSet set = input.generator ? input.generator() : geometry::read_patches(input.file);
  return geometry::connect(scaled(std::move(set), input.length_unit), input.tolerance);
}

BuiltProblem build_problem(const Study& study, const Progress& progress) {
  progress("reading the model", 0);
  const MultiPatch model = load_model(study.model);
  const std::vector<iga::Material> materials = assign_materials(study, model.patch_count());
  const ModelReport seen = report(model, progress);
  progress("refining", 0);
  BuiltProblem built{{iga::discretize(model, study.discretization), materials, {}, {}, {}},
                     seen,
                     {},
                     certificate_warnings(model, seen)};
  refuse_folds(built.problem.discretization, seen, study.options.quadrature_points);
  for (const SupportInput& support : study.supports)
    built.problem.supports.push_back(
        {support.name, select_faces(model, support.selection), support.condition});
  for (const LoadInput& load : study.loads) add_load(load, built.problem);
  for (const ProbeInput& probe : study.probes) built.probes.push_back(locate_probe(probe, built.problem));
  if (study.loads.empty())
    built.warnings.push_back("the study has no load; only prescribed displacements can move the part");
  return built;
}

}  // namespace isopatch::app
