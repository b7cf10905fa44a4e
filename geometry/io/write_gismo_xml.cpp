#include "geometry/io/write_gismo_xml.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string_view>
#include <vector>

#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

// Text that grows: one for the whole file, local to it.
using Text = fmt::memory_buffer;

template <class... Args>
void add(Text& text, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
}

std::string escaped(std::string_view raw) {
  std::string result;
  for (const char c : raw) switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        if (c >= 0 && c < ' ')
          result += fmt::format("&#{};", static_cast<int>(c));
        else
          result += c;
    }
  return result;
}

void add_basis(Text& text, const NurbsVolume& patch) {
  if (patch.is_rational()) add(text, "  <Basis type=\"TensorNurbsBasis3\">\n");
  add(text, "  <Basis type=\"TensorBSplineBasis3\">\n");
  for (int d = 0; d < 3; ++d)
    add(text,
        "   <Basis type=\"BSplineBasis\" index=\"{}\">\n    <KnotVector degree=\"{}\">{}</KnotVector>\n   "
        "</Basis>\n",
        d, patch.degree(d), fmt::join(patch.knots(d).knots(), " "));
  add(text, "  </Basis>\n");
  if (patch.is_rational())
    add(text, "  <weights>{}</weights>\n  </Basis>\n", fmt::join(patch.weights(), "\n"));
}

void add_patch(Text& text, const NurbsVolume& patch, std::size_t id) {
  add(text, " <Geometry type=\"{}\" id=\"{}\">\n", patch.is_rational() ? "TensorNurbs3" : "TensorBSpline3",
      id);
  add_basis(text, patch);
  add(text, "  <coefs geoDim=\"3\">");
  for (const auto& point : patch.control_points().colwise())
    add(text, "{} {} {}\n", point[0], point[1], point[2]);
  add(text, "</coefs>\n </Geometry>\n");
}

// A face as G+Smo names it: patch id and side 1 .. 6.
std::string numbers(const PatchFace& face) {
  return fmt::format("{} {}", face.patch.value, static_cast<int>(face.side) + 1);
}

void add_faces(Text& text, const std::vector<PatchFace>& faces, const std::string& name) {
  add(text, "  <boundary{}>", name.empty() ? "" : fmt::format(" name=\"{}\"", escaped(name)));
  for (const PatchFace& face : faces) add(text, "{}\n", numbers(face));
  add(text, "</boundary>\n");
}

// "patch side patch side", where each direction of the first patch goes on the second, and whether both run
// the same way there; across the interface: whether one runs on into the other.
std::string interface_line(const StatedInterface& interface) {
  const PatchFace &first = interface.first, &second = interface.second;
  const auto on_first = tangents(first.side);
  const auto on_second = tangents(second.side);
  const FaceOrientation& o = interface.orientation;
  std::array<int, 3> map{};
  std::array<bool, 3> same{};
  const auto across = static_cast<std::size_t>(direction(first.side));
  map[across] = direction(second.side);
  same[across] = is_high(first.side) != is_high(second.side);
  for (std::size_t t = 0; t < 2; ++t) {
    const auto d = static_cast<std::size_t>(on_first[t]);
    const std::size_t image = o.swapped ? 1 - t : t;
    map[d] = on_second[image];
    same[d] = !(image == 0 ? o.flip_first : o.flip_second);
  }
  return fmt::format("{} {} {} {:d} {:d} {:d}", numbers(first), numbers(second), fmt::join(map, " "), same[0],
                     same[1], same[2]);
}

void add_interfaces(Text& text, const std::vector<StatedInterface>& interfaces) {
  add(text, "  <interfaces>");
  for (const StatedInterface& interface : interfaces) add(text, "{}\n", interface_line(interface));
  add(text, "</interfaces>\n");
}

std::vector<StatedInterface> interfaces_in_input_names(const MultiPatch& model) {
  std::vector<StatedInterface> result;
  for (const Interface& i : model.interfaces())
    result.push_back(turned_around({i.first, i.second, i.orientation}, model.was_reversed(i.first.patch),
                                   model.was_reversed(i.second.patch)));
  return result;
}

std::vector<PatchFace> to_input(const MultiPatch& model, const std::vector<PatchFace>& faces) {
  std::vector<PatchFace> result;
  for (const PatchFace& face : faces) result.push_back(model.to_input(face));
  return result;
}

Text opening(const std::vector<NurbsVolume>& patches) {
  Text text;
  add(text,
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!--Written by isopatch in the format of "
      "G+Smo-->\n<xml>\n");
  for (std::size_t p = 0; p < patches.size(); ++p) add_patch(text, patches[p], p);
  add(text, " <MultiPatch parDim=\"3\" id=\"{0}\">\n  <patches type=\"id_range\">0 {1}</patches>\n",
      patches.size(), patches.size() - 1);
  return text;
}

std::string closed(Text& text) {
  add(text, " </MultiPatch>\n</xml>\n");
  return fmt::to_string(text);
}

}  // namespace

std::string to_gismo_xml(const MultiPatch& model) {
  std::vector<NurbsVolume> patches = model.patches();
  for (std::size_t p = 0; p < patches.size(); ++p)
    if (model.was_reversed(PatchId(static_cast<int>(p)))) patches[p] = reversed(patches[p], 0);
  Text text = opening(patches);
  add_interfaces(text, interfaces_in_input_names(model));
  // All outer faces first: older versions of G+Smo read only the first list, newer ones drop repetitions.
  if (!model.boundary_faces().empty()) add_faces(text, to_input(model, model.boundary_faces()), "");
  for (const Boundary& boundary : model.boundaries())
    add_faces(text, to_input(model, boundary.faces), boundary.name);
  return closed(text);
}

std::string to_gismo_xml(const PatchSet& patches) {
  Text text = opening(patches.patches);
  if (!patches.interfaces.empty()) add_interfaces(text, patches.interfaces);
  for (const Boundary& boundary : patches.boundaries) add_faces(text, boundary.faces, boundary.name);
  return closed(text);
}

}  // namespace isopatch::geometry
