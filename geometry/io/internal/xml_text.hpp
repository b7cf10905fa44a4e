#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/io/text_scanner.hpp"

namespace isopatch::geometry {

/// A parsed XML text that knows the line of each of its nodes. For the .cpp files of this folder only.
class XmlText {
 public:
  /// @throws Error bad_format with line and column for XML that does not parse
  XmlText(std::string_view text, std::string source);

  pugi::xml_node root() const { return document_.document_element(); }
  const std::string& source() const { return source_; }
  int line(pugi::xml_node node) const;
  /// The text inside an element, around its comments, each piece on its own line of the file.
  std::string content(pugi::xml_node node) const;
  /// The element's attribute as an integer in [low, high].
  int integer_attribute(pugi::xml_node node, const char* name, int low, int high) const;
  [[noreturn]] void fail(pugi::xml_node node, const std::string& message,
                         ErrorCode code = ErrorCode::bad_format) const;

 private:
  int line_at(std::ptrdiff_t offset) const;

  pugi::xml_document document_;
  std::string_view text_;
  std::string source_;
  std::vector<std::size_t> line_starts_;
};

}  // namespace isopatch::geometry
