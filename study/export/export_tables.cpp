#include "base/search.h"
#include "protocols/validation/validation.h"
#include "study/export/codebook.h"
#include "study/export/export.h"
#include "study/export/export_parts.h"
#include "study/export/public_tables.h"
#include "study/export/statistics_table.h"
#include "study/export/study_tables.h"
#include "study/export/value_lists.h"

namespace study {

std::vector<base::Message> disclosuresOf(Study& study) {
  std::vector<base::Message> found;
  for (const auto id : study.protocols().all()) {
    for (const auto& disclosure : protocols::disclosuresOf(study.protocol(id).protocol)) {
      const bool isKnown = base::contains(found, disclosure.what);
      if (!isKnown) found.push_back(disclosure.what);
    }
  }
  return found;
}

std::string blindingInWords(Study& study, const ExportOptions& options) {
  if (!options.isBlinded) return "NOT blinded";
  const auto found = disclosuresOf(study);
  if (found.empty()) return "blinded";
  return "with codes for conditions but NOT blinded (" + base::describe(found) + ")";
}

bool isExported(const ExportOptions& options, const storage::SessionRow& session) {
  return (!options.runMode || session.runMode == *options.runMode) &&
         (options.participant.empty() || session.participant == options.participant);
}

Readers readersOf(Study& study, const ExportOptions& options) {
  return {
      .isBlinded = options.isBlinded,
      .isPublic = options.publicClassSize.has_value(),
      .seeExact = options.isExact,
      .seeTexts = options.hasTexts,
      .lists = valueListsOf(study, options),
      .device = study.protocol().protocol.onlyDeviceKind()};
}

std::vector<ExportedTable> exportTables(Study& study, const ExportOptions& options) {
  const StudyRows rows(study, options);
  const auto readers = readersOf(study, options);
  std::vector<ExportedTable> all;
  const auto add = [&](const auto& table, const auto& readRows) {
    if (table.isFor(readers)) all.push_back(exportedTable(table, readRows(), readers));
  };
  add(sessionTable(), [&] { return rows.sessions(); });
  add(responseTable(), [&] { return rows.answers(); });
  add(textTable(), [&] { return rows.texts(); });
  add(trialTable(), [&] { return rows.trials(); });
  add(cutTable(), [&] { return rows.cuts(); });
  add(eventTable(), [&] { return rows.events(); });
  return all;
}

std::vector<ExportedTable> tablesFor(Study& study, const ExportOptions& options) {
  const auto readers = readersOf(study, options);
  auto tables =
      options.publicClassSize ? publicTables(study, options) : exportTables(study, options);
  tables.push_back(itemsTable(study, readers));
  if (options.format == ExportFormat::Csv && !options.publicClassSize) {
    const StudyRows rows(study, options);
    tables.push_back(exportedTable(
        wideTable(study.protocol()), wideRows(study.protocol(), rows.answers()), readers));
  }
  // The statistics are of all participants.
  if (!options.isBlinded && !options.publicClassSize && options.participant.empty()) {
    const auto results = resultsFor(study, options);
    tables.push_back(statisticsTable(study, options, results));
    tables.push_back(votesTable(study, options, results));
  }
  return tables;
}

}  // namespace study
