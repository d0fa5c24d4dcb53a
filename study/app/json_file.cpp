#include "study/app/json_file.h"

#include <nlohmann/json.hpp>

#include "study/storage/records.h"

namespace study::app {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::string printed(const Json& json) {
  return json.dump(2) + "\n";
}

using haptics::recordings::CurvePoint;

Json asJson(const std::optional<CurvePoint>& point) {
  if (!point) return nullptr;
  return {{"travel", point->travel}, {"force_n", point->force}};
}

Json asJson(const haptics::recordings::Closure& closure) {
  return {
      {"first_row", closure.rows.first},
      {"last_row", closure.rows.last},
      {"closing_rows", {closure.closing.first, closure.closing.last}},
      {"start_s", closure.start},
      {"duration_s", closure.duration},
      {"complete", closure.isComplete},
      {"saturated_rows", closure.saturatedRows},
      {"peak_force_n", closure.peakForce},
      {"interception", asJson(closure.landmarks.interception)},
      {"yield", asJson(closure.landmarks.yield)},
      {"bottom_out", asJson(closure.landmarks.bottomOut)},
      {"opening", asJson(closure.landmarks.opening)}};
}

Json chosenAsJson(
    const haptics::recordings::ImportedCut& imported, const haptics::recordings::Trace& trace) {
  const auto& [cut, report] = imported;
  Json chosen{{"name", cut.name}, {"cuts", report.closures}};
  chosen["rows"] = Json::array();
  for (const auto& rows : report.rows) chosen["rows"].push_back({rows.first, rows.last});
  chosen["calibration"] = cut.provenance.calibration;
  chosen["filter"] = cut.provenance.filter;
  chosen["filter_parameters"] = cut.provenance.filterParameters;
  chosen["peak_before_n"] = report.peakBefore;
  chosen["peak_n"] = report.peakAfter;
  chosen["points"] = report.points;
  chosen["moved_points"] = report.movedPoints;
  chosen["altered"] = report.isAltered();
  chosen["largest_slope_before"] = report.slopeBefore;
  chosen["steepness_before"] = report.steepness;
  chosen["largest_slope"] = cut.curve.largestSlope();
  chosen["largest_change_n"] = report.largestChange;
  chosen["changes"] = cut.provenance.changes;
  chosen["samples"] = Json::array();
  for (const auto& rows : report.rows) {
    for (std::size_t row = rows.first - 1; row < rows.last; ++row) {
      chosen["samples"].push_back({{"travel", trace.travel[row]}, {"force_n", trace.force[row]}});
    }
  }
  chosen["curve"] = Json::array();
  for (const auto& point : cut.curve.nodes()) {
    chosen["curve"].push_back({{"travel", point.travel}, {"force_n", point.force}});
  }
  return chosen;
}

}  // namespace

std::string problemsAsJson(
    const std::string& file, bool isSound, const std::vector<questionnaires::Problem>& problems) {
  Json json{{"file", file}, {"sound", isSound}, {"problems", Json::array()}};
  for (const auto& problem : problems) {
    const bool isError = problem.severity == questionnaires::Severity::Error;
    json["problems"].push_back(
        {{"severity", isError ? "error" : "warning"},
         {"path", problem.path},
         {"what", base::describe(problem.what)},
         {"fix", base::describe(problem.fix)}});
  }
  return printed(json);
}

std::string statusAsJson(Study& study) {
  const auto current = study.protocols().current();
  const auto commitment = study.events().commitment();
  Json json{
      {"study_id", study.protocol().protocol.study.id},
      {"title", study.protocol().protocol.study.title},
      {"uuid", study.uuid()},
      {"created_utc", study.createdUtc()},
      {"commitment", commitment.empty() ? Json() : Json(commitment)},
      {"protocol_hash", current.sha256},
      {"protocol_frozen_utc", orNull(current.frozenUtc)},
      {"sessions", Json::array()}};
  for (const auto& s : storage::Records(study.database()).sessions()) {
    json["sessions"].push_back(
        {{"id", static_cast<std::int64_t>(s.id)},
         {"participant_id", s.participant},
         {"session_num", s.number},
         {"cohort", s.cohort},
         {"run_mode", nameOf(s.runMode)},
         {"status", statusOf(s.state)},
         {"place", s.slot + 1},
         {"started_utc", s.startedUtc},
         {"ended_utc", orNull(s.endedUtc)}});
  }
  return printed(json);
}

std::string blanksAsJson(const std::vector<protocols::Blank>& blanks) {
  Json all = Json::array();
  for (const auto& blank : blanks) {
    const auto text = blank.text.isEmpty() ? Json(nullptr) : Json(blank.text.all());
    all.push_back({{"key", blank.key}, {"title", base::describe(blank.title)}, {"text", text}});
  }
  return printed(all);
}

std::string verificationAsJson(const Verification& verification) {
  Json json{
      {"sound", verification.isSound()},
      {"audit_trail", verification.head},
      {"checks", Json::array()}};
  for (const auto& check : verification.checks) {
    json["checks"].push_back(
        {{"what", check.what},
         {"sound", check.problems.empty()},
         {"problems", check.problems},
         {"remarks", check.remarks}});
  }
  return printed(json);
}

std::string importAsJson(
    const haptics::recordings::Recording& recording,
    const haptics::recordings::RecordingSurvey& survey,
    const haptics::recordings::Trace& trace,
    const std::optional<haptics::recordings::ImportedCut>& imported,
    const std::string& whyNot) {
  Json json{
      {"file", recording.source},
      {"rows", survey.rows},
      {"rows_are_numbered_from", 1},
      {"refused_lines", Json::array()},
      {"refused_line_count", survey.refusedLines},
      {"sample_rate_hz", survey.sampling.rate},
      {"step_min_s", survey.sampling.stepMin},
      {"step_max_s", survey.sampling.stepMax},
      {"saturated_rows", survey.saturatedRows},
      {"uncalibrated_rows", survey.uncalibratedRows},
      {"min_force_n", survey.minForce},
      {"max_force_n", survey.maxForce},
      {"distinct_travels", survey.distinctTravels},
      {"cuts", Json::array()}};
  for (const auto& line : recording.refusedLines) {
    json["refused_lines"].push_back({{"line", line.number}, {"reason", line.reason}});
  }
  for (const auto& closure : survey.closures) json["cuts"].push_back(asJson(closure));
  json["chosen"] = imported ? chosenAsJson(*imported, trace) : Json(nullptr);
  json["reason"] = imported ? describe(imported->report.reason) : whyNot;
  return printed(json);
}

std::string processNoiseAsJson(const haptics::recordings::ProcessNoise& noise) {
  return printed(
      {{"process_force", noise.force},
       {"process_covariance", noise.covariance},
       {"process_stiffness", noise.stiffness}});
}

std::string passesAsJson(
    const protocols::Condition& condition,
    const haptics::engine::CompiledScene& scene,
    const haptics::engine::RenderedSlope& slope,
    const haptics::devices::Capabilities& device,
    const std::vector<SceneCost>& costs) {
  Json json{
      {"condition", condition.id},
      {"largest_stiffness", slope.steepest},
      {"passes", Json::array()}};
  using Basis = haptics::engine::RenderedSlope::Basis;
  json["largest_stiffness_is"] = slope.basis == Basis::Proved    ? "proved"
                                 : slope.basis == Basis::Sampled ? "sampled"
                                                                 : "swept";
  if (slope.jitter > 0.0) json["jitter_n"] = slope.jitter;
  if (slope.basis == Basis::Swept) {
    json["sweep"]["largest_step_at_rest_n"] = slope.largestStepAtRest;
    json["sweep"]["limit_cycle"] = nullptr;
    if (const auto& cycle = slope.limitCycle) {
      json["sweep"]["limit_cycle"] = {
          {"amplitude_n", cycle->amplitude},
          {"frequency_hz", cycle->frequency},
          {"travel", cycle->travel}};
    }
  }
  if (scene.hasTorque()) {
    json["torque"] = {{"rendered", device.rendersTorque()}, {"device_max_nm", device.maxTorque}};
  }
  for (const auto& jump : haptics::engine::jumpsOf(*condition.model)) {
    json["jumps"].push_back({{"travel", jump.travel}, {"from_n", jump.from}, {"to_n", jump.to}});
  }
  for (const auto& cost : costs) {
    json["costs"].push_back(
        {{"what", cost.what}, {"median_ns", cost.time.median}, {"p99_ns", cost.time.p99}});
  }
  for (const auto& pass : scene.passes()) {
    json["passes"].push_back(
        {{"name", pass.name}, {"in", pass.isInUse}, {"why", pass.why}, {"bytes", pass.bytes}});
  }
  return printed(json);
}

}  // namespace study::app
