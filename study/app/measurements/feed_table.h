#pragma once

#include <string>

#include "haptics/engine/scene_spec.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/packing/packed_bone.h"
#include "study/model/data_table.h"

namespace study::app {

/// The force that a reamer needs at different feed rates: a virtual experiment reams @p bone to 10
/// mm at feeds from 0.01 mm/s to 0.9 of the feed limit of @p reamer. A row for each feed and each
/// curve of the bone: the force at 4, 6 and 8 mm beside that of the curve, the mass that was
/// removed, its share of the whole mass, and the share that is unaccounted for.
/// @param fit  report on the fit of @p bone.
DataTable feedTable(
    const haptics::reaming::PackedBone& bone,
    const haptics::reaming::BoneFitReport& fit,
    const haptics::engine::Reamer& reamer = {});

/// The table for the curves of a material, as a scene `material` renders them, up to 10 mm or the
/// end of the curve. Instead of mass it has the work of removal, ∫ F dz. Work of the machine that
/// is neither work of removal nor cutting damping is unaccounted for.
///
/// @param force  curves over depth [N over m]; must be valid.
/// @param middle  name of the middle curve.
DataTable feedTable(
    const haptics::reaming::HardnessCurves& force,
    const std::string& middle,
    const haptics::engine::Reamer& reamer = {});

}  // namespace study::app
