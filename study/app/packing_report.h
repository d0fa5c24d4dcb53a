#pragma once

#include "haptics/reaming/packed_bone.h"
#include "study/report/document.h"

namespace study::app {

/// How the spheres of a bone feel against the curves they were fitted to.
report::Document packingReport(
    const haptics::reaming::PackedBone& bone, const haptics::reaming::BoneFitReport& fit);

}  // namespace study::app
