#include "geometry/brep/iges_header.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

struct Unit {
  int flag;
  std::string_view name;  ///< as the file writes it
  std::string_view shown;
  double metres;
};
// IGES 5.3, 2.2.4.3.14 and 15; flag 3 says that the name alone counts.
constexpr std::array<Unit, 12> units = {{{1, "IN", "inch", 0.0254},
                                         {1, "INCH", "inch", 0.0254},
                                         {2, "MM", "mm", 1e-3},
                                         {4, "FT", "foot", 0.3048},
                                         {5, "MI", "mile", 1609.344},
                                         {6, "M", "m", 1},
                                         {7, "KM", "km", 1e3},
                                         {8, "MIL", "mil", 2.54e-5},
                                         {9, "UM", "um", 1e-6},
                                         {10, "CM", "cm", 1e-2},
                                         {11, "UIN", "microinch", 2.54e-8},
                                         {2, "MILLIMETER", "mm", 1e-3}}};

constexpr std::size_t columns = 72;

std::string global_section(std::string_view text) {
  std::string result;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    std::string_view line = text.substr(from, end - from);
    from = end + 1;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.size() <= columns) continue;
    if (line[columns] == 'G') result += line.substr(0, columns);
    if (line[columns] == 'D' || line[columns] == 'P') break;
  }
  return result;
}

std::string trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == text.npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

/// The parameters of the section; texts (nHtext) without their count.
class Parameters {
 public:
  Parameters(std::string text, std::string source) : text_(std::move(text)), source_(std::move(source)) {
    read();
  }
  std::string at(std::size_t number) const { return number <= values_.size() ? values_[number - 1] : ""; }

 private:
  // The first two parameters say what separates parameters and what ends them.
  void read() {
    const auto delimiter = [&](char fallback) {
      char result = fallback;
      if (text_.compare(place_, 2, "1H") == 0 && place_ + 2 < text_.size()) {
        result = text_[place_ + 2];
        place_ += 3;
      }
      return result;
    };
    separator_ = delimiter(',');
    if (place_ < text_.size() && text_[place_] == separator_) ++place_;
    end_ = delimiter(';');
    if (place_ < text_.size() && text_[place_] == separator_) ++place_;
    values_ = {std::string(1, separator_), std::string(1, end_)};
    while (next()) {
    }
  }

  bool next() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
    std::size_t count = 0;
    const auto [stop, problem] = std::from_chars(text_.data() + place_, text_.data() + text_.size(), count);
    const auto after = static_cast<std::size_t>(stop - text_.data());
    if (problem == std::errc{} && after < text_.size() && text_[after] == 'H' &&
        count <= text_.size() - after - 1) {
      values_.push_back(text_.substr(after + 1, count));
      place_ = after + 1 + count;
      skip_to_delimiter();
    } else {
      const std::size_t from = place_;
      skip_to_delimiter();
      values_.push_back(trimmed(std::string_view(text_).substr(from, place_ - from)));
    }
    if (place_ >= text_.size())
      throw Error(ErrorCode::bad_format, source_ + ": the global section of the IGES file does not end");
    return text_[place_++] != end_;
  }

  void skip_to_delimiter() {
    while (place_ < text_.size() && text_[place_] != separator_ && text_[place_] != end_) ++place_;
  }

  std::string text_, source_;
  std::size_t place_ = 0;
  char separator_ = ',', end_ = ';';
  std::vector<std::string> values_;
};

template <class Holds>
std::optional<Unit> unit_that(Holds holds) {
  for (const Unit& unit : units)
    if (holds(unit)) return unit;
  return std::nullopt;
}

std::optional<double> number(std::string text) {
  for (char& c : text)
    if (c == 'D' || c == 'd') c = 'E';
  if (!text.empty() && text.front() == '+') text.erase(0, 1);
  double value = 0;
  const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc{} || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

IgesHeader iges_header(std::string_view text, const std::string& source) {
  const std::string section = global_section(text);
  if (section.empty())
    throw Error(ErrorCode::bad_format, source + ": this is no IGES file: it has no global section");
  const Parameters parameters(section, source);
  IgesHeader result;
  const std::string flag_text = parameters.at(14), name = parameters.at(15);
  const double flag = number(flag_text).value_or(0);
  const auto by_flag = unit_that([&](const Unit& unit) { return unit.flag == flag; });
  const auto by_name = unit_that([&](const Unit& unit) { return unit.name == name; });
  const auto found = flag == 3 ? by_name : by_flag ? by_flag : by_name;
  result.has_unit = found.has_value();
  if (found) {
    result.unit = found->shown;
    result.metres = found->metres;
  }
  if (!found)
    result.warnings.push_back(
        fmt::format("the unit of length (flag '{}', name '{}') is none that IGES knows; mm is taken; give "
                    "length_unit if it is another",
                    flag_text, name));
  else if (flag != 3 && by_flag && by_name && by_flag->metres != by_name->metres)
    result.warnings.push_back(fmt::format("the unit's flag says {}, its name says {}; {} is taken",
                                          by_flag->shown, by_name->shown, by_flag->shown));
  if (const std::string scale = parameters.at(13); !scale.empty()) {
    const auto value = number(scale);
    if (!value || !(*value > 0))
      throw Error(ErrorCode::bad_format,
                  fmt::format("{}: the scale of the model is '{}'; it must be positive", source, scale));
    result.scale = *value;
  }
  if (result.scale != 1)
    result.warnings.push_back(
        fmt::format("the model is drawn {:.6g} times its size; lengths are divided by that", result.scale));
  return result;
}

}  // namespace isopatch::geometry
