#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "study/export/export.h"
#include "study/results/protocol_versions.h"
#include "study/storage/records.h"

namespace study {

/// The participant and session of a row. In public folders the participant has a random id, and
/// cohort and site may be empty.
struct RowOwner {
  SessionId session{};
  std::string_view participant;
  int sessionNumber = 1;
  std::string_view cohort;
  std::string_view site = {};
  RunMode runMode = RunMode::Live;
};

/// A row of sessions.csv. It points into data of StudyRows, as all row types below do.
struct ExportedSession {
  RowOwner owner;
  const storage::SessionRecord* record = nullptr;
  int day = 1;  ///< day in UTC, counted from 1 on the day of the first exported session
};

/// The step in which an answer was given or a trial was run.
struct ExportedStep {
  RowOwner owner;
  VisitKey visit;
  std::string_view block;
  std::optional<int> position;     ///< std::nullopt for optional trials, and without a condition
  std::optional<int> alternative;  ///< std::nullopt if the step has no condition
  std::string_view conditionCode;
  std::string_view condition;
};

/// A row of responses.csv or texts.csv.
struct ExportedAnswer : ExportedStep {
  const storage::AnswerRecord* record = nullptr;
  /// The instrument in the version of the session; nullptr if it has none.
  const questionnaires::Instrument* instrument = nullptr;
  const questionnaires::Item* item = nullptr;  ///< nullptr if the protocol no longer has the item
  Cell response = {};
  std::string band = {};  ///< replaces a number about the person; empty if the number itself is
                          ///< exported
  std::string_view labelLanguage = {};
  std::string_view chosen = {};    ///< condition, or its code, of the alternative that is named
  std::string_view excluded = {};  ///< why statistics ignore the answer; empty: they do not
};

/// A row of trials.csv.
struct ExportedTrial : ExportedStep {
  const storage::StoredTrial* record = nullptr;
};

/// A row of cuts.csv.
struct ExportedCut {
  RowOwner owner;
  VisitKey visit;
  const storage::CutRecord* record = nullptr;
};

/// A row of events.csv.
struct ExportedEvent {
  RowOwner owner;
  VisitKey visit;
  storage::Event event;
  double onset = 0.0;  ///< time since the session's first event [s]
};

/// Reads the data of a study that its options select, the oldest first. The study must outlive this
/// object, and this object must outlive the rows that it returns.
class StudyRows {
 public:
  StudyRows(Study& study, const ExportOptions& options);

  std::vector<ExportedSession> sessions() const;
  std::vector<ExportedAnswer> answers() const;  ///< without free texts
  std::vector<ExportedAnswer> texts() const;    ///< free texts only
  std::vector<ExportedTrial> trials() const;
  std::vector<ExportedCut> cuts() const;
  std::vector<ExportedEvent> events() const;

 private:
  std::vector<ExportedAnswer> answers(bool areTexts) const;
  ExportedStep stepOf(const storage::SessionRecord& session, const storage::StepRecord& step) const;
  /// The condition, or its code, of the alternative that a response names.
  std::string_view chosenIn(const ExportedAnswer& row) const;
  /// Whether the answer is a vote of a participant who had not felt every alternative.
  bool isVoteWithoutAll(const ExportedAnswer& row) const;

  Study& study_;
  ProtocolVersions versions_;
  bool isExact_;
  bool isBlinded_;
  std::map<RunMode, std::map<std::string, std::string>> codes_;  ///< codes by condition id, for
                                                                 ///< each run mode
  std::map<SessionId, storage::SessionRecord> sessions_;
  std::vector<storage::AnswerRecord> answers_;
  std::vector<storage::StoredTrial> trials_;
  std::vector<storage::CutRecord> cuts_;
  std::map<std::pair<SessionId, std::string>, int> unfinishedTrials_;
  storage::Records::Allocation conditionOfAlternative_;  ///< condition ids, of exported rows only
};

}  // namespace study
