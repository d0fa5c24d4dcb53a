#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/export/export_rows.h"
#include "study/storage/trace_store.h"

// The tables of recorded data, one for each exported file.
namespace study {

Table<ExportedSession> sessionTable();
Table<ExportedAnswer> responseTable();
Table<ExportedAnswer> textTable();
Table<ExportedTrial> trialTable();
Table<ExportedCut> cutTable();
Table<ExportedEvent> eventTable();

/// The answers and scores of a participant about one alternative of a block.
struct ExportedForms : ExportedStep {
  std::map<std::string, Cell> cells;  ///< by the name of their column
};
/// One row per participant and alternative with a column for each question and score, as SPSS and
/// jamovi read repeated measures. Only answers that the statistics include; no free texts.
Table<ExportedForms> wideTable(const protocols::LoadedProtocol& loaded);
std::vector<ExportedForms> wideRows(
    const protocols::LoadedProtocol& loaded, const std::vector<ExportedAnswer>& answers);

/// A sample of a trial, with the time of its tick at the nominal rate [s].
struct ExportedTick {
  storage::TraceSample sample;
  double time = 0.0;
};
Table<ExportedTick> traceTable();
/// The table of a trial without torque: the columns that release 0.1 wrote.
Table<ExportedTick> traceTableWithoutTorque();

/// Tables whose columns or order differ in BIDS.
Table<ExportedSession> bidsParticipantTable();
Table<ExportedSession> bidsSessionTable();
Table<ExportedEvent> bidsEventTable();

/// Names of folders in BIDS: "sub-P001", "ses-1".
std::string bidsSubject(const RowOwner& owner);
std::string bidsSession(const RowOwner& owner);

inline constexpr const char* kCohortInWords = "Group of participants";

inline constexpr const char* kSiteInWords = "Where the session took place";

/// Values of run_mode, in every table.
inline constexpr const char* kRunModeInWords = "live, pilot or simulated";

/// The quasi-identifiers of public folders that are not asked by a form.
inline constexpr const char* kCohortColumn = "cohort";
inline constexpr const char* kSiteColumn = "site";
inline constexpr const char* kOrderColumn = "condition_order";

}  // namespace study
