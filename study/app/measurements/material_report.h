#pragma once

#include <vector>

#include "haptics/reaming/material/material_fit.h"
#include "study/report/document.h"

namespace study::app {

/// Figures 4 to 7 of the reaming paper for any data: a spectrum, raw and filtered force, normalised
/// force and torque, envelopes, and the cubic against the Hermite spline on the same nodes; and
/// tables of every series and every curve.
///
/// @param series  as the fit was made of, in the same order.
report::Document materialReport(
    const std::vector<haptics::reaming::Series>& series,
    const haptics::reaming::MaterialFit& fit,
    const haptics::reaming::FitOptions& options);

}  // namespace study::app
