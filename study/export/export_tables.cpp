#include <algorithm>
#include <map>

#include "base/random.h"
#include "questionnaires/model/answer.h"
#include "questionnaires/model/instrument.h"
#include "study/export/codebook.h"
#include "study/export/export.h"
#include "study/storage/answer_repository.h"
#include "study/storage/records.h"

namespace study {
namespace {

using storage::SessionRecord;
using storage::StepRecord;

template <typename T>
Cell exportCell(const std::optional<T>& value) {
  return value ? Cell(*value) : Cell();
}

Cell exportCell(const std::string& text) {
  return text.empty() ? Cell() : Cell(text);
}

/// How long after a session's first event things happened. The clock that is never set back begins
/// anew with the computer, so what lies between two runs of the program is taken from the wall.
class Onsets {
 public:
  double of(const storage::Event& event) {
    auto& last = last_[event.visit->session];
    if (last) {
      const bool isNewRun = event.kind == "resumed";
      const auto passed = isNewRun ? (event.when.wall - last->when.wall) * 1'000'000
                                   : event.when.monotonic - last->when.monotonic;
      last->onset += std::max<std::int64_t>(passed, 0);
      last->when = event.when;
    } else {
      last = {.when = event.when};
    }
    return static_cast<double>(last->onset) / 1e9;
  }

 private:
  struct Last {
    Moment when;
    std::int64_t onset = 0;  ///< [ns]
  };
  std::map<SessionId, std::optional<Last>> last_;
};

/// Reads a study once and lays it out.
class Tables {
 public:
  Tables(Study& study, const ExportOptions& options)
      : study_(study),
        options_(options),
        records_(study.database()),
        codes_(conditionCodes(study)) {
    for (auto& session : records_.sessions()) {
      const bool isWanted = !options.runMode || session.runMode == nameOf(*options.runMode);
      if (isWanted) sessions_.emplace(session.id, session);
    }
  }

  DataTable sessions() const {
    DataTable table{
        .name = "sessions",
        .description = "One row per session: who took part, when, and how it ended.",
        .columns = {
            {"participant_id", "Pseudonym of the participant"},
            {"session_num", "Which of the participant's sessions"},
            {"cohort", "Group of participants"},
            {"run_mode", "live, pilot or simulated"},
            {"status", "in_progress, completed, declined, withdrawn, rejected or aborted_hardware"},
            {"end_reason", "Why it ended", true},
            {"included", "Whether the statistics of its run mode count it"},
            {"session_language", "Of the texts when the session ended"},
            {"place", "Place in the design of the cohort, from 1"},
            {"started_utc", "ISO 8601, UTC"},
            {"ended_utc", "ISO 8601, UTC"},
            {"protocol_hash", "SHA-256 of the protocol with its files"},
            {"app_version", "Version of palpate that ran the session"}}};
    for (const auto& [id, s] : sessions_) {
      table.rows.push_back(
          {s.participant,
           std::int64_t{s.number},
           s.cohort,
           s.runMode,
           s.status,
           exportCell(s.endReason),
           s.status == "completed",
           s.language,
           s.slot + 1,
           s.startedUtc,
           exportCell(s.endedUtc),
           s.protocolHash,
           s.appVersion});
    }
    return table;
  }

  DataTable responses() const {
    DataTable table{
        .name = "responses",
        .description =
            "One row per answer. An item that was not answered has no row: it is missing.",
        .columns = columnsWith(
            {{"instrument", "Questionnaire"},
             {"item_id", "Question"},
             {"item_order", "Where it stood on its page, from 1"},
             {"item_type", std::string(kItemTypeInWords)},
             {"key", "1: a high answer is good; -1: a low one is"},
             {"response", "As given: a point, a number, the id of an option, a text", true},
             {"response_keyed", "Points only: reversed where the key is -1"},
             {"response_label",
              "What the response is called in the language it was given in",
              true},
             {"first_touch_s", "From the page's appearance to the first touch of the item"},
             {"response_time_s", "… to the last change of the answer"},
             {"n_changes", "How often it was changed after the first touch"},
             {"language", "Of the question as it is worded here"},
             {"included", "Whether the statistics of its run mode count it"},
             {"exclude_reason", "Why they do not"},
             {"saved_utc", "When it was on the disk, ISO 8601, UTC"}})};
    for (const auto& answer : records_.answers()) {
      const auto session = sessions_.find(answer.step.visit.session);
      if (session != sessions_.end()) table.rows.push_back(rowOf(answer, session->second));
    }
    return table;
  }

  DataTable trials() const {
    DataTable table{
        .name = "trials",
        .description = "One row per trial: how well what was felt was rendered.",
        .columns = columnsWith(
            {{"device", "Which device"},
             {"ending",
              "How it ended: finished, stopped, aborted_hardware, trace_lost, timed_out, "
              "program_ended"},
             {"qc_status", "PASS, WARN or FAIL"},
             {"qc_reason", "Why"},
             {"duration_s", "Of the engine's own time"},
             {"cuts", "Cuts (strokes) that were made"},
             {"contact_s", "How long something was felt"},
             {"saturation_s", "How long the scene asked for more than the limit"},
             {"slewed_s", "How long it asked for a faster change than the limit"},
             {"undefined_s", "How long it had no answer"},
             {"ticks", "Steps of the force loop"},
             {"nominal_rate_hz", "Rate of the force loop as asked for"},
             {"loop_rate_hz", "… as reached; empty where no clock was running"},
             {"lateness_p50_us", "Median lateness of a tick"},
             {"lateness_p99_us", "99 % of ticks were not later"},
             {"lateness_max_us", "The latest"},
             {"deadline_misses", "Ticks later than a whole period"},
             {"lost_samples", "Samples that the recorder could not take"},
             {"invalid_ticks", "Ticks without a measurement"},
             {"trace_samples", "Samples kept in traces.db"}})};
    for (const auto& trial : records_.trials()) {
      const auto session = sessions_.find(trial.step.visit.session);
      if (session == sessions_.end()) continue;
      auto row = keysOf(session->second, trial.step);
      const std::vector<Cell> more{
          trial.device,
          trial.ending,
          trial.verdict,
          exportCell(base::describe(trial.reasons)),
          trial.duration,
          trial.cuts,
          trial.contact,
          trial.saturated,
          trial.slewed,
          trial.undefined,
          trial.ticks,
          trial.nominalRate,
          exportCell(trial.achievedRate),
          exportCell(trial.latenessMedian),
          exportCell(trial.latenessP99),
          exportCell(trial.latenessLargest),
          exportCell(trial.lateTicks),
          trial.lostSamples,
          trial.invalidTicks,
          trial.traceSamples};
      row.insert(row.end(), more.begin(), more.end());
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  DataTable events() const {
    DataTable table{
        .name = "events",
        .description = "Everything that happened, in order.",
        .columns = {
            {"participant_id", "Pseudonym of the participant"},
            {"session_num", "Which of the participant's sessions"},
            {"step_num", "Step of the session, from 1"},
            {"attempt", "How often this step has been begun, from 1"},
            {"utc", "ISO 8601, UTC"},
            {"onset_s", "Since the session's first event, by a clock that is never set back"},
            {"actor", "participant, operator or program"},
            {"event", "What happened"},
            {"detail", "More about it", true}}};
    Onsets onsets;
    for (const auto& event : study_.events().read()) {
      if (!event.visit) continue;
      const auto session = sessions_.find(event.visit->session);
      if (session == sessions_.end()) continue;
      // How stiff a scene is says which one it is.
      if (options_.isBlinded && (event.kind == "passivity" || event.kind == "view")) continue;
      // Answers stand in responses.csv; here it matters that and when one was given.
      table.rows.push_back(
          {session->second.participant,
           std::int64_t{session->second.number},
           std::int64_t{event.visit->step} + 1,
           std::int64_t{event.visit->attempt},
           asUtc(event.when.wall),
           onsets.of(event),
           std::string(storage::nameOf(event.actor)),
           event.kind,
           exportCell(storage::describe(event))});
    }
    return table;
  }

  DataTable cuts() const {
    DataTable table{
        .name = "cuts",
        .description =
            "One row per cut (stroke), with its landmarks; what was not found is missing.",
        .columns = {
            {"participant_id", "Pseudonym of the participant"},
            {"session_num", "Which of the participant's sessions"},
            {"step_num", "Step of the session, from 1"},
            {"attempt", "How often this step has been begun, from 1"},
            {"cut_num", "From 1"},
            {"interception_travel", "Where the load began to rise [travel unit of the device]"},
            {"interception_n", "… and the force there"},
            {"yield_travel", "Where the surface was cut through"},
            {"yield_n", "… and the force there"},
            {"bottom_out_travel", "Where the end of travel was reached"},
            {"bottom_out_n", "… and the force there"},
            {"opening_travel", "Where the force was largest before contact was lost"},
            {"opening_n", "… and the force there"},
            {"peak_n", "Largest force of the cut"}}};
    for (const auto& cut : records_.cuts()) {
      const auto session = sessions_.find(cut.visit.session);
      if (session == sessions_.end()) continue;
      table.rows.push_back(
          {session->second.participant,
           std::int64_t{session->second.number},
           std::int64_t{cut.visit.step} + 1,
           std::int64_t{cut.visit.attempt},
           std::int64_t{cut.number},
           exportCell(cut.interceptionTravel),
           exportCell(cut.interceptionForce),
           exportCell(cut.yieldTravel),
           exportCell(cut.yieldForce),
           exportCell(cut.bottomOutTravel),
           exportCell(cut.bottomOutForce),
           exportCell(cut.openingTravel),
           exportCell(cut.openingForce),
           cut.peakForce});
    }
    return table;
  }

 private:
  std::vector<Column> columnsWith(std::vector<Column> more) const {
    std::vector<Column> columns{
        {"participant_id", "Pseudonym of the participant"},
        {"session_num", "Which of the participant's sessions"},
        {"cohort", "Group of participants"},
        {"run_mode", "live, pilot or simulated"},
        {"step_num", "Step of the session, from 1"},
        {"attempt", "How often this step has been begun, from 1"},
        {"block", "Phase of the protocol"},
        {"position",
         "Position of the alternative in its block, from 1; empty where it was offered again"},
        {"alternative", "Label that the participant saw"},
        {"condition_code", "Which rendering it was, as a code that means the same in every row"}};
    if (!options_.isBlinded) columns.push_back({"condition", "Which rendering it was"});
    columns.insert(columns.end(), more.begin(), more.end());
    return columns;
  }

  std::string codeOf(const std::string& condition) const {
    const auto code = codes_.find(condition);
    return code == codes_.end() ? std::string() : code->second;
  }

  std::vector<Cell> keysOf(const SessionRecord& session, const StepRecord& step) const {
    const bool isFelt = !step.condition.empty();
    std::vector<Cell> row{
        session.participant,
        std::int64_t{session.number},
        session.cohort,
        session.runMode,
        std::int64_t{step.visit.step} + 1,
        std::int64_t{step.visit.attempt},
        step.phase,
        isFelt && step.position > 0 ? Cell(std::int64_t{step.position}) : Cell(),
        isFelt ? Cell(std::int64_t{step.label}) : Cell(),
        isFelt ? exportCell(codeOf(step.condition)) : Cell()};
    if (!options_.isBlinded) row.push_back(exportCell(step.condition));
    return row;
  }

  std::vector<Cell> rowOf(const storage::AnswerRecord& record, const SessionRecord& session) const {
    auto row = keysOf(session, record.step);
    const auto& answer = record.answer;
    const auto& loaded = study_.protocol(session.protocol);
    const auto* instrument = loaded.instrument(record.step.instrument);
    const auto* item = instrument == nullptr ? nullptr : instrument->item(answer.item);
    const auto stored = storage::stored(answer.response);
    Cell keyed;
    if (item != nullptr && stored.point) keyed = questionnaires::keyed(*item, *stored.point);
    const Cell response = stored.point    ? Cell(*stored.point)
                          : stored.number ? Cell(*stored.number)
                                          : Cell(stored.text.value_or(""));
    const std::string excluded = session.status != "completed"           ? session.status
                                 : record.step.visitStatus != "finished" ? record.step.visitStatus
                                                                         : "";
    const std::vector<Cell> more{
        exportCell(record.step.instrument),
        answer.item,
        std::int64_t{answer.itemOrder},
        item == nullptr ? Cell() : Cell(std::string(questionnaires::nameOf(item->type))),
        item == nullptr ? Cell() : Cell(std::int64_t{item->key}),
        response,
        keyed,
        item == nullptr
            ? Cell()
            : exportCell(questionnaires::labelOf(*item, answer.response, answer.language)),
        answer.firstTouch,
        answer.responseTime,
        std::int64_t{answer.changes},
        answer.language,
        excluded.empty(),
        exportCell(excluded),
        record.savedUtc};
    row.insert(row.end(), more.begin(), more.end());
    return row;
  }

  Study& study_;
  ExportOptions options_;
  storage::Records records_;
  std::map<std::string, std::string> codes_;
  std::map<SessionId, SessionRecord> sessions_;
};

/// Lets the one kind of device of a study say in its own words what a table is about.
void sayAs(const haptics::devices::DeviceKind& kind, DataTable& table) {
  const auto say = [&](std::string& words) {
    for (const auto& sentence : kind.sentences) {
      if (sentence.language == "en" && sentence.english == words) words = sentence.text;
    }
  };
  say(table.description);
  for (auto& column : table.columns) say(column.description);
}

}  // namespace

std::map<std::string, std::string> conditionCodes(Study& study) {
  std::map<std::string, std::string> codes;
  std::uint64_t version = 0;
  for (const auto id : study.protocols().all()) {
    std::vector<std::string> added;
    for (const auto& known : study.protocol(id).protocol.conditions) {
      if (codes.count(known.id) == 0) added.push_back(known.id);
    }
    std::sort(added.begin(), added.end());
    base::RandomStream(study.seed(), version++, "blinding").shuffle(added);
    for (const auto& condition : added) {
      codes.emplace(condition, "C" + std::to_string(codes.size() + 1));
    }
  }
  return codes;
}

std::vector<DataTable> exportTables(Study& study, const ExportOptions& options) {
  const Tables tables(study, options);
  std::vector<DataTable> all{tables.sessions(), tables.responses(), tables.trials()};
  // The forces of cuts tell what an alternative is: one whose tissue yields at 7 N has a model.
  if (!options.isBlinded) all.push_back(tables.cuts());
  all.push_back(tables.events());
  if (const auto* kind = study.protocol().protocol.onlyDeviceKind()) {
    for (auto& table : all) sayAs(*kind, table);
  }
  return all;
}

}  // namespace study
