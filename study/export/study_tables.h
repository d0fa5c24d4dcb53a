#pragma once

#include "study/export/column.h"
#include "study/export/export_rows.h"
#include "study/storage/trace_store.h"

// The columns of every file that holds what happened, a table for each file.
namespace study {

Table<ExportedSession> sessionTable();
Table<ExportedAnswer> responseTable();
Table<ExportedTrial> trialTable();
Table<ExportedCut> cutTable();
Table<ExportedEvent> eventTable();

/// A tick of a trial, and its time by the rate that was asked for [s].
struct ExportedTick {
  storage::TraceSample sample;
  double time = 0.0;
};
Table<ExportedTick> traceTable();

/// Where BIDS asks for other columns or another order.
Table<ExportedSession> bidsParticipantTable();
Table<ExportedSession> bidsSessionTable();
Table<ExportedEvent> bidsEventTable();

/// What folders of BIDS are called: "sub-P001", "ses-1".
std::string bidsSubject(const RowOwner& owner);
std::string bidsSession(const RowOwner& owner);

/// What may stand in item_type, in every table.
inline constexpr const char* kItemTypeInWords =
    "likert, semantic_differential, slider, single_choice, multiple_choice, number, short_text, "
    "long_text or pairwise_choice";

inline constexpr const char* kCohortInWords = "Group of participants";

/// What may stand in run_mode, in every table.
inline constexpr const char* kRunModeInWords = "live, pilot or simulated";

/// What people may be told apart by in a public folder, besides what forms ask.
inline constexpr const char* kCohortColumn = "cohort";
inline constexpr const char* kOrderColumn = "condition_order";

}  // namespace study
