#pragma once

#include <string>
#include <vector>

#include "haptics/reaming/material/material_fit.h"
#include "study/report/document.h"

namespace study::app {

/// The number of nodes in Fig. 7 of the reaming paper.
inline constexpr std::size_t kPaperNodes = 12;

/// A curve of a fit, with the names of its test set, quantity and curve.
struct NamedCurve {
  std::string setName;
  std::string quantity;   ///< "force" or "torque"
  std::string curveName;  ///< "minimum", "average" or "middle-specimen", "maximum"
  const haptics::reaming::FittedCurve* curve = nullptr;
  double floor = 0.0;  ///< smallest denominator of relative errors [N, N·m]
};

/// All curves of @p fit, which must outlive the result.
std::vector<NamedCurve> curvesOf(
    const haptics::reaming::MaterialFit& fit, const haptics::reaming::FitOptions& options);

/// The path of a curve: "dynamic-1/force/maximum".
std::string pathOf(const NamedCurve& curve);

/// The name of the curve between minimum and maximum.
std::string middleCurveNameOf(haptics::reaming::EnvelopeRule rule);

/// Figures 3 to 7 of the reaming paper for any data: all series; for each series force and torque
/// (measured, filtered and normalised) and their spectra; envelopes; and the cubic and the Hermite
/// spline on the same nodes. Includes tables of all series and curves, and all data as CSV files.
///
/// @param series  the series of the fit, in its order.
report::Document materialReport(
    const std::vector<haptics::reaming::Series>& series,
    const haptics::reaming::MaterialFit& fit,
    const haptics::reaming::FitOptions& options);

/// The part of a report on one series: figures 4 and 5 of the paper, and the data as a table for a
/// CSV file.
///
/// @param number  number of the series, from 1.
/// @param scale  largest displacement of its test set [m].
report::DocumentPart seriesPart(
    const haptics::reaming::Series& series,
    const haptics::reaming::PreparedSeries& prepared,
    std::size_t number,
    double scale,
    const haptics::reaming::FitOptions& options);

/// @p options for Fig. 7 of the paper: if no nodes were chosen, 12 nodes, placed for the natural
///     cubic.
haptics::reaming::FitOptions optionsForFigure7(haptics::reaming::FitOptions options);

/// Fig. 7 of the paper for one curve: the natural cubic and the Hermite spline through the nodes of
/// @p options, with their largest errors and the depths of these.
report::DocumentPart splineComparisonPart(
    const NamedCurve& curve, const haptics::reaming::FitOptions& options);

}  // namespace study::app
