#pragma once

#include "app/study/keys.hpp"
#include "iga/problem/hydrostatic_load.hpp"
#include "iga/problem/remote_load.hpp"
#include "iga/problem/rotation_load.hpp"
#include "iga/problem/thermal_load.hpp"

namespace isopatch::app {

/// The keys of loads that are tables: remote, hydrostatic, rotation, temperature.
const Keys<iga::RemoteForce>& remote_keys();
const Keys<iga::Liquid>& hydrostatic_keys();
const Keys<iga::Rotation>& rotation_keys();
const Keys<iga::TemperatureChange>& temperature_keys();

}  // namespace isopatch::app
