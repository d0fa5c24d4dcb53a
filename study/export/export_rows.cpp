#include "study/export/export_rows.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "questionnaires/model/answer.h"
#include "questionnaires/model/instrument.h"
#include "study/export/coarsening.h"
#include "study/export/condition_codes.h"
#include "study/storage/answer_repository.h"

namespace study {
namespace {

using storage::SessionRecord;
using storage::StepRecord;

/// The time between two events of a session [ns]. The monotonic clock restarts with the computer,
/// so the time between two runs of the program is taken from the wall clock. The time before a
/// ClockStepped event is that of the wall clock minus the step.
std::int64_t timeBetween(const Moment& last, const storage::Event& event) {
  const std::int64_t byWallClock = (event.when.wall - last.wall) * 1'000'000;
  if (event.kind == EventKind::Resumed || event.kind == EventKind::TookOver) return byWallClock;
  if (const auto* by = event.value("by_s");
      event.kind == EventKind::ClockStepped && by != nullptr) {
    if (const auto* step = std::get_if<double>(by)) return byWallClock - std::llround(*step * 1e9);
  }
  return event.when.monotonic - last.monotonic;
}

/// The times of events since the session's first event.
class EventOnsets {
 public:
  double of(const storage::Event& event) {
    auto& last = lastEvents_[event.visit->session];
    if (last) {
      last->onset += std::max<std::int64_t>(timeBetween(last->when, event), 0);
      last->when = event.when;
    } else {
      last = {.when = event.when};
    }
    return static_cast<double>(last->onset) / 1e9;
  }

 private:
  struct LastEvent {
    Moment when;
    std::int64_t onset = 0;  ///< [ns]
  };
  std::map<SessionId, std::optional<LastEvent>> lastEvents_;
};

RowOwner ownerOf(const SessionRecord& session) {
  return {
      .session = session.id,
      .participant = session.participant,
      .sessionNumber = session.number,
      .cohort = session.cohort,
      .site = session.site,
      .runMode = session.runMode};
}

/// The bands that replace numbers about the person.
class Bands {
 public:
  /// The band of an answer; empty for items that are no numbers about the person.
  std::string of(const storage::AnswerRecord& answer, const questionnaires::Item& item) {
    if (answer.step.kind != StepKind::Form || publicFormOf(item) != PublicForm::Bands) return {};
    const auto& bands = hierarchies_.try_emplace(&item, item, "").first->second;
    return bands.levelCount() == 0 ? std::string() : bands.releasedValue(0, answer.answer.response);
  }

 private:
  // the language is empty, because labels of bands have no words
  std::map<const questionnaires::Item*, GeneralisationHierarchy> hierarchies_;
};

/// The day in a stored time such as "2026-11-23T08:15:00Z".
std::chrono::sys_days dayOf(const std::string& utc) {
  const auto number = [&](std::size_t from, std::size_t count) {
    return from + count <= utc.size() ? std::atoi(utc.substr(from, count).c_str()) : 0;
  };
  return std::chrono::sys_days(std::chrono::year(number(0, 4)) / number(5, 2) / number(8, 2));
}

Cell responseOf(const questionnaires::Response& response) {
  const auto stored = storage::stored(response);
  if (stored.point) return *stored.point;
  if (stored.number) return *stored.number;
  return stored.text.value_or("");
}

/// Whether the answer is free text. A string that answers an item which the protocol no longer has
/// counts as free text.
bool isText(const ExportedAnswer& row) {
  if (row.item == nullptr) return std::holds_alternative<std::string>(row.record->answer.response);
  return questionnaires::answerKindOf(row.item->type) == questionnaires::AnswerKind::Text;
}

}  // namespace

StudyRows::StudyRows(Study& study, const ExportOptions& options)
    : study_(study), versions_(study), isExact_(options.isExact), isBlinded_(options.isBlinded) {
  for (const auto mode : {RunMode::Live, RunMode::Pilot, RunMode::Simulated}) {
    // codes of other run modes may need a key that is not available
    if (options.runMode && *options.runMode != mode) continue;
    codes_.emplace(mode, conditionCodes(study, mode, options.codes));
  }
  const storage::Records records(study.database());
  for (auto& session : records.sessions()) {
    if (isExported(options, session)) sessions_.emplace(session.id, std::move(session));
  }
  answers_ = records.answers();
  trials_ = records.trials();
  cuts_ = records.cuts();
  unfinishedTrials_ = records.unfinishedTrials();
  // A vote's alternative gets a code only from the folder's own rows: if nothing was asked about
  // the alternative, a blinded folder has no row with its code.
  const auto add = [&](const StepRecord& step) {
    if (!step.condition.empty())
      conditionOfAlternative_.try_emplace(
          {step.visit.session, step.phase, step.label}, step.condition);
  };
  for (const auto& answer : answers_) add(answer.step);
  if (isBlinded_) return;
  for (const auto& trial : trials_) add(trial.step);
}

ExportedStep StudyRows::stepOf(const SessionRecord& session, const StepRecord& step) const {
  const bool isFelt = !step.condition.empty();
  const auto& codes = codes_.at(session.runMode);
  const auto code = codes.find(step.condition);
  return {
      .owner = ownerOf(session),
      .visit = step.visit,
      .block = step.phase,
      .position = isFelt && step.position > 0 ? std::optional(step.position) : std::nullopt,
      .alternative = isFelt ? std::optional(step.label) : std::nullopt,
      .conditionCode = code == codes.end() ? std::string_view() : code->second,
      .condition = step.condition};
}

std::string_view StudyRows::chosenIn(const ExportedAnswer& row) const {
  const auto& session = sessions_.at(row.owner.session);
  const auto* phase = study_.protocol(session.protocol).protocol.phase(row.block);
  if (phase == nullptr) return {};
  const auto* chosen =
      chosenCondition(conditionOfAlternative_, *row.record, row.item, phase->block);
  if (chosen == nullptr) return {};
  if (!isBlinded_) return *chosen;
  const auto& codes = codes_.at(row.owner.runMode);
  const auto code = codes.find(*chosen);
  return code == codes.end() ? std::string_view() : code->second;
}

bool StudyRows::isVoteWithoutAll(const ExportedAnswer& row) const {
  const auto& session = sessions_.at(row.owner.session);
  const auto* phase = study_.protocol(session.protocol).protocol.phase(row.block);
  return phase != nullptr && row.item != nullptr &&
         row.item->optionSource == questionnaires::OptionSource::Alternatives &&
         unfinishedTrials_.contains({session.id, phase->block});
}

std::vector<ExportedSession> StudyRows::sessions() const {
  std::vector<ExportedSession> rows;
  std::optional<std::chrono::sys_days> first;
  for (const auto& [id, session] : sessions_) {
    const auto day = dayOf(session.startedUtc);
    first = first ? std::min(*first, day) : day;
  }
  for (const auto& [id, session] : sessions_) {
    const auto days = (dayOf(session.startedUtc) - *first).count();
    rows.push_back({ownerOf(session), &session, static_cast<int>(days) + 1});
  }
  return rows;
}

std::vector<ExportedAnswer> StudyRows::answers() const {
  return answers(false);
}

std::vector<ExportedAnswer> StudyRows::texts() const {
  return answers(true);
}

std::vector<ExportedAnswer> StudyRows::answers(bool areTexts) const {
  std::vector<ExportedAnswer> rows;
  Bands bands;
  for (const auto& record : answers_) {
    const auto session = sessions_.find(record.step.visit.session);
    if (session == sessions_.end()) continue;
    ExportedAnswer row{stepOf(session->second, record.step)};
    const auto version = session->second.protocol;
    const auto& asked = record.step.instrument;
    row.record = &record;
    row.instrument = versions_.of(version).instrument(asked);
    row.item = versions_.item(version, asked, record.answer.item);
    if (isText(row) != areTexts) continue;
    row.response = responseOf(record.answer.response);
    if (row.item != nullptr && !isExact_) row.band = bands.of(record, *row.item);
    row.labelLanguage = record.answer.language;
    row.chosen = chosenIn(row);
    if (!session->second.isCompleted()) {
      row.excluded = statusOf(session->second.state);
    } else if (!record.step.isFinished()) {
      row.excluded = nameOf(record.step.visitStatus);
    } else if (!versions_.isPooled(version, asked, record.answer.item)) {
      row.excluded = "other_scale";
    } else if (isVoteWithoutAll(row)) {
      row.excluded = "not_all_felt";
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<ExportedTrial> StudyRows::trials() const {
  std::vector<ExportedTrial> rows;
  for (const auto& record : trials_) {
    const auto session = sessions_.find(record.step.visit.session);
    if (session == sessions_.end()) continue;
    rows.push_back({stepOf(session->second, record.step), &record});
  }
  return rows;
}

std::vector<ExportedCut> StudyRows::cuts() const {
  std::vector<ExportedCut> rows;
  for (const auto& record : cuts_) {
    const auto session = sessions_.find(record.visit.session);
    if (session == sessions_.end()) continue;
    rows.push_back({ownerOf(session->second), record.visit, &record});
  }
  return rows;
}

std::vector<ExportedEvent> StudyRows::events() const {
  std::vector<ExportedEvent> rows;
  EventOnsets onsets;
  for (auto& event : study_.events().read()) {
    if (!event.visit) continue;
    const auto session = sessions_.find(event.visit->session);
    if (session == sessions_.end()) continue;
    const auto visit = *event.visit;
    const double onset = onsets.of(event);
    rows.push_back({ownerOf(session->second), visit, std::move(event), onset});
  }
  return rows;
}

}  // namespace study
