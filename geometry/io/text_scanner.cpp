#include "geometry/io/text_scanner.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace isopatch::geometry {
namespace {

bool is_space(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// from_chars knows no leading plus.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
  return word;
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : word.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (word.size() > longest ? "...'" : "'");
}

TextScanner::TextScanner(std::string_view text, std::string source, int first_line, char comment)
    : text_(text), source_(std::move(source)), line_(first_line), word_line_(first_line), comment_(comment) {
  text_ = without_byte_order_mark(text_);
}

void TextScanner::skip_space() {
  while (position_ < text_.size()) {
    const char c = text_[position_];
    if (comment_ != '\0' && c == comment_) {
      while (position_ < text_.size() && text_[position_] != '\n') ++position_;
    } else if (is_space(c)) {
      line_ += c == '\n';
      ++position_;
    } else {
      return;
    }
  }
}

bool TextScanner::at_end() {
  skip_space();
  return position_ == text_.size();
}

std::string_view TextScanner::peek() {
  skip_space();
  std::size_t end = position_;
  while (end < text_.size() && !is_space(text_[end]) && !(comment_ != '\0' && text_[end] == comment_)) ++end;
  return text_.substr(position_, end - position_);
}

std::string_view TextScanner::word(std::string_view what) {
  const std::string_view result = peek();
  word_line_ = line_;
  if (result.empty())
    fail(fmt::format("the data end where {} is expected; the file may be cut off or a count wrong", what));
  position_ += result.size();
  return result;
}

void TextScanner::expect(std::string_view expected) {
  const std::string_view found = word(fmt::format("'{}'", expected));
  if (found != expected) fail(fmt::format("{} found where '{}' is expected", quoted(found), expected));
}

double TextScanner::number(std::string_view what) {
  return number_in(word(what), what);
}

double TextScanner::fraction(std::string_view what) {
  const std::string_view whole = word(what);
  const std::size_t bar = whole.find('/');
  if (bar == whole.npos) return number_in(whole, what);
  const double value = number_in(whole.substr(0, bar), what) / number_in(whole.substr(bar + 1), what);
  if (!std::isfinite(value)) fail(fmt::format("{} is {}; it must be finite", what, quoted(whole)));
  return value;
}

double TextScanner::number_in(std::string_view whole, std::string_view what) const {
  const std::string_view digits = without_plus(whole);
  double value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || status == std::errc::invalid_argument)
    fail(fmt::format("{} is not a number, where {} is expected", quoted(whole), what));
  if (status == std::errc::result_out_of_range) {
    const std::size_t exponent = digits.find_first_of("eE");
    if (exponent + 1 < digits.size() && exponent != digits.npos && digits[exponent + 1] == '-') return 0;
    fail(fmt::format("{} is too large for a double, where {} is expected", quoted(whole), what));
  }
  if (!std::isfinite(value)) fail(fmt::format("{} is {}; it must be finite", what, quoted(whole)));
  return value;
}

int TextScanner::integer(std::string_view what, int low, int high) {
  const std::string_view whole = word(what);
  const std::string_view digits = without_plus(whole);
  int value = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (end != digits.data() + digits.size() || status == std::errc::invalid_argument)
    fail(fmt::format("{} is not an integer, where {} is expected", quoted(whole), what));
  if (status == std::errc::result_out_of_range || value < low || value > high)
    fail(fmt::format("{} is {}, outside {} .. {}", what, quoted(whole), low, high));
  return value;
}

std::string_view TextScanner::rest_of_line() {
  word_line_ = line_;
  std::size_t end = position_;
  while (end < text_.size() && text_[end] != '\n' && !(comment_ != '\0' && text_[end] == comment_)) ++end;
  std::string_view result = text_.substr(position_, end - position_);
  position_ = end;
  while (!result.empty() && is_space(result.front())) result.remove_prefix(1);
  while (!result.empty() && is_space(result.back())) result.remove_suffix(1);
  return result;
}

void TextScanner::require_room(std::size_t count, std::string_view what) {
  // Each number takes a digit and, but for the last, a space.
  if (count > (text_.size() - position_ + 1) / 2)
    fail(
        fmt::format("{} are announced, more than the rest of the data can hold; "
                    "the file may be cut off or a count wrong",
                    what));
}

void TextScanner::expect_end(std::string_view after) {
  if (at_end()) return;
  const std::string_view found = word("nothing");
  fail(fmt::format("{} follows {}; remove what does not belong there, or correct a count", quoted(found),
                   after));
}

void TextScanner::fail(const std::string& message, ErrorCode code) const {
  throw Error(code, fmt::format("{}:{}: {}", source_, word_line_, message));
}

}  // namespace isopatch::geometry
