// The columns of events.csv, and of the event file in BIDS.
#include "study/export/study_columns.h"

namespace study {
namespace {

Column<ExportedEvent> onsetColumn(std::string name) {
  return {
      std::move(name),
      holds::Number{"s"},
      "Since the session's first event, by a clock that is never set back",
      &ExportedEvent::onset};
}

Column<ExportedEvent> utcColumn() {
  return Column<ExportedEvent>(
             "utc",
             holds::Utc{},
             "ISO 8601, UTC",
             [](const ExportedEvent& row) { return asUtc(row.event.when.wall); })
      .exact();
}

/// The columns of events: @p first and the columns that follow. The details of answers are left
/// out, because responses.csv has the answers.
Columns<ExportedEvent> columnsAfter(Columns<ExportedEvent> first) {
  auto detail = Column<ExportedEvent>(
                    "detail",
                    holds::FreeText{},
                    "More about it",
                    [](const ExportedEvent& row) { return storage::describe(row.event); })
                    .onRequest();
  const Columns<ExportedEvent> what{
      {"actor",
       holds::Text{},
       "participant, operator or program",
       [](const ExportedEvent& row) { return storage::nameOf(row.event.actor); }},
      {"event",
       holds::Text{},
       "What happened",
       [](const ExportedEvent& row) { return row.event.name(); }},
      std::move(detail)};
  first.insert(first.end(), what.begin(), what.end());
  return first;
}

Table<ExportedEvent> tableOfEvents(Columns<ExportedEvent> columns) {
  return {
      .name = "events",
      .description = "Everything that happened, in order.",
      .columns = std::move(columns),
      // The times of events reveal the duration of each trial; events of safety functions and
      // devices, and notes of the operator, describe the rendering.
      .revealsCondition = true};
}

}  // namespace

Table<ExportedEvent> eventTable() {
  return tableOfEvents(columnsAfter(
      {participantColumn<ExportedEvent>(),
       sessionNumberColumn<ExportedEvent>(),
       siteColumn<ExportedEvent>(),
       stepNumberColumn<ExportedEvent>(),
       attemptColumn<ExportedEvent>(),
       utcColumn(),
       onsetColumn("onset_s")}));
}

Table<ExportedEvent> bidsEventTable() {
  return tableOfEvents(columnsAfter(
      {onsetColumn("onset"),
       {"duration",
        holds::Number{"s"},
        "Not measured: an event has a beginning only",
        [](const ExportedEvent&) { return std::optional<double>(); }},
       stepNumberColumn<ExportedEvent>(),
       attemptColumn<ExportedEvent>(),
       utcColumn()}));
}

}  // namespace study
