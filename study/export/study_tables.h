#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/export/export_rows.h"
#include "study/storage/trace_store.h"

// The tables of recorded data. Each is exported as one file.
namespace study {

Table<ExportedSession> sessionTable();
Table<ExportedAnswer> responseTable();
Table<ExportedAnswer> textTable();
Table<ExportedTrial> trialTable();
Table<ExportedCut> cutTable();
Table<ExportedEvent> eventTable();

/// The answers and scores of a participant about one alternative of a block.
struct ExportedForms : ExportedStep {
  std::map<std::string, Cell> cells;  ///< of questions and scores, by the names of columns
};
/// One row per participant and alternative, with a column for each question and score: the layout
/// of repeated measures in SPSS and jamovi. Only answers that the statistics include; no free
/// texts.
Table<ExportedForms> wideTable(const protocols::LoadedProtocol& loaded);
std::vector<ExportedForms> wideRows(
    const protocols::LoadedProtocol& loaded, const std::vector<ExportedAnswer>& answers);

/// A sample of a trial, with the time of its tick at the nominal rate [s].
struct ExportedTick {
  storage::TraceSample sample;
  double time = 0.0;
};
Table<ExportedTick> traceTable();
/// The trace table for a trial without torque, with the columns of release 0.1.
Table<ExportedTick> traceTableWithoutTorque();

/// Tables whose columns, or order of columns, differ in BIDS.
Table<ExportedSession> bidsParticipantTable();
Table<ExportedSession> bidsSessionTable();
Table<ExportedEvent> bidsEventTable();

/// Names of folders in the BIDS layout: "sub-P001", "ses-1".
std::string bidsSubject(const RowOwner& owner);
std::string bidsSession(const RowOwner& owner);

inline constexpr const char* kCohortDescription = "Group of participants";

inline constexpr const char* kSiteDescription = "Where the session took place";

/// Description of the values of run_mode.
inline constexpr const char* kRunModeDescription = "live, pilot or simulated";

/// Column names of quasi-identifiers that no form asks for.
inline constexpr const char* kCohortColumn = "cohort";
inline constexpr const char* kSiteColumn = "site";
inline constexpr const char* kOrderColumn = "condition_order";

}  // namespace study
