// The columns of sessions.csv, and of the session files in BIDS.
#include "study/export/study_columns.h"

namespace study {
namespace {

/// The columns on the course of a session; columns on its owner are added elsewhere.
Columns<ExportedSession> columnsOfSession() {
  using namespace holds;
  const auto record = [](auto member) {
    return [member](const ExportedSession& row) { return std::invoke(member, row.record); };
  };
  using Record = storage::SessionRecord;
  using C = Column<ExportedSession>;
  return {
      cohortColumn<ExportedSession>(),
      siteColumn<ExportedSession>(),
      runModeColumn<ExportedSession>(),
      {"status",
       OneOf{ValueList::Statuses},
       "in_progress, completed, declined, withdrawn, rejected, aborted_hardware or erased",
       [](const ExportedSession& row) { return statusOf(row.record->state); }},
      // written by the operator, or the reason of a device
      C("end_reason", FreeText{}, "Why it ended", record(&Record::endReason))
          .revealsCondition()
          .onRequest(),
      includedColumn<ExportedSession>(
          [](const ExportedSession& row) { return row.record->isCompleted(); }),
      {"session_language",
       Text{},
       "Of the texts when the session ended",
       record(&Record::language)},
      // place and seed determine the order of conditions
      C("place",
        Integer{},
        "Place in the design of the cohort, from 1",
        [](const ExportedSession& row) {
          return row.record->slot + 1;
        }).revealsCondition(),
      {"day",
       Integer{},
       "Since the first session of this export, which has 1",
       &ExportedSession::day},
      C("started_utc", Utc{}, "ISO 8601, UTC", record(&Record::startedUtc)).exact(),
      // end minus start contains the duration of all trials
      C("ended_utc", Utc{}, "ISO 8601, UTC", record(&Record::endedUtc)).revealsCondition().exact(),
      {"protocol_hash",
       Text{},
       "SHA-256 of the protocol with its files",
       record(&Record::protocolHash)},
      {"app_version",
       Text{},
       "Version of palpate that ran the session",
       record(&Record::appVersion)}};
}

Table<ExportedSession> tableOfSessions(Columns<ExportedSession> first) {
  for (auto& column : columnsOfSession()) first.push_back(std::move(column));
  return {
      .name = "sessions",
      .description = "One row per session: who took part, when, and how it ended.",
      .columns = std::move(first)};
}

}  // namespace

Table<ExportedSession> sessionTable() {
  return tableOfSessions(
      {participantColumn<ExportedSession>(), sessionNumberColumn<ExportedSession>()});
}

Table<ExportedSession> bidsSessionTable() {
  return tableOfSessions(
      {{"session_id", holds::Text{}, "As the name of a folder", [](const ExportedSession& row) {
          return bidsSession(row.owner);
        }}});
}

Table<ExportedSession> bidsParticipantTable() {
  return {
      .name = "participants",
      .description = "One row per person.",
      .columns = {
          {"participant_id",
           holds::Text{},
           "Pseudonym, as the name of a folder",
           [](const ExportedSession& row) { return bidsSubject(row.owner); }},
          cohortColumn<ExportedSession>(),
          siteColumn<ExportedSession>(),
          runModeColumn<ExportedSession>()}};
}

}  // namespace study
