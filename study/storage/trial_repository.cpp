#include "study/storage/trial_repository.h"

#include <span>
#include <string>
#include <utility>

#include "study/storage/keys/sealed_condition.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"

namespace study::storage {

namespace {

/// What was measured, by columns of trial and of cut; what has no value is left out.
base::NamedArguments measured(const TrialRecord& record) {
  base::NamedArguments values;
  const auto add = [&](std::string name, const auto& value) {
    values.emplace_back(std::move(name), value);
  };
  const auto addIfKnown = [&](std::string name, const auto& value) {
    if (value) values.emplace_back(std::move(name), *value);
  };
  const auto judgement = record.judgement();
  add("verdict", std::string(nameOf(judgement.verdict)));
  add("verdict_reason", asJson(judgement.reasons));
  add("duration_s", record.duration);
  add("ticks", record.ticks);
  add("nominal_rate_hz", record.nominalRate);
  addIfKnown("achieved_rate_hz", record.achievedRate);
  addIfKnown("lateness_p50_us", record.latenessMedian);
  addIfKnown("lateness_p99_us", record.latenessP99);
  addIfKnown("lateness_max_us", record.latenessLargest);
  addIfKnown("late_ticks", record.lateTicks);
  add("lost_samples", record.lostSamples);
  add("invalid_ticks", record.invalidTicks);
  add("saturated_s", record.saturated);
  add("slewed_s", record.slewed);
  add("undefined_s", record.undefined);
  add("contact_s", record.contact);
  add("largest_force_n", record.largestForce);
  add("cuts", static_cast<std::int64_t>(record.cuts.size()));
  int number = 0;
  for (const auto& cut : record.cuts) {
    const std::string prefix = "cut_" + std::to_string(++number) + "_";
    const auto addPoint = [&](const std::string& name, const auto& point) {
      if (!point.found) return;
      add(prefix + name + "_travel", static_cast<double>(point.travel));
      add(prefix + name + "_n", static_cast<double>(point.force));
    };
    addPoint("interception", cut.interception);
    addPoint("yield", cut.yield);
    addPoint("bottom_out", cut.bottomOut);
    addPoint("opening", cut.opening);
    add(prefix + "peak_n", static_cast<double>(cut.peakForce));
  }
  return values;
}

}  // namespace

void TrialRepository::add(const VisitKey& visit, const TrialRecord& record) {
  const auto* key = isSimulated(visit.session) ? nullptr : database_.measurementKey();
  if (key == nullptr) return addOpen(visit, record);
  Statement insert(
      database_,
      "INSERT INTO trial (session_id, step, attempt, device, ending, verdict, verdict_reason, "
      "force_unit, travel_unit, duration_s, ticks, nominal_rate_hz, lost_samples, invalid_ticks, "
      "saturated_s, slewed_s, undefined_s, contact_s, largest_force_n, cuts, trace_samples, "
      "sealed) "
      "VALUES (?,?,?,?,?,'PASS','','N',?,0,0,0,0,0,0,0,0,0,0,0,?,?)");
  const auto sealed = sealedMeasurements(*key, visit, asJson(measured(record)));
  insert.bind(1, visit);
  insert.bind(4, record.device)
      .bind(5, nameOf(record.ending))
      .bind(6, record.travelUnit)
      .bind(7, record.traceSamples)
      .bind(8, std::span<const std::byte>(sealed));
  insert.run();
}

bool TrialRepository::isSimulated(SessionId session) const {
  Statement select(database_, "SELECT 1 FROM session WHERE id = ? AND run_mode = 'simulated'");
  return select.bind(1, static_cast<std::int64_t>(session)).step();
}

void TrialRepository::addOpen(const VisitKey& visit, const TrialRecord& record) {
  Statement insert(
      database_,
      "INSERT INTO trial (session_id, step, attempt, device, ending, verdict, verdict_reason, "
      "force_unit, travel_unit, duration_s, ticks, nominal_rate_hz, achieved_rate_hz, "
      "lateness_p50_us, "
      "lateness_p99_us, lateness_max_us, late_ticks, lost_samples, invalid_ticks, saturated_s, "
      "slewed_s, "
      "undefined_s, contact_s, largest_force_n, cuts, trace_samples) "
      "VALUES (?,?,?,?,?,?,?,'N',?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?,?)");
  insert.bind(1, visit);
  const auto judgement = record.judgement();
  insert.bind(4, record.device)
      .bind(5, nameOf(record.ending))
      .bind(6, nameOf(judgement.verdict))
      .bind(7, asJson(judgement.reasons))
      .bind(8, record.travelUnit)
      .bind(9, record.duration)
      .bind(10, record.ticks)
      .bind(11, record.nominalRate)
      .bind(12, record.achievedRate)
      .bind(13, record.latenessMedian)
      .bind(14, record.latenessP99)
      .bind(15, record.latenessLargest)
      .bind(16, record.lateTicks)
      .bind(17, record.lostSamples)
      .bind(18, record.invalidTicks)
      .bind(19, record.saturated)
      .bind(20, record.slewed)
      .bind(21, record.undefined)
      .bind(22, record.contact)
      .bind(23, record.largestForce)
      .bind(24, static_cast<std::int64_t>(record.cuts.size()))
      .bind(25, record.traceSamples);
  insert.run();
  std::int64_t number = 0;
  for (const auto& cut : record.cuts) addCut(visit, ++number, cut);
}

void TrialRepository::addCut(
    const VisitKey& visit, std::int64_t number, const TrialRecord::Cut& cut) {
  Statement insert(
      database_,
      "INSERT INTO cut (session_id, step, attempt, number, interception_travel, interception_n, "
      "yield_travel, yield_n, bottom_out_travel, bottom_out_n, opening_travel, opening_n, peak_n) "
      "VALUES (?,?,?,?,?,?,?,?,?,?,?,?,?)");
  insert.bind(1, visit);
  insert.bind(4, number);
  int column = 5;
  for (const auto* point : {&cut.interception, &cut.yield, &cut.bottomOut, &cut.opening}) {
    insert.bind(column++, point->found ? std::optional(point->travel) : std::nullopt);
    insert.bind(column++, point->found ? std::optional(point->force) : std::nullopt);
  }
  insert.bind(column, cut.peakForce);
  insert.run();
}

}  // namespace study::storage
