#pragma once

#include <optional>
#include <vector>

#include "segmentation/decomposition/combinatorics/search_options.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"
#include "segmentation/decomposition/given_plane.hpp"

namespace isopatch::segmentation {

/// What becomes of sides that meet others in parts.
enum class TJoints {
  remove,  ///< further cuts and templates, until all meet side to side
  keep,    ///< left as they are
};

/// How hexahedra are looked for.
enum class Method {
  automatic,  ///< stacks are swept, turned solids turned, with or without branches, others cut into such by
              ///< planes; unless cuts along loops take fewer
  cuts,       ///< by cutting loops and extended faces alone
};

/// What becomes of rounds along edges.
enum class Blends {
  keep,    ///< they are faces as others are
  remove,  ///< those in the way are taken off, and their neighbours extended until they meet
};

struct DecompositionOptions {
  SearchOptions search = {.beam = 6,
                          .branches = 16,
                          .evaluations = 20000,
                          .refusals = 5000,
                          .alternatives = 4,
                          .extensions = false,
                          .cost = {.t_joint = 2, .divided = 4}};
  CutOptions cut = {};
  Method method = Method::automatic;
  double time_limit =
      60;  ///< seconds of computing, after which the best way known is taken, or none; above 0
  TJoints t_joints = TJoints::remove;
  Blends blends = Blends::keep;
  double largest_blend = 0.1;  ///< radius up to which rounds may be removed, as a share of the size; above 0
  std::vector<GivenPlane> cuts =
      {};  ///< made first, by hand; what comes of them must be pieces that are swept
  std::optional<GivenPlane> symmetry = {};  ///< one half is divided, swept or in such pieces, and mirrored
  int max_cells = 2000;  ///< at most so many hexahedra when sides are made to meet; range 1 ..
  bool operator==(const DecompositionOptions&) const = default;
};
/// Whether the user has a say in where the solid is cut.
bool is_cut_by_hand(const DecompositionOptions& options);
void validate(const DecompositionOptions& options);

}  // namespace isopatch::segmentation
