#include "segmentation/parameterization/tests/step_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <map>

namespace isopatch::segmentation::test {
namespace {

using Point = Eigen::Vector3d;

/// Entities, numbered as they come.
class Text {
 public:
  std::string add(const std::string& entity) {
    const std::string id = fmt::format("#{}", ++count_);
    body_ += id + " = " + entity + ";\n";
    return id;
  }
  std::string point(const Point& p) {
    return add(fmt::format("CARTESIAN_POINT('',({:.9f},{:.9f},{:.9f}))", p[0], p[1], p[2]));
  }
  std::string direction(const Point& d) {
    return add(fmt::format("DIRECTION('',({:.9f},{:.9f},{:.9f}))", d[0], d[1], d[2]));
  }
  std::string vertex(const Point& p) { return add(fmt::format("VERTEX_POINT('',{})", point(p))); }
  std::string frame(const Point& origin, const Point& z, const Point& x) {
    const std::string o = point(origin), a = direction(z), b = direction(x);
    return add(fmt::format("AXIS2_PLACEMENT_3D('',{},{},{})", o, a, b));
  }
  std::string line(const Point& from, const Point& to) {
    const std::string o = point(from), d = direction((to - from).normalized());
    const std::string vector = add(fmt::format("VECTOR('',{},1.)", d));
    return add(fmt::format("LINE('',{},{})", o, vector));
  }
  std::string edge(const std::string& from, const std::string& to, const std::string& curve) {
    return add(fmt::format("EDGE_CURVE('',{},{},{},.T.)", from, to, curve));
  }
  /// An edge with a sign in front if it is walked backwards.
  std::string loop(const std::vector<std::string>& signed_edges) {
    std::vector<std::string> uses;
    for (const std::string& edge : signed_edges) {
      const bool back = edge[0] == '-';
      uses.push_back(
          add(fmt::format("ORIENTED_EDGE('',*,*,{},.{}.)", back ? edge.substr(1) : edge, back ? "F" : "T")));
    }
    return add(fmt::format("EDGE_LOOP('',({}))", fmt::join(uses, ",")));
  }
  void face(const std::string& surface, const std::vector<std::string>& loops) {
    std::vector<std::string> bounds;
    for (const std::string& loop : loops)
      bounds.push_back(add(fmt::format("FACE_{}BOUND('',{},.T.)", bounds.empty() ? "OUTER_" : "", loop)));
    faces_.push_back(add(fmt::format("ADVANCED_FACE('',({}),{},.T.)", fmt::join(bounds, ","), surface)));
  }
  std::string plane(const Point& origin, const Point& normal) {
    const Point x = normal.unitOrthogonal();
    return add(fmt::format("PLANE('',{})", frame(origin, normal, x)));
  }

  /// The file, with all faces in one shell.
  std::string file() {
    const std::string shell = add(fmt::format("CLOSED_SHELL('',({}))", fmt::join(faces_, ",")));
    const std::string solid = add(fmt::format("MANIFOLD_SOLID_BREP('',{})", shell));
    const std::string world = frame(Point::Zero(), Point::UnitZ(), Point::UnitX());
    const std::string length = add("( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )");
    const std::string angle = add("( NAMED_UNIT(*) PLANE_ANGLE_UNIT() SI_UNIT($,.RADIAN.) )");
    const std::string space = add("( NAMED_UNIT(*) SI_UNIT($,.STERADIAN.) SOLID_ANGLE_UNIT() )");
    const std::string context =
        add(fmt::format("( GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT(({},{},{})) "
                        "REPRESENTATION_CONTEXT('','3D') )",
                        length, angle, space));
    const std::string shape =
        add(fmt::format("ADVANCED_BREP_SHAPE_REPRESENTATION('',({},{}),{})", world, solid, context));
    const std::string application = add("APPLICATION_CONTEXT('design')");
    const std::string product_context = add(fmt::format("PRODUCT_CONTEXT('',{},'mechanical')", application));
    const std::string product = add(fmt::format("PRODUCT('part','part','',({}))", product_context));
    const std::string formation = add(fmt::format("PRODUCT_DEFINITION_FORMATION('','',{})", product));
    const std::string definition_context =
        add(fmt::format("PRODUCT_DEFINITION_CONTEXT('part definition',{},'design')", application));
    const std::string definition =
        add(fmt::format("PRODUCT_DEFINITION('design','',{},{})", formation, definition_context));
    const std::string definition_shape = add(fmt::format("PRODUCT_DEFINITION_SHAPE('','',{})", definition));
    add(fmt::format("SHAPE_DEFINITION_REPRESENTATION({},{})", definition_shape, shape));
    return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
           "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
           body_ + "ENDSEC;\nEND-ISO-10303-21;\n";
  }

 private:
  int count_ = 0;
  std::string body_;
  std::vector<std::string> faces_;
};

const Point x = Point::UnitX(), y = Point::UnitY(), z = Point::UnitZ();

}  // namespace

std::string step_cylinder(double radius, double height) {
  Text text;
  const Point low = radius * x, high = low + height * z;
  const std::string a = text.vertex(low), b = text.vertex(high);
  const std::string below =
      text.edge(a, a, text.add(fmt::format("CIRCLE('',{},{:.9f})", text.frame(Point::Zero(), z, x), radius)));
  const std::string above =
      text.edge(b, b, text.add(fmt::format("CIRCLE('',{},{:.9f})", text.frame(height * z, z, x), radius)));
  const std::string seam = text.edge(a, b, text.line(low, high));
  const std::string wall =
      text.add(fmt::format("CYLINDRICAL_SURFACE('',{},{:.9f})", text.frame(Point::Zero(), z, x), radius));
  text.face(wall, {text.loop({below, seam, "-" + above, "-" + seam})});
  text.face(text.plane(Point::Zero(), -z), {text.loop({"-" + below})});
  text.face(text.plane(height * z, z), {text.loop({above})});
  return text.file();
}

std::string step_half_cylinder(double radius, double height) {
  Text text;
  const Point right = radius * x, left = -right, up = height * z;
  const std::string a = text.vertex(right), b = text.vertex(left), c = text.vertex(right + up),
                    d = text.vertex(left + up);
  const auto arc = [&](const Point& middle) {
    return text.add(fmt::format("CIRCLE('',{},{:.9f})", text.frame(middle, z, x), radius));
  };
  const std::string arc_below = text.edge(a, b, arc(Point::Zero())), arc_above = text.edge(c, d, arc(up));
  const std::string chord_below = text.edge(b, a, text.line(left, right));
  const std::string chord_above = text.edge(d, c, text.line(left + up, right + up));
  const std::string on_right = text.edge(a, c, text.line(right, right + up));
  const std::string on_left = text.edge(b, d, text.line(left, left + up));
  const std::string wall =
      text.add(fmt::format("CYLINDRICAL_SURFACE('',{},{:.9f})", text.frame(Point::Zero(), z, x), radius));
  text.face(wall, {text.loop({arc_below, on_left, "-" + arc_above, "-" + on_right})});
  text.face(text.plane(Point::Zero(), -y),
            {text.loop({chord_below, on_right, "-" + chord_above, "-" + on_left})});
  text.face(text.plane(Point::Zero(), -z), {text.loop({"-" + chord_below, "-" + arc_below})});
  text.face(text.plane(up, z), {text.loop({arc_above, chord_above})});
  return text.file();
}

std::string step_square_ring() {
  Text text;
  // Corners of the outer and the inner square, below and above, counter-clockwise seen from above.
  std::vector<Point> points;
  for (const double height : {0.0, 1.0})
    for (const double half : {2.0, 1.0})
      for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        points.emplace_back(half * i, half * j, height);
  std::vector<std::string> vertices;
  for (const Point& p : points) vertices.push_back(text.vertex(p));
  std::map<std::pair<int, int>, std::string> edges;
  const auto use = [&](int from, int to) {
    if (const auto back = edges.find({to, from}); back != edges.end()) return "-" + back->second;
    const auto at = [](int i) { return static_cast<std::size_t>(i); };
    return edges[{from, to}] =
               text.edge(vertices[at(from)], vertices[at(to)], text.line(points[at(from)], points[at(to)]));
  };
  const auto loop = [&](const std::vector<int>& around) {
    std::vector<std::string> uses;
    for (std::size_t i = 0; i < around.size(); ++i)
      uses.push_back(use(around[i], around[(i + 1) % around.size()]));
    return text.loop(uses);
  };
  text.face(text.plane(z, z), {loop({8, 9, 10, 11}), loop({15, 14, 13, 12})});
  text.face(text.plane(Point::Zero(), -z), {loop({3, 2, 1, 0}), loop({4, 5, 6, 7})});
  for (int i = 0; i < 4; ++i) {
    const int next = (i + 1) % 4;
    const Point out = i == 0 ? Point(-y) : i == 1 ? x : i == 2 ? y : Point(-x);
    text.face(text.plane(2 * out, out), {loop({i, next, 8 + next, 8 + i})});
    text.face(text.plane(out, -out), {loop({4 + next, 4 + i, 12 + i, 12 + next})});
  }
  return text.file();
}

}  // namespace isopatch::segmentation::test
