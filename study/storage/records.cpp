#include "study/storage/records.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <type_traits>

#include "study/storage/answer_repository.h"
#include "study/storage/events_of_release_0_1.h"
#include "study/storage/keys/sealed_condition.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"

namespace study::storage {
namespace {

// All statements that read visits begin with these columns, followed by the sealed condition.
constexpr const char* kStepColumns =
    "v.session_id, v.step, v.attempt, s.kind, s.phase, s.instrument, s.position, s.label, "
    "coalesce(a.condition, ''), v.status, ";
constexpr const char* kStepJoins =
    " JOIN visit AS v ON v.session_id = x.session_id AND v.step = x.step AND v.attempt = x.attempt "
    "JOIN step AS s ON s.session_id = x.session_id AND s.step = x.step "
    "LEFT JOIN allocation AS a ON a.session_id = x.session_id AND a.step = x.step ";
constexpr int kFirstOwnColumn = 11;

std::string stepColumns(const Database& database) {
  return std::string(kStepColumns) + sealedColumn(database);
}

VisitKey readVisitKey(const Statement& row) {
  return {
      SessionId{row.number(0)}, static_cast<int>(row.number(1)), static_cast<int>(row.number(2))};
}

std::vector<base::Message> reasonsIn(const std::string& text) {
  return text.empty() || text.starts_with('[') ? messagesIn(text)
                                               : release_0_1::trialReasonsIn(text);
}

/// Reads a condition that may be sealed.
struct ConditionCell {
  const Database& database;
  Records::Conditions wanted = Records::Conditions::Shown;

  std::string in(const Statement& row, int open, int sealed, SessionId session, int step) const {
    if (wanted == Records::Conditions::LeftOut) return {};
    const auto bytes = row.blob(sealed);
    return bytes.empty() ? row.text(open) : openCondition(database.key(), session, step, bytes);
  }
};

StepRecord stepIn(const Statement& row, const ConditionCell& condition) {
  const auto visit = readVisitKey(row);
  return {
      .visit = visit,
      .kind = requireKnown(stepKindNamed(row.text(3)), row.text(3)),
      .phase = row.text(4),
      .instrument = row.text(5),
      .position = static_cast<int>(row.number(6)),
      .label = static_cast<int>(row.number(7)),
      .condition = condition.in(row, 8, kFirstOwnColumn - 1, visit.session, visit.step),
      .visitStatus = requireKnown(visitStatusNamed(row.text(9)), row.text(9))};
}

/// The value named @p name; std::nullopt if there is none of that type.
template <typename Value>
std::optional<Value> valueIn(const base::NamedArguments& values, std::string_view name) {
  for (const auto& [known, value] : values) {
    if (known != name) continue;
    if (const auto* found = std::get_if<Value>(&value)) return *found;
    // JSON has a whole number for 3.0.
    if constexpr (std::is_same_v<Value, double>) {
      if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    }
  }
  return std::nullopt;
}

base::NamedArguments measuredIn(const std::string& text) {
  auto values = valuesIn(text);
  if (!values) {
    throw StorageError(
        "What was measured in a trial cannot be read. Is the study damaged? 'palpate study verify' "
        "says more.",
        StorageError::Kind::Damaged);
  }
  return std::move(*values);
}

void fillIn(StoredTrial& trial, const base::NamedArguments& values) {
  const auto real = [&](const char* name) { return valueIn<double>(values, name); };
  const auto whole = [&](const char* name) { return valueIn<std::int64_t>(values, name); };
  const auto text = [&](const char* name) {
    return valueIn<std::string>(values, name).value_or("");
  };
  trial.verdict = requireKnown(verdictNamed(text("verdict")), text("verdict"));
  trial.reasons = reasonsIn(text("verdict_reason"));
  trial.duration = real("duration_s").value_or(0.0);
  trial.ticks = whole("ticks").value_or(0);
  trial.nominalRate = real("nominal_rate_hz").value_or(0.0);
  trial.achievedRate = real("achieved_rate_hz");
  trial.latenessMedian = real("lateness_p50_us");
  trial.latenessP99 = real("lateness_p99_us");
  trial.latenessLargest = real("lateness_max_us");
  trial.lateTicks = whole("late_ticks");
  trial.lostSamples = whole("lost_samples").value_or(0);
  trial.invalidTicks = whole("invalid_ticks").value_or(0);
  trial.saturated = real("saturated_s").value_or(0.0);
  trial.slewed = real("slewed_s").value_or(0.0);
  trial.undefined = real("undefined_s").value_or(0.0);
  trial.contact = real("contact_s").value_or(0.0);
  trial.largestForce = real("largest_force_n").value_or(0.0);
  trial.cuts = whole("cuts").value_or(0);
}

void addCuts(
    const VisitKey& visit, const base::NamedArguments& values, std::vector<CutRecord>& cuts) {
  const auto count = valueIn<std::int64_t>(values, "cuts").value_or(0);
  for (int number = 1; number <= count; ++number) {
    const auto real = [&](const char* name) {
      return valueIn<double>(values, "cut_" + std::to_string(number) + "_" + name);
    };
    cuts.push_back(
        {.visit = visit,
         .number = number,
         .interceptionTravel = real("interception_travel"),
         .interceptionForce = real("interception_n"),
         .yieldTravel = real("yield_travel"),
         .yieldForce = real("yield_n"),
         .bottomOutTravel = real("bottom_out_travel"),
         .bottomOutForce = real("bottom_out_n"),
         .openingTravel = real("opening_travel"),
         .openingForce = real("opening_n"),
         .peakForce = real("peak_n").value_or(0.0)});
  }
}

/// The column of the table trial AS x with sealed measurements; NULL in files of older formats that
/// were opened for reading only.
const char* sealedTrialColumn(const Database& database) {
  return database.hasColumn("trial", "sealed") ? "x.sealed" : "NULL";
}

const char* siteColumn(const Database& database) {
  return database.hasColumn("session", "site") ? "s.site" : "''";
}

}  // namespace

std::vector<SessionRecord> Records::sessions() const {
  Statement select(
      database_,
      "SELECT s.id, p.code, s.number, s.cohort, s.run_mode, s.state, coalesce(s.end_reason, ''), "
      "s.language, s.protocol_id, r.sha256, s.slot, s.app_version, s.started_utc, s.ended_utc, " +
          std::string(siteColumn(database_)) +
          " FROM session AS s JOIN participant AS p ON p.id = s.participant_id "
          "JOIN protocol AS r ON r.id = s.protocol_id ORDER BY s.id");
  std::vector<SessionRecord> sessions;
  while (select.step()) {
    sessions.push_back(
        {.id = SessionId{select.number(0)},
         .participant = select.text(1),
         .number = static_cast<int>(select.number(2)),
         .cohort = select.text(3),
         .runMode = requireKnown(runModeNamed(select.text(4)), select.text(4)),
         .state = requireKnown(sessionStateNamed(select.text(5)), select.text(5)),
         .endReason = select.text(6),
         .language = select.text(7),
         .protocol = ProtocolId{select.number(8)},
         .protocolHash = select.text(9),
         .slot = select.number(10),
         .appVersion = select.text(11),
         .startedUtc = select.text(12),
         .endedUtc = select.optionalText(13),
         .site = select.text(14)});
  }
  return sessions;
}

std::vector<AnswerRecord> Records::answers(std::optional<SessionId> session) const {
  Statement select(
      database_,
      "SELECT " + stepColumns(database_) +
          ", x.item, x.item_order, x.kind, x.point, x.number, x.text, x.first_touch_s, "
          "x.response_s, x.changes, x.language, x.saved_utc FROM answer AS x" +
          kStepJoins + (session ? "WHERE x.session_id = ? " : "") +
          "ORDER BY x.session_id, x.step, x.attempt, x.item_order, x.item");
  if (session) select.bind(1, static_cast<std::int64_t>(*session));
  const ConditionCell condition{database_, conditions_};
  std::vector<AnswerRecord> answers;
  while (select.step()) {
    constexpr int k = kFirstOwnColumn;
    answers.push_back(
        {.step = stepIn(select, condition),
         .answer =
             {.item = select.text(k),
              .response = restored(
                  {.kind = select.text(k + 2),
                   .point = select.optionalNumber(k + 3),
                   .number = select.optionalReal(k + 4),
                   .text = select.optionalText(k + 5)}),
              .itemOrder = static_cast<int>(select.number(k + 1)),
              .firstTouch = select.real(k + 6),
              .responseTime = select.real(k + 7),
              .changes = static_cast<int>(select.number(k + 8)),
              .language = select.text(k + 9)},
         .savedUtc = select.text(k + 10)});
  }
  return answers;
}

std::vector<PointCount> Records::pointCounts(RunMode mode) const {
  // Two queries in the order of the visits, merged here. SQLite would run a single GROUP BY four
  // times as long, because it sorts all answers by text.
  Statement visits(
      database_,
      "SELECT v.session_id, v.step, v.attempt, n.cohort, s.phase, s.instrument, "
      "coalesce(a.condition, ''), " +
          std::string(sealedColumn(database_)) +
          " FROM visit AS v JOIN session AS n ON n.id = v.session_id "
          "JOIN step AS s ON s.session_id = v.session_id AND s.step = v.step "
          "LEFT JOIN allocation AS a ON a.session_id = v.session_id AND a.step = v.step "
          "WHERE n.run_mode = ? AND n.state = ? AND s.kind = ? AND v.status = 'finished' "
          "ORDER BY v.session_id, v.step, v.attempt");
  visits.bind(1, nameOf(mode)).bind(2, nameOf(SessionState::Completed));
  visits.bind(3, nameOf(StepKind::Questionnaire));
  Statement answers(
      database_,
      "SELECT session_id, step, attempt, item, coalesce(point, CAST(number AS INTEGER)) FROM "
      "answer "
      "WHERE point IS NOT NULL OR number = CAST(number AS INTEGER) "
      "ORDER BY session_id, step, attempt");

  using ItemCounts = std::map<std::string, std::map<std::int64_t, std::uint64_t>>;
  std::map<std::array<std::string, 4>, ItemCounts> counted;
  const ConditionCell condition{database_, conditions_};
  bool isThere = answers.step();  // from now on both queries see the same state of the database
  while (visits.step() && isThere) {
    const auto visit = readVisitKey(visits);
    auto& items = counted[{
        visits.text(3),
        visits.text(4),
        visits.text(5),
        condition.in(visits, 6, 7, visit.session, visit.step)}];
    while (isThere && readVisitKey(answers) < visit) isThere = answers.step();
    for (; isThere && readVisitKey(answers) == visit; isThere = answers.step()) {
      ++items[answers.text(3)][answers.number(4)];
    }
  }

  std::vector<PointCount> counts;
  for (const auto& [place, items] : counted) {
    for (const auto& [item, points] : items) {
      for (const auto& [point, times] : points) {
        counts.push_back(
            {.cohort = place[0],
             .phase = place[1],
             .instrument = place[2],
             .condition = place[3],
             .item = item,
             .point = point,
             .times = times});
      }
    }
  }
  return counts;
}

std::vector<StoredTrial> Records::trials() const {
  Statement select(
      database_,
      "SELECT " + stepColumns(database_) +
          ", x.device, x.ending, x.verdict, x.verdict_reason, x.travel_unit, x.duration_s, "
          "x.ticks, "
          "x.nominal_rate_hz, x.achieved_rate_hz, x.lateness_p50_us, x.lateness_p99_us, "
          "x.lateness_max_us, x.late_ticks, x.lost_samples, x.invalid_ticks, x.saturated_s, "
          "x.slewed_s, x.undefined_s, x.contact_s, x.largest_force_n, x.cuts, x.trace_samples, " +
          sealedTrialColumn(database_) + " FROM trial AS x" + kStepJoins +
          "ORDER BY x.session_id, x.step, x.attempt");
  const ConditionCell condition{database_, conditions_};
  std::vector<StoredTrial> trials;
  while (select.step()) {
    constexpr int k = kFirstOwnColumn;
    trials.push_back(
        {.step = stepIn(select, condition),
         .device = select.text(k),
         .travelUnit = select.text(k + 4),
         .ending = requireKnown(trialEndingNamed(select.text(k + 1)), select.text(k + 1)),
         .verdict = requireKnown(verdictNamed(select.text(k + 2)), select.text(k + 2)),
         .reasons = reasonsIn(select.text(k + 3)),
         .duration = select.real(k + 5),
         .ticks = select.number(k + 6),
         .nominalRate = select.real(k + 7),
         .achievedRate = select.optionalReal(k + 8),
         .latenessMedian = select.optionalReal(k + 9),
         .latenessP99 = select.optionalReal(k + 10),
         .latenessLargest = select.optionalReal(k + 11),
         .lateTicks = select.optionalNumber(k + 12),
         .lostSamples = select.number(k + 13),
         .invalidTicks = select.number(k + 14),
         .saturated = select.real(k + 15),
         .slewed = select.real(k + 16),
         .undefined = select.real(k + 17),
         .contact = select.real(k + 18),
         .largestForce = select.real(k + 19),
         .cuts = select.number(k + 20),
         .traceSamples = select.number(k + 21)});
    const auto sealed = select.blob(k + 22);
    if (sealed.empty() || conditions_ == Conditions::LeftOut) continue;
    auto& trial = trials.back();
    fillIn(trial, measuredIn(openMeasurements(database_.key(), trial.step.visit, sealed)));
  }
  return trials;
}

std::vector<CutRecord> Records::cuts() const {
  Statement select(
      database_,
      "SELECT session_id, step, attempt, number, interception_travel, interception_n, "
      "yield_travel, "
      "yield_n, bottom_out_travel, bottom_out_n, opening_travel, opening_n, peak_n FROM cut "
      "ORDER BY session_id, step, attempt, number");
  std::vector<CutRecord> cuts;
  while (select.step()) {
    cuts.push_back(
        {.visit = readVisitKey(select),
         .number = static_cast<int>(select.number(3)),
         .interceptionTravel = select.optionalReal(4),
         .interceptionForce = select.optionalReal(5),
         .yieldTravel = select.optionalReal(6),
         .yieldForce = select.optionalReal(7),
         .bottomOutTravel = select.optionalReal(8),
         .bottomOutForce = select.optionalReal(9),
         .openingTravel = select.optionalReal(10),
         .openingForce = select.optionalReal(11),
         .peakForce = select.real(12)});
  }
  if (conditions_ == Conditions::LeftOut) return cuts;
  Statement sealed(
      database_,
      std::string("SELECT session_id, step, attempt, x.sealed FROM (SELECT session_id, step, "
                  "attempt, ") +
          sealedTrialColumn(database_) +
          " AS sealed FROM trial AS x) AS x WHERE sealed IS NOT NULL");
  while (sealed.step()) {
    const auto visit = readVisitKey(sealed);
    addCuts(visit, measuredIn(openMeasurements(database_.key(), visit, sealed.blob(3))), cuts);
  }
  std::sort(cuts.begin(), cuts.end(), [](const CutRecord& a, const CutRecord& b) {
    return std::tie(a.visit, a.number) < std::tie(b.visit, b.number);
  });
  return cuts;
}

std::map<Records::Alternative, std::string> Records::allocation() const {
  Statement select(
      database_,
      std::string("SELECT s.session_id, s.phase, s.label, a.condition, s.step, ") +
          sealedColumn(database_) +
          " FROM step AS s "
          "JOIN allocation AS a ON a.session_id = s.session_id AND a.step = s.step "
          "WHERE s.kind = 'trial'");
  const ConditionCell condition{database_, conditions_};
  std::map<Alternative, std::string> allocation;
  while (select.step()) {
    const SessionId session{select.number(0)};
    const Alternative place{session, select.text(1), static_cast<int>(select.number(2))};
    allocation[place] = condition.in(select, 3, 5, session, static_cast<int>(select.number(4)));
  }
  return allocation;
}

}  // namespace study::storage
