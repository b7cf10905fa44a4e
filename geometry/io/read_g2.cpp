#include "geometry/io/read_g2.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>

#include "geometry/io/reader_limits.hpp"
#include "geometry/io/text_scanner.hpp"

namespace isopatch::geometry {
namespace {

constexpr int spline_volume = 700;

std::string object_name(int type) {
  static const std::map<int, std::string> names = {{100, "SplineCurve"},
                                                   {110, "CurveOnSurface"},
                                                   {120, "Line"},
                                                   {130, "Circle"},
                                                   {140, "Ellipse"},
                                                   {200, "SplineSurface"},
                                                   {210, "BoundedSurface"},
                                                   {250, "Plane"},
                                                   {260, "Cylinder"},
                                                   {270, "Sphere"},
                                                   {280, "Cone"},
                                                   {290, "Torus"},
                                                   {291, "SurfaceOfRevolution"},
                                                   {400, "PointCloud"},
                                                   {410, "LineCloud"},
                                                   {500, "CompositeCurve"},
                                                   {710, "BoundedVolume"}};
  const auto found = names.find(type);
  return found == names.end() ? "unknown to this version" : found->second;
}

// "700 1 0 n" and the n integers that follow: colour or other data of the writing program.
void read_header(TextScanner& scanner) {
  const int type = scanner.integer("an object's type", 0, 1'000'000);
  if (type != spline_volume)
    scanner.fail(fmt::format("object of type {} ({}); the solver needs volumes: type 700 (SplineVolume)",
                             type, object_name(type)),
                 ErrorCode::unsupported);
  scanner.integer("the major version", 0, 1000);
  scanner.integer("the minor version", 0, 1000);
  const int extra = scanner.integer("the number of extra integers", 0, 1000);
  for (int i = 0; i < extra; ++i)
    scanner.integer("an extra integer of the header", -2'000'000'000, 2'000'000'000);
}

KnotVector read_knots(TextScanner& scanner, const std::string& name) {
  const int count = scanner.integer("the number of coefficients of " + name, 2, max_control_points);
  const int order = scanner.integer("the order (degree + 1) of " + name, 2, KnotVector::max_degree + 1);
  const int line = scanner.line();
  const std::size_t knot_count = static_cast<std::size_t>(count) + static_cast<std::size_t>(order);
  scanner.require_room(knot_count, fmt::format("{} knots of {}", knot_count, name));
  std::vector<double> knots(knot_count);
  for (double& knot : knots) knot = scanner.number("a knot of " + name);
  return located(scanner.source(), line, name, [&] { return KnotVector(order - 1, std::move(knots)); });
}

NurbsVolume read_volume(TextScanner& scanner, const std::string& name) {
  if (const int dimension = scanner.integer("the dimension of " + name, 1, 1000); dimension != 3)
    scanner.fail(fmt::format("{} has control points in {} dimensions; 3 are needed", name, dimension),
                 ErrorCode::unsupported);
  const bool rational = scanner.integer("the rational flag of " + name, 0, 1) == 1;
  const int line = scanner.line();
  NurbsVolume::KnotVectors knots;
  for (std::size_t d = 0; d < 3; ++d)
    knots[d] = read_knots(scanner, fmt::format("{}, direction {}", name, d));
  const auto count = located(scanner.source(), line, name,
                             [&] { return checked_control_points(knots[0], knots[1], knots[2]); });
  const Eigen::Index rows = rational ? 4 : 3;
  scanner.require_room(static_cast<std::size_t>(rows * count),
                       fmt::format("{} control points of {}", count, name));
  Eigen::Matrix4Xd points = Eigen::Matrix4Xd::Ones(4, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index r = 0; r < rows; ++r) points(r, i) = scanner.number("a coefficient of " + name);
    if (!(points(3, i) > 0))
      scanner.fail(fmt::format("weight {} of {} is {}; weights must be positive", i, name, points(3, i)));
  }
  return located(scanner.source(), line, name, [&] {
    return rational ? NurbsVolume::from_homogeneous(std::move(knots), points)
                    : NurbsVolume(std::move(knots), points.topRows<3>());
  });
}

}  // namespace

PatchSet read_g2(std::string_view text, const std::string& source) {
  TextScanner scanner(text, source);
  PatchSet result;
  while (!scanner.at_end()) {
    read_header(scanner);
    if (result.patches.size() == max_patches) scanner.fail(fmt::format("more than {} patches", max_patches));
    result.patches.push_back(read_volume(scanner, fmt::format("patch {}", result.patches.size())));
  }
  if (result.patches.empty()) scanner.fail("the file is empty; SplineVolume objects (type 700) are needed");
  return result;
}

}  // namespace isopatch::geometry
