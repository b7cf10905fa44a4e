#include "app/study/study_documentation.hpp"

#include <fmt/format.h>

#include "app/base/unit_table.hpp"
#include "app/study/accuracy_keys.hpp"
#include "app/study/attachment_keys.hpp"
#include "app/study/case_keys.hpp"
#include "app/study/generated_models.hpp"
#include "app/study/load_keys.hpp"
#include "app/study/load_tables.hpp"
#include "app/study/material_keys.hpp"
#include "app/study/model_keys.hpp"
#include "app/study/modes_keys.hpp"
#include "app/study/parameterization_keys.hpp"
#include "app/study/reconstruction_keys.hpp"
#include "app/study/section_keys.hpp"
#include "app/study/segmentation_keys.hpp"
#include "app/study/selection_keys.hpp"
#include "app/study/study_keys.hpp"
#include "app/study/support_keys.hpp"
#include "app/study/support_tables.hpp"
#include "geometry/base/nearest_name.hpp"

namespace isopatch::app {
namespace {

constexpr const char* introduction = R"(# The study file

A study is a TOML file. Every key is listed here with its unit, its range and its default. This text is printed by
`isopatch keys`, from the same table that the parser reads by; `isopatch keys NAME` prints one section.

**Quantities.** A number is in SI units: m, kg, s, N, Pa, J, kg/m^3, m/s^2, rad. A string carries its unit:
"20 MPa", "225 mm", "7850 kg/m^3", "9.81 m/s^2", "1 kN", "36 deg", "30 ksi", "2 GB". Known are
{}
(kB and so on are powers of 1000, KiB and so on of 1024); a space, * or / joins them, ^ raises them.
The unit is checked for its dimension.

**Numbering.** Patches count from 0, in the order of the file. Sides and parameters are those of the file, also where
isopatch turned a left-handed patch around.

**From the command line.** `--set discretization.refine=2` replaces one value; elements of arrays count from 0:
`--set load.0.pressure='2 MPa'`.

)";

std::string row(const KeyText& key) {
  std::string type = key.type;
  if (!key.range.empty()) type += ", " + key.range;
  const std::string fallback = key.required ? "required" : key.fallback.empty() ? "-" : key.fallback;
  return fmt::format("| `{}` | {} | {} | {} |\n", key.name, type, fallback, key.meaning);
}

std::string markdown(const SectionText& section) {
  std::string result =
      fmt::format("## {}\n\n{}\n\n| key | type and range | default | meaning |\n|---|---|---|---|\n",
                  section.heading, section.meaning);
  for (const KeyText& key : section.keys) result += row(key);
  return result + "\n";
}

bool concerns(const SectionText& section, const std::string& topic) {
  if (section.name.find(topic) != std::string::npos) return true;
  for (const KeyText& key : section.keys)
    if (key.name == topic) return true;
  return false;
}

}  // namespace

std::vector<SectionText> study_sections() {
  std::vector<SectionText> sections = {
      {"study", "The file", "Keys and tables at the top.", texts(study_keys())},
      {"model", "[model]", "Where the patches come from: a file, or a generated model with its dimensions.",
       texts(model_keys())},
      {"parameterization", "[parameterization]",
       "How topological hexahedra become patches, if [model] has `blocks` or a `file` of solids.",
       texts(parameterization_keys())},
      {"segmentation", "[segmentation]",
       "How solids are cut into topological hexahedra, if [model] has a `file` of solids: along loops on "
       "their boundaries, through "
       "concave edges first, until all parts are hexahedra, prisms over triangles or tetrahedra, which then "
       "become hexahedra.",
       texts(segmentation_keys())},
      {"segmentation.cut", "[[segmentation.cut]]",
       "A plane that cuts the body. Bodies that are cut by hand become pieces that are swept, or are "
       "refused.",
       texts(given_plane_keys())},
      {"reconstruction", "[reconstruction]",
       "How triangles become a solid, if [model] has a `file` of them (.stl, .obj, .ply, .3mf): its faces "
       "are the "
       "planes, cylinders, cones, "
       "spheres and tori that the vertices lie on, its edges are where these meet.",
       texts(reconstruction_keys())}};
  for (const GeneratedModel& model : generated_models())
    sections.push_back({"model." + model.name, fmt::format("[model] with generate = \"{}\"", model.name),
                        model.meaning + " Plain numbers are model units, see `length_unit`.", model.keys});
  sections.push_back(
      {"model.attach", "[[model.attach]]",
       "Adds a patch to each of some faces of the model, straight from the face to its image: a ring in a "
       "bore, a pad, a longer pipe. They are numbered behind the others, in the order of the faces; "
       "their front is the face, their back the image, their first two directions are those of the face, "
       "increasing. Plain numbers are model units, see `length_unit`.",
       texts(attachment_keys({}))});
  const std::vector<SectionText> others = {
      {"discretization", "[discretization]",
       "The solution space: it refines the geometry's, so the geometry stays exact.",
       texts(discretization_keys())},
      {"discretization.patch", "[[discretization.patch]]",
       "What some patches have beyond [discretization]. It continues through neighbours as far as faces have "
       "to match; with "
       "coupling.non_matching = \"nitsche\" or \"mortar\" it ends at the patches' faces.",
       texts(patch_discretization_keys())},
      {"material", "[[material]]",
       "Isotropic and linear elastic: by `lame`, by `young` and `poisson`, or by `name` alone. Every patch "
       "needs exactly one.",
       texts(material_keys())},
      {"material.lame", "[[material]] lame = { ... }", "Lame parameters.", texts(lame_keys())},
      {"support", "[[support]]",
       "One of `displacement` (and or `displacement_gradient`), `symmetry`, `roller`, `cylindrical`, "
       "`elastic`, `free_body`. Where supports meet, all of them apply.",
       texts(support_keys())},
      {"support.cylindrical", "[[support]] cylindrical = { ... }",
       "Radial or tangential alone is held by springs ten thousand times as stiff as the part, at as many "
       "points "
       "as the faces have functions; all else exactly.",
       texts(cylindrical_keys())},
      {"support.elastic", "[[support]] elastic = { ... }",
       "Stiffness per area, or of all faces together; what is given of both adds up.", texts(elastic_keys())},
      {"load", "[[load]]",
       "One of `traction`, `pressure`, `force`, `bearing`, `remote`, `hydrostatic` on faces, or one of "
       "`body_force`, `gravity`, `acceleration`, `rotation`, `temperature` in patches.",
       texts(load_keys())},
      {"load.remote", "[[load]] remote = { ... }",
       "A force and a moment, by the tractions t(x) = a + b x (x - c) that have them, the least in the mean "
       "square: faces deform as they like.",
       texts(remote_keys())},
      {"load.hydrostatic", "[[load]] hydrostatic = { ... }",
       "A liquid: density times gravity times depth below its surface.", texts(hydrostatic_keys())},
      {"load.rotation", "[[load]] rotation = { ... }", "A steady rotation about an axis.",
       texts(rotation_keys())},
      {"load.temperature", "[[load]] temperature = { ... }",
       "A change of temperature, even or linear in the place.", texts(temperature_keys())},
      {"combination", "[[combination]]",
       "A sum of load cases with factors, as codes ask for. It costs no solution; stresses and energies are "
       "computed from the sum.",
       texts(combination_keys())},
      {"where", "where = { ... } of supports and loads",
       "Faces chosen by geometry, because patch numbers mean little where a program made the patches. All "
       "conditions given "
       "must hold at every point of a face; only boundary faces are looked at.",
       texts(where_keys())},
      {"edges", "edges = { ... } of supports",
       "Edges of the patches that have the support's faces, chosen by geometry. All conditions given must "
       "hold "
       "at every point of an edge.",
       texts(edges_keys())},
      {"part", "part = { ... } of supports, loads and patches",
       "A part of faces, bounded by what need not be an edge of a patch. Loads and springs are integrated up "
       "to "
       "its rim. What is held there are the functions of the solution that are largest there, so the rim is "
       "met "
       "to half an element.",
       texts(part_keys())},
      {"where.plane", "where, edges or part = { plane = { ... } }", "A plane.", texts(plane_keys())},
      {"where.cylinder", "where, edges or part = { cylinder = { ... } }", "An infinite cylinder.",
       texts(cylinder_keys())},
      {"where.sphere", "where, edges or part = { sphere = { ... } }", "A sphere.", texts(sphere_keys())},
      {"where.box", "where, edges or part = { box = { ... } }", "A box.", texts(box_keys())},
      {"coupling", "[coupling]", "How the patches are held together.", texts(coupling_keys())},
      {"solver", "[solver]", "How the equations are solved.", texts(solver_keys())},
      {"probe", "[[probe]]",
       "Values at a place: displacement, stress and von Mises stress appear in summary.json.",
       texts(probe_keys())},
      {"section", "[[section]]",
       "The force and moment that one side of a plane cut exerts on the other, in summary.json and on the "
       "pages.",
       texts(section_keys())},
      {"accuracy", "[accuracy]",
       "How accurate `isopatch run` shall be. It solves with the study's discretization, estimates the "
       "error, "
       "halves the elements that it comes from, and solves again until the goal is reached; the table of all "
       "solutions says how. Halved elements continue through neighbouring patches. A goal that is not "
       "reached "
       "is a warning, and in summary.json. Estimates are rather too small than too large, by up to a fifth, "
       "at "
       "sharp edges a third. Other commands pass over it.",
       texts(accuracy_keys())},
      {"modes", "[modes]",
       "Natural frequencies and shapes, by `isopatch modes`; other commands pass over it.",
       texts(modes_keys())},
      {"output", "[output]", "What is written, and where. Files appear whole or not at all.",
       texts(output_keys())}};
  sections.insert(sections.end(), others.begin(), others.end());
  return sections;
}

std::string study_documentation(const std::string& topic) {
  std::string result = topic.empty() ? fmt::format(introduction, known_units()) : "";
  std::vector<std::string> names;
  bool found = false;
  for (const SectionText& section : study_sections()) {
    names.push_back(section.name);
    for (const KeyText& key : section.keys) names.push_back(key.name);
    if (!topic.empty() && !concerns(section, topic)) continue;
    found = true;
    result += markdown(section);
  }
  if (!found)
    throw Error(ErrorCode::invalid_argument, fmt::format("the study file has no section or key '{}'{}", topic,
                                                         did_you_mean(topic, names)));
  result.pop_back();
  return result;
}

}  // namespace isopatch::app
