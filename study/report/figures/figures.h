#pragma once

#include "study/report/figures/figure_format.h"
#include "study/report/report_section.h"

namespace study::report {

/// Paints all figures of a section into it. Needs a QGuiApplication.
void paintFigures(ReportSection& section, const FigureFormat& format = {});

// Each figure, as an SVG:

/// Differences between methods within people: mean differences with intervals, thick at 1 − α; if p
/// is corrected by Bonferroni's method, thin at 1 − α/m. The shaded range holds the differences
/// that the protocol declares negligible.
std::string effectFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format);

/// Force over travel on one device: a line for each condition, with the range between its 10th and
/// 90th percentile.
std::string renderedForceFigure(
    const ReportSection& section, const std::string& device, const FigureFormat& format);

/// Diverging stacked bars: how often each point of the scale was chosen, condition by condition,
/// cohort by cohort, with the middle of the scale on one line.
std::string likertFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format);

/// The ratings of every method by the participants' means: interquartile range and median; a
/// diamond is the mean. At most fifty participants have a dot each, equal ones above one another.
std::string participantMeansFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format);

/// Forest plot: the difference of two methods at each site with its interval at 1 − α, a square
/// whose area is the site's weight, and a diamond for the pooled difference. Empty for one site.
std::string siteFigure(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format);

/// Preferences by cohort and round: a bar for each condition with its interval. The dashed line is
/// the share that each would have if all were preferred equally often.
std::string voteFigure(const ReportSection& section, const FigureFormat& format);

/// How often each option of @p item was chosen, by cohort and alternative.
/// @param summaries  the summaries of the answers to this item about alternatives
std::string choiceFigure(
    const ReportSection& section,
    const questionnaires::Item& item,
    const std::vector<ItemSummary>& summaries,
    const FigureFormat& format);

}  // namespace study::report
