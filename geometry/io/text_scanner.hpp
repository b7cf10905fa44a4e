#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

/// Reads the words and numbers of a text one after the other and knows the line of each.
///
/// A byte order mark of UTF-8 at the beginning is skipped. Numbers are read the same whatever the locale.
/// Every error is an Error that begins with "source:line: ".
class TextScanner {
 public:
  /// @param text        must outlive the scanner
  /// @param source      the file's name, for messages
  /// @param first_line  line of the text's first character
  /// @param comment     a character that begins a comment up to the line's end; '\0': none
  TextScanner(std::string_view text, std::string source, int first_line = 1, char comment = '\0');

  /// Whether only white space and comments are left.
  bool at_end();
  /// The next word without taking it; "" at the end.
  std::string_view peek();
  /// @param what  what is expected, for the message if the text ends
  std::string_view word(std::string_view what);
  /// The next word, which must be `expected`.
  void expect(std::string_view expected);
  /// A finite number; magnitudes too small for a double are 0.
  double number(std::string_view what);
  /// A finite number, or a fraction of two: "-1/2".
  double fraction(std::string_view what);
  /// An integer in [low, high].
  int integer(std::string_view what, int low, int high);
  /// The rest of the current line, trimmed, without its comment.
  std::string_view rest_of_line();

  /// Fails unless the rest is long enough to hold `count` more numbers: call it before allocating them.
  void require_room(std::size_t count, std::string_view what);
  /// Fails if anything but white space and comments is left.
  void expect_end(std::string_view after);

  const std::string& source() const { return source_; }
  /// Line of the word read last.
  int line() const { return word_line_; }
  [[noreturn]] void fail(const std::string& message, ErrorCode code = ErrorCode::bad_format) const;

 private:
  void skip_space();
  double number_in(std::string_view word, std::string_view what) const;

  std::string_view text_;
  std::string source_;
  std::size_t position_ = 0;
  int line_;
  int word_line_;
  char comment_;
};

/// Calls `make`, and begins the message of an Error that it throws with "source:line: where: "; the code
/// invalid_argument becomes bad_format.
template <class Make>
auto located(const std::string& source, int line, const std::string& where, Make make) {
  try {
    return make();
  } catch (const Error& error) {
    const bool is_argument = error.code() == ErrorCode::invalid_argument;
    throw Error(is_argument ? ErrorCode::bad_format : error.code(),
                source + ":" + std::to_string(line) + ": " + where + ": " + error.what());
  }
}

/// Without the bytes by which some editors mark UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// A word of a broken file for a message: shortened, unprintable bytes replaced.
std::string quoted(std::string_view word);

}  // namespace isopatch::geometry
