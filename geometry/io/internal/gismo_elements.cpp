#include "geometry/io/internal/gismo_elements.hpp"

#include <fmt/format.h>

#include <utility>

#include "geometry/io/internal/base64_numbers.hpp"

namespace isopatch::geometry {

pugi::xml_node required_child(const XmlText& xml, pugi::xml_node parent, const char* tag,
                              const std::string& name) {
  const pugi::xml_node found = parent.child(tag);
  if (!found) xml.fail(parent, fmt::format("{}: element <{}> lacks its <{}>", name, parent.name(), tag));
  return found;
}

namespace {

// How numbers are written: "" or ASCII, or base64.
std::string_view format_of(const XmlText& xml, pugi::xml_node node, const std::string& what) {
  const std::string_view format = node.attribute("format").value();
  const bool ascii = format.empty() || format == "ASCII" || format == "ascii";
  if (!ascii && !is_base64(format))
    xml.fail(node,
             fmt::format("{}: numbers in format {}; ASCII and base64 (B64Float64) are supported", what,
                         quoted(format)),
             ErrorCode::unsupported);
  return format;
}

}  // namespace

GivenKnots given_knots(const XmlText& xml, pugi::xml_node node, const std::string& name) {
  GivenKnots result;
  result.line = xml.line(node);
  result.degree = xml.integer_attribute(node, "degree", 1, KnotVector::max_degree);
  const std::string content = xml.content(node);
  TextScanner scanner(content, xml.source(), result.line);
  if (const std::string_view format = format_of(xml, node, name); is_base64(format))
    result.knots = base64_numbers(content, format, scanner, "knots of " + name);
  else
    while (!scanner.at_end()) result.knots.push_back(scanner.number("a knot of " + name));
  return result;
}

template <int D>
std::array<GivenKnots, D> given_knots(const XmlText& xml, pugi::xml_node basis, const std::string& name) {
  constexpr std::array<const char*, 4> in_words = {"", "one", "two", "three"};
  std::array<GivenKnots, D> result;
  std::array<bool, D> seen{};
  int next = 0;
  for (const pugi::xml_node factor : basis.children("Basis")) {
    if (next == D) xml.fail(factor, fmt::format("{}: more than {} directions", name, in_words[D]));
    const int index = factor.attribute("index") ? xml.integer_attribute(factor, "index", 0, D - 1) : next;
    const auto direction = static_cast<std::size_t>(index);
    if (seen[direction]) xml.fail(factor, fmt::format("{}: direction {} is given twice", name, index));
    seen[direction] = true;
    ++next;
    result[direction] = given_knots(xml, required_child(xml, factor, "KnotVector", name),
                                    fmt::format("{}, direction {}", name, index));
  }
  if (next != D) xml.fail(basis, fmt::format("{}: {} directions instead of {}", name, next, in_words[D]));
  return result;
}

template std::array<GivenKnots, 2> given_knots<2>(const XmlText&, pugi::xml_node, const std::string&);
template std::array<GivenKnots, 3> given_knots<3>(const XmlText&, pugi::xml_node, const std::string&);

KnotVector knot_vector(const XmlText& xml, GivenKnots given, const std::string& name) {
  return located(xml.source(), given.line, name,
                 [&] { return KnotVector(given.degree, std::move(given.knots)); });
}

Eigen::MatrixXd numbers(const XmlText& xml, pugi::xml_node node, int rows, std::int64_t count,
                        const std::string& what) {
  const std::string_view format = format_of(xml, node, what);
  const std::string content = xml.content(node);
  TextScanner scanner(content, xml.source(), xml.line(node));
  if (is_base64(format)) {
    const std::vector<double> given = base64_numbers(content, format, scanner, what);
    if (static_cast<std::int64_t>(given.size()) != rows * count)
      scanner.fail(
          fmt::format("{} numbers where the knot vectors ask for {} ({})", given.size(), rows * count, what));
    return Eigen::Map<const Eigen::MatrixXd>(given.data(), rows, count);
  }
  scanner.require_room(static_cast<std::size_t>(rows * count),
                       fmt::format("{} numbers ({})", rows * count, what));
  Eigen::MatrixXd result(rows, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (int r = 0; r < rows; ++r) result(r, i) = scanner.number(what + " " + std::to_string(i));
  scanner.expect_end(fmt::format("the {} numbers that the knot vectors ask for ({})", rows * count, what));
  return result;
}

}  // namespace isopatch::geometry
