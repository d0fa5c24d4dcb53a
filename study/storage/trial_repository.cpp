#include "study/storage/trial_repository.h"

#include "study/storage/statement.h"
#include "study/storage/stored_values.h"

namespace study::storage {

void TrialRepository::add(const VisitKey& visit, const TrialRecord& record) {
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
