// The BIDS layout (bids-specification.readthedocs.io, 1.8.0, behavioural experiments):
// tab-separated tables in sub-<label>/ses-<label>/beh/, each with a data dictionary, and "n/a" for
// missing values. Labels consist of letters and digits.
#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "study/export/codebook.h"
#include "study/export/export_parts.h"
#include "study/export/study_tables.h"
#include "study/model/new_file.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A cell of a tab-separated table; tabs and line breaks in it are replaced by spaces.
std::string tsvCell(const Cell& cell, bool isFreeText) {
  const auto* words = std::get_if<std::string>(&cell);
  std::string text = words == nullptr ? csvCell(cell)
                     : isFreeText     ? withFormulaEscaped(*words)
                                      : *words;
  std::ranges::replace_if(
      text, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return text.empty() ? "n/a" : text;
}

std::string asTsv(const ExportedTable& table) {
  return asLines(table, '\t', tsvCell);
}

Json sidecarOf(const ExportedTable& table) {
  Json json;
  for (const auto& column : table.columns) {
    auto& entry = json[column.name] = {{"Description", column.description}};
    for (const auto& level : column.levels) entry["Levels"][level.value] = level.label;
    if (!column.unit.empty()) entry["Units"] = column.unit;
  }
  return json;
}

void writeWithSidecar(const fs::path& stem, const ExportedTable& table, const Json& sidecar) {
  writeNewFile(stem.string() + ".tsv", asTsv(table));
  writeNewFile(stem.string() + ".json", sidecar.dump(2) + "\n");
}

void writeWithSidecar(const fs::path& stem, const ExportedTable& table) {
  writeWithSidecar(stem, table, sidecarOf(table));
}

/// Adds a table to @p contents, unless the table of that name from another session was added.
void addTableOnce(FolderContents& contents, const std::string& file, const ExportedTable& table) {
  const bool isListed =
      std::ranges::any_of(contents.tables, [&](const auto& known) { return known.file == file; });
  if (!isListed) contents.tables.push_back(writtenTable(file, table));
}

/// Writes the data of one session: a folder of files with participant and session in their names.
class BidsSession {
 public:
  BidsSession(
      const fs::path& folder,
      const RowOwner& owner,
      const std::string& task,
      const Readers& readers,
      FolderContents& contents)
      : session_(owner.session),
        readers_(readers),
        contents_(contents),
        folder_(folder / bidsSubject(owner) / bidsSession(owner) / "beh"),
        stem_(bidsSubject(owner) + "_" + bidsSession(owner) + "_task-" + task),
        task_(task) {
    fs::create_directories(folder_);
  }

  /// Writes those of @p rows that belong to this session; writes no file if there are none.
  template <typename Row>
  void write(const Table<Row>& table, const std::vector<Row>& rows) const {
    if (!table.isFor(readers_)) return;
    const auto part = partOf(table, rows);
    auto sidecar = sidecarOf(part);
    sidecar["TaskName"] = task_;
    writeUnlessEmpty("_acq-" + table.name + "_beh", part, sidecar);
  }

  void writeEvents(const std::vector<ExportedEvent>& rows) const {
    const auto table = bidsEventTable();
    if (!table.isFor(readers_)) return;
    const auto part = partOf(table, rows);
    writeUnlessEmpty("_events", part, sidecarOf(part));
  }

 private:
  void writeUnlessEmpty(
      const std::string& ending, const ExportedTable& part, const Json& sidecar) const {
    if (part.rows.empty()) return;
    writeWithSidecar(folder_ / (stem_ + ending), part, sidecar);
    addTableOnce(contents_, "sub-…/ses-…/beh/…" + ending + ".tsv", part);
  }

  template <typename Row>
  ExportedTable partOf(const Table<Row>& table, const std::vector<Row>& rows) const {
    std::vector<Row> theirs;
    for (const auto& row : rows) {
      if (row.owner.session == session_) theirs.push_back(row);
    }
    return exportedTable(table, theirs, readers_);
  }

  SessionId session_;
  const Readers& readers_;
  FolderContents& contents_;
  fs::path folder_;
  std::string stem_;
  std::string task_;
};

/// One row for each person, with the values of the person's first session.
ExportedTable participantsOf(const std::vector<ExportedSession>& sessions, const Readers& readers) {
  std::vector<ExportedSession> first;
  std::set<std::string> seen;
  for (const auto& session : sessions) {
    if (seen.insert(bidsSubject(session.owner)).second) first.push_back(session);
  }
  return exportedTable(bidsParticipantTable(), first, readers);
}

ExportedTable sessionsOf(
    std::string_view participant,
    const std::vector<ExportedSession>& sessions,
    const Readers& readers) {
  std::vector<ExportedSession> theirs;
  for (const auto& session : sessions) {
    if (session.owner.participant == participant) theirs.push_back(session);
  }
  return exportedTable(bidsSessionTable(), theirs, readers);
}

Json bidsDescription(Study& study, const ExportOptions& options) {
  Json json{
      {"Name", study.protocol().protocol.study.title},
      {"BIDSVersion", "1.8.0"},
      {"DatasetType", "raw"},
      {"GeneratedBy", {{{"Name", "palpate"}, {"Version", appVersion()}}}},
      {"palpate", Json::parse(exportMetadataAsJson(study, options))}};
  const auto& authors = study.protocol().protocol.study.authors;
  if (!authors.empty()) json["Authors"] = authors;
  return json;
}

}  // namespace

std::string bidsLabel(const std::string& text) {
  std::string label;
  for (const char c : text) {
    const bool isDigit = c >= '0' && c <= '9';
    const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (isDigit || isLetter) label += c;
  }
  return label.empty() ? "study" : label;
}

std::string bidsSubject(const RowOwner& owner) {
  return "sub-" + bidsLabel(std::string(owner.participant));
}

std::string bidsSession(const RowOwner& owner) {
  return "ses-" + std::to_string(owner.sessionNumber);
}

std::size_t writeBids(Study& study, const fs::path& folder, const ExportOptions& options) {
  const StudyRows rows(study, options);
  auto readers = readersOf(study, options);
  readers.needParticipantColumn = false;
  const auto sessions = rows.sessions();
  const auto answers = rows.answers();
  const auto texts = rows.texts();
  const auto trials = rows.trials();
  const auto cuts = rows.cuts();
  const auto events = rows.events();
  const auto task = bidsLabel(study.protocol().protocol.study.id);
  FolderContents contents{.sessions = sessions.size(), .tables = {}};
  const auto people = participantsOf(sessions, readers);
  writeWithSidecar(folder / "participants", people);
  addTableOnce(contents, "participants.tsv", people);
  for (const auto& session : sessions) {
    const BidsSession files(folder, session.owner, task, readers, contents);
    files.write(responseTable(), answers);
    files.write(textTable(), texts);
    files.write(trialTable(), trials);
    files.write(cutTable(), cuts);
    files.writeEvents(events);
    if (session.owner.sessionNumber != 1) continue;
    const auto subject = bidsSubject(session.owner);
    const auto own = sessionsOf(session.owner.participant, sessions, readers);
    writeWithSidecar(folder / subject / (subject + "_sessions"), own);
    addTableOnce(contents, "sub-…/sub-…_sessions.tsv", own);
  }
  const auto source = folder / "sourcedata";
  fs::create_directories(source);
  const auto items = itemsTable(study, readers);
  writeWithSidecar(source / "items", items);
  addTableOnce(contents, "sourcedata/items.tsv", items);
  if (options.hasTraces) writeTraces(study, source / "traces", options);
  writeNewFile(
      (folder / "dataset_description.json").string(),
      bidsDescription(study, options).dump(2) + "\n");
  writeNewFile((folder / "README.md").string(), readmeOf(study, options, contents));
  return contents.sessions;
}

}  // namespace study
