#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/export/export.h"
#include "study/storage/records.h"

namespace study {

/// Whose a row is. In a public folder the participant has an id drawn for it, and a cohort that may
/// be empty.
struct RowOwner {
  SessionId session{};
  std::string_view participant;
  int sessionNumber = 1;
  std::string_view cohort;
  RunMode runMode = RunMode::Live;
};

/// A row of sessions.csv. Rows point into what StudyRows holds.
struct ExportedSession {
  RowOwner owner;
  const storage::SessionRecord* record = nullptr;
};

/// What rows of answers and trials say of their step.
struct ExportedStep {
  RowOwner owner;
  VisitKey visit;
  std::string_view block;
  std::optional<int> position;     ///< nothing where it was offered again, or nothing was felt
  std::optional<int> alternative;  ///< nothing where nothing was felt
  std::string_view conditionCode;
  std::string_view condition;
};

struct ExportedAnswer : ExportedStep {
  const storage::AnswerRecord* record = nullptr;
  const questionnaires::Item* item = nullptr;  ///< nothing: the protocol does not have it
  Cell response = {};
  std::string_view labelLanguage = {};
  std::string_view excluded = {};  ///< why the statistics do not count it; empty: they do
};

struct ExportedTrial : ExportedStep {
  const storage::TrialRow* record = nullptr;
};

struct ExportedCut {
  RowOwner owner;
  VisitKey visit;
  const storage::CutRecord* record = nullptr;
};

struct ExportedEvent {
  RowOwner owner;
  VisitKey visit;
  storage::Event event;
  double onset = 0.0;  ///< since the session's first event [s]
};

/// Reads a study once: what @p options choose, in the order in which it was done. The study
/// outlives it, and it outlives its rows.
class StudyRows {
 public:
  StudyRows(Study& study, const ExportOptions& options);

  std::vector<ExportedSession> sessions() const;
  std::vector<ExportedAnswer> answers() const;
  std::vector<ExportedTrial> trials() const;
  std::vector<ExportedCut> cuts() const;
  /// Blinded, without those that tell what an alternative is.
  std::vector<ExportedEvent> events() const;

 private:
  ExportedStep stepOf(const storage::SessionRecord& session, const storage::StepRecord& step) const;

  Study& study_;
  bool isBlinded_;
  std::map<std::string, std::string> codes_;
  std::map<SessionId, storage::SessionRecord> sessions_;
  std::vector<storage::AnswerRecord> answers_;
  std::vector<storage::TrialRow> trials_;
  std::vector<storage::CutRecord> cuts_;
};

}  // namespace study
