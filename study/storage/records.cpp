#include "study/storage/records.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <tuple>
#include <variant>

#include <fmt/format.h>

#include "study/storage/answer_repository.h"
#include "study/storage/events_of_release_0_1.h"
#include "study/storage/named_rows.h"
#include "study/storage/required_key.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"
#include "study/storage/trial_repository.h"

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

constexpr VisitKey kBeforeAll{.session = SessionId{std::numeric_limits<std::int64_t>::min()}};

/// Rows in the order of the visit in their first three columns (0 where a row is for more than
/// one).
struct OrderedRows {
  OrderedRows(const Database& database, const std::string& sql) : row(database, sql) {}

  /// Whether there is a row for @p wanted, which is at least that of the call before.
  bool advanceTo(const VisitKey& wanted) {
    while (isThere_ && visit_ < wanted) {
      isThere_ = row.step();
      if (isThere_) visit_ = readVisitKey(row);
    }
    return isThere_ && visit_ == wanted;
  }

  Statement row;

 private:
  VisitKey visit_ = kBeforeAll;
  bool isThere_ = true;
};

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
    return bytes.empty() ? row.text(open)
                         : openCondition(requireKey(database), session, step, bytes);
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
  const auto real = [&](const char* name) { return storedValue<double>(values, name); };
  const auto whole = [&](const char* name) { return storedValue<std::int64_t>(values, name); };
  const auto verdict = storedText(values, "verdict");
  trial.verdict = requireKnown(verdictNamed(verdict), verdict);
  trial.reasons = reasonsIn(storedText(values, "verdict_reason"));
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

/// @param prefix  of the names of this cut's values
CutRecord cutIn(
    const VisitKey& visit,
    int number,
    const base::NamedArguments& values,
    const std::string& prefix) {
  const auto real = [&](const char* name) { return storedValue<double>(values, prefix + name); };
  return {
      .visit = visit,
      .number = number,
      .interceptionTravel = real("interception_travel"),
      .interceptionForce = real("interception_n"),
      .yieldTravel = real("yield_travel"),
      .yieldForce = real("yield_n"),
      .bottomOutTravel = real("bottom_out_travel"),
      .bottomOutForce = real("bottom_out_n"),
      .openingTravel = real("opening_travel"),
      .openingForce = real("opening_n"),
      .peakForce = real("peak_n").value_or(0.0)};
}

/// The column of the table trial AS x with sealed measurements; NULL in files of older formats that
/// were opened for reading only.
const char* sealedTrialColumn(const Database& database) {
  return database.hasColumn("trial", "sealed") ? "x.sealed" : "NULL";
}

}  // namespace

std::vector<SessionRecord> Records::sessions() const {
  Statement select(
      database_,
      selectSessions(database_, ", r.sha256, s.app_version") +
          "JOIN protocol AS r ON r.id = s.protocol_id ORDER BY s.id");
  std::vector<SessionRecord> sessions;
  while (select.step()) {
    sessions.push_back(
        {sessionIn(select),
         select.text(kSessionColumnCount),
         select.text(kSessionColumnCount + 1)});
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
  if (session) select.bindAll(*session);
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
  // Queries in one order, merged here. SQLite would sort all answers by text to group them, and
  // search three tables for each visit to join them: twice as long.
  Statement answers(
      database_,
      "SELECT session_id, step, attempt, item, coalesce(point, CAST(number AS INTEGER)) FROM "
      "answer WHERE point IS NOT NULL OR number = CAST(number AS INTEGER) "
      "ORDER BY session_id, step, attempt");
  OrderedRows visits(
      database_,
      "SELECT session_id, step, attempt FROM visit WHERE status = 'finished' "
      "ORDER BY session_id, step, attempt");
  OrderedRows sessions(
      database_,
      "SELECT id, 0, 0, cohort, protocol_id FROM session WHERE run_mode = ? AND state = ? ORDER BY "
      "id");
  sessions.row.bindAll(nameOf(mode), nameOf(SessionState::Completed));
  OrderedRows steps(
      database_,
      "SELECT session_id, step, 0, phase, instrument FROM step WHERE kind = ? "
      "ORDER BY session_id, step");
  steps.row.bindAll(nameOf(StepKind::Questionnaire));
  OrderedRows allocations(
      database_,
      std::string("SELECT session_id, step, 0, condition, ") + sealedColumn(database_) +
          " FROM allocation AS a ORDER BY session_id, step");

  using ItemCounts = std::map<std::string, std::map<std::int64_t, std::uint64_t>>;
  std::map<std::pair<std::array<std::string, 4>, ProtocolId>, ItemCounts> counted;
  const ConditionCell condition{database_, conditions_};
  const auto countsOf = [&](const VisitKey& visit) -> ItemCounts* {
    const auto [session, step, attempt] = visit;
    if (!sessions.advanceTo({session, 0, 0}) || !steps.advanceTo({session, step, 0}) ||
        !visits.advanceTo(visit)) {
      return nullptr;
    }
    const bool isAllocated = allocations.advanceTo({session, step, 0});
    const std::array place{
        sessions.row.text(3),
        steps.row.text(3),
        steps.row.text(4),
        isAllocated ? condition.in(allocations.row, 3, 4, session, step) : std::string()};
    return &counted[{place, ProtocolId{sessions.row.number(4)}}];
  };
  auto visit = kBeforeAll;
  ItemCounts* counts = nullptr;
  while (answers.step()) {  // from the first on all queries see the same state of the database
    if (const auto next = readVisitKey(answers); next != visit) counts = countsOf(visit = next);
    if (counts != nullptr) ++(*counts)[answers.text(3)][answers.number(4)];
  }

  std::vector<PointCount> rows;
  for (const auto& [key, items] : counted) {
    const auto& [place, protocol] = key;
    for (const auto& [item, points] : items) {
      for (const auto& [point, times] : points) {
        rows.push_back(
            {.protocol = protocol,
             .cohort = place[0],
             .phase = place[1],
             .instrument = place[2],
             .condition = place[3],
             .item = item,
             .point = point,
             .times = times});
      }
    }
  }
  return rows;
}

std::vector<StoredTrial> Records::trials() const {
  Statement select(
      database_,
      fmt::format(
          "SELECT {}, x.device, x.ending, x.travel_unit, x.trace_samples, {}, {} FROM trial AS x{}"
          "ORDER BY x.session_id, x.step, x.attempt",
          stepColumns(database_),
          sealedTrialColumn(database_),
          kMeasuredColumns,
          kStepJoins));
  const ConditionCell condition{database_, conditions_};
  const auto measured = namesIn(kMeasuredColumns);
  std::vector<StoredTrial> trials;
  while (select.step()) {
    constexpr int k = kFirstOwnColumn;
    auto& trial = trials.emplace_back(StoredTrial{
        .step = stepIn(select, condition),
        .device = select.text(k),
        .travelUnit = select.text(k + 2),
        .ending = requireKnown(trialEndingNamed(select.text(k + 1)), select.text(k + 1)),
        .reasons = {},
        .traceSamples = select.number(k + 3)});
    const auto sealed = select.blob(k + 4);
    const bool isOpen = sealed.empty() || conditions_ == Conditions::LeftOut;
    fillIn(
        trial,
        isOpen ? presentValues(rowIn(select, measured, k + 5), measured)
               : measuredIn(openMeasurements(requireKey(database_), trial.step.visit, sealed)));
  }
  return trials;
}

std::vector<CutRecord> Records::cuts() const {
  Statement select(
      database_,
      fmt::format(
          "SELECT session_id, step, attempt, number, {} FROM cut "
          "ORDER BY session_id, step, attempt, number",
          kMeasuredColumnsOfCut));
  const auto measured = namesIn(kMeasuredColumnsOfCut);
  std::vector<CutRecord> cuts;
  while (select.step()) {
    const auto values = presentValues(rowIn(select, measured, 4), measured);
    cuts.push_back(cutIn(readVisitKey(select), static_cast<int>(select.number(3)), values, ""));
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
    const auto values = measuredIn(openMeasurements(requireKey(database_), visit, sealed.blob(3)));
    const auto count = storedValue<std::int64_t>(values, "cuts").value_or(0);
    for (int number = 1; number <= count; ++number) {
      cuts.push_back(cutIn(visit, number, values, prefixOfCut(number)));
    }
  }
  std::ranges::sort(cuts, [](const CutRecord& a, const CutRecord& b) {
    return std::tie(a.visit, a.number) < std::tie(b.visit, b.number);
  });
  return cuts;
}

std::map<std::pair<SessionId, std::string>, int> Records::unfinishedTrials() const {
  Statement select(
      database_,
      "SELECT s.session_id, s.phase, count(*) FROM step AS s "
      "WHERE s.kind = 'trial' AND s.position > 0 AND NOT EXISTS "
      "(SELECT 1 FROM visit AS v WHERE v.session_id = s.session_id AND v.step = s.step "
      "AND v.status = 'finished') GROUP BY s.session_id, s.phase");
  std::map<std::pair<SessionId, std::string>, int> trials;
  while (select.step()) {
    trials[{SessionId{select.number(0)}, select.text(1)}] = static_cast<int>(select.number(2));
  }
  return trials;
}

Records::Allocation Records::allocation() const {
  Statement select(
      database_,
      std::string("SELECT s.session_id, s.phase, s.label, a.condition, s.step, ") +
          sealedColumn(database_) +
          " FROM step AS s "
          "JOIN allocation AS a ON a.session_id = s.session_id AND a.step = s.step "
          "WHERE s.kind = 'trial'");
  const ConditionCell condition{database_, conditions_};
  Allocation allocation;
  while (select.step()) {
    const SessionId session{select.number(0)};
    const Alternative place{session, select.text(1), static_cast<int>(select.number(2))};
    allocation[place] = condition.in(select, 3, 5, session, static_cast<int>(select.number(4)));
  }
  return allocation;
}

const std::string* conditionOf(
    const Records::Allocation& allocation,
    SessionId session,
    const std::string& block,
    const std::string& label) {
  int number = 0;
  std::from_chars(label.data(), label.data() + label.size(), number);
  const auto felt = allocation.find({session, block, number});
  return felt == allocation.end() ? nullptr : &felt->second;
}

const std::string* chosenCondition(
    const Records::Allocation& allocation,
    const AnswerRecord& answer,
    const questionnaires::Item* item,
    const std::string& block) {
  const auto* label = std::get_if<std::string>(&answer.answer.response);
  const bool isVote = item != nullptr && label != nullptr &&
                      item->optionSource == questionnaires::OptionSource::Alternatives;
  return isVote ? conditionOf(allocation, answer.step.visit.session, block, *label) : nullptr;
}

}  // namespace study::storage
