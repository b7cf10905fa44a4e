#include "app/problem/build_problem.hpp"
#include "app/base/place_tolerance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "app/base/overloaded.hpp"
#include "app/base/place_outside.hpp"
#include "app/base/place_text.hpp"
#include "app/problem/attachment.hpp"
#include "app/problem/corner_selection.hpp"
#include "app/problem/discretization_of.hpp"
#include "app/problem/edge_selection.hpp"
#include "app/problem/face_part.hpp"
#include "app/problem/held_part_warning.hpp"
#include "app/problem/located_points.hpp"
#include "app/problem/loose_bodies.hpp"
#include "app/problem/plausibility.hpp"
#include "app/problem/read_model_file.hpp"
#include "app/problem/selection.hpp"
#include "app/problem/solid_stages.hpp"
#include "app/study/generated_models.hpp"
#include "geometry/attach.hpp"
#include "geometry/io/read_patches.hpp"
#include "iga/problem/bearing_load.hpp"
#include "iga/problem/face_axis.hpp"
#include "iga/problem/hydrostatic_load.hpp"
#include "iga/problem/loads.hpp"
#include "iga/problem/remote_load.hpp"
#include "iga/problem/rotation_load.hpp"
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

/// Faces, and where on them.
struct CaughtFaces {
  std::vector<geometry::PatchFace> faces;
  iga::Region region;
};

/// The faces of a support or a load, with its share of the report and a warning if some are missed by little.
CaughtFaces caught_faces(const FaceSelection& selection, const std::string& name, std::string_view kind,
                         BuiltProblem& built, std::vector<AppliedRegion>& regions) {
  const MultiPatch& model = built.problem.discretization.model;
  SelectedFaces selected = select_faces(model, selection);
  CaughtFaces caught{std::move(selected.faces), part_of(selection)};
  if (selection.part) {
    caught.faces = faces_reaching_into(caught.region, model, caught.faces, selection.place);
    refuse_covered_part(caught.region, model, caught.faces, selection.place);
  }
  regions.push_back(region_of(name, kind, caught.faces, built.report));
  regions.back().given = selection.faces;
  if (selection.part) {
    regions.back().is_part = true;
    regions.back().area = iga::area_of(model.patches(), caught.faces, caught.region);
  }
  const std::string warning = near_miss_warning(model, selection, name, selected);
  if (!warning.empty()) built.warnings.push_back({warning});
  return caught;
}

// Lines and points take forces by stresses without limit.
void warn_of_singular(const Place& place, const std::string& name, const char* what, BuiltProblem& built) {
  built.warnings.push_back(
      {fmt::format("{}: {} {}: where that takes a force, stresses grow without limit as elements become "
                   "small, and so does what gives way; look at them elsewhere",
                   to_string(place), name, what)});
}

Eigen::Vector3d total_of(const iga::SurfaceLoad& load, const iga::Discretization& discretization) {
  Eigen::Vector3d total = Eigen::Vector3d::Zero();
  for (const geometry::PatchFace& face : load.faces)
    total += iga::face_load(discretization.patches[static_cast<std::size_t>(face.patch.value)], face.side,
                            load.traction, load.region)
                 .rowwise()
                 .sum();
  return total;
}

/// Adds a load to a problem and to the list of what loads caught.
class LoadAdder {
 public:
  LoadAdder(const AppliedLoad& load, BuiltProblem& built) : load_(load), built_(built) {}

  void operator()(const Traction& traction) {
    CaughtFaces on = faces_on(traction.selection);
    add(iga::constant_traction(load_.name, std::move(on.faces), traction.value, on.region));
  }
  void operator()(const Pressure& pressure) {
    CaughtFaces on = faces_on(pressure.selection);
    add(iga::pressure_load(load_.name, std::move(on.faces), pressure.value, on.region));
  }
  void operator()(const Force& force) {
    if (!force.points.empty()) return add_points(force);
    if (!force.line.empty()) return add_line(force);
    add(placed(
        [&](const CaughtFaces& on) {
          return iga::total_force(load_.name, on.faces, force.value, built_.problem.discretization,
                                  on.region);
        },
        force.selection));
  }
  void operator()(const Bearing& bearing) {
    add(placed(
        [&](const CaughtFaces& on) {
          return iga::bearing_load(load_.name, on.faces, bearing.value, built_.problem.discretization,
                                   on.region);
        },
        bearing.selection));
  }
  void operator()(const Remote& remote) {
    add(placed(
        [&](const CaughtFaces& on) {
          return iga::remote_load(load_.name, on.faces, remote.value, built_.problem.discretization,
                                  on.region);
        },
        remote.selection));
  }
  void operator()(const Hydrostatic& liquid) {
    add(placed(
        [&](const CaughtFaces& on) {
          return iga::hydrostatic_load(load_.name, on.faces, liquid.value, built_.problem.discretization,
                                       on.region);
        },
        liquid.selection));
  }
  void operator()(const BodyForce& force) {
    const auto patches = patches_in(force.patches);
    for (const PatchId id : patches) total() += volume(id) * force.value;
    built_.problem.volume_loads.push_back(
        {load_.name, patches, [f = force.value](const Eigen::Vector3d&) { return f; }});
  }
  void operator()(const Gravity& gravity) { add_weight(gravity.patches, gravity.value); }
  void operator()(const Acceleration& acceleration) { add_weight(acceleration.patches, -acceleration.value); }
  void operator()(const Rotating& rotating) {
    const auto patches = patches_in(rotating.patches);
    for (auto& load : at_place([&] {
           return iga::rotation_load(load_.name, patches, rotating.value, built_.problem.materials);
         })) {
      total() += iga::total_force(load, built_.problem.discretization);
      built_.problem.volume_loads.push_back(std::move(load));
    }
  }
  void operator()(const Temperature& temperature) {
    iga::TemperatureLoad load{load_.name, patches_in(temperature.patches), temperature.value};
    at_place([&] { return iga::thermal_strains({load}, built_.problem.materials); });
    built_.problem.temperatures.push_back(std::move(load));
  }

 private:
  /// What `make()` gives; its errors get the load's place in the study.
  template <class Make>
  std::invoke_result_t<Make> at_place(Make make) {
    try {
      return make();
    } catch (const Error& error) {
      throw error_at(load_.place, error.what(), error.code());
    }
  }
  template <class Make>
  iga::SurfaceLoad placed(Make make, const FaceSelection& selection) {
    const CaughtFaces on = faces_on(selection);
    return at_place([&] { return make(on); });
  }
  void add_points(const Force& force) {
    add_at(force, located_points(built_.problem.discretization.model, force.points, load_.place),
           "acts at points");
    built_.loads.back().points = static_cast<int>(force.points.size());
  }
  void add_line(const Force& force) {
    add_at(force, located_line(built_.problem.discretization.model, force.line, load_.place),
           "acts along a line");
    built_.loads.back().length = length_of(force.line);
  }
  void add_at(const Force& force, std::vector<iga::PatchPoint> points, const char* how) {
    built_.loads.push_back(
        region_of(load_.name, kind_name(load_), std::vector<geometry::PatchFace>{}, built_.report));
    built_.problem.point_loads.push_back({load_.name, force.value, std::move(points)});
    total() = force.value;
    warn_of_singular(load_.place, load_.name, how, built_);
  }
  void add_weight(const PatchSelection& selection, const Eigen::Vector3d& acceleration) {
    const auto patches = patches_in(selection);
    const auto& materials = built_.problem.materials;
    for (auto& weight : at_place([&] { return iga::gravity(load_.name, patches, acceleration, materials); }))
      built_.problem.volume_loads.push_back(std::move(weight));
    for (const PatchId id : patches)
      total() += volume(id) * materials[static_cast<std::size_t>(id.value)].density * acceleration;
  }
  CaughtFaces faces_on(const FaceSelection& selection) {
    return caught_faces(selection, load_.name, kind_name(load_), built_, built_.loads);
  }
  std::vector<PatchId> patches_in(const PatchSelection& selection) {
    auto patches = select_patches(built_.problem.discretization.model, selection);
    built_.loads.push_back(region_of(load_.name, kind_name(load_), patches, built_.report));
    return patches;
  }
  void add(iga::SurfaceLoad load) {
    total() = total_of(load, built_.problem.discretization);
    built_.problem.surface_loads.push_back(std::move(load));
  }
  double volume(PatchId id) const { return built_.report.patches[static_cast<std::size_t>(id.value)].volume; }
  Eigen::Vector3d& total() { return built_.loads.back().total; }

  const AppliedLoad& load_;
  BuiltProblem& built_;
};

/// A support's condition as the solver takes it.
struct SupportCondition {
  using Condition = decltype(iga::Support::condition);
  Condition operator()(const HeldDisplacement& held) const { return held.displacement; }
  Condition operator()(const Symmetry&) const { return iga::PlaneSupport{}; }
  Condition operator()(const Roller& roller) const { return iga::PlaneSupport{roller.normal_displacement}; }
  Condition operator()(const Cylindrical& about) const {
    iga::CylindricalSupport result{
        .radial = about.radial, .tangential = about.tangential, .axial = about.axial};
    if (about.point) {
      result.point = *about.point;
      result.axis = *about.axis;
      return result;
    }
    const iga::FaceAxis axis = iga::face_axis(model, faces);
    constexpr double tilted = 1e-3;
    if (!(axis.off <= place_tolerance * model.size() && axis.tilt <= tilted))
      throw error_at(place,
                     "cylindrical: the faces are no cylinders about one axis; choose those of one bore or "
                     "shaft, or give point and axis");
    result.point = axis.point;
    result.axis = axis.direction;
    return result;
  }
  Condition operator()(const Elastic& springs) const {
    return iga::ElasticSupport{springs.normal + springs.total_normal / area,
                               springs.tangential + springs.total_tangential / area};
  }
  Condition operator()(const FreeBody&) const { return iga::FreeBodySupport{}; }

  const MultiPatch& model;
  const std::vector<geometry::PatchFace>& faces;
  double area = 0;  // of the faces, m^2
  Place place;
};

// Springs cannot move what they hold; said here, where the study's line is known.
void require_held_at_zero(const iga::Support& made, const Place& place) {
  const auto* held = std::get_if<iga::PrescribedDisplacement>(&made.condition);
  const bool moves =
      held && (!held->gradient.isZero(0) || std::any_of(held->value.begin(), held->value.end(),
                                                        [](const auto& u) { return u.value_or(0) != 0; }));
  if (moves && !made.points.empty())
    throw error_at(place, made.name +
                              " moves points or a line that are no corners of patches: these can be held "
                              "where they are, with a displacement of 0, and not moved");
}

// The places that a support holds instead of faces: corners of patches as such, others as points.
void hold_points(const HeldDisplacement& held, const Place& place, const MultiPatch& model,
                 iga::Support& made, AppliedRegion& region) {
  for (const Eigen::Vector3d& wanted : held.points) {
    const auto corners = corners_at(model, wanted);
    made.corners.insert(made.corners.end(), corners.begin(), corners.end());
    if (!corners.empty()) continue;
    const auto points = located_points(model, {wanted}, place);
    made.points.insert(made.points.end(), points.begin(), points.end());
  }
  region.points = static_cast<int>(held.points.size());
  if (held.line.empty()) return;
  made.points = located_line(model, held.line, place);
  region.length = length_of(held.line);
}

void add_support(const SupportInput& support, BuiltProblem& built) {
  const MultiPatch& model = built.problem.discretization.model;
  const Place& place = support.selection.place;
  iga::Support made{support.name, {}, iga::FreeBodySupport{}};
  const auto* held = std::get_if<HeldDisplacement>(&support.condition);
  const bool has_points = held && !(held->points.empty() && held->line.empty());
  if (std::holds_alternative<FreeBody>(support.condition) || has_points) {
    built.supports.push_back(region_of(support.name, kind_name(support), made.faces, built.report));
  } else {
    CaughtFaces caught =
        caught_faces(support.selection, support.name, kind_name(support), built, built.supports);
    made.faces = std::move(caught.faces);
    made.region = std::move(caught.region);
  }
  made.condition =
      std::visit(SupportCondition{model, made.faces, built.supports.back().area, place}, support.condition);
  if (held && held->edges) {
    made.edges = select_edges(model, made.faces, *held->edges, place);
    built.supports.back() = region_of(support.name, kind_name(support), made.edges, model);
    built.supports.back().given = support.selection.faces;
    made.faces.clear();
    warn_of_singular(place, support.name, "holds lines", built);
  }
  if (has_points) {
    hold_points(*held, place, model, made, built.supports.back());
    warn_of_singular(place, support.name, held->line.empty() ? "holds points" : "holds a line", built);
  }
  built.supports.back().key = support.key;
  require_held_at_zero(made, place);
  built.problem.supports.push_back(std::move(made));
}

// The names of the blocks that the patches were, if they were any.
std::vector<std::string> patch_names(const std::optional<segmentation::ParameterizationReport>& solids) {
  std::vector<std::string> names;
  if (solids)
    for (const auto& patch : solids->patches) names.push_back(patch.name);
  return names;
}

LocatedProbe locate_probe(const ProbeInput& probe, const PatchParameter& where, const MultiPatch& model) {
  if (where.patch >= model.patch_count())
    throw error_at(probe.place, fmt::format("patch {} does not exist: the model has patches 0 to {}",
                                            where.patch, model.patch_count() - 1));
  const auto& patch = model.patch(PatchId(where.patch));
  const auto parameter = model.from_input(PatchId(where.patch), where.parameter);
  if (((parameter - patch.low()).array() < 0).any() || ((patch.high() - parameter).array() < 0).any())
    throw error_at(probe.place, fmt::format("the parameter lies outside the patch's knots, {} to {}",
                                            place_text(patch.low()), place_text(patch.high())));
  return {probe.name, where.patch, parameter};
}

LocatedProbe locate_probe(const ProbeInput& probe, const Eigen::Vector3d& point,
                          const iga::ElasticityProblem& problem) {
  const MultiPatch& model = problem.discretization.model;
  iga::ElasticField undeformed;
  undeformed.patches = model.patches();
  for (const auto& patch : model.patches())
    undeformed.displacement.emplace_back(Eigen::Matrix3Xd::Zero(3, patch.size()));
  undeformed.materials = problem.materials;
  const iga::Location location = iga::locate(undeformed, point);
  if (location.distance > place_tolerance * model.size())
    throw error_at(probe.place, outside_text(model, point, location));
  return {probe.name, location.patch, location.parameter};
}

LocatedProbe locate_probe(const ProbeInput& probe, const iga::ElasticityProblem& problem) {
  if (const auto* point = std::get_if<Eigen::Vector3d>(&probe.where))
    return locate_probe(probe, *point, problem);
  return locate_probe(probe, std::get<PatchParameter>(probe.where), problem.discretization.model);
}

LocatedSection locate_section(const SectionInput& section, const iga::Discretization& discretization) {
  LocatedSection result{section.name, section.plane,
                        iga::section_points(discretization.patches, section.plane)};
  if (result.points.empty())
    throw error_at(section.place,
                   fmt::format("{}: the plane does not cut the part{}", section.name,
                               std::isfinite(section.plane.radius) ? " within the radius" : ""));
  return result;
}

/// Patches of a source, before anything is attached to them.
struct SourcePatches {
  geometry::PatchSet set;
  double length_unit = 1;  ///< m per unit of the patches
  std::optional<segmentation::ParameterizationReport> parameterization = {};
  std::vector<StageReport> stages = {};
};

SourcePatches patches_of(const ModelInput& input, const Progress& progress) {
  return std::visit(Overloaded{[](const PatchFile& file) -> SourcePatches {
                                 return {read_model_file(file.path), file.length_unit};
                               },
                               [&](const BlocksInput& solids) -> SourcePatches {
                                 StagedPatches found = staged_patches(solids, Stage::patches, progress);
                                 return {std::move(found.made->patches), 1, std::move(found.made->report),
                                         std::move(found.stages)};
                               },
                               [&](const GeneratedInput& model) -> SourcePatches {
                                 try {
                                   return {generated_patches(model.dimensions), model.length_unit};
                                 } catch (const Error& error) {
                                   throw error_at(input.place, error.what(), error.code());
                                 }
                               }},
                    input.source);
}

}  // namespace

LoadedModel load_model(const ModelInput& input, const Progress& progress) {
  SourcePatches found = patches_of(input, progress);
  geometry::PatchSet set = scaled(attached(std::move(found.set), input.attachments), found.length_unit);
  return {geometry::connect(std::move(set), input.tolerance), std::move(found.parameterization),
          std::move(found.stages)};
}

ReportedModel reported_model(const Study& study, const Progress& progress) {
  progress("reading the model", 0);
  LoadedModel loaded = load_model(study.model, progress);
  // Before the report, which takes longer.
  assign_materials(study, loaded.model);
  ModelReport seen = report(loaded.model, progress);
  return {std::move(loaded), std::move(seen)};
}

void warn_of_no_load(const Study& study, BuiltProblem& built) {
  if (study.loads.empty())
    built.warnings.push_back({"the study has no load; only prescribed displacements can move the part"});
}

BuiltProblem build_problem(const Study& study, const Progress& progress) {
  const ReportedModel model = reported_model(study, progress);
  return build_problem(study, model.loaded, model.report, progress);
}

BuiltProblem build_problem(const Study& study, const LoadedModel& loaded, const ModelReport& seen,
                           const Progress& progress) {
  const MultiPatch& model = loaded.model;
  const std::vector<iga::Material> materials = assign_materials(study, model);
  progress("refining", 0);
  const iga::DiscretizationOptions discretization = discretization_of(study, model);
  const iga::DirectionKnots knots = iga::solution_knots(model, discretization);
  iga::require_memory(iga::solution_model(model, knots), knots, materials, study.options.coupling,
                      study.options.non_matching, study.options.solver, study.options.processes);
  BuiltProblem built{{iga::discretize(model, discretization), materials, {}, {}, {}},
                     seen,
                     {},
                     {},
                     {},
                     certificate_warnings(model, seen)};
  // Patches with functions of their own do not match any more.
  if (const MultiPatch& solved = built.problem.discretization.model;
      solved.non_matching().size() != model.non_matching().size()) {
    built.report.non_matching.clear();
    add_non_matching(solved, built.report);
  }
  built.parameterization = loaded.parameterization;
  built.stages = loaded.stages;
  for (const StageReport& stage : built.stages)
    if (!stage.problem.empty())
      built.warnings.push_back({fmt::format("{} could not be kept for further runs: {}",
                                            name_of(stage_choices(), stage.stage), stage.problem)});
  if (built.parameterization)
    for (const std::string& complaint : built.parameterization->complaints())
      built.warnings.push_back({complaint});
  progress("looking for loose bodies", 0);
  for (Warning& warning : loose_body_warnings(model, patch_names(built.parameterization)))
    built.warnings.push_back(std::move(warning));
  for (Warning& warning : input_warnings(study)) built.warnings.push_back(std::move(warning));
  for (Warning& warning : idle_refinement_warnings(study)) built.warnings.push_back(std::move(warning));
  for (const SupportInput& support : study.supports) add_support(support, built);
  for (Warning& warning : held_part_warnings(built.problem)) built.warnings.push_back(std::move(warning));
  for (const AppliedLoad& load : study.loads) {
    std::visit(LoadAdder(load, built), load.load);
    built.loads.back().key = load.key;
  }
  for (const ProbeInput& probe : study.probes) built.probes.push_back(locate_probe(probe, built.problem));
  for (const SectionInput& section : study.sections)
    built.sections.push_back(locate_section(section, built.problem.discretization));
  built.mass = mass_properties(model, materials);
  return built;
}

}  // namespace isopatch::app
