#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/module.hpp"

namespace isopatch::geometry::test {

/// A STEP file in mm that OpenCASCADE made when the tests were built (made_solids/main.cpp): "block" (30 x 20
/// x 10), "cylinder", "cone", "sphere", "torus", "drilled" (the block with a bore), "grooved" (with a quarter
/// of a cylinder taken off an edge), "notched" (with a step in the middle of an edge), "round_edge",
/// "round_corner" (radius 3), "spring" (two turns; splines), "named" (a plate with a coloured and named top,
/// and a pin). Stacks along z (made_solids/stacks.cpp): "countersunk", "drafted_pocket", "drafted_boss",
/// "shaft" (with a cone), "bored_boss", "pocketed", "turned_off" (corners by a cone),
/// "bored_beside_a_pocket", "wavy" (a wall is a spline), "tipped_cover" (a bored disc with four blind holes,
/// whose tips end in flats), "cusp" (a cylinder touches two of its sides). Of several directions
/// (made_solids/crossed.cpp): "angle" (two plates of 8, bored), "bent_sheet" (the same, bent round), "fork"
/// (with a pin's bore and one across it), "rod_fork" (on a rod that is wider than its slot), "bored_rod_fork"
/// (the rod is a tube), "nozzle" (on the side of a block, its bore ends in a slot), "lugs" (two on a plate),
/// "flanged_bend" (a pipe). Blocks along x with bores across (made_solids/drilled.cpp): "port", "ports"
/// (through), "three_bores", "sunk_port", "blind_bore", "port_beside" (the axis), "tipped_bore" (down, its
/// tip is a drill's), "tipped_gallery" (likewise, a bore across beside the tip), and "wide_port", which is
/// wider than the bore that it ends in; "vee_block" along y; "greased_bar" (round, along y, with a flat and a
/// hole from it into its bore), "keyed_hub" (on a disc, along z, with a hole into its keyway). Stacks with
/// slots across (made_solids/slotted.cpp): "slotted_bar", "slotted_wing" (freeform walls and slot),
/// "pocketed_wing", "slotted_lens" (round walls), "bored_lens", "flatted_pin" (bored through two flats under
/// a chamfer). Stacks but for their rounds (made_solids/rounds.cpp): "filleted_boss", "filleted_step",
/// "filleted_pocket" (concave ones along floors), "rounded_boss", "rounded_plate", "eased_block" (convex
/// ones), "rounded_boss_on_fillet" (one above the other). Turned with branches across
/// (made_solids/branched.cpp): "bossed_bar", "bossed_oblique", "tapped_boss", "two_bosses", "cross_bored",
/// "beside_the_axis", "oil_bore", "pinned_tube", "grooved_bushing" (four holes into a groove inside),
/// "sunk_bar", "keyed_bar", "tee", "boss_near_the_end", "oil_bores_at_120", "bolted_cap" (with bores beside
/// the axis), "bolted_close" (near a raised face); "wide_boss" and "boss_at_the_end", for which there is no
/// room. Turned (made_solids/turned.cpp): "ball_on_rod" (along x), "bored_ball", "hollow_ball", "domed_rod",
/// "round_cup", "flat_cup", "pointed_rod", "ring_in_halves" (all faces), "sheave", "round_ring",
/// "vessel_head" (ellipsoids), and by an angle "bent_rod" (120 degrees), "bent_tube" (90), "half_torus",
/// "half_shaft", "quarter_shaft", "three_quarters", "half_dome", which reach the axis; with prisms about
/// their axis "socket_screw" (a hexagonal socket), "square_end", "twelve_sided_hole", "odd_socket" (five
/// sides). One spline all around (made_solids/closed_faces.cpp): "ellipsoid" (15, 10, 7), "pebble", "creased"
/// (a spline with edges), "banana" (bent too far to be seen from its middle). Hexahedra with curved sides:
/// "drilled_quarters" (the drilled block in four), "ring_quarter", "ring_150" (radii 5 and 8, height 4),
/// "oblique_ring" (a quarter under z = 6 + x / 4
/// + y / 8), "cone_quarter" (radii 6 and 8 below, 3 and 4 above, height 5), "shell_piece" (radii 5 and 7,
/// latitudes 10 to 60 degrees, a quarter around), "elbow_piece" (a quarter of a pipe of radii 1 and 2, bent
/// by 60 degrees with radius 6). "drilled_splines" and other names with that ending: all faces and edges as
/// splines.
inline std::filesystem::path made_solid(const std::string& name) {
  return std::filesystem::path(ISOPATCH_MADE_SOLIDS) / (name + ".step");
}

/// One of them, read in this very process: faster than `read_brep`, which trusts no file.
inline Brep made_brep(const std::string& name) {
  const std::filesystem::path path = made_solid(name);
  const std::string text = read_file(path);
  return Brep(brep_module().read({.path = path, .text = text}, {}).bodies.front().kernel);
}

/// All that are one body.
inline const std::array<std::string, 11> made_solids = {"block",      "cylinder",     "cone",    "sphere",
                                                        "torus",      "drilled",      "grooved", "notched",
                                                        "round_edge", "round_corner", "spring"};

}  // namespace isopatch::geometry::test
