#include "geometry/brep/tests/step_assembly.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <map>

namespace isopatch::geometry::test {

std::string references(const std::vector<int>& ids) {
  std::string text;
  for (const int id : ids) text += fmt::format("{}#{}", text.empty() ? "" : ",", id);
  return text;
}

StepAssembly::StepAssembly(const std::string& unit) {
  application_ = add("APPLICATION_CONTEXT('automotive design')");
  add(fmt::format("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{})",
                  application_));
  product_context_ = add(fmt::format("PRODUCT_CONTEXT('',#{},'mechanical')", application_));
  definition_context_ =
      add(fmt::format("PRODUCT_DEFINITION_CONTEXT('part definition',#{},'design')", application_));
  const int angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  const int solid_angle = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
  if (unit == "$") {
    context_ = add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)REPRESENTATION_CONTEXT('c','3D'))");
    return;
  }
  const int length = add(unit);
  context_ =
      add(fmt::format("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#{},#{},#{}))"
                      "REPRESENTATION_CONTEXT('c','3D'))",
                      length, angle, solid_angle));
}

int StepAssembly::add(const std::string& entity) {
  data_ += fmt::format("#{}={};\n", ++last_, entity);
  return last_;
}

int StepAssembly::placement(const std::array<double, 3>& at) {
  const int origin = add(fmt::format("CARTESIAN_POINT('',({:#},{:#},{:#}))", at[0], at[1], at[2]));
  const int z = add("DIRECTION('',(0.,0.,1.))"), x = add("DIRECTION('',(1.,0.,0.))");
  return add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", origin, z, x));
}

std::vector<int> StepAssembly::faces(const Polyhedron& polyhedron) {
  std::vector<int> points, vertices;
  const auto triple = [](const Eigen::Vector3d& p) {
    return fmt::format("({:#.17g},{:#.17g},{:#.17g})", p.x(), p.y(), p.z());
  };
  for (const auto& p : polyhedron.vertices.colwise()) {
    points.push_back(add(fmt::format("CARTESIAN_POINT('',{})", triple(p))));
    vertices.push_back(add(fmt::format("VERTEX_POINT('',#{})", points.back())));
  }
  std::map<std::pair<int, int>, int> edges;
  const auto oriented = [&](int a, int b) {
    const bool forward = a < b;
    const auto key = std::minmax(a, b);
    if (!edges.contains(key)) {
      const Eigen::Vector3d along = polyhedron.vertices.col(key.second) - polyhedron.vertices.col(key.first);
      const int direction = add(fmt::format("DIRECTION('',{})", triple(along.normalized())));
      const int vector = add(fmt::format("VECTOR('',#{},1.)", direction));
      const int line = add(fmt::format("LINE('',#{},#{})", points[std::size_t(key.first)], vector));
      edges[key] = add(fmt::format("EDGE_CURVE('',#{},#{},#{},.T.)", vertices[std::size_t(key.first)],
                                   vertices[std::size_t(key.second)], line));
    }
    return add(fmt::format("ORIENTED_EDGE('',*,*,#{},.{}.)", edges[key], forward ? "T" : "F"));
  };
  std::vector<int> result;
  for (const auto& corners : polyhedron.faces) {
    std::vector<int> loop;
    for (std::size_t i = 0; i < corners.size(); ++i)
      loop.push_back(oriented(corners[i], corners[(i + 1) % corners.size()]));
    const Eigen::Vector3d a = polyhedron.vertices.col(corners[0]), b = polyhedron.vertices.col(corners[1]),
                          c = polyhedron.vertices.col(corners[2]);
    const int normal = add(fmt::format("DIRECTION('',{})", triple((b - a).cross(c - a).normalized())));
    const int side = add(fmt::format("DIRECTION('',{})", triple((b - a).normalized())));
    const int axes =
        add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", points[std::size_t(corners[0])], normal, side));
    const int plane = add(fmt::format("PLANE('',#{})", axes));
    const int outline = add(fmt::format("EDGE_LOOP('',({}))", references(loop)));
    const int bound = add(fmt::format("FACE_OUTER_BOUND('',#{},.T.)", outline));
    result.push_back(add(fmt::format("ADVANCED_FACE('',(#{}),#{},.T.)", bound, plane)));
  }
  return result;
}

StepAssembly::Body StepAssembly::body(const Polyhedron& polyhedron, const std::string& name,
                                      const std::string& kind) {
  Body result;
  result.faces = faces(polyhedron);
  result.shell = add(fmt::format("CLOSED_SHELL('',({}))", references(result.faces)));
  result.item =
      add(kind == "solid" ? fmt::format("MANIFOLD_SOLID_BREP('{}',#{})", name, result.shell)
                          : fmt::format("SHELL_BASED_SURFACE_MODEL('{}',(#{}))", name, result.shell));
  return result;
}

StepAssembly::Body StepAssembly::body(const std::vector<Polyhedron>& pieces) {
  Body result;
  for (const Polyhedron& piece : pieces)
    for (const int face : faces(piece)) result.faces.push_back(face);
  result.shell = add(fmt::format("CLOSED_SHELL('',({}))", references(result.faces)));
  result.item = add(fmt::format("MANIFOLD_SOLID_BREP('',#{})", result.shell));
  return result;
}

StepAssembly::Product StepAssembly::product(const std::string& name, const std::vector<int>& items) {
  const int axes = placement({0, 0, 0});
  std::vector<int> all = {axes};
  all.insert(all.end(), items.begin(), items.end());
  Product result;
  result.shape = add(fmt::format("SHAPE_REPRESENTATION('',({}),#{})", references(all), context_));
  const int product = add(fmt::format("PRODUCT('{}','{}','',(#{}))", name, name, product_context_));
  const int formation = add(fmt::format("PRODUCT_DEFINITION_FORMATION('','',#{})", product));
  result.definition =
      add(fmt::format("PRODUCT_DEFINITION('design','',#{},#{})", formation, definition_context_));
  const int of_product = add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", result.definition));
  add(fmt::format("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", of_product, result.shape));
  return result;
}

void StepAssembly::place(const Product& assembly, const Product& part, const std::array<double, 3>& by,
                         const std::string& name) {
  const int from = placement({0, 0, 0}), to = placement(by);
  const int usage = add(fmt::format("NEXT_ASSEMBLY_USAGE_OCCURRENCE('{0}','{0}','',#{1},#{2},$)", name,
                                    assembly.definition, part.definition));
  const int shape = add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", usage));
  const int transformation = add(fmt::format("ITEM_DEFINED_TRANSFORMATION('','',#{},#{})", from, to));
  const int relation = add(fmt::format(
      "(REPRESENTATION_RELATIONSHIP('','',#{},#{})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{})"
      "SHAPE_REPRESENTATION_RELATIONSHIP())",
      part.shape, assembly.shape, transformation));
  add(fmt::format("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{},#{})", relation, shape));
}

void StepAssembly::colour(int item, const std::array<double, 3>& rgb) {
  const int colour = add(fmt::format("COLOUR_RGB('',{:#},{:#},{:#})", rgb[0], rgb[1], rgb[2]));
  const int fill = add(fmt::format("FILL_AREA_STYLE_COLOUR('',#{})", colour));
  const int area = add(fmt::format("FILL_AREA_STYLE('',(#{}))", fill));
  const int surface = add(fmt::format("SURFACE_STYLE_FILL_AREA(#{})", area));
  const int side = add(fmt::format("SURFACE_SIDE_STYLE('',(#{}))", surface));
  const int usage = add(fmt::format("SURFACE_STYLE_USAGE(.BOTH.,#{})", side));
  const int style = add(fmt::format("PRESENTATION_STYLE_ASSIGNMENT((#{}))", usage));
  styled_.push_back(add(fmt::format("STYLED_ITEM('',(#{}),#{})", style, item)));
}

std::string StepAssembly::text() const {
  std::string data = data_;
  if (!styled_.empty())
    data += fmt::format("#{}=MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',({}),#{});\n",
                        last_ + 1, references(styled_), context_);
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
         data + "ENDSEC;\nEND-ISO-10303-21;\n";
}

}  // namespace isopatch::geometry::test
