#include <cmath>

#include <nlohmann/json.hpp>

#include "study/bench/bench_stats.h"

namespace study::app {
namespace {

using Json = nlohmann::ordered_json;

Json finiteOrNull(double number) {
  return std::isfinite(number) ? Json(number) : Json(nullptr);
}

Json timesOf(const std::vector<double>& seconds) {
  if (seconds.empty()) return nullptr;
  return {
      {"times", seconds.size()},
      {"first_s", seconds.front()},
      {"p50_s", quantileOf(seconds, 0.5)},
      {"p99_s", quantileOf(seconds, 0.99)}};
}

Json asJson(const TableRow& row) {
  return {
      {"cohort", row.cohort},
      {"group1", row.first},
      {"group2", row.second},
      {"mean1", finiteOrNull(row.mean1)},
      {"mean2", finiteOrNull(row.mean2)},
      {"variance1", finiteOrNull(row.variance1)},
      {"variance2", finiteOrNull(row.variance2)},
      {"t", finiteOrNull(row.t)},
      {"p", finiteOrNull(row.p)}};
}

Json asJson(const TableRun& run) {
  Json json{{"way", run.way}, {"version", run.version}, {"time", timesOf(run.seconds)}};
  json["absence"] = run.absence.empty() ? Json(nullptr) : Json(run.absence);
  json["rows"] = Json::array();
  for (const auto& row : run.rows) json["rows"].push_back(asJson(row));
  return json;
}

}  // namespace

std::string statsAsJson(const StatsMeasurement& measured) {
  Json json{
      {"synthetic", true},
      {"answers", measured.answers},
      {"sessions", measured.sessions},
      {"database_mb", measured.databaseSize},
      {"making_s", measured.making},
      {"memory_mb", finiteOrNull(measured.memory)},
      {"memory_before_mb", finiteOrNull(measured.memoryBefore)},
      {"table", asJson(measured.ours)},
      {"processor", timesOf(measured.processor)},
      {"after_an_edit", timesOf(measured.edits)},
      {"same_after_edits", measured.isSameAfterEdits},
      {"edit_itself", timesOf(measured.writing)}};
  json["peers"] = Json::array();
  for (const auto& peer : measured.peers) {
    json["peers"].push_back(asJson(peer));
    json["peers"].back()["largest_difference"] =
        finiteOrNull(largestDifference(measured.ours.rows, peer.rows));
  }
  json["targets"] = Json::array();
  for (const auto& target : statsTargets(measured)) {
    json["targets"].push_back(
        {{"target", target.id},
         {"what", target.what},
         {"measured", finiteOrNull(target.measured)},
         {"wanted", target.wanted},
         {"reached", target.isReached()}});
  }
  return json.dump(2) + "\n";
}

}  // namespace study::app
