#include "study/report/figures/figures.h"

#include <algorithm>

#include "study/report/study_parts.h"

namespace study::report {
namespace {

/// The family without the cohorts that have no answers; unchanged if no cohort has answers.
FamilyResult withAnswers(const FamilyResult& family) {
  auto answered = family;
  std::erase_if(answered.cohorts, [](const auto& cohort) { return !hasAnswers(cohort); });
  return answered.cohorts.empty() ? family : answered;
}

/// The family without the comparisons that its sentences leave out.
FamilyResult withMainComparisons(FamilyResult family, const std::string& compared) {
  for (auto& cohort : family.cohorts) {
    std::erase_if(cohort.within.rows, [&](const auto& row) {
      return !compared.empty() && row.group1 != compared && row.group2 != compared;
    });
  }
  return family;
}

FamilyFigures figuresOf(
    const ReportSection& section, const FamilyResult& family, const FigureFormat& format) {
  FamilyFigures figures;
  if (isShownByPoint(family)) figures.answers = likertFigure(section, family, format);
  figures.participantMeans = participantMeansFigure(section, family, format);
  figures.effects = effectFigure(section, family, format);
  figures.sites = siteFigure(section, family, format);
  return figures;
}

/// The participants' answers to a slider or a number, as a table of one statement.
FamilyResult asFamily(const questionnaires::Item& item, const std::vector<ItemSummary>& summaries) {
  FamilyResult family;
  const bool isSlider = item.type == questionnaires::ItemType::Slider;
  double low = isSlider ? item.least : *summaries.front().least;
  double high = isSlider ? item.most : *summaries.front().most;
  for (const auto& one : summaries) {
    low = std::min(low, *one.least);
    high = std::max(high, *one.most);
    if (family.cohorts.empty() || family.cohorts.back().cohort != one.cohort) {
      family.cohorts.push_back({.cohort = one.cohort, .table = {.isPointScale = false}});
    }
    auto& table = family.cohorts.back().table;
    for (std::size_t i = 0; i < one.values.size(); ++i) {
      if (i >= table.participants.size()) table.participants.push_back(std::to_string(i));
      table.answers.push_back(
          {.participant = i, .method = table.methods.size(), .score = one.values[i]});
    }
    table.methods.push_back(one.condition);
  }
  if (low == high) high = low + 1.0;
  for (auto& cohort : family.cohorts) {
    cohort.table.lowest = low;
    cohort.table.highest = high;
  }
  return family;
}

/// The figure of one item, if it is a choice, a slider or a number that was asked about
/// alternatives.
std::string itemFigure(
    const ReportSection& section,
    const questionnaires::Instrument& instrument,
    const questionnaires::Item& item,
    const FigureFormat& format) {
  std::vector<ItemSummary> summaries;
  for (const auto& one : section.results.answers.items) {
    const bool isOf = one.instrument == instrument.id && one.item == item.id;
    if (isOf && !one.condition.empty()) summaries.push_back(one);
  }
  if (summaries.empty()) return {};
  if (!summaries.front().options.empty()) return choiceFigure(section, item, summaries, format);
  if (answerKindOf(item.type) != questionnaires::AnswerKind::Number) return {};
  return participantMeansFigure(section, asFamily(item, summaries), format);
}

}  // namespace

void paintFigures(ReportSection& section, const FigureFormat& format) {
  section.figures = {};
  for (const auto& family : section.results.families) {
    const auto answered = withAnswers(family);
    auto& figures = section.figures.families.emplace_back(figuresOf(section, answered, format));
    if (mainFigureOf(section, family) != MainFigure::Differences) continue;
    const auto compared = mainAlternativeOf(family);
    figures.mainEffects = effectFigure(section, withMainComparisons(answered, compared), format);
  }
  for (const auto& instrument : section.instruments) {
    for (const auto& item : instrument.items) {
      auto svg = itemFigure(section, instrument, item, format);
      if (!svg.empty()) section.figures.items.push_back({instrument.id, item.id, std::move(svg)});
    }
  }
  if (!section.results.votes.empty()) section.figures.votes = voteFigure(section, format);
  for (const auto& device : section.protocol.devices) {
    const bool wasFelt = std::any_of(
        section.curves.begin(), section.curves.end(), [&](const RenderedForceCurve& curve) {
          return curve.device == device.id && !curve.points.empty();
        });
    if (wasFelt)
      section.figures.renderedForce.push_back(renderedForceFigure(section, device.id, format));
  }
}

}  // namespace study::report
