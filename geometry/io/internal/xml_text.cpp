#include "geometry/io/internal/xml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace isopatch::geometry {

XmlText::XmlText(std::string_view text, std::string source)
    : text_(without_byte_order_mark(text)), source_(std::move(source)) {
  text = text_;
  line_starts_.push_back(0);
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\n') line_starts_.push_back(i + 1);
  // The encoding is fixed so that the offsets of the nodes are those of the text.
  const auto result =
      document_.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (result) return;
  const int line = line_at(result.offset);
  const auto column =
      result.offset - static_cast<std::ptrdiff_t>(line_starts_[static_cast<std::size_t>(line) - 1]);
  throw Error(ErrorCode::bad_format,
              fmt::format("{}:{}: broken XML at column {}: {}; the file may be cut off", source_, line,
                          column + 1, result.description()));
}

int XmlText::line_at(std::ptrdiff_t offset) const {
  const auto position = static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0));
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), position);
  return static_cast<int>(after - line_starts_.begin());
}

int XmlText::line(pugi::xml_node node) const {
  return line_at(node.offset_debug());
}

std::string XmlText::content(pugi::xml_node node) const {
  std::string result;
  int reached = line(node);
  for (const pugi::xml_node child : node.children()) {
    if (child.type() != pugi::node_pcdata && child.type() != pugi::node_cdata) continue;
    const int begin = line(child);
    result.append(static_cast<std::size_t>(std::max(begin - reached, 0)), '\n');
    result += ' ';
    const std::string_view piece = child.value();
    result += piece;
    reached = begin + static_cast<int>(std::count(piece.begin(), piece.end(), '\n'));
  }
  return result;
}

int XmlText::integer_attribute(pugi::xml_node node, const char* name, int low, int high) const {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute) fail(node, fmt::format("element <{}> lacks the attribute '{}'", node.name(), name));
  TextScanner scanner(attribute.value(), source_, line(node));
  const int value = scanner.integer(fmt::format("attribute '{}'", name), low, high);
  scanner.expect_end(fmt::format("the number in attribute '{}'", name));
  return value;
}

void XmlText::fail(pugi::xml_node node, const std::string& message, ErrorCode code) const {
  throw Error(code, fmt::format("{}:{}: {}", source_, line(node), message));
}

}  // namespace isopatch::geometry
