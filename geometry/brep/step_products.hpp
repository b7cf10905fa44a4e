#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/brep/part21.hpp"

namespace isopatch::geometry {

/// What a STEP file lists: products, where they are placed, and the bodies of each.
class StepProducts {
 public:
  explicit StepProducts(const Part21File& file);

  /// How many bodies there are once every product stands wherever assemblies place it; nothing (-1) where
  /// bodies are listed in a way that is not counted (mapped items, loose faces).
  int placed_bodies() const { return placed_bodies_; }
  /// The name of the product that an entity belongs to, as the file has it; "" if it belongs to none.
  std::string product_of(std::int64_t entity) const;
  /// Whether anything in the file refers to an entity.
  bool is_used(std::int64_t entity) const { return users_.contains(entity); }
  /// Entities that are solids of kinds which are not made of faces with boundaries (CSG, swept, tessellated).
  const std::vector<const Part21Instance*>& other_solids() const { return other_solids_; }

 private:
  void count_bodies();

  const Part21File& file_;
  std::unordered_map<std::int64_t, std::vector<std::int64_t>> users_;
  std::vector<const Part21Instance*> other_solids_;
  int placed_bodies_ = -1;
};

}  // namespace isopatch::geometry
