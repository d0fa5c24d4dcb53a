#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/export/export.h"
#include "study/storage/records.h"

namespace study {

/// The owner of a row. In a public folder the participant has a random id, and cohort and site may
/// be empty.
struct RowOwner {
  SessionId session{};
  std::string_view participant;
  int sessionNumber = 1;
  std::string_view cohort;
  std::string_view site = {};
  RunMode runMode = RunMode::Live;
};

/// A row of sessions.csv. Rows point into data of StudyRows.
struct ExportedSession {
  RowOwner owner;
  const storage::SessionRecord* record = nullptr;
  int day = 1;  ///< since the first of these sessions, by UTC
};

/// The step of an answer or a trial.
struct ExportedStep {
  RowOwner owner;
  VisitKey visit;
  std::string_view block;
  std::optional<int> position;     ///< std::nullopt if optional, or without a condition
  std::optional<int> alternative;  ///< std::nullopt if the step has no condition
  std::string_view conditionCode;
  std::string_view condition;
};

struct ExportedAnswer : ExportedStep {
  const storage::AnswerRecord* record = nullptr;
  const questionnaires::Item* item = nullptr;  ///< nullptr: the protocol does not have it
  Cell response = {};
  std::string band = {};  ///< replaces a number about the person; empty: the number is exported
  std::string_view labelLanguage = {};
  std::string_view chosen = {};  ///< the condition, or its code, of the alternative in the response
  std::string_view excluded = {};  ///< why the statistics leave it out; empty: they count it
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

/// Reads the data of a study that @p options select, in order of time. The study must outlive this
/// object, which must outlive its rows.
class StudyRows {
 public:
  StudyRows(Study& study, const ExportOptions& options);

  std::vector<ExportedSession> sessions() const;
  std::vector<ExportedAnswer> answers() const;  ///< without texts
  std::vector<ExportedAnswer> texts() const;    ///< answers that are free text
  std::vector<ExportedTrial> trials() const;
  std::vector<ExportedCut> cuts() const;
  std::vector<ExportedEvent> events() const;

 private:
  std::vector<ExportedAnswer> answers(bool areTexts) const;
  ExportedStep stepOf(const storage::SessionRecord& session, const storage::StepRecord& step) const;
  std::string_view chosenIn(const ExportedAnswer& row) const;

  Study& study_;
  bool isExact_;
  bool isBlinded_;
  std::map<RunMode, std::map<std::string, std::string>> codes_;  ///< by condition
  std::map<SessionId, storage::SessionRecord> sessions_;
  std::vector<storage::AnswerRecord> answers_;
  std::vector<storage::TrialRow> trials_;
  std::vector<storage::CutRecord> cuts_;
  std::map<storage::Records::Alternative, std::string> felt_;  ///< conditions, of exported rows
};

}  // namespace study
