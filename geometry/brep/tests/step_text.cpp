#include "geometry/brep/tests/step_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace isopatch::geometry::test {
namespace {

// STEP wants a point in every number.
std::string number(double value) {
  std::string text = fmt::format("{:.17g}", value);
  if (text.find_first_of(".e") == text.npos) text += ".";
  if (const auto e = text.find('e'); e != text.npos && text.find('.') == text.npos) text.insert(e, ".");
  return text;
}

std::string numbers(const Eigen::Vector3d& v) {
  return fmt::format("({},{},{})", number(v.x()), number(v.y()), number(v.z()));
}

std::vector<std::string> reference_words(const std::vector<int>& entities) {
  std::vector<std::string> result;
  for (const int entity : entities) result.push_back(fmt::format("#{}", entity));
  return result;
}

}  // namespace

int StepText::add(const std::string& entity) {
  text_ += fmt::format("#{}={};\n", ++count_, entity);
  return count_;
}

int StepText::point(const Eigen::Vector3d& at) {
  return add(fmt::format("CARTESIAN_POINT('',{})", numbers(at + offset_)));
}
int StepText::direction(const Eigen::Vector3d& along) {
  return add(fmt::format("DIRECTION('',{})", numbers(along.normalized())));
}
int StepText::frame(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis, const Eigen::Vector3d& x) {
  const int o = point(origin), z = direction(axis), along = direction(x);
  return add(fmt::format("AXIS2_PLACEMENT_3D('',#{},#{},#{})", o, z, along));
}
int StepText::vertex(const Eigen::Vector3d& at) {
  return add(fmt::format("VERTEX_POINT('',#{})", point(at)));
}
int StepText::line(const Eigen::Vector3d& from, const Eigen::Vector3d& along) {
  const int p = point(from), v = add(fmt::format("VECTOR('',#{},1.)", direction(along)));
  return add(fmt::format("LINE('',#{},#{})", p, v));
}

int StepText::spline(const NurbsCurve& curve, const Eigen::Vector3d& shift) {
  std::vector<int> points;
  for (const auto& p : curve.control_points().colwise()) points.push_back(point(p + shift));
  std::map<double, int> multiplicities;
  for (const double knot : curve.knots(0).knots()) ++multiplicities[knot];
  std::vector<std::string> knots;
  std::vector<int> counts;
  for (const auto& [knot, multiplicity] : multiplicities) {
    knots.push_back(number(knot));
    counts.push_back(multiplicity);
  }
  return add(fmt::format(
      "B_SPLINE_CURVE_WITH_KNOTS('',{},({}),.UNSPECIFIED.,.F.,.F.,({}),({}),.UNSPECIFIED.)", curve.degree(0),
      fmt::join(reference_words(points), ","), fmt::join(counts, ","), fmt::join(knots, ",")));
}

int StepText::plane(const Eigen::Vector3d& origin, const Eigen::Vector3d& normal) {
  return add(fmt::format("PLANE('',#{})", frame(origin, normal, normal.unitOrthogonal())));
}
int StepText::edge(int start, int end, int curve) {
  return add(fmt::format("EDGE_CURVE('',#{},#{},#{},.T.)", start, end, curve));
}
int StepText::loop(const std::vector<int>& uses) {
  std::vector<int> oriented;
  for (const int use : uses)
    oriented.push_back(
        add(fmt::format("ORIENTED_EDGE('',*,*,#{},.{}.)", std::abs(use), use > 0 ? 'T' : 'F')));
  const int list = add(fmt::format("EDGE_LOOP('',({}))", fmt::join(reference_words(oriented), ",")));
  return add(fmt::format("FACE_BOUND('',#{},.T.)", list));
}
int StepText::face(int surface, const std::vector<int>& loops, bool agrees) {
  return add(fmt::format("ADVANCED_FACE('',({}),#{},.{}.)", fmt::join(reference_words(loops), ","), surface,
                         agrees ? 'T' : 'F'));
}

std::string StepText::file(const std::vector<int>& faces, const std::string& unit) const {
  StepText all = *this;
  const int shell = all.add(fmt::format("CLOSED_SHELL('',({}))", fmt::join(reference_words(faces), ",")));
  const int solid = all.add(fmt::format("MANIFOLD_SOLID_BREP('part',#{})", shell));
  const int length =
      all.add(fmt::format("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({},.METRE.))", unit == "mm" ? ".MILLI." : "$"));
  const int angle = all.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
  const int solid_angle = all.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
  const int uncertainty =
      all.add(fmt::format("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#{},'accuracy','')", length));
  const int context =
      all.add(fmt::format("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{}))"
                          "GLOBAL_UNIT_ASSIGNED_CONTEXT((#{},#{},#{}))REPRESENTATION_CONTEXT('',''))",
                          uncertainty, length, angle, solid_angle));
  const int representation =
      all.add(fmt::format("ADVANCED_BREP_SHAPE_REPRESENTATION('',(#{}),#{})", solid, context));
  const int application = all.add("APPLICATION_CONTEXT('automotive design')");
  all.add(fmt::format(
      "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{})", application));
  const int part_context = all.add(fmt::format("PRODUCT_CONTEXT('',#{},'mechanical')", application));
  const int product = all.add(fmt::format("PRODUCT('part','part','',(#{}))", part_context));
  const int formation = all.add(fmt::format("PRODUCT_DEFINITION_FORMATION('','',#{})", product));
  const int design =
      all.add(fmt::format("PRODUCT_DEFINITION_CONTEXT('part definition',#{},'design')", application));
  const int definition = all.add(fmt::format("PRODUCT_DEFINITION('design','',#{},#{})", formation, design));
  const int shape = all.add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',#{})", definition));
  all.add(fmt::format("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", shape, representation));
  return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
         "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
         all.text_ + "ENDSEC;\nEND-ISO-10303-21;\n";
}

std::vector<int> prism_faces(StepText& step, const ClosedCurve& curve, double h) {
  const Eigen::Vector3d up(0, 0, h);
  const int low = step.vertex(curve.start), high = step.vertex(curve.start + up);
  const int bottom = step.edge(low, low, curve.bottom), top = step.edge(high, high, curve.top);
  const int seam = step.edge(low, high, step.line(curve.start, up));
  const int along = step.add(fmt::format("VECTOR('',#{},1.)", step.direction(up)));
  const int side = step.add(fmt::format("SURFACE_OF_LINEAR_EXTRUSION('',#{},#{})", curve.bottom, along));
  return {step.face(side, {step.loop({bottom, seam, -top, -seam})}),
          step.face(step.plane({0, 0, 0}, -up), {step.loop({-bottom})}),
          step.face(step.plane(up, up), {step.loop({top})})};
}

std::vector<int> elliptic_prism(StepText& step, double a, double b, double h) {
  const auto ellipse = [&](double z) {
    return step.add(fmt::format("ELLIPSE('',#{},{},{})", step.frame({0, 0, z}), number(a), number(b)));
  };
  const int bottom = ellipse(0), top = ellipse(h);
  return prism_faces(step, {bottom, top, {a, 0, 0}}, h);
}

std::vector<int> spline_prism(StepText& step, const NurbsCurve& curve, double h) {
  const int bottom = step.spline(curve), top = step.spline(curve, {0, 0, h});
  return prism_faces(step, {bottom, top, curve.control_points().col(0)}, h);
}

namespace {

int circle(StepText& step, double r, double z) {
  return step.add(fmt::format("CIRCLE('',#{},{})", step.frame({0, 0, z}), number(r)));
}

}  // namespace

std::vector<int> cylinder(StepText& step, double r, double h) {
  const Eigen::Vector3d up(0, 0, h), at(r, 0, 0);
  const int low = step.vertex(at), high = step.vertex(at + up);
  const int bottom = step.edge(low, low, circle(step, r, 0)), top = step.edge(high, high, circle(step, r, h));
  const int seam = step.edge(low, high, step.line(at, up));
  const int side = step.add(fmt::format("CYLINDRICAL_SURFACE('',#{},{})", step.frame({0, 0, 0}), number(r)));
  return {step.face(side, {step.loop({bottom, seam, -top, -seam})}),
          step.face(step.plane({0, 0, 0}, -up), {step.loop({-bottom})}),
          step.face(step.plane(up, up), {step.loop({top})})};
}

std::vector<int> cone(StepText& step, double r, double h) {
  const Eigen::Vector3d at(r, 0, 0), apex(0, 0, h);
  const int low = step.vertex(at), high = step.vertex(apex);
  const int bottom = step.edge(low, low, circle(step, r, 0));
  const int seam = step.edge(low, high, step.line(at, apex - at));
  // The radius grows along the axis, so the axis points down.
  const int side =
      step.add(fmt::format("CONICAL_SURFACE('',#{},{},{})", step.frame({0, 0, 0}, {0, 0, -1}, {1, 0, 0}),
                           number(r), number(std::atan2(r, h))));
  return {step.face(side, {step.loop({bottom, seam, -seam})}),
          step.face(step.plane({0, 0, 0}, {0, 0, -1}), {step.loop({-bottom})})};
}

std::vector<int> sphere(StepText& step, double r) {
  const int south = step.vertex({0, 0, -r}), north = step.vertex({0, 0, r});
  const int meridian =
      step.add(fmt::format("CIRCLE('',#{},{})", step.frame({0, 0, 0}, {0, -1, 0}, {1, 0, 0}), number(r)));
  const int seam = step.edge(south, north, meridian);
  const int surface = step.add(fmt::format("SPHERICAL_SURFACE('',#{},{})", step.frame({0, 0, 0}), number(r)));
  return {step.face(surface, {step.loop({seam, -seam})})};
}

std::vector<int> torus(StepText& step, double large, double small) {
  const int at = step.vertex({large + small, 0, 0});
  const int around = step.edge(at, at, circle(step, large + small, 0));
  const int section = step.add(
      fmt::format("CIRCLE('',#{},{})", step.frame({large, 0, 0}, {0, -1, 0}, {1, 0, 0}), number(small)));
  const int through = step.edge(at, at, section);
  const int surface = step.add(
      fmt::format("TOROIDAL_SURFACE('',#{},{},{})", step.frame({0, 0, 0}), number(large), number(small)));
  return {step.face(surface, {step.loop({around, through, -around, -through})})};
}

std::vector<int> revolved(StepText& step, const NurbsCurve& profile) {
  const Eigen::Index last = profile.control_points().cols() - 1;
  const int low = step.vertex(profile.control_points().col(0));
  const int high = step.vertex(profile.control_points().col(last));
  const int curve = step.spline(profile);
  const int seam = step.edge(low, high, curve);
  const int axis =
      step.add(fmt::format("AXIS1_PLACEMENT('',#{},#{})", step.point({0, 0, 0}), step.direction({0, 0, 1})));
  const int surface = step.add(fmt::format("SURFACE_OF_REVOLUTION('',#{},#{})", curve, axis));
  return {step.face(surface, {step.loop({seam, -seam})})};
}

std::vector<int> block(StepText& step, const Eigen::Vector3d& sides, double off) {
  const auto corner = [&](int i) {
    return Eigen::Vector3d(sides.x() * (i & 1), sides.y() * ((i >> 1) & 1), sides.z() * ((i >> 2) & 1));
  };
  std::vector<int> vertices;
  for (int i = 0; i < 8; ++i) vertices.push_back(step.vertex(corner(i)));
  std::map<std::pair<int, int>, int> edges;
  const auto use = [&](int from, int to) {
    const auto key = std::minmax(from, to);
    if (!edges.contains(key))
      edges[key] = step.edge(vertices[static_cast<std::size_t>(key.first)],
                             vertices[static_cast<std::size_t>(key.second)],
                             step.line(corner(key.first), corner(key.second) - corner(key.first)));
    return from < to ? edges[key] : -edges[key];
  };
  std::vector<int> faces;
  const std::vector<std::array<int, 4>> corners = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                                   {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& c : corners) {
    std::vector<int> uses;
    for (std::size_t i = 0; i < 4; ++i) uses.push_back(use(c[i], c[(i + 1) % 4]));
    const Eigen::Vector3d normal =
        (corner(c[1]) - corner(c[0])).cross(corner(c[2]) - corner(c[0])).normalized();
    const double shift = normal.x() > 0.5 ? off : 0;
    faces.push_back(step.face(step.plane(corner(c[0]) + shift * normal, normal), {step.loop(uses)}));
  }
  return faces;
}

NurbsCurve random_closed_spline(int degree, int points, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> radius(0.6, 1.4), step(0.2, 2);
  Eigen::Matrix3Xd control(3, points + 1);
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points;
    control.col(i) = radius(random) * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  }
  control.col(points) = control.col(0);
  std::vector<double> knots(static_cast<std::size_t>(degree), 0);
  double at = 0;
  for (int i = 0; i <= points + 1 - degree; ++i) {
    knots.push_back(at);
    at += step(random);
  }
  knots.insert(knots.end(), static_cast<std::size_t>(degree), knots.back());
  return NurbsCurve({KnotVector(degree, knots)}, control);
}

}  // namespace isopatch::geometry::test
