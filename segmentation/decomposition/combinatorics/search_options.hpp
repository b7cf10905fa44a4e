#pragma once

#include "segmentation/decomposition/combinatorics/loop_cost.hpp"

namespace isopatch::segmentation {

/// What a search need not cut further, where the oracle accepts it.
enum class Finish {
  base_solids,    ///< hexahedra, prisms, tetrahedra, pyramids; simple solids may stay or be cut
  simple_solids,  ///< simple solids are never cut: quick, and more hexahedra
  convex_solids,  ///< nor is any convex one: quicker, and more still
};

/// How far a search looks.
struct SearchOptions {
  int beam = 8;            ///< states kept after each round; range 1 .. 10000
  int branches = 4;        ///< cuts of one cell that are followed from a state; range 1 .. 1000
  int evaluations = 2000;  ///< by the oracle, after which the best state is finished greedily; range 1 ..
  int refusals = 100;      ///< of one cell, after which no more of its cuts are tried; range 1 ..
  int cuts = 1000;         ///< on the way to one state; range 0 ..
  int max_length = 6;      ///< of a loop; extending ones may be twice as long; range 3 .. 500
  int considered = 50;     ///< loops of a cell that are cut and costed before the oracle is asked; range 1 ..
  int alternatives = 1;  ///< ways to the end that are handed back, where so many were found; range 1 .. 1000
  Finish finish = Finish::base_solids;
  bool extensions =
      true;  ///< whether loops that extend faces are looked for; those proposed are taken anyway
  CostOptions cost;
  bool operator==(const SearchOptions&) const = default;
};
/// @throws Error invalid_argument  naming field, value and range
void validate(const SearchOptions& options);

}  // namespace isopatch::segmentation
