#pragma once

#include <string>

#include "haptics/engine/scene_spec.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/packing/packed_bone.h"
#include "study/model/data_table.h"

namespace study::app {

/// The force that a reamer needs for a feed rate: the virtual experiment reams @p bone to 10 mm at
/// feeds from 0.01 mm/s to 0.9 of the feed limit of @p reamer. A row for each feed and each curve
/// of the bone: the force at 4, 6 and 8 mm beside the curve's force, and the mass that was removed,
/// that remained and that is unaccounted for.
/// @param fit  the fit of @p bone.
DataTable feedTable(
    const haptics::reaming::PackedBone& bone,
    const haptics::reaming::BoneFitReport& fit,
    const haptics::engine::Reamer& reamer = {});

/// The same table for the curves of a material, as a scene `material` renders them, up to 10 mm or
/// the curve's end. The mass of a curve is the work of its removal, ∫ F dz. The work of the machine
/// that is neither this nor cutting damping is unaccounted for.
///
/// @param force  curves over depth [N over m]; must be valid. @param middle  name of the middle
/// curve.
DataTable feedTable(
    const haptics::reaming::HardnessCurves& force,
    const std::string& middle,
    const haptics::engine::Reamer& reamer = {});

}  // namespace study::app
