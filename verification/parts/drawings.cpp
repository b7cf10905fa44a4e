#include "verification/parts/internal/drawings.hpp"

#include "verification/parts/internal/basic_parts.hpp"
#include "verification/parts/internal/car_part.hpp"
#include "verification/parts/internal/chair_stand.hpp"
#include "verification/parts/internal/demonstrator.hpp"
#include "verification/parts/internal/drawn_later.hpp"
#include "verification/parts/internal/held_out.hpp"
#include "verification/parts/internal/held_out_later.hpp"
#include "verification/parts/internal/shop_parts.hpp"
#include "verification/parts/internal/turned_parts.hpp"

namespace isopatch::parts {

const std::vector<Drawing>& drawings() {
  static const std::vector<Drawing> all = {
      {"bored_block", "basic", "a block with a bore through it", bored_block, 4},
      {"plate_with_2_bores", "basic", "a plate with two bores in a row", plate_with_2_bores, 7},
      {"plate_with_3_bores", "basic", "three", plate_with_3_bores, 10},
      {"plate_with_5_bores", "basic", "five", plate_with_5_bores, 16},
      {"round_bar", "basic", "a round bar", round_bar, 12},
      {"link", "basic", "the link of examples/link", link, 11},
      {"stepped_shaft", "basic", "a shaft of three sections, with a cone", stepped_shaft, 27},
      {"pipe_elbow", "basic", "a pipe elbow with two flanges of four bolts", pipe_elbow},
      {"pipe_tee", "basic", "a pipe tee with a flange", pipe_tee},
      {"shaft_with_boss", "basic", "a shaft with a boss across", shaft_with_boss},
      {"countersunk_plate", "basic", "a plate with a countersunk bore", countersunk_plate},
      {"nut", "basic", "a hexagon nut, sharp", nut},
      {"chamfered_nut", "basic", "a hexagon nut as it is sold", chamfered_nut},
      {"chamfered_block", "basic", "a block with every edge chamfered", chamfered_block},
      {"rounded_block", "basic", "a block with every edge rounded", rounded_block},
      {"bracket", "basic", "an L with two bores and a rib", bracket},
      {"flange", "basic", "a flange with eight bores and a hub", flange},
      {"bearing_block", "shop", "a bearing housing on two feet", bearing_block},
      {"clevis", "shop", "a fork on a rod", clevis},
      {"hinge_leaf", "shop", "a hinge leaf with three knuckles and countersunk holes", hinge_leaf},
      {"pulley", "shop", "a V-belt pulley with web, holes and keyway", pulley},
      {"t_slot_nut", "shop", "a nut for a T-slot", t_slot_nut},
      {"cam", "shop", "a disk cam with keyway", cam},
      {"motor_plate", "shop", "a motor plate with a stepped seat, eight holes and two pockets", motor_plate},
      {"manifold_block", "shop", "a hydraulic manifold with crossing bores", manifold_block},
      {"lever", "shop", "a lever with two hubs", lever},
      {"key_shaft", "shop", "a stepped shaft with fillets, chamfers and a keyway", key_shaft},
      {"heat_sink", "shop", "a heat sink with nine fins", heat_sink},
      {"u_bracket", "shop", "a bracket bent from a sheet", u_bracket},
      {"gusset_bracket", "later", "a bracket with a gusset and two slots", gusset_bracket},
      {"valve_block", "later", "a hydraulic block with three bores that meet", valve_block},
      {"shaft_end", "later", "a shaft's end with two flats and a hole across", shaft_end},
      {"hex_bolt", "later", "a hexagon bolt with a chamfered head", hex_bolt},
      {"split_clamp", "later", "a clamp with a slot and its screw", split_clamp},
      {"cover_plate", "later", "a cover with sunk screws and a groove for an O-ring", cover_plate},
      {"ball_stud", "turned", "a ball on a neck, a cone and a shank", ball_stud},
      {"turned_handle", "turned", "a handle of arcs with a round end", turned_handle},
      {"rounded_shaft", "turned", "a shaft of two sections with a fillet and round edges", rounded_shaft},
      {"rounded_washer", "turned", "a washer with round edges", rounded_washer},
      {"bent_pipe", "turned", "a pipe, bent", bent_pipe},
      {"bent_bar", "turned", "a round bar, bent", bent_bar},
      {"shell_octant", "turned", "an eighth of a hollow ball", shell_octant},
      {"motor_mount", "held_out", "an angle for a motor, with slots in its foot", motor_mount},
      {"angle_bracket", "held_out", "an angle with a gusset at each side", angle_bracket},
      {"split_housing", "held_out", "the lower half of a bearing housing", split_housing},
      {"bell_crank", "held_out", "two arms at right angles with three hubs", bell_crank},
      {"weld_neck_flange", "held_out", "a flange with a tapered neck and a raised face", weld_neck_flange},
      {"gear_blank", "held_out", "a gear's blank with lightening holes and a keyway", gear_blank},
      {"hydraulic_block", "held_out", "drilled bores that meet, with their tips", hydraulic_block},
      {"rod_end", "held_out", "a fork on a shank with a thread", rod_end},
      {"vee_block", "held_out", "a vee block with slots and bores", vee_block},
      {"vise_jaw", "held_out", "a jaw with two vees that cross", vise_jaw},
      {"cap_screw", "held_out", "a screw with a hexagon socket", cap_screw},
      {"spindle", "held_out", "a spindle with groove, keyway and cross hole", spindle},
      {"u_channel", "held_out", "a channel with bores and slots", u_channel},
      {"lid", "held_out", "a lid with a round edge, a rim and a groove", lid},
      {"eye_bolt", "held_out", "an eye bolt", eye_bolt},
      {"swing_plate", "held_out", "a lever with a bent slot and a round edge", swing_plate},
      {"pillow_block", "held_out_later", "a bearing block with a hole for grease", pillow_block},
      {"pilot_flange", "held_out_later", "a motor's flange with pilot, bent slots and tapped holes",
       pilot_flange},
      {"radial_bushing", "held_out_later", "a stepped bushing with a groove and radial holes",
       radial_bushing},
      {"bent_bracket", "held_out_later", "a bracket of bent sheet with holes and a slot", bent_bracket},
      {"yoke", "held_out_later", "a yoke of a universal joint", yoke},
      {"timing_pulley", "held_out_later", "a pulley with keyway and set screw", timing_pulley},
      {"valve_body", "held_out_later", "a valve's body with three ports", valve_body},
      {"clamp_collar", "held_out_later", "a slit collar with its screw", clamp_collar},
      {"webbed_lever", "held_out_later", "a lever hollowed from both sides", webbed_lever},
      {"mounting_rail", "held_out_later", "a rail of bent sheet with slots", mounting_rail},
      {"demonstrator", "models", "the TERRIFIC demonstrator, from its dimensions", demonstrator},
      {"car_part", "models", "a wishbone of a car, of sharp edges", car_part},
      {"chair_stand", "models", "one fifth of a chair's base, from its dimensions", chair_stand},
      {"chair_stand_with_ring_and_pin", "assemblies", "the same with what it holds, three bodies",
       chair_stand_with_ring_and_pin},
  };
  return all;
}

}  // namespace isopatch::parts
