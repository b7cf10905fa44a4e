#include "geometry/brep/internal/step_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

/// A piece of the text to be said otherwise.
struct Edit {
  std::size_t begin = 0, end = 0;
  std::string text;
};

bool is_ascii(std::string_view bytes) {
  return std::all_of(bytes.begin(), bytes.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

bool is_utf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto lead = static_cast<unsigned char>(bytes[i]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xc2 && lead < 0xe0 ? 2
                               : lead >= 0xe0 && lead < 0xf0 ? 3
                               : lead >= 0xf0 && lead < 0xf5 ? 4
                                                             : 0;
    if (length == 0 || i + length > bytes.size()) return false;
    for (std::size_t k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(bytes[i + k]) & 0xc0) != 0x80) return false;
    i += length;
  }
  return true;
}

// Where Windows-1252 differs from Latin-1; 0 where it has nothing.
constexpr std::array<int, 32> windows = {0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021,
                                         0x02c6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017d, 0,
                                         0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022, 0x2013, 0x2014,
                                         0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

void append_utf8(std::string& text, int code) {
  if (code < 0x80) {
    text += static_cast<char>(code);
  } else if (code < 0x800) {
    text += static_cast<char>(0xc0 | (code >> 6));
    text += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    text += static_cast<char>(0xe0 | (code >> 12));
    text += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    text += static_cast<char>(0x80 | (code & 0x3f));
  }
}

/// "1e-3" as "1.E-3".
std::string regular(std::string_view number) {
  const std::size_t exponent = number.find_first_of("eE");
  std::string result(number.substr(0, exponent));
  if (result.find('.') == result.npos) result += '.';
  return result + "E" + std::string(number.substr(exponent + 1));
}

std::string edited(std::string_view text, std::vector<Edit> edits) {
  std::sort(edits.begin(), edits.end(), [](const Edit& a, const Edit& b) { return a.begin < b.begin; });
  std::string result;
  std::size_t from = 0;
  for (const Edit& edit : edits) {
    if (edit.begin < from) continue;  // within the one before, which says it already
    result += text.substr(from, edit.begin - from);
    result += edit.text;
    from = edit.end;
  }
  return result += text.substr(from);
}

}  // namespace

std::string utf8_name(std::string_view bytes) {
  if (is_utf8(bytes)) return std::string(bytes);
  std::string result;
  for (const char c : bytes) {
    const int code = static_cast<unsigned char>(c);
    const int changed = code >= 0x80 && code < 0xa0 ? windows[static_cast<std::size_t>(code - 0x80)] : code;
    append_utf8(result, changed == 0 ? '?' : changed);
  }
  return result;
}

void require_coordinates(const Part21File& file) {
  for (const Part21Instance& instance : file.instances()) {
    if (instance.type != "CARTESIAN_POINT" && instance.type != "DIRECTION") continue;
    const auto records = file.records(instance);
    const auto& values = records.front().values;
    const auto& numbers = values.size() == 2 ? values[1].items : values;
    const bool right = values.size() == 2 && !numbers.empty() && numbers.size() <= 3 &&
                       std::all_of(numbers.begin(), numbers.end(), [](const Part21Value& value) {
                         return value.kind == Part21Value::Kind::number;
                       });
    if (!right)
      throw Error(ErrorCode::bad_format,
                  fmt::format("{}:{}: #{} = {} must have a name and one to three numbers", file.source(),
                              instance.line, instance.id, instance.type));
  }
}

std::string kernel_text(const Part21File& file, const StepUnits& units) {
  const std::string_view text = file.text();
  const auto place = [&](std::string_view piece) {
    return static_cast<std::size_t>(piece.data() - text.data());
  };
  std::vector<Edit> edits;
  for (const auto& [id, said] : units.replaced) {
    const std::string_view body = file.find(id)->body;
    edits.push_back({place(body), place(body) + body.size(), said});
  }
  if (!units.added.empty()) edits.push_back({file.end_of_data(), file.end_of_data(), units.added});
  for (const std::string_view number : file.irregular_numbers())
    edits.push_back({place(number), place(number) + number.size(), regular(number)});
  if (!is_ascii(text))
    for (const std::string_view name : file.texts())
      if (!is_utf8(name)) edits.push_back({place(name), place(name) + name.size(), utf8_name(name)});
  return edited(text, std::move(edits));
}

}  // namespace isopatch::geometry
