#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/packing/packed_bone.h"
#include "study/report/document.h"

namespace study::app {

/// A note that @p bone is synthetic; empty if it was measured.
std::string syntheticMark(const haptics::reaming::PackedBone& bone);

/// A warning for each curve whose fit did not reach its optimum: the densities then do not
/// reproduce the force of the curve.
std::vector<std::string> warningsOf(const haptics::reaming::BoneFitReport& fit);

/// Compares the forces of a bone's spheres with the curves to which they were fitted.
/// @param feeds  feedTable() of @p bone and @p fit.
report::Document packingReport(
    const haptics::reaming::PackedBone& bone,
    const haptics::reaming::BoneFitReport& fit,
    const DataTable& feeds);

}  // namespace study::app
