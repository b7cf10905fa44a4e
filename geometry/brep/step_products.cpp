#include "geometry/brep/step_products.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>

namespace isopatch::geometry {
namespace {

constexpr std::array<std::string_view, 3> solids = {"MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS", "FACETED_BREP"};
constexpr std::array<std::string_view, 18> other_kinds = {"CSG_SOLID",
                                                          "EXTRUDED_AREA_SOLID",
                                                          "EXTRUDED_FACE_SOLID",
                                                          "REVOLVED_AREA_SOLID",
                                                          "REVOLVED_FACE_SOLID",
                                                          "SOLID_REPLICA",
                                                          "SWEPT_DISK_SOLID",
                                                          "SURFACE_CURVE_SWEPT_AREA_SOLID",
                                                          "BLOCK",
                                                          "SPHERE",
                                                          "RIGHT_CIRCULAR_CYLINDER",
                                                          "RIGHT_CIRCULAR_CONE",
                                                          "RIGHT_ANGULAR_WEDGE",
                                                          "TORUS",
                                                          "TESSELLATED_SOLID",
                                                          "TESSELLATED_SHELL",
                                                          "TRIANGULATED_FACE",
                                                          "COMPLEX_TRIANGULATED_FACE"};

template <class Names>
bool is_one_of(const Names& names, std::string_view type) {
  return std::find(names.begin(), names.end(), type) != names.end();
}

/// The types of an instance; several for a complex one.
std::vector<std::string> types_of(const Part21File& file, const Part21Instance& instance) {
  if (!instance.type.empty()) return {std::string(instance.type)};
  std::vector<std::string> types;
  for (const Part21Record& record : file.records(instance)) types.push_back(record.type);
  return types;
}

bool has_type(const Part21File& file, const Part21Instance& instance, std::string_view type) {
  const auto types = types_of(file, instance);
  return is_one_of(types, type);
}

/// Follows a product's parts.
class Counter {
 public:
  std::map<std::int64_t, std::vector<std::int64_t>> parts;  ///< of a product, once for each place
  std::map<std::int64_t, int> own;                          ///< bodies of a product itself

  std::optional<int> count(std::int64_t product, int depth = 0) const {
    if (depth > 100) return std::nullopt;
    int sum = own.contains(product) ? own.at(product) : 0;
    const auto found = parts.find(product);
    if (found == parts.end()) return sum;
    for (const std::int64_t part : found->second) {
      const auto more = count(part, depth + 1);
      if (!more || sum > 1'000'000) return std::nullopt;
      sum += *more;
    }
    return sum;
  }
};

}  // namespace

StepProducts::StepProducts(const Part21File& file) : file_(file) {
  for (const Part21Instance& instance : file.instances()) {
    for (const std::int64_t used : file.references(instance)) users_[used].push_back(instance.id);
    if (is_one_of(other_kinds, instance.type)) other_solids_.push_back(&instance);
  }
  count_bodies();
}

std::string StepProducts::product_of(std::int64_t entity) const {
  std::deque<std::int64_t> open = {entity};
  std::set<std::int64_t> seen = {entity};
  const auto visit = [&](std::int64_t id) {
    if (seen.insert(id).second) open.push_back(id);
  };
  while (!open.empty()) {
    const std::int64_t id = open.front();
    open.pop_front();
    const Part21Instance* instance = file_.find(id);
    if (instance == nullptr) continue;
    if (instance->type == "PRODUCT") {
      const auto records = file_.records(*instance);
      const auto& values = records.front().values;
      if (values.size() > 1 && !values[1].text.empty()) return values[1].text;
      return values.empty() ? "" : values[0].text;
    }
    // Down again only where a product hangs on its shape, and from shapes that are the same one.
    const bool downwards = instance->type == "SHAPE_DEFINITION_REPRESENTATION" ||
                           instance->type == "PRODUCT_DEFINITION_SHAPE" ||
                           instance->type == "PRODUCT_DEFINITION" ||
                           instance->type.starts_with("PRODUCT_DEFINITION_FORMATION") ||
                           instance->type == "SHAPE_REPRESENTATION_RELATIONSHIP";
    if (downwards)
      for (const std::int64_t used : file_.references(*instance)) visit(used);
    const bool ends = instance->type.starts_with("PRODUCT") || instance->type == "STYLED_ITEM";
    const auto users = users_.find(id);
    if (ends || users == users_.end()) continue;
    for (const std::int64_t user : users->second) visit(user);
  }
  return "";
}

void StepProducts::count_bodies() {
  // Bodies of each representation, then of those that are the same shape, then of the products.
  std::map<std::int64_t, int> bodies;
  std::map<std::int64_t, std::int64_t> shape_of;  // product definition shape -> product definition
  Counter counter;
  std::set<std::int64_t> placed;
  for (const Part21Instance& instance : file_.instances()) {
    if (instance.type == "MAPPED_ITEM" || instance.type == "FACE_BASED_SURFACE_MODEL" ||
        is_one_of(other_kinds, instance.type))
      return;
    if (instance.type == "PRODUCT_DEFINITION_SHAPE") {
      for (const std::int64_t used : file_.references(instance)) shape_of[instance.id] = used;
    } else if (instance.type == "NEXT_ASSEMBLY_USAGE_OCCURRENCE") {
      const auto used = file_.references(instance);
      if (used.size() < 2) return;
      counter.parts[used[0]].push_back(used[1]);
      placed.insert(used[1]);
    } else if (instance.type == "SHELL_BASED_SURFACE_MODEL" || is_one_of(solids, instance.type) ||
               (instance.type.empty() && has_type(file_, instance, "MANIFOLD_SOLID_BREP"))) {
      const int shells =
          instance.type == "SHELL_BASED_SURFACE_MODEL" ? int(file_.references(instance).size()) : 1;
      const auto users = users_.find(instance.id);
      if (users == users_.end()) return;
      for (const std::int64_t user : users->second)
        if (const Part21Instance* shape = file_.find(user);
            shape->type.ends_with("REPRESENTATION") && !shape->type.starts_with("MECHANICAL"))
          bodies[user] += shells;
    }
  }
  std::map<std::int64_t, std::set<std::int64_t>> same;  // shapes
  for (const Part21Instance& instance : file_.instances())
    if (instance.type == "SHAPE_REPRESENTATION_RELATIONSHIP") {
      const auto used = file_.references(instance);
      if (used.size() < 2) continue;
      same[used[0]].insert(used[1]);
      same[used[1]].insert(used[0]);
    }
  std::map<std::int64_t, std::set<std::int64_t>> shapes;  // of each product definition
  for (const Part21Instance& instance : file_.instances())
    if (instance.type == "SHAPE_DEFINITION_REPRESENTATION") {
      const auto used = file_.references(instance);
      if (used.size() < 2 || !shape_of.contains(used[0])) continue;
      auto& of_product = shapes[shape_of[used[0]]];
      of_product.insert(used[1]);
      for (const std::int64_t other : same[used[1]]) of_product.insert(other);
    }
  int sum = 0;
  for (const auto& [product, its] : shapes)
    for (const std::int64_t shape : its) counter.own[product] += bodies.contains(shape) ? bodies[shape] : 0;
  std::set<std::int64_t> roots;
  for (const auto& entry : shapes) roots.insert(entry.first);
  for (const auto& entry : counter.parts) roots.insert(entry.first);
  for (const std::int64_t root : roots) {
    if (placed.contains(root)) continue;
    const auto count = counter.count(root);
    if (!count) return;
    sum += *count;
  }
  placed_bodies_ = sum;
}

}  // namespace isopatch::geometry
