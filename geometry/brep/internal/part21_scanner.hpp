#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace isopatch::geometry {

/// A token of a STEP file.
struct Part21Token {
  enum class Kind { end, word, number, text, enumeration, reference, binary, sign };
  Kind kind = Kind::end;
  std::string_view bytes;  ///< of a text with its quotes
  std::size_t begin = 0;
  int line = 1;  ///< where it begins
  double number = 0;
  std::int64_t reference = 0;  ///< of "#12"

  bool is(char sign) const { return kind == Kind::sign && bytes.front() == sign; }
  bool is(std::string_view word) const { return kind == Kind::word && bytes == word; }
};

/// Takes a STEP file apart, token by token; comments and white space are passed over.
class Part21Scanner {
 public:
  /// @param line  of the text's first character
  Part21Scanner(std::string_view text, std::string source, int line = 1);

  /// @throws Error bad_format  what is no token, with "source:line: "
  Part21Token next();
  /// What is being read, for messages: "#12 = PLANE"; "" for nothing.
  void set_entity(std::string entity) { entity_ = std::move(entity); }
  /// @throws Error bad_format  always: "source:line: entity: message"
  [[noreturn]] void fail(int line, const std::string& message) const;
  int line() const { return line_; }

 private:
  void skip_space();
  Part21Token text_token(Part21Token token);
  Part21Token number_token(Part21Token token);
  Part21Token take(Part21Token token, Part21Token::Kind kind, std::size_t end);
  char at(std::size_t place) const { return place < text_.size() ? text_[place] : '\0'; }

  std::string_view text_;
  std::string source_;
  std::string entity_;
  std::size_t place_ = 0;
  int line_;
};

}  // namespace isopatch::geometry
