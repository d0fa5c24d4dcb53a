// Rows of the statistics table that belong to no family.
#include <filesystem>

#include "study/export/coarsening.h"
#include "study/export/statistics_row.h"
#include "study/model/messages.h"

namespace study {
namespace {

constexpr double kStudyRowLevel = 0.95;

StatisticsRow studyRow(std::string_view method, const std::string& cohort = {}) {
  StatisticsRow row{.cohort = cohort, .unit = "participant", .level = kStudyRowLevel};
  row.test.id = method;
  return row;
}

StatisticsRow scoreRow(
    const std::string& instrument,
    const ScoreSummary& score,
    const std::map<std::string, std::string>& codes) {
  auto row = studyRow("score", score.cohort);
  row.instrument = instrument;
  row.score = score.score;
  row.occasion = score.occasion;
  if (!score.condition.empty()) row.group1 = codes.at(score.condition);
  row.missing = score.missing;
  row.test.n1 = score.values.size();
  analysis::GroupMoments moments{.mean = score.mean, .variance = score.standardDeviation};
  if (moments.variance) *moments.variance *= *moments.variance;
  row.test.moments = {moments, {}};
  row.test.interval = score.interval;
  return row;
}

StatisticsRow acceptabilityRow(
    const std::string& instrument,
    const AcceptabilitySummary& summary,
    const std::map<std::string, std::string>& codes) {
  auto row = studyRow("acceptability", summary.cohort);
  row.instrument = instrument;
  row.item = summary.item.itemId;
  if (!summary.condition.empty()) row.group1 = codes.at(summary.condition);
  row.acceptableFrom = summary.item.acceptableFrom;
  row.test.n1 = summary.item.answered;
  row.test.effect = {"share", summary.item.share};
  row.test.effectInterval = summary.interval;
  return row;
}

/// The error of the traces without the path of the study's folder, which must not be exported.
base::Message withoutFolder(const base::Message& error) {
  if (error.key() != "traces.damaged") return message("traces.unreadable");
  const std::filesystem::path file = std::get<std::string>(error.arguments().at(0));
  return message("traces.damaged", file.filename().string(), error.arguments().at(1));
}

}  // namespace

std::vector<StatisticsRow> instrumentRows(
    const std::vector<InstrumentSummary>& instruments,
    const std::map<std::string, std::string>& codes) {
  std::vector<StatisticsRow> rows;
  for (const auto& one : instruments) {
    for (const auto& score : one.scores) rows.push_back(scoreRow(one.instrument, score, codes));
    for (const auto& item : one.acceptable) {
      rows.push_back(acceptabilityRow(one.instrument, item, codes));
    }
  }
  return rows;
}

std::vector<StatisticsRow> itemRows(
    const std::vector<ItemSummary>& items,
    const protocols::LoadedProtocol& loaded,
    const std::map<std::string, std::string>& codes,
    bool isExact) {
  std::vector<StatisticsRow> rows;
  for (const auto& one : items) {
    const auto* item = loaded.instrument(one.instrument)->item(one.item);
    const bool isTheirs = one.condition.empty() && publicFormOf(*item) == PublicForm::Bands;
    if (isTheirs && !isExact) continue;
    auto about = studyRow(one.mean ? "item" : "item_option", one.cohort);
    about.instrument = one.instrument;
    about.item = one.item;
    if (!one.condition.empty()) about.group1 = codes.at(one.condition);
    if (one.mean) {
      analysis::GroupMoments moments{.mean = one.mean, .variance = one.standardDeviation};
      if (moments.variance) *moments.variance *= *moments.variance;
      about.test.moments = {moments, {}};
      about.test.n1 = one.values.size();
      about.test.estimate.value = one.median;
      rows.push_back(about);
    }
    about.unit = "answer";
    about.test.n1 = one.answers;
    for (const auto& [option, times] : one.options) {
      about.option = option;
      about.test.effect = {"share", static_cast<double>(times) / static_cast<double>(one.answers)};
      rows.push_back(about);
    }
  }
  return rows;
}

RenderedForceResult renderedForceResult(Study& study, RunMode mode) {
  try {
    return {.curves = renderedForceCurves(study, mode), .reason = {}};
  } catch (const storage::StorageError& error) {
    return {.curves = {}, .reason = withoutFolder(error.message())};
  }
}

std::vector<StatisticsRow> renderedForceRows(
    const RenderedForceResult& forces, const std::map<std::string, std::string>& codes) {
  std::vector<StatisticsRow> rows;
  if (!forces.reason.empty()) {
    rows.push_back(studyRow("felt_difference"));
    rows.back().test.reason = forces.reason;
  }
  for (const auto& difference : renderedForceDifferences(forces.curves)) {
    auto& row = rows.emplace_back(studyRow("felt_difference"));
    row.design = "paired";
    row.group1 = codes.at(difference.condition1);
    row.group2 = codes.at(difference.condition2);
    row.test.n1 = difference.participants;
    row.test.estimate.value = difference.mean;
    row.test.interval = difference.interval;
    row.test.effect = {"rms_pooled", difference.pooled};
  }
  return rows;
}

}  // namespace study
