#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/packing/packed_bone.h"
#include "study/report/document.h"

namespace study::app {

/// What @p bone says of itself where nobody measured it; empty where somebody did.
std::string syntheticMark(const haptics::reaming::PackedBone& bone);

/// Each curve whose optimum was not reached, in a sentence: its densities are not what the curve
/// asks for.
std::vector<std::string> warningsOf(const haptics::reaming::BoneFitReport& fit);

/// How the spheres of a bone feel against the curves they were fitted to.
report::Document packingReport(
    const haptics::reaming::PackedBone& bone, const haptics::reaming::BoneFitReport& fit);

}  // namespace study::app
