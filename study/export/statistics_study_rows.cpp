// Rows of the statistics table that belong to no family.
#include <filesystem>

#include "study/export/statistics_row.h"
#include "study/model/messages.h"

namespace study {
namespace {

constexpr double kStudyRowLevel = 0.95;

StatisticsRow studyRow(const char* method) {
  return {
      {"unit", std::string("participant")},
      {"method", std::string(method)},
      {"declared", false},
      {"conf_level", kStudyRowLevel}};
}

StatisticsRow scoreRow(
    const std::string& instrument,
    const ScoreSummary& score,
    const std::map<std::string, std::string>& codes) {
  auto row = studyRow("score");
  row["cohort"] = score.cohort;
  row["instrument"] = instrument;
  row["score"] = score.score;
  addName(row, "occasion", score.occasion);
  if (!score.condition.empty()) row["group1"] = codes.at(score.condition);
  row["n1"] = whole(score.values.size());
  row["n_missing"] = whole(score.missing);
  row["mean1"] = cellOf(score.mean);
  row["sd1"] = cellOf(score.standardDeviation);
  addInterval(row, "conf", score.interval);
  return row;
}

StatisticsRow acceptabilityRow(
    const std::string& instrument,
    const AcceptabilitySummary& summary,
    const std::map<std::string, std::string>& codes) {
  auto row = studyRow("acceptability");
  row["cohort"] = summary.cohort;
  row["instrument"] = instrument;
  row["item_id"] = summary.item.itemId;
  if (!summary.condition.empty()) row["group1"] = codes.at(summary.condition);
  row["acceptable_from"] = summary.item.acceptableFrom;
  row["n1"] = whole(summary.item.answered);
  row["effect_name"] = std::string("share");
  row["effect"] = cellOf(summary.item.share);
  addInterval(row, "effect", summary.interval);
  return row;
}

/// The problem of the traces without the path of the study's folder, which must not be exported.
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

FeltResult feltResult(Study& study, RunMode mode) {
  try {
    return {.curves = feltCurves(study, mode), .reason = {}};
  } catch (const storage::StorageError& error) {
    return {.curves = {}, .reason = withoutFolder(error.message())};
  }
}

std::vector<StatisticsRow> feltRows(
    const FeltResult& felt, const std::map<std::string, std::string>& codes) {
  std::vector<StatisticsRow> rows;
  if (!felt.reason.empty()) {
    rows.push_back(studyRow("felt_difference"));
    addReason(rows.back(), felt.reason);
  }
  for (const auto& difference : feltDifferences(felt.curves)) {
    auto row = studyRow("felt_difference");
    row["design"] = std::string("paired");
    row["group1"] = codes.at(difference.condition1);
    row["group2"] = codes.at(difference.condition2);
    row["n1"] = whole(difference.participants);
    row["estimate"] = cellOf(difference.mean);
    addInterval(row, "conf", difference.interval);
    row["effect_name"] = std::string("rms_pooled");
    row["effect"] = difference.pooled;
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace study
