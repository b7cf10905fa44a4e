#include "app/tests/study_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <cmath>
#include <variant>

#include "app/study/generated_models.hpp"
#include "geometry/measures.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {
namespace {

std::string words_of(const Eigen::Vector3d& v) {
  return fmt::format("{:.6g} {:.6g} {:.6g}", v[0], v[1], v[2]);
}

std::string words_of(const PatchSelection& patches) {
  std::string text;
  for (const auto& [first, last] : patches.ranges) text += fmt::format(" {}-{}", first, last);
  for (const std::string& name : patches.names) text += " " + name;
  return text.empty() ? " all" : text;
}

std::string words_of(const FaceConditions& c, const std::string& of) {
  std::string text;
  if (c.plane)
    text += fmt::format("{} plane point {}\n{} plane normal {}\n", of, words_of(c.plane->point), of,
                        words_of(c.plane->normal));
  if (c.cylinder)
    text += fmt::format("{} cylinder point {}\n{} cylinder axis {}\n{} cylinder radius {:g}\n", of,
                        words_of(c.cylinder->point), of, words_of(c.cylinder->axis), of, c.cylinder->radius);
  if (c.sphere)
    text += fmt::format("{} sphere centre {}\n{} sphere radius {:g}\n", of, words_of(c.sphere->centre), of,
                        c.sphere->radius);
  if (c.box)
    text += fmt::format("{} box min {}\n{} box max {}\n", of, words_of(c.box->min), of, words_of(c.box->max));
  if (c.normal) text += fmt::format("{} normal {}\n", of, words_of(*c.normal));
  text += fmt::format("{} angle {:.6g}\n", of, c.angle.radians());
  if (c.tolerance) text += fmt::format("{} tolerance {:g}\n", of, *c.tolerance);
  return text;
}

std::string words_of(const FaceSelection& selection, const std::string& of) {
  std::string text;
  for (const std::string& face : selection.faces) text += fmt::format("{} face {}\n", of, face);
  if (selection.part) text += words_of(*selection.part, of + " part");
  return text + (selection.where ? words_of(*selection.where, of + " where") : "");
}

std::string words_of(const geometry::PatchSet& set) {
  Eigen::AlignedBox3d box;
  double volume = 0;
  int degree = 0;
  for (const geometry::NurbsVolume& patch : set.patches) {
    for (const Eigen::Vector3d point : patch.control_points().colwise()) box.extend(point);
    volume += std::abs(geometry::volume(patch));
    degree += patch.degree(0);
  }
  const Eigen::Matrix3Xd& points = set.patches.front().control_points();
  return fmt::format(
      "patches {}\nfrom {}\nextent {}\nvolume {:.6g}\nsum of degrees {}\nfirst {}\nlast of the first {}\n",
      set.patches.size(), words_of(box.min()), words_of(box.sizes()), volume, degree, words_of(points.col(0)),
      words_of(points.rightCols<1>().col(0)));
}

std::string words_of_cutting(const BlocksInput& blocks) {
  if (!blocks.decomposition) return "";
  const segmentation::DecompositionOptions& o = *blocks.decomposition;
  std::string planes;
  std::vector<segmentation::GivenPlane> given = o.cuts;
  if (o.symmetry) given.push_back(*o.symmetry);
  for (const segmentation::GivenPlane& plane : given) {
    planes += "plane";
    if (plane.normal) planes += " across " + words_of(*plane.normal);
    if (plane.point) planes += " at " + words_of(*plane.point);
    if (!plane.face.empty()) planes += " of " + plane.face;
    for (const Eigen::Vector3d& point : plane.through) planes += " through " + words_of(point);
    planes += "\n";
  }
  return planes + fmt::format(
                      "cutting seconds {:g}\ncells {}\nbeam {}\nbranches {}\nsmallest cut angle "
                      "{:.4g}\nlargest cut angle "
                      "{:.4g}\ncut edge {:g}\nT-joints {}\nmethod {}\nblends {} up to {:g}\n",
                      o.time_limit, o.max_cells, o.search.beam, o.search.branches,
                      o.cut.smallest_angle.degrees(), o.cut.largest_angle.degrees(), o.cut.shortest_edge,
                      static_cast<int>(o.t_joints), static_cast<int>(o.method), static_cast<int>(o.blends),
                      o.largest_blend);
}

std::string words_of(const segmentation::ReconstructionOptions& o) {
  return fmt::format(
      "regions by {}\nvertices within {:g}\nsmooth below {:.4g}\nsharp from {:.4g}, inside from "
      "{:.4g}\nlarge above {:g}\nsmall below {:g}\nrounds left out {}\nreconstruction seconds {:g}\n",
      static_cast<int>(o.method), o.tolerance, o.smooth.degrees(), o.cutoff.degrees(),
      o.inner_cutoff.degrees(), o.large, o.small, o.remove_blends, o.time_limit);
}

std::string words_of(const BlocksInput& blocks) {
  std::string text;
  for (const auto& file : blocks.files.files) text += fmt::format("block {}\n", file.string());
  if (blocks.files.pairs) text += fmt::format("pairs {}\n", blocks.files.pairs->string());
  if (blocks.files.length_unit) text += fmt::format("length of solids {:g}\n", *blocks.files.length_unit);
  const segmentation::ParameterizationOptions& o = blocks.options;
  return text +
         fmt::format("partial {}\ncad seconds {:g}\ncad bytes {}\nmeeting {:g}\n", blocks.files.allow_partial,
                     blocks.files.limits.seconds, blocks.files.limits.bytes,
                     blocks.files.assembly.same_point) +
         fmt::format("fit of {} degree\nfit method {}\nfit tolerance {:g}\nfit spans {} to {}\n",
                     o.fit.degree, static_cast<int>(o.method), o.fit.tolerance, o.fit.start_spans,
                     o.fit.max_spans) +
         fmt::format("wanted {:g}\noptimize {}\n", o.wanted_quality, o.optimize) + words_of_cutting(blocks) +
         words_of(blocks.reconstruction);
}

std::string words_of(const PatchFile& file) {
  return fmt::format("file {}\nlength unit {:g}\n", file.path.string(), file.length_unit);
}

std::string words_of(const GeneratedInput& generated) {
  return fmt::format("generate number {}\nlength unit {:g}\n", generated.dimensions.index(),
                     generated.length_unit) +
         words_of(generated_patches(generated.dimensions));
}

std::string words_of(const ModelInput& model) {
  std::string text =
      fmt::format("same_point {:g}\nnear_miss {:g}\nsame_knot {:g}\n{}", model.tolerance.same_point,
                  model.tolerance.near_miss, model.tolerance.same_knot,
                  model.tolerance.keep_non_matching ? "non-matching faces kept\n" : "");
  for (const AttachmentInput& a : model.attachments) {
    text += fmt::format("attach name {}\nattach faces {}\n", a.name, fmt::join(a.faces, ","));
    text +=
        fmt::format("attach 0 0 0 goes to {}\n", words_of(Eigen::Vector3d(a.map * Eigen::Vector3d::Zero())));
    text +=
        fmt::format("attach 1 1 1 goes to {}\n", words_of(Eigen::Vector3d(a.map * Eigen::Vector3d::Ones())));
  }
  return text + std::visit([](const auto& source) { return words_of(source); }, model.source);
}

std::string words_of(const MaterialInput& input) {
  const iga::Material& m = input.material;
  return fmt::format(
      "material patches{}\nlambda {:.6g}\nmu {:.6g}\ndensity {:g}\nexpansion {:g}\nyield {:g}\ncalled {}\n",
      words_of(input.patches), m.lambda, m.mu, m.density, m.expansion, m.yield, m.name);
}

std::string words_of(const HeldDisplacement& held) {
  std::string text;
  if (held.edges) text += words_of(*held.edges, "support edges");
  for (const Eigen::Vector3d& point : held.points) text += fmt::format("held point {}\n", words_of(point));
  for (const Eigen::Vector3d& point : held.line) text += fmt::format("held line {}\n", words_of(point));
  for (const auto& value : held.displacement.value)
    text += value ? fmt::format("held {:g}\n", *value) : "free\n";
  return text + fmt::format("gradient {:g}\n", fmt::join(held.displacement.gradient.reshaped(), " "));
}

std::string words_of(const Symmetry&) {
  return "";
}

std::string words_of(const Roller& roller) {
  return fmt::format("support moves {:g}\n", roller.normal_displacement);
}

std::string words_of(const Cylindrical& about) {
  return fmt::format("about radial {} tangential {} axial {}\nabout {}\nabout axis {}\n", about.radial,
                     about.tangential, about.axial, about.point ? words_of(*about.point) : "own",
                     about.axis ? words_of(*about.axis) : "own");
}

std::string words_of(const Elastic& springs) {
  return fmt::format("springs {:g} and {:g}, in all {:g} and {:g}\n", springs.normal, springs.tangential,
                     springs.total_normal, springs.total_tangential);
}

std::string words_of(const FreeBody&) {
  return "";
}

std::string words_of(const SupportInput& input) {
  return fmt::format("support key {}\nsupport kind {}\nsupport cases {}\n", input.key, kind_name(input),
                     fmt::join(input.cases, " ")) +
         words_of(input.selection, "support") +
         std::visit([](const auto& condition) { return words_of(condition); }, input.condition);
}

std::string value_text(const Eigen::Vector3d& vector) {
  return words_of(vector);
}

std::string value_text(double pressure) {
  return fmt::format("{:g}", pressure);
}

std::string value_text(const iga::RemoteForce& remote) {
  return fmt::format("force {} moment {} at {}", words_of(remote.force), words_of(remote.moment),
                     remote.point ? words_of(*remote.point) : "centroid");
}

std::string value_text(const iga::Liquid& liquid) {
  return fmt::format("of {:g} from {} to {}", liquid.density, words_of(liquid.surface),
                     words_of(liquid.gravity));
}

std::string value_text(const iga::TemperatureChange& t) {
  return fmt::format("by {:g} and {} from {}", t.change, words_of(t.gradient), words_of(t.point));
}

std::string value_text(const iga::Rotation& rotation) {
  return fmt::format("with {:g} about {} along {}", rotation.speed, words_of(rotation.point),
                     words_of(rotation.axis));
}

std::string words_of(const AppliedLoad& input) {
  std::string text =
      fmt::format("load key {}\nload {} {}\n", input.key, kind_name(input),
                  std::visit([](const auto& load) { return value_text(load.value); }, input.load));
  text += fmt::format("load cases {}\n", fmt::join(input.cases, " "));
  if (const PatchSelection* patches = patches_of(input))
    text += fmt::format("load patches{}\n", words_of(*patches));
  if (const FaceSelection* faces = faces_of(input)) text += words_of(*faces, "load");
  if (const auto* force = std::get_if<Force>(&input.load)) {
    for (const Eigen::Vector3d& point : force->points)
      text += fmt::format("load point {}\n", words_of(point));
    for (const Eigen::Vector3d& point : force->line) text += fmt::format("load line {}\n", words_of(point));
  }
  return text;
}

std::string words_of(const ProbeInput& input) {
  if (const auto* point = std::get_if<Eigen::Vector3d>(&input.where))
    return fmt::format("probe {}\nprobe point {}\n", input.name, words_of(*point));
  const auto& where = std::get<PatchParameter>(input.where);
  return fmt::format("probe {}\nprobe patch {}\nprobe parameter {}\n", input.name, where.patch,
                     words_of(where.parameter));
}

std::string words_of(const iga::ElasticityOptions& o) {
  const solvers::SolverOptions& s = o.solver;
  return fmt::format(
             "points {}\ncoupling {}\nnon-matching faces by {}{}\nmethod {}\ntolerance {:g}\niterations {}\n",
             o.quadrature_points, iga::name(o.coupling), iga::name(o.non_matching),
             o.mortar_side == iga::MortarSide::other ? "\nmortar on the other side" : "", name(s.method),
             s.tolerance, s.max_iterations) +
         fmt::format("preconditioner {}\noperator {}\nsmoothing {} over {:g}\nmemory {:g}\n",
                     name(s.preconditioner), name(s.form), s.multigrid.smoothing_degree,
                     s.multigrid.smoothing_range, s.memory_limit);
}

std::string words_of(const OutputInput& o) {
  return fmt::format(
      "directory {}\nfields {}\npieces {}\nexact {}\nprecision {}\nhdf5 {}\nreport {}\nstages {}\nerror "
      "estimate "
      "{}\nmoments about {}\n",
      o.directory.string(), o.fields, o.field_options.pieces, o.field_options.exact,
      static_cast<int>(o.field_options.precision), o.hdf5, o.report, o.stages, o.error_estimate,
      words_of(o.moments_about));
}

}  // namespace

std::string words_of(const Study& study) {
  const iga::DiscretizationOptions& d = study.discretization;
  std::string text = fmt::format("title {}\n", study.title) + words_of(study.model) +
                     fmt::format("degree {}\nrefine {}\nelements {}\nmax_size {:g}\ncontinuity {}\n",
                                 d.degree, d.refine, d.elements_per_direction, d.max_size, d.continuity);
  for (const PatchDiscretizationInput& input : study.patch_discretizations) {
    const iga::PatchRefinement& own = input.refinement;
    text += fmt::format(
        "patches of their own{}\n{}own degree {}\nown refine {}\nown elements {}\nown size {:g}\n",
        words_of(input.patches), input.reach.part ? words_of(*input.reach.part, "own part") : "", own.degree,
        own.refine, own.elements_per_direction, own.max_size);
  }
  for (const MaterialInput& input : study.materials) text += words_of(input);
  for (const SupportInput& input : study.supports) text += words_of(input);
  for (const AppliedLoad& input : study.loads) text += words_of(input);
  for (const CombinationInput& input : study.combinations) {
    text += "combination " + input.name;
    for (const auto& [name, factor] : input.factors) text += fmt::format(" {} {:g}", name, factor);
    text += "\n";
  }
  for (const ProbeInput& input : study.probes) text += words_of(input);
  for (const SectionInput& input : study.sections)
    text += fmt::format("section {}\nsection point {}\nsection normal {}\nsection radius {:g}\n", input.name,
                        words_of(input.plane.point), words_of(input.plane.normal), input.plane.radius);
  text += fmt::format("modes {}\nmodes free {}\nmodes counted {}\n", study.modes.number, study.modes.is_free,
                      study.modes.count);
  const AccuracyInput& a = study.accuracy;
  text +=
      fmt::format("accuracy energy {:g}\naccuracy stress {:g}\naccuracy probe {}\naccuracy refinements {}\n",
                  a.energy.value_or(0), a.stress.value_or(0), a.probe, a.refinements);
  return "\n" + text + words_of(study.options) + words_of(study.output);
}

}  // namespace isopatch::app
