#pragma once

#include "study/export/study_tables.h"

// Columns that several tables have.
namespace study {

template <typename Row>
Column<Row> participantColumn() {
  return Column<Row>(
             "participant_id",
             holds::Text{},
             "Pseudonym of the participant",
             [](const Row& row) { return row.owner.participant; })
      .identifiesParticipant();
}

template <typename Row>
Column<Row> sessionNumberColumn() {
  return Column<Row>(
             "session_num",
             holds::Integer{},
             "Which of the participant's sessions",
             [](const Row& row) { return row.owner.sessionNumber; })
      .identifiesParticipant();
}

template <typename Row>
Column<Row> cohortColumn() {
  return {"cohort", holds::OneOf{ValueList::Cohorts}, kCohortDescription, [](const Row& row) {
            return row.owner.cohort;
          }};
}

/// Exported only for studies with several sites.
template <typename Row>
Column<Row> siteColumn() {
  return {"site", holds::OneOf{ValueList::Sites}, kSiteDescription, [](const Row& row) {
            return row.owner.site;
          }};
}

template <typename Row>
Column<Row> runModeColumn() {
  return {"run_mode", holds::OneOf{ValueList::RunModes}, kRunModeDescription, [](const Row& row) {
            return row.owner.runMode;
          }};
}

template <typename Row>
Column<Row> stepNumberColumn() {
  return {"step_num", holds::Integer{}, "Step of the session, from 1", [](const Row& row) {
            return row.visit.step + 1;
          }};
}

template <typename Row>
Column<Row> attemptColumn() {
  return {
      "attempt",
      holds::Integer{},
      "How often this step has been begun, from 1",
      [](const Row& row) { return row.visit.attempt; }};
}

// Columns on the step in which a condition was rendered or questions were asked.

template <typename Row>
Column<Row> blockColumn() {
  return {"block", holds::OneOf{ValueList::Blocks}, "Phase of the protocol", &Row::block};
}

template <typename Row>
Column<Row> positionColumn() {
  return {
      "position",
      holds::Integer{},
      "Position of the alternative in its block, from 1; empty where it was offered again",
      &Row::position};
}

template <typename Row>
Column<Row> alternativeColumn() {
  return {"alternative", holds::Integer{}, "Label that the participant saw", &Row::alternative};
}

template <typename Row>
Column<Row> conditionCodeColumn() {
  return {
      "condition_code",
      holds::OneOf{ValueList::ConditionCodes},
      "Which rendering it was, as a code that means the same in every row",
      &Row::conditionCode};
}

template <typename Row>
Column<Row> conditionColumn() {
  return Column<Row>(
             "condition",
             holds::OneOf{ValueList::Conditions},
             "Which rendering it was",
             &Row::condition)
      .revealsCondition();
}

template <typename Row>
Column<Row> includedColumn(bool (*isIncluded)(const Row&)) {
  return {
      "included", holds::Boolean{}, "Whether the statistics of its run mode count it", isIncluded};
}

}  // namespace study
