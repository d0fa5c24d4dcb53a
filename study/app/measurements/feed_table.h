#pragma once

#include <string>

#include "haptics/engine/scene_spec.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/packing/packed_bone.h"
#include "study/model/data_table.h"

namespace study::app {

/// What a reamer has to be pushed with for a feed: @p bone is reamed to 10 mm by the virtual
/// experiment at feeds from 0.01 mm/s to nine tenths of the most that @p reamer goes at. A row for
/// each feed and each of the curves of the bone: the force at 4, 6 and 8 mm beside the curve's, and
/// what was removed, what remained and what is not accounted for.
/// @param fit  of that bone.
DataTable feedTable(
    const haptics::reaming::PackedBone& bone,
    const haptics::reaming::BoneFitReport& fit,
    const haptics::engine::Reamer& reamer = {});

/// The same of the curves of a material, as a scene `material` renders them, up to 10 mm or the
/// curve's end. The mass of a curve is the work of its removal, ∫ F dz; what the machine has worked
/// beyond that and the cutting damping is not accounted for.
///
/// @param force  valid, over depth. @param middle  name of the middle curve.
DataTable feedTable(
    const haptics::reaming::HardnessCurves& force,
    const std::string& middle,
    const haptics::engine::Reamer& reamer = {});

}  // namespace study::app
