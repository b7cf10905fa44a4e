#include "app/results/place_values.hpp"

#include <fmt/format.h>

#include <cctype>
#include <fstream>

#include "app/base/place_tolerance.hpp"
#include "app/results/stored_results.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::app {
namespace {

constexpr const char* heading =
    "place,x,y,z,distance,patch,material,u_x,u_y,u_z,s_xx,s_yy,s_zz,s_xy,s_yz,s_zx,von_mises\n";

// A text field as RFC 4180 has it.
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string row(const iga::FieldValues& v, int patch, const std::string& material) {
  const Eigen::Matrix3d& s = v.stress;
  const auto& u = v.displacement;
  return fmt::format(
      "{},{},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g}\n", patch,
      quoted(material), u[0], u[1], u[2], s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(2, 0), v.von_mises);
}

}  // namespace

std::vector<Eigen::Vector3d> line_places(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int count) {
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    places.emplace_back((1 - share) * from + share * to);
  }
  return places;
}

std::vector<Eigen::Vector3d> read_places(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw Error(ErrorCode::io, fmt::format("cannot read {}", path.string()));
  std::vector<Eigen::Vector3d> places;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
    if (line.empty() || line.front() == '#' || std::isalpha(static_cast<unsigned char>(line.front())))
      continue;
    try {
      places.push_back(parse_point(line));
    } catch (const Error& error) {
      throw Error(ErrorCode::invalid_argument, fmt::format("{}:{}: {}", path.string(), number, error.what()));
    }
  }
  if (places.empty())
    throw Error(ErrorCode::invalid_argument, fmt::format("{} has no place X,Y,Z", path.string()));
  return places;
}

std::string places_csv(const iga::StoredResult& result, const std::vector<Eigen::Vector3d>& places) {
  const double within = place_tolerance * iga::model_of(result).size();
  std::string text = heading;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d& place = places[i];
    const std::string at = fmt::format("{},{:.12g},{:.12g},{:.12g},{:.12g},", i + 1, place[0], place[1],
                                       place[2], (place - places.front()).norm());
    const std::vector<iga::Location> sides = iga::locate_sides(result.field, place, within);
    if (sides.front().distance > within) {
      text += at + ",,,,,,,,,,,\n";
      continue;
    }
    for (const iga::Location& side : sides)
      text += at + row(iga::evaluate(result.field, side.patch, side.parameter), side.patch,
                       result.field.materials[static_cast<std::size_t>(side.patch)].name);
  }
  return text;
}

}  // namespace isopatch::app
