#include "geometry/brep/internal/part21_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_';
}
// What may stand behind a number, a reference or an enumeration.
bool ends_value(char c) {
  return c == ',' || c == ')' || c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '=' || c == ';' ||
         c == '/' || c == '\0';
}

std::string shown(std::string_view bytes) {
  std::string text;
  for (const char c : bytes.substr(0, 40)) text += c >= ' ' && c <= '~' ? c : '?';
  return text;
}

}  // namespace

Part21Scanner::Part21Scanner(std::string_view text, std::string source, int line)
    : text_(text), source_(std::move(source)), line_(line) {}

void Part21Scanner::fail(int line, const std::string& message) const {
  throw Error(ErrorCode::bad_format,
              fmt::format("{}:{}: {}{}{}", source_, line, entity_, entity_.empty() ? "" : ": ", message));
}

void Part21Scanner::skip_space() {
  while (place_ < text_.size()) {
    const char c = text_[place_];
    if (c == '\n') ++line_;
    if (c == '/' && at(place_ + 1) == '*') {
      const std::size_t end = text_.find("*/", place_ + 2);
      if (end == text_.npos) fail(line_, "a comment (/*) does not end");
      line_ += static_cast<int>(
          std::count(text_.begin() + std::ptrdiff_t(place_), text_.begin() + std::ptrdiff_t(end), '\n'));
      place_ = end + 2;
    } else if (static_cast<unsigned char>(c) <= ' ') {
      ++place_;
    } else {
      return;
    }
  }
}

Part21Token Part21Scanner::take(Part21Token token, Part21Token::Kind kind, std::size_t end) {
  token.kind = kind;
  token.bytes = text_.substr(place_, end - place_);
  place_ = end;
  return token;
}

Part21Token Part21Scanner::text_token(Part21Token token) {
  std::size_t end = place_ + 1;
  while (true) {
    end = text_.find('\'', end);
    if (end == text_.npos) fail(token.line, "a text does not end: a quote (') is missing");
    if (at(end + 1) != '\'') break;
    end += 2;
  }
  const auto from = text_.begin() + std::ptrdiff_t(place_);
  line_ += static_cast<int>(std::count(from, text_.begin() + std::ptrdiff_t(end), '\n'));
  return take(token, Part21Token::Kind::text, end + 1);
}

Part21Token Part21Scanner::number_token(Part21Token token) {
  std::size_t end = place_;
  while (!ends_value(at(end)) && at(end) != '(') ++end;
  std::string_view digits = text_.substr(place_, end - place_);
  const std::string_view whole = digits;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  const bool plain = digits.find_first_not_of("+-.0123456789eE") == digits.npos;
  const auto [stop, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), token.number);
  if (problem == std::errc::result_out_of_range && plain && stop == digits.data() + digits.size())
    token.number = digits.find("E-") != digits.npos || digits.find("e-") != digits.npos ? 0 : INFINITY;
  else if (problem != std::errc{} || !plain || stop != digits.data() + digits.size())
    fail(token.line, fmt::format("'{}' is no number", shown(whole)));
  if (!std::isfinite(token.number))
    fail(token.line, fmt::format("{} is too large for a number", shown(whole)));
  return take(token, Part21Token::Kind::number, end);
}

Part21Token Part21Scanner::next() {
  skip_space();
  Part21Token token;
  token.line = line_;
  token.begin = place_;
  if (place_ >= text_.size()) return token;
  const char c = text_[place_];
  if (c == '\'') return text_token(token);
  if (is_digit(c) || c == '+' || c == '-' || (c == '.' && is_digit(at(place_ + 1))))
    return number_token(token);
  std::size_t end = place_ + 1;
  if (is_letter(c) || c == '!') {
    while (is_letter(at(end)) || is_digit(at(end)) || at(end) == '-') ++end;
    return take(token, Part21Token::Kind::word, end);
  }
  if (c == '.') {
    while (is_letter(at(end)) || is_digit(at(end))) ++end;
    if (at(end) != '.' || end == place_ + 1)
      fail(line_, fmt::format("'{}' is no value", shown(text_.substr(place_, end - place_ + 1))));
    return take(token, Part21Token::Kind::enumeration, end + 1);
  }
  if (c == '"') {
    end = text_.find('"', end);
    if (end == text_.npos) fail(line_, "a binary value does not end: a quote (\") is missing");
    return take(token, Part21Token::Kind::binary, end + 1);
  }
  if (c == '#' || c == '@') {
    while (is_digit(at(end)) || is_letter(at(end))) ++end;
    const std::string_view digits = text_.substr(place_ + 1, end - place_ - 1);
    const auto [stop, problem] =
        std::from_chars(digits.data(), digits.data() + digits.size(), token.reference);
    if (problem != std::errc{} || stop != digits.data() + digits.size() || !ends_value(at(end)))
      fail(line_, fmt::format("'{}' is no number of an instance", shown(text_.substr(place_, end - place_))));
    return take(token, Part21Token::Kind::reference, end);
  }
  return take(token, Part21Token::Kind::sign, end);
}

}  // namespace isopatch::geometry
