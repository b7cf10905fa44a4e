#include "segmentation/decomposition/known_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/require_solid.hpp"
#include "segmentation/balls/ball_cells.hpp"
#include "segmentation/branches/branched_cells.hpp"
#include "segmentation/branches/cross_bored_cells.hpp"
#include "segmentation/decomposition/looks.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/pieces/mirror_planes.hpp"
#include "segmentation/pieces/mirrored_cells.hpp"
#include "segmentation/pieces/pieced_cells.hpp"
#include "segmentation/pieces/pieces_apart.hpp"
#include "segmentation/sweeps/in_the_way.hpp"
#include "segmentation/sweeps/layered_cells.hpp"
#include "segmentation/sweeps/rounds.hpp"
#include "segmentation/sweeps/swept_cells.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

/// Whether planes come in several faces, as of triangulations: their outlines would all be drawn.
bool planes_are_divided(const geometry::Brep& solid) {
  try {
    const geometry::CellComplex merged = prepared(solid);
    return merged.cells.front().faces.size() < solid.faces().size();
  } catch (const Error&) {
    return false;  // faces with holes or seams are of no triangulation
  }
}

/// "face 3 (torus), face 5 'rim' (cone)", the first few.
std::string listed(const geometry::Brep& solid, const std::vector<FaceId>& faces) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, faces.size()); ++i)
    text += fmt::format("{}{} ({})", i == 0 ? "" : ", ", describe(solid, faces[i]),
                        name(solid.face(faces[i]).kind));
  return faces.size() > most ? fmt::format("{} and {} more", text, faces.size() - most) : text;
}

/// Why a solid is no stack, as a sentence: what is in the way along its best direction, and what can be done;
/// "" if nothing is.
std::string no_stack(const geometry::Brep& solid, const DecompositionOptions& options) {
  const std::optional<InTheWay> least = least_in_the_way(solid);
  if (!least || least->faces.empty()) return "";
  const std::string what = fmt::format(
      "It is no stack to be swept: along {}, where the fewest are in the way, {} {} neither across nor along "
      "it: {}",
      direction_text(least->along), least->faces.size(), least->faces.size() == 1 ? "face is" : "faces are",
      listed(solid, least->faces));
  const Rounds rounds = rounds_in_the_way(solid, solid.size());
  const double share = 1.01 * rounds.largest_radius / solid.size();
  const bool small = share < options.largest_blend;
  if (rounds.faces.empty() || (options.blends == Blends::remove && small))
    return what + "; a [[segmentation.cut]] that parts it from the rest may help";
  return fmt::format(
      "{}. These are rounds of {:.3g} m at most: with blends = \"remove\"{} they are taken off, "
      "if the faces around them meet then",
      what, rounds.largest_radius, small ? "" : fmt::format(" and largest_blend = {:.2g}", share));
}

std::string text_of(const SweptCells& swept) {
  const std::string rounds =
      swept.rounds > 0 ? fmt::format(", {} round{} kept", swept.rounds, swept.rounds == 1 ? "" : "s")
                       : std::string();
  return fmt::format("swept along {}: {} quadrilateral{} between {} levels{}", direction_text(swept.along),
                     swept.quadrilaterals, swept.quadrilaterals == 1 ? "" : "s", swept.levels, rounds);
}

std::string text_of(const TurnedCells& turned) {
  const std::string column =
      turned.along_axis > 0 ? fmt::format(", {} along the axis", turned.along_axis) : std::string();
  return fmt::format("turned about {}: {} quadrilateral{} in {} sector{}{}", direction_text(turned.about),
                     turned.quadrilaterals, turned.quadrilaterals == 1 ? "" : "s", turned.sectors,
                     turned.sectors == 1 ? "" : "s", column);
}

std::string text_of(const BallCells&) {
  return "one closed face around a hexahedron";
}

std::string text_of(const BranchedCells& cells) {
  return fmt::format("turned about {} with {} branch{}", direction_text(cells.about), cells.branches,
                     cells.branches == 1 ? "" : "es");
}

std::string text_of(const CrossBoredCells& cells) {
  const auto counted = [](int count, const char* what) {
    return count == 0 ? std::string() : fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
  };
  std::string list;
  for (const std::string& some :
       {counted(cells.bores - cells.slots - cells.bosses, "bore"), counted(cells.slots, "slot"),
        cells.bosses == 1 ? std::string("1 boss") : counted(cells.bosses, "bosse")})
    if (!some.empty()) list += (list.empty() ? "" : " and ") + some;
  return fmt::format("swept along {} with {} across", direction_text(cells.along), list);
}

/// "3 pieces: swept along z, x; turned about y".
std::string text_of(const PiecedCells& cells) {
  std::string swept, turned;
  for (const PiecedCells::Piece& piece : cells.pieces) {
    std::string& list = piece.turned ? turned : swept;
    list += (list.empty() ? "" : ", ") + direction_text(piece.along);
  }
  return fmt::format("{} pieces: {}{}{}{}{}", cells.pieces.size(), swept.empty() ? "" : "swept along ", swept,
                     swept.empty() || turned.empty() ? "" : "; ", turned.empty() ? "" : "turned about ",
                     turned);
}

/// Hexahedra that were found without a search.
struct KnownCells {
  geometry::CellComplex complex;
  std::string seen_as;
  bool in_pieces = false;
  bool apart = false;  ///< they meet in parts of sides
};

/// A half and its image.
struct MirroredCells {
  geometry::CellComplex complex;
  std::string half;  ///< what it was seen as
};

std::string text_of(const MirroredCells& cells) {
  return "one half mirrored, " + cells.half;
}

/// Of a scaled Jacobian; better ones are not worth another hexahedron.
constexpr double good_quality = 0.25;

/// How dear hexahedra are: their number, and more of it where they are poor.
double cost(const geometry::CellComplex& complex) {
  const double quality = std::clamp(geometry::least_quality(complex), 0.01, good_quality);
  return static_cast<double>(complex.cells.size()) / quality;
}

/// Looks at a solid in one way, and keeps what is found if it is cheaper than what is known.
/// @param why_not  gets what stopped a solid that looks as if it would do
template <class Look>
void look(const Look& at, std::optional<KnownCells>& best, std::string& why_not) {
  try {
    auto made = at();
    if (!made || (best && cost(best->complex) <= cost(made->complex))) return;
    std::string text = text_of(*made);
    best = KnownCells{std::move(made->complex), std::move(text)};
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    why_not = error.what();
  }
}

/// What stopped a solid that looks as if it would do.
struct WhyNot {
  std::string stopped_by;
  std::string not_swept;     ///< one that looks like a stack, maybe but for rounds
  std::string not_branched;  ///< one that looks turned with branches
  std::string not_bored;     ///< one that looks like a stack with bores across

  /// The last of all.
  const std::string& text() const {
    return !not_bored.empty() ? not_bored : not_branched.empty() ? stopped_by : not_branched;
  }
};

/// @param seconds  to look for planes that cut it into pieces
std::optional<KnownCells> known_cells(const geometry::Brep& solid, double seconds, WhyNot& why) {
  std::optional<KnownCells> best;
  const auto is_good = [&] { return best && geometry::least_quality(best->complex) >= good_quality; };
  std::string not_turned;
  const auto as_turned = [&] { look([&] { return turned_cells(solid); }, best, not_turned); };
  // What is a stack but for rounds or roofs takes long to sweep.
  const bool is_plain = !sweep_frames(solid).empty();
  if (!is_plain) as_turned();
  if (!is_good() && !planes_are_divided(solid)) look([&] { return swept_cells(solid); }, best, why.not_swept);
  if (is_plain) as_turned();
  why.stopped_by = not_turned.empty() ? why.not_swept : not_turned;
  if (!best && is_one_closed_face(solid)) look([&] { return ball_cells(solid); }, best, why.stopped_by);
  // Where it is swept, but poorly or around rounds, it may do better.
  if (!is_good() || !is_plain) look([&] { return branched_cells(solid); }, best, why.not_branched);
  if (best || planes_are_divided(solid)) return best;
  // Bores that meet cannot be separated by planes; other solids are divided into pieces sooner.
  const auto as_bored = [&] { look([&] { return cross_bored_cells(solid); }, best, why.not_bored); };
  const bool meet = bores_meet(solid);
  if (meet) as_bored();
  if (best) return best;
  look([&] { return pieced_cells(solid, {}, seconds); }, best, why.stopped_by);
  if (best)
    best->in_pieces = true;
  else if (!meet)
    as_bored();
  return best;
}

/// Layers of a stack, or else pieces between planes, divided each by itself.
std::optional<KnownCells> cells_apart(const geometry::Brep& solid, double seconds, WhyNot& why) {
  std::optional<KnownCells> best;
  if (planes_are_divided(solid)) return best;
  if (!sweep_frames(solid).empty())
    look([&] { return layered_cells(solid); }, best, why.stopped_by);
  else
    look([&] { return pieces_apart(solid, {}, seconds); }, best, why.stopped_by);
  if (best) {
    best->apart = true;
    best->seen_as += ", each divided by itself";
  }
  return best;
}

/// What is swept or turned is divided along its symmetries at once; what comes in pieces is tried by halves
/// as well.
std::optional<KnownCells> known_or_mirrored(const geometry::Brep& solid, double seconds, WhyNot& why) {
  std::optional<KnownCells> best = known_cells(solid, seconds, why);
  if (!best || !best->in_pieces) return best;
  constexpr std::size_t most = 3;
  const std::vector<geometry::PlaneSurface> planes = mirror_planes(solid);
  for (std::size_t i = 0; i < std::min(most, planes.size()); ++i) {
    WhyNot half_why;
    look(
        [&]() -> std::optional<MirroredCells> {
          MirroredCells result;
          result.complex = mirrored_cells(solid, planes[i], [&](const geometry::Brep& half) {
            std::optional<KnownCells> made = known_cells(half, seconds, half_why);
            if (!made) throw Error(ErrorCode::unsupported, half_why.text());
            result.half = made->seen_as;
            return std::move(made->complex);
          });
          return result;
        },
        best, half_why.stopped_by);
  }
  return best;
}

/// The pieces that the cuts a user gives lead to, or an error; no other way is tried.
KnownCells as_given(const geometry::Brep& solid, const std::vector<geometry::PlaneSurface>& cuts,
                    double seconds, TJoints t_joints) {
  WhyNot why;
  std::optional<KnownCells> made;
  const bool apart = t_joints == TJoints::keep;
  if (cuts.empty())
    made = known_cells(solid, seconds, why);
  else if (auto pieces = apart ? pieces_apart(solid, cuts, seconds) : pieced_cells(solid, cuts, seconds))
    made = KnownCells{std::move(pieces->complex), text_of(*pieces), true, apart};
  if (!made)
    throw Error(ErrorCode::unsupported,
                fmt::format("{} come to no pieces that can be swept{}{}; give cuts where its pieces join, or "
                            "none, so that it is cut along loops",
                            cuts.empty() ? "its halves" : "the cuts given", why.text().empty() ? "" : ": ",
                            why.text()));
  return std::move(*made);
}

KnownCells by_hand(const geometry::Brep& solid, const DecompositionOptions& options) {
  const double seconds = options.time_limit / 4;
  std::vector<geometry::PlaneSurface> cuts;
  for (const GivenPlane& cut : options.cuts) cuts.push_back(plane_of(solid, cut));
  if (!options.symmetry) return as_given(solid, cuts, seconds, options.t_joints);
  std::string halves;
  geometry::CellComplex complex =
      mirrored_cells(solid, plane_of(solid, *options.symmetry), [&](const geometry::Brep& half) {
        KnownCells made = as_given(half, cuts, seconds, TJoints::remove);
        halves += (halves.empty() ? "" : "; ") + made.seen_as;
        return std::move(made.complex);
      });
  return {std::move(complex), "one half mirrored, " + halves};
}

Decomposition decomposition_of(KnownCells cells, double seconds) {
  Decomposition result{cells.complex, cells.complex, {}, {}};
  result.report.cells = result.report.hexahedra = static_cast<int>(cells.complex.cells.size());
  result.report.seen_as = std::move(cells.seen_as);
  result.report.seconds = seconds;
  result.report.t_joints_kept = cells.apart;
  return result;
}

}  // namespace

KnownShape known_shape(const geometry::Brep& solid, const DecompositionOptions& options) {
  const Stopwatch watch;
  KnownShape result;
  if (is_cut_by_hand(options)) {
    result.decomposition = decomposition_of(by_hand(solid, options), watch.seconds());
    return result;
  }
  if (options.method == Method::cuts) return result;
  WhyNot why;
  const double seconds = options.time_limit / 4;
  std::optional<KnownCells> made;
  if (options.t_joints == TJoints::keep) made = cells_apart(solid, seconds, why);
  if (!made) made = known_or_mirrored(solid, seconds, why);
  if (made)
    result.decomposition = decomposition_of(std::move(*made), watch.seconds());
  else if (result.why_not = no_stack(solid, options); result.why_not.empty() && !why.stopped_by.empty())
    result.why_not = (is_one_closed_face(solid) ? "One face all around would do, but "
                                                : "It looks swept or turned, but ") +
                     why.stopped_by;
  else if (!result.decomposition && !result.why_not.empty() && !why.not_swept.empty())
    result.why_not += ". Without its rounds it would be one, but " + why.not_swept;
  if (!result.decomposition && !why.not_bored.empty())
    result.why_not = "It looks like a stack with bores across, but " + why.not_bored +
                     (result.why_not.empty() ? "" : ". " + result.why_not);
  if (!result.decomposition && !why.not_branched.empty())
    result.why_not = "It looks turned with branches, but " + why.not_branched +
                     (result.why_not.empty() ? "" : ". " + result.why_not);
  return result;
}

}  // namespace isopatch::segmentation
