// Every key of the study file is read, and changes what the study says.

#include "app/study/study_documentation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/study/parse_study.hpp"
#include "app/tests/study_words.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

// A key at work: the line of `words_of` that the study has with it and has not without it.
struct Shown {
  std::string key;
  std::string assignment;   ///< as one writes it, on one line
  std::string line;         ///< empty: all that is sure is that something changes
  std::string before = "";  ///< what the section needs beside it
};

struct ShownSection {
  std::string name;     ///< as in `study_sections`
  std::string heading;  ///< what opens the section in a file
  std::vector<Shown> keys;
};

const std::string box = "generate = \"box\"\n";
const std::string solid = "blocks = [\"one.step\"]\n";
const std::string steel = "young = 1e9\npoisson = 0.25\n";
const std::string held = "faces = [\"x_min\"]\n";
const std::string displaced = held + "displacement = [0, 0, 0]\n";

ShownSection model_section(const std::string& name, const std::vector<Shown>& keys) {
  return {"model." + name, "[model]\ngenerate = \"" + name + "\"\n", keys};
}

std::vector<ShownSection> sections_of_the_model() {
  return {{"study",
           "",
           {{"title", "title = \"all\"", "title all"},
            {"model", "model = { generate = \"cook\" }", "generate number 6"},
            {"parameterization", "parameterization = { degree = 5 }", "fit of 5 degree",
             "model = { blocks = [\"a.step\"] }\n"},
            {"segmentation", "segmentation = { beam = 3 }", "beam 3", "model = { file = \"a.step\" }\n"},
            {"reconstruction", "reconstruction = { tolerance = 1e-5 }", "vertices within 1e-05",
             "model = { file = \"a.stl\" }\n"},
            {"discretization", "discretization = { refine = 3 }", "refine 3"},
            {"material", "material = [{ young = 2e9, poisson = 0.25 }]", "mu 8e+08"},
            {"support", "support = [{ name = \"wall\", faces = [\"x_min\"], symmetry = true }]",
             "support key wall"},
            {"load", "load = [{ name = \"weight\", gravity = [0, 0, 1] }]", "load key weight"},
            {"combination", "combination = [{ factors = { wind = 2 } }]", "combination combination_1 wind 2"},
            {"coupling", "coupling = { method = \"lagrange\" }", "coupling lagrange"},
            {"solver", "solver = { max_iterations = 7 }", "iterations 7"},
            {"probe", "probe = [{ name = \"tip\", point = [0, 0, 1] }]", "probe tip"},
            {"section", "section = [{ point = [0, 0, 1], normal = \"z\" }]", "section section 1"},
            {"modes", "modes = { number = 7 }", "modes 7"},
            {"accuracy", "accuracy = { energy = 0.02 }", "accuracy energy 0.02"},
            {"output", "output = { pieces = 5 }", "pieces 5"}}},
          {"model",
           "[model]\n",
           {{"file", "file = \"patches.xml\"", "file folder/patches.xml"},
            {"blocks", "blocks = [\"one.step\", \"/two.step\"]", "block /two.step"},
            {"pairs", "pairs = \"pairs.txt\"", "pairs folder/pairs.txt", solid},
            {"generate", "generate = \"cook\"", "generate number 6"},
            {"attach", "attach = [{ faces = [\"x_max\"], move = [1, 0, 0] }]", "attach faces x_max", box},
            {"length_unit", "length_unit = \"225 mm\"", "length unit 0.225", box},
            {"allow_partial", "allow_partial = true", "partial true", solid},
            {"cad_time_limit", "cad_time_limit = 77", "cad seconds 77", solid},
            {"cad_memory_limit", "cad_memory_limit = 1e9", "cad bytes 1000000000", solid},
            {"same_point", "same_point = 1e-5", "same_point 1e-05", box},
            {"near_miss", "near_miss = 1e-2", "near_miss 0.01", box},
            {"same_knot", "same_knot = 1e-8", "same_knot 1e-08", box}}},
          {"parameterization",
           "[model]\n" + solid + "[parameterization]\n",
           {{"method", "method = \"paper\"", "fit method 1"},
            {"tolerance", "tolerance = 1e-3", "fit tolerance 0.001"},
            {"degree", "degree = 4", "fit of 4 degree"},
            {"start_spans", "start_spans = 2", "fit spans 2 to 64"},
            {"max_spans", "max_spans = 32", "fit spans 1 to 32"},
            {"wanted_quality", "wanted_quality = 0.4", "wanted 0.4"},
            {"optimize", "optimize = false", "optimize false"},
            {"same_point", "same_point = 2e-3", "meeting 0.002"}}},
          {"segmentation",
           "[model]\nfile = \"one.step\"\n[segmentation]\n",
           {{"t_joints", "t_joints = \"keep\"", "T-joints 1"},
            {"method", "method = \"cuts\"", "method 1"},
            {"blends", "blends = \"remove\"", "blends 1 up to 0.1"},
            {"largest_blend", "largest_blend = 0.2", "blends 0 up to 0.2"},
            {"cut", "cut = [{ normal = \"y\" }]", "plane across 0 1 0"},
            {"symmetry", "symmetry = \"z\"", "plane across 0 0 1"},
            {"time_limit", "time_limit = 7", "cutting seconds 7"},
            {"max_cells", "max_cells = 70", "cells 70"},
            {"beam", "beam = 3", "beam 3"},
            {"branches", "branches = 5", "branches 5"},
            {"smallest_angle", "smallest_angle = \"8 deg\"", "smallest cut angle 8"},
            {"largest_angle", "largest_angle = \"150 deg\"", "largest cut angle 150"},
            {"shortest_edge", "shortest_edge = 0.01", "cut edge 0.01"}}},
          {"segmentation.cut",
           "[model]\nfile = \"one.step\"\n[[segmentation.cut]]\n",
           {{"normal", "normal = [0, 0, 2]", "plane across 0 0 1"},
            {"point", "point = [1, \"20 mm\", 0]", "plane across 1 0 0 at 1 0.02 0", "normal = \"x\"\n"},
            {"face", "face = \"face 3\"", "plane of face 3"},
            {"through", "through = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]",
             "plane through 0 0 0 through 1 0 0 through 0 1 0"}}},
          {"reconstruction",
           "[model]\nfile = \"one.stl\"\n[reconstruction]\n",
           {{"method", "method = \"angles\"", "regions by 1"},
            {"tolerance", "tolerance = 1e-5", "vertices within 1e-05"},
            {"smooth", "smooth = \"30 deg\"", "smooth below 30"},
            {"cutoff", "cutoff = \"12 deg\"", "sharp from 12, inside from 15"},
            {"inner_cutoff", "inner_cutoff = \"20 deg\"", "sharp from 40, inside from 20"},
            {"large", "large = 0.3", "large above 0.3"},
            {"small", "small = 2", "small below 2"},
            {"blends", "blends = \"remove\"", "rounds left out true"},
            {"time_limit", "time_limit = 7", "reconstruction seconds 7"}}},
          {"model.attach",
           "[model]\n" + box + "[[model.attach]]\n",
           {{"faces", "faces = [\"0:east\"]", "attach faces 0:east", "move = [1, 0, 0]\n"},
            {"scale", "scale = [1, 2, 3]", "attach 1 1 1 goes to 1 2 3", "faces = [\"x_max\"]\n"},
            {"about", "about = [1, 0, 0]", "attach 0 0 0 goes to -1 0 0", "faces = [\"x_max\"]\nscale = 2\n"},
            {"move", "move = [1, 2, 3]", "attach 0 0 0 goes to 1 2 3", "faces = [\"x_max\"]\n"},
            {"name", "name = \"ring\"", "attach name ring", "faces = [\"x_max\"]\nscale = 2\n"}}}};
}

// Volumes and extents by hand; "extent" and "first" are of control points, which pass arcs.
std::vector<ShownSection> sections_of_generated_models() {
  return {
      model_section("box", {{"size", "size = [2, 3, 4]", "extent 2 3 4"},
                            {"origin", "origin = [1, 2, 3]", "from 1 2 3"},
                            {"patches", "patches = [2, 3, 4]", "patches 24"},
                            {"distortion", "distortion = 0.3", "", "patches = [2, 2, 2]\n"},
                            {"curvature", "curvature = 0.3", "sum of degrees 2"},
                            {"distort_faces", "distort_faces = false", "last of the first 0.5 0.5 1",
                             "patches = [2, 2, 1]\ndistortion = 0.3\n"},
                            {"seed", "seed = 2", "", "patches = [2, 2, 2]\ndistortion = 0.3\n"},
                            {"orientation_seed", "orientation_seed = 5", ""}}),
      model_section("cylinder", {{"inner_radius", "inner_radius = 0.5", "volume 1.47262"},
                                 {"outer_radius", "outer_radius = 3", "volume 3.14159"},
                                 {"height", "height = 2", "volume 4.71239"},
                                 {"angle", "angle = \"180 deg\"", "volume 2.35619"},
                                 {"radial_patches", "radial_patches = 3", "patches 3"},
                                 {"axial_patches", "axial_patches = 4", "patches 4"},
                                 {"patches_around", "patches_around = 5", "patches 5"}}),
      model_section("link", {{"distance", "distance = 120", "volume 34071.4"},
                             {"left_bore_radius", "left_bore_radius = 8", "volume 31588.6"},
                             {"right_bore_radius", "right_bore_radius = 6", "volume 30721.5"},
                             {"left_outer_radius", "left_outer_radius = 24", "volume 36183.7"},
                             {"right_outer_radius", "right_outer_radius = 15", "volume 31149.9"},
                             {"shank_width", "shank_width = 18", "volume 31852.1"},
                             {"fillet_radius", "fillet_radius = 22", "volume 30293"},
                             {"thickness", "thickness = 24", "volume 60462.8"},
                             {"shank_patches", "shank_patches = 2", "patches 12"}}),
      model_section("sphere", {{"inner_radius", "inner_radius = 0.5", "volume 4.12334"},
                               {"outer_radius", "outer_radius = 3", "volume 13.6136"},
                               {"radial_patches", "radial_patches = 2", "patches 6"}}),
      model_section("plate", {{"width", "width = 5", "extent 5 4 1"},
                              {"height", "height = 5", "extent 4 5 1"},
                              {"hole_radius", "hole_radius = 2", "volume 12.8584"},
                              {"thickness", "thickness = 3", "extent 4 4 3"}}),
      model_section("bracket", {{"leg", "leg = 3", "extent 3 3 1"},
                                {"width", "width = 0.5", "volume 1.75"},
                                {"thickness", "thickness = 2", "extent 2 2 2"}}),
      model_section("cook", {{"width", "width = 50", "extent 50 60 1"},
                             {"left_height", "left_height = 50", "volume 1584"},
                             {"right_height", "right_height = 20", "volume 1536"},
                             {"rise", "rise = 50", "extent 48 66 1"},
                             {"thickness", "thickness = 2", "extent 48 60 2"},
                             {"patches", "patches = [2, 3]", "patches 6"}}),
      model_section("elbow", {{"inner_radius", "inner_radius = 6", "volume 12348.4"},
                              {"outer_radius", "outer_radius = 12", "volume 15435.5"},
                              {"bend_radius", "bend_radius = 24", "volume 7656.59"},
                              {"bend_angle", "bend_angle = \"180 deg\"", "volume 10499"},
                              {"inlet_length", "inlet_length = 5", "volume 5815"},
                              {"outlet_length", "outlet_length = 25", "volume 8076.95"}}),
      model_section("elliptic_plate", {{"inner_x", "inner_x = 2.5", "volume 3.0336"},
                                       {"inner_y", "inner_y = 1.5", "volume 2.79798"},
                                       {"outer_x", "outer_x = 4", "volume 4.24115"},
                                       {"outer_y", "outer_y = 3", "volume 3.6521"},
                                       {"thickness", "thickness = 1", "volume 5.4487"},
                                       {"layers", "layers = 3", "patches 3"}}),
      model_section("twisted_beam", {{"length", "length = 10", "volume 3.52"},
                                     {"width", "width = 2", "volume 7.68"},
                                     {"depth", "depth = 1", "volume 13.2"},
                                     {"twist", "twist = \"180 deg\"", "last of the first 12 -0.55 -0.16"}})};
}

std::vector<Shown> shapes(const std::string& of) {
  return {{"plane", "plane = { normal = \"x\" }", of + " plane normal 1 0 0"},
          {"cylinder", "cylinder = { radius = 2 }", of + " cylinder radius 2"},
          {"sphere", "sphere = { radius = 3 }", of + " sphere radius 3"},
          {"box", "box = { min = [0, 0, 0], max = [1, 2, 3] }", of + " box max 1 2 3"},
          {"tolerance", "tolerance = \"0.1 mm\"", of + " tolerance 0.0001", "sphere = { radius = 3 }\n"}};
}

std::vector<ShownSection> sections_of_conditions() {
  std::vector<Shown> where = shapes("support where");
  where.push_back({"normal", "normal = [0, 0, -2]", "support where normal 0 0 -1"});
  where.push_back({"angle", "angle = \"45 deg\"", "support where angle 0.785398", "normal = \"z\"\n"});
  const std::string open = "[[support]]\ndisplacement = [0, 0, 0]\n";
  std::vector<Shown> part = shapes("support part");
  part.pop_back();  // a part has no tolerance
  return {{"where", open + "[support.where]\n", where},
          {"part", open + "[support.part]\n", part},
          {"edges", open + held + "[support.edges]\n", shapes("support edges")},
          {"where.plane",
           open + "[support.where.plane]\n",
           {{"point", "point = [1, \"2 mm\", 3]", "support where plane point 1 0.002 3", "normal = \"x\"\n"},
            {"normal", "normal = [0, 3, 0]", "support where plane normal 0 1 0"}}},
          {"where.cylinder",
           open + "[support.where.cylinder]\n",
           {{"point", "point = [1, 2, 3]", "support where cylinder point 1 2 3", "radius = 1\n"},
            {"axis", "axis = [0, 2, 0]", "support where cylinder axis 0 1 0", "radius = 1\n"},
            {"radius", "radius = \"5 mm\"", "support where cylinder radius 0.005"}}},
          {"where.sphere",
           open + "[support.where.sphere]\n",
           {{"centre", "centre = [1, 2, 3]", "support where sphere centre 1 2 3", "radius = 1\n"},
            {"radius", "radius = \"5 mm\"", "support where sphere radius 0.005"}}},
          {"where.box",
           open + "[support.where.box]\n",
           {{"min", "min = [-1, -2, -3]", "support where box min -1 -2 -3", "max = [1, 1, 1]\n"},
            {"max", "max = [4, 5, 6]", "support where box max 4 5 6", "min = [0, 0, 0]\n"}}}};
}

std::vector<ShownSection> sections_of_the_problem() {
  const std::string on_face = "faces = [\"x_max\"]\n";
  const std::string pulled = on_face + "traction = [1, 0, 0]\n";
  const std::string pushed = "faces = [\"x_max\"]\npressure = 1\n";
  return {
      {"discretization",
       "[discretization]\n",
       {{"degree", "degree = [2, 3, 4]", "degree [2, 3, 4]"},
        {"refine", "refine = 2", "refine 2"},
        {"elements_per_direction", "elements_per_direction = 5", "elements [5, 5, 5]"},
        {"max_size", "max_size = \"3 mm\"", "max_size 0.003"},
        {"continuity", "continuity = 1", "continuity 1"},
        {"points", "points = 6", "points 6"},
        {"patch", "patch = [{ patches = [2], refine = 1 }]", "patches of their own 2-2"}}},
      {"material",
       "[[material]]\n",
       {{"patches", "patches = [0, \"2-4\"]", "material patches 0-0 2-4", steel},
        {"name", "name = \"alu\"", "called alu", steel},
        {"young", "young = \"5 GPa\"", "mu 2e+09", "poisson = 0.25\n"},
        {"poisson", "poisson = 0", "mu 5e+08", "young = 1e9\n"},
        {"lame", "lame = { lambda = 3e9, mu = 2e9 }", "lambda 3e+09"},
        {"density", "density = \"2.7 g/cm^3\"", "density 2700", steel},
        {"expansion", "expansion = \"12e-6 1/K\"", "expansion 1.2e-05", steel},
        {"yield", "yield = \"355 MPa\"", "yield 3.55e+08", steel}}},
      {"material.lame",
       "[[material]]\n[material.lame]\n",
       {{"lambda", "lambda = \"54 GPa\"", "lambda 5.4e+10", "mu = 1e9\n"},
        {"mu", "mu = 27.8e9", "mu 2.78e+10", "lambda = 1e9\n"}}},
      {"support",
       "[[support]]\n",
       {{"name", "name = \"clamp\"", "support key clamp", displaced},
        {"faces", "faces = [\"0:back\", \"inner\"]", "support face inner", "symmetry = true\n"},
        {"where", "where = { sphere = { radius = 2 } }", "support where sphere radius 2", displaced},
        {"part", "part = { sphere = { radius = 2 } }", "support part sphere radius 2", displaced},
        {"edges", "edges = { sphere = { radius = 2 } }", "support edges sphere radius 2", displaced},
        {"displacement", "displacement = [\"1 mm\", \"free\", 0]", "held 0.001", held},
        {"displacement_gradient", "displacement_gradient = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]",
         "gradient 1 4 7 2 5 8 3 6 9", displaced},
        {"symmetry", "symmetry = true", "support kind symmetry", held},
        {"roller", "roller = true", "support kind roller", held},
        {"normal_displacement", "normal_displacement = \"-2 um\"", "support moves -2e-06",
         held + "roller = true\n"},
        {"points", "points = [[0, 0, 0], [\"1 mm\", 0, 0]]", "held point 0.001 0 0",
         "displacement = [0, 0, 0]\n"},
        {"line", "line = [[0, 0, 0], [\"1 mm\", 0, 0]]", "held line 0.001 0 0", "displacement = [0, 0, 0]\n"},
        {"cylindrical", "cylindrical = { axial = \"fixed\" }",
         "about radial true tangential false axial true", held},
        {"elastic", "elastic = { normal = \"1 MPa/mm\" }", "springs 1e+09 and 0, in all 0 and 0", held},
        {"free_body", "free_body = true", "support kind free_body"},
        {"case", "case = [\"a\", \"b\"]", "support cases a b", displaced}}},
      {"support.cylindrical",
       "[[support]]\n" + held + "[support.cylindrical]\n",
       {{"radial", "radial = \"free\"", "about radial false tangential false axial true",
         "axial = \"fixed\"\n"},
        {"tangential", "tangential = \"fixed\"", "about radial true tangential true axial false"},
        {"axial", "axial = \"fixed\"", "about radial true tangential false axial true"},
        {"point", "point = [\"5 mm\", 0, 0]", "about 0.005 0 0", "axis = \"x\"\n"},
        {"axis", "axis = [0, 2, 0]", "about axis 0 1 0", "point = [0, 0, 0]\n"}}},
      {"support.elastic",
       "[[support]]\n" + held + "[support.elastic]\n",
       {{"normal", "normal = 5", "springs 5 and 0, in all 0 and 0"},
        {"tangential", "tangential = 5", "springs 0 and 5, in all 0 and 0"},
        {"total_normal", "total_normal = \"2 N/mm\"", "springs 0 and 0, in all 2000 and 0"},
        {"total_tangential", "total_tangential = 5", "springs 0 and 0, in all 0 and 5"}}},
      {"load",
       "[[load]]\n",
       {{"name", "name = \"wind\"", "load key wind", pushed},
        {"faces", "faces = [\"0:east\"]", "load face 0:east", "pressure = 1\n"},
        {"where", "where = { sphere = { radius = 2 } }", "load where sphere radius 2", pushed},
        {"part", "part = { sphere = { radius = 2 } }", "load part sphere radius 2", pushed},
        {"points", "points = [[\"1 mm\", 0, 0]]", "load point 0.001 0 0", "force = [1, 0, 0]\n"},
        {"line", "line = [[0, 0, 0], [\"1 mm\", 0, 0]]", "load line 0.001 0 0", "force = [1, 0, 0]\n"},
        {"traction", "traction = [\"20 MPa\", -3, 0]", "load traction 2e+07 -3 0", on_face},
        {"pressure", "pressure = \"1 bar\"", "load pressure 100000", on_face},
        {"force", "force = [0, 0, \"1 kN\"]", "load force 0 0 1000", on_face},
        {"patches", "patches = \"1-3\"", "load patches 1-3", "gravity = [0, 0, 1]\n"},
        {"body_force", "body_force = [0, 0, \"1 N/mm^3\"]", "load body_force 0 0 1e+09"},
        {"gravity", "gravity = [0, 0, \"-9.81 m/s^2\"]", "load gravity 0 0 -9.81"},
        {"bearing", "bearing = [0, 0, \"1 kN\"]", "load bearing 0 0 1000", on_face},
        {"remote", "remote = { force = [1, 0, 0] }", "load remote force 1 0 0 moment 0 0 0 at centroid",
         on_face},
        {"hydrostatic", "hydrostatic = { density = 900, surface = [0, 0, 1] }",
         "load hydrostatic of 900 from 0 0 1 to 0 0 -9.80665", on_face},
        {"acceleration", "acceleration = [0, 0, 2]", "load acceleration 0 0 2"},
        {"rotation", "rotation = { speed = \"30 rpm\" }",
         "load rotation with 3.14159 about 0 0 0 along 0 0 1"},
        {"temperature", "temperature = { change = \"50 K\" }", "load temperature by 50 and 0 0 0 from 0 0 0"},
        {"case", "case = \"storm\"", "load cases storm", pushed}}},
      {"load.temperature",
       "[[load]]\n[load.temperature]\n",
       {{"change", "change = \"50 K\"", "load temperature by 50 and 0 0 0 from 0 0 0"},
        {"gradient", "gradient = [\"2 K/mm\", 0, 0]", "load temperature by 0 and 2000 0 0 from 0 0 0"},
        {"point", "point = [1, 0, 0]", "load temperature by 0 and 0 0 0 from 1 0 0"}}},
      {"load.remote",
       "[[load]]\n" + on_face + "[load.remote]\n",
       {{"force", "force = [0, \"1 kN\", 0]", "load remote force 0 1000 0 moment 0 0 0 at centroid"},
        {"moment", "moment = [0, 0, \"2 N m\"]", "load remote force 0 0 0 moment 0 0 2 at centroid"},
        {"point", "point = [\"5 mm\", 0, 0]", "load remote force 0 0 1 moment 0 0 0 at 0.005 0 0",
         "force = [0, 0, 1]\n"}}},
      {"load.hydrostatic",
       "[[load]]\n" + on_face + "[load.hydrostatic]\n",
       {{"density", "density = 13600", "load hydrostatic of 13600 from 0 0 0 to 0 0 -9.80665",
         "surface = [0, 0, 0]\n"},
        {"surface", "surface = [0, 0, \"2 m\"]", "load hydrostatic of 1000 from 0 0 2 to 0 0 -9.80665",
         "density = 1000\n"},
        {"gravity", "gravity = [0, -10, 0]", "load hydrostatic of 1000 from 0 0 0 to 0 -10 0",
         "surface = [0, 0, 0]\ndensity = 1000\n"}}},
      {"load.rotation",
       "[[load]]\n[load.rotation]\n",
       {{"speed", "speed = 7", "load rotation with 7 about 0 0 0 along 0 0 1"},
        {"point", "point = [1, 0, 0]", "load rotation with 7 about 1 0 0 along 0 0 1", "speed = 7\n"},
        {"axis", "axis = \"y\"", "load rotation with 7 about 0 0 0 along 0 1 0", "speed = 7\n"}}},
      {"combination",
       "[[combination]]\n",
       {{"name", "name = \"worst\"", "combination worst a 1", "factors = { a = 1 }\n"},
        {"factors", "factors = { b = -1.5 }", "combination combination_1 b -1.5"}}},
      {"coupling",
       "[coupling]\n",
       {{"method", "method = \"lagrange\"", "coupling lagrange"},
        {"non_matching", "non_matching = \"mortar\"", "non-matching faces by mortar"},
        {"mortar_side", "mortar_side = \"other\"", "mortar on the other side",
         "non_matching = \"mortar\"\n"}}},
      {"solver",
       "[solver]\n",
       {{"method", "method = \"mumps\"", "method mumps"},
        {"tolerance", "tolerance = 1e-9", "tolerance 1e-09"},
        {"max_iterations", "max_iterations = 77", "iterations 77"},
        {"preconditioner", "preconditioner = \"block_jacobi\"", "preconditioner block_jacobi"},
        {"operator", "operator = \"matrix_free\"", "operator matrix_free"},
        {"smoothing_degree", "smoothing_degree = 8", "smoothing 8 over 160"},
        {"memory_limit", "memory_limit = \"2 GB\"", "memory 2e+09"}}},
      {"probe",
       "[[probe]]\n",
       {{"name", "name = \"tip\"", "probe tip", "point = [0, 0, 0]\n"},
        {"point", "point = [\"1 mm\", 0, 2]", "probe point 0.001 0 2"},
        {"patch", "patch = 2", "probe patch 2", "parameter = [0, 0, 0]\n"},
        {"parameter", "parameter = [0.5, 0, 1]", "probe parameter 0.5 0 1", "patch = 1\n"}}},
      {"output",
       "[output]\n",
       {{"directory", "directory = \"out\"", "directory folder/out"},
        {"fields", "fields = false", "fields false"},
        {"pieces", "pieces = 6", "pieces 6"},
        {"exact", "exact = false", "exact false"},
        {"precision", "precision = \"single\"", "precision 2"},
        {"hdf5", "hdf5 = false", "hdf5 false"},
        {"report", "report = false", "report false"},
        {"stages", "stages = false", "stages false"},
        {"error_estimate", "error_estimate = false", "error estimate false"},
        {"moments_about", "moments_about = [1, 2, 3]", "moments about 1 2 3"}}},
      {"section",
       "[[section]]\n",
       {{"name", "name = \"neck\"", "section neck", "point = [0, 0, 0]\nnormal = \"x\"\n"},
        {"point", "point = [\"1 mm\", 0, 2]", "section point 0.001 0 2", "normal = \"x\"\n"},
        {"normal", "normal = [0, 2, 0]", "section normal 0 1 0", "point = [0, 0, 0]\n"},
        {"radius", "radius = \"5 mm\"", "section radius 0.005", "point = [0, 0, 0]\nnormal = \"x\"\n"}}},
      {"discretization.patch",
       "[[discretization.patch]]\n",
       {{"patches", "patches = [3]", "patches of their own 3-3"},
        {"part", "part = { sphere = { radius = 2 } }", "own part sphere radius 2"},
        {"degree", "degree = [3, 4, 5]", "own degree [3, 4, 5]", "patches = [0]\n"},
        {"refine", "refine = 2", "own refine 2", "patches = [0]\n"},
        {"elements_per_direction", "elements_per_direction = 4", "own elements [4, 4, 4]", "patches = [0]\n"},
        {"max_size", "max_size = \"2 mm\"", "own size 0.002", "patches = [0]\n"}}},
      {"modes",
       "[modes]\n",
       {{"number", "number = 3", "modes 3"},
        {"free", "free = true", "modes free true"},
        {"count", "count = false", "modes counted false"}}},
      {"accuracy",
       "[accuracy]\n",
       {{"energy", "energy = \"1 %\"", "accuracy energy 0.01"},
        {"stress", "stress = \"5 %\"", "accuracy stress 0.05"},
        {"probe", "probe = \"tip\"", "accuracy probe tip", "stress = 0.05\n"},
        {"refinements", "refinements = 3", "accuracy refinements 3", "energy = 0.01\n"}}}};
}

std::vector<ShownSection> all_sections() {
  std::vector<ShownSection> all;
  for (const auto& some : {sections_of_the_model(), sections_of_generated_models(), sections_of_conditions(),
                           sections_of_the_problem()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

// With what every study needs and the text does not say.
std::string whole(std::string text) {
  const auto lacks = [&](const std::string& table) {
    return text.find("[" + table + "]") == std::string::npos &&
           ("\n" + text).find("\n" + table + " =") == std::string::npos;
  };
  const bool model = lacks("model"), material = lacks("material"), support = lacks("support");
  text += "\n";
  if (model) text += "[model]\n" + box;
  if (material) text += "[[material]]\n" + steel;
  if (support) text += "[[support]]\n" + displaced;
  return text;
}

std::optional<std::string> words(const std::string& text) {
  try {
    return words_of(parse_study(whole(text), "folder/study.toml"));
  } catch (const Error&) {
    return std::nullopt;  // what is left without the key is no study
  }
}

TEST(StudyKeys, AreAllReadAndChangeTheStudy) {
  for (const ShownSection& section : all_sections())
    for (const Shown& shown : section.keys) {
      const std::string rest = section.heading + shown.before;
      const std::string of = section.name + "." + shown.key;
      ASSERT_EQ(shown.assignment.rfind(shown.key + " =", 0), 0u) << of;
      SCOPED_TRACE(of);
      const std::string with =
          words_of(parse_study(whole(rest + shown.assignment + "\n"), "folder/study.toml"));
      const std::optional<std::string> without = words(rest);
      EXPECT_NE(with, without) << of;
      if (shown.line.empty()) continue;
      EXPECT_THAT(with, testing::HasSubstr("\n" + shown.line + "\n")) << of;
      if (without) {
        EXPECT_THAT(*without, testing::Not(testing::HasSubstr("\n" + shown.line + "\n"))) << of;
      }
    }
}

// All that a study says: its text, which says it too, apart.
std::optional<Study> said_by(const std::string& text) {
  try {
    Study study = parse_study(whole(text), "folder/study.toml");
    study.text.clear();
    return study;
  } catch (const Error&) {
    return std::nullopt;
  }
}

TEST(StudyKeys, MakeStudiesThatAreEqualIfAndOnlyIfTheySayTheSame) {
  std::size_t compared = 0;
  for (const ShownSection& section : all_sections())
    for (const Shown& shown : section.keys) {
      const std::string rest = section.heading + shown.before;
      const std::optional<Study> with = said_by(rest + shown.assignment + "\n");
      ASSERT_TRUE(with) << section.name << "." << shown.key;
      EXPECT_EQ(said_by(rest + shown.assignment + "\n"), with);
      // A comment instead, so that all else stays where it was.
      const std::optional<Study> without = said_by(rest + "#\n");
      if (!without) continue;
      EXPECT_NE(without, with) << section.name << "." << shown.key;
      ++compared;
    }
  EXPECT_GT(compared, 100u);
}

TEST(StudyKeys, AreAllShownToBeRead) {
  std::map<std::string, std::vector<std::string>> documented, shown;
  for (const SectionText& section : study_sections())
    for (const KeyText& key : section.keys) documented[section.name].push_back(key.name);
  for (const ShownSection& section : all_sections())
    for (const Shown& key : section.keys) shown[section.name].push_back(key.key);
  for (const auto& [name, keys] : documented)
    EXPECT_THAT(shown[name], testing::UnorderedElementsAreArray(keys))
        << "section " << name << ": show what each of its keys changes";
  EXPECT_EQ(shown.size(), documented.size());
}

}  // namespace
}  // namespace isopatch::app
