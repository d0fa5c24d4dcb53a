// The layout that BIDS asks for (bids-specification.readthedocs.io, 1.8.0, behavioural
// experiments): tables with tabs below sub-<label>/ses-<label>/beh/, dictionaries beside them, n/a
// for what is missing. Labels: letters and digits.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "study/export/codebook.h"
#include "study/export/export_parts.h"
#include "study/model/new_file.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using ByName = std::map<std::string, std::vector<Level>>;

/// "P001" and 1: whose rows these are.
using BidsSitting = std::pair<std::string, std::int64_t>;

std::string textOf(const Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text == nullptr ? std::string() : *text;
}

/// A cell of a table with tabs, which cannot hold any: they become spaces, as do new lines.
std::string tsvCell(const Cell& cell) {
  std::string text;
  if (const auto* flag = std::get_if<bool>(&cell)) text = *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) text = std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&cell)) text = exactly(*number);
  if (const auto* words = std::get_if<std::string>(&cell)) text = *words;
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return text.empty() ? "n/a" : text;
}

std::string asTsv(const DataTable& table) {
  std::string text;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    text += (i == 0 ? "" : "\t") + table.columns[i].name;
  }
  text += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) text += (i == 0 ? "" : "\t") + tsvCell(row[i]);
    text += '\n';
  }
  return text;
}

Json sidecarOf(const DataTable& table, const ByName& levels) {
  Json json;
  for (const auto& column : table.columns) {
    auto& entry = json[column.name] = {{"Description", column.description}};
    for (const auto& level : levelsOf(column, levels)) entry["Levels"][level.value] = level.label;
    if (column.name.ends_with("_s") || column.name == "onset" || column.name == "duration") {
      entry["Units"] = "s";
    }
    if (column.name.ends_with("_n")) entry["Units"] = "N";
  }
  return json;
}

void writeWithSidecar(const fs::path& stem, const DataTable& table, Json sidecar) {
  writeNewFile(stem.string() + ".tsv", asTsv(table));
  writeNewFile(stem.string() + ".json", sidecar.dump(2) + "\n");
}

std::size_t columnPlace(const DataTable& table, const std::string& column) {
  const auto found = std::find_if(
      table.columns.begin(), table.columns.end(), [&](const auto& c) { return c.name == column; });
  return static_cast<std::size_t>(found - table.columns.begin());
}

/// The rows of one sitting, without the columns that say whose they are.
DataTable partOf(const DataTable& table, const BidsSitting& sitting) {
  DataTable part{table.name, table.description, {}, {}};
  const auto who = columnPlace(table, "participant_id");
  const auto which = columnPlace(table, "session_num");
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (i != who && i != which) part.columns.push_back(table.columns[i]);
  }
  for (const auto& row : table.rows) {
    if (BidsSitting{textOf(row[who]), std::get<std::int64_t>(row[which])} != sitting) continue;
    auto& cells = part.rows.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i != who && i != which) cells.push_back(row[i]);
    }
  }
  return part;
}

/// BIDS wants onset and duration first; how long an event lasted nobody has measured.
DataTable asBidsEvents(const DataTable& events) {
  DataTable table{events.name, events.description, {}, {}};
  const auto onset = columnPlace(events, "onset_s");
  table.columns = {
      {"onset", events.columns[onset].description},
      {"duration", "Not measured: an event has a beginning only"}};
  for (const auto& row : events.rows) table.rows.push_back({row[onset], Cell()});
  for (std::size_t i = 0; i < events.columns.size(); ++i) {
    if (i == onset) continue;
    table.columns.push_back(events.columns[i]);
    for (std::size_t r = 0; r < events.rows.size(); ++r) table.rows[r].push_back(events.rows[r][i]);
  }
  return table;
}

/// One row per person; of somebody who came more than once, as they were the first time.
DataTable participantsOf(const DataTable& sessions) {
  DataTable table{
      "participants",
      "One row per person.",
      {{"participant_id", "Pseudonym, as the name of a folder"},
       {"cohort", "Group of participants"},
       {"run_mode", "live, pilot or simulated"}},
      {}};
  std::vector<std::string> seen;
  for (const auto& row : sessions.rows) {
    const auto label = "sub-" + bidsLabel(textOf(row[columnPlace(sessions, "participant_id")]));
    if (std::find(seen.begin(), seen.end(), label) != seen.end()) continue;
    seen.push_back(label);
    table.rows.push_back(
        {label, row[columnPlace(sessions, "cohort")], row[columnPlace(sessions, "run_mode")]});
  }
  return table;
}

/// The sessions of one person, as BIDS names them.
DataTable sessionsOf(const DataTable& sessions, const std::string& participant) {
  DataTable table{
      "sessions", sessions.description, {{"session_id", "As the name of a folder"}}, {}};
  const auto who = columnPlace(sessions, "participant_id");
  const auto which = columnPlace(sessions, "session_num");
  table.columns.insert(table.columns.end(), sessions.columns.begin() + 2, sessions.columns.end());
  for (const auto& row : sessions.rows) {
    if (textOf(row[who]) != participant) continue;
    const auto number = std::get<std::int64_t>(row[which]);
    auto& cells = table.rows.emplace_back(std::vector<Cell>{"ses-" + std::to_string(number)});
    cells.insert(cells.end(), row.begin() + 2, row.end());
  }
  return table;
}

/// What one person did in one sitting.
void writeSitting(
    const fs::path& folder,
    const BidsSitting& sitting,
    const std::string& task,
    const std::vector<DataTable>& tables,
    const ByName& levels) {
  const auto subject = "sub-" + bidsLabel(sitting.first);
  const auto session = "ses-" + std::to_string(sitting.second);
  const auto beh = folder / subject / session / "beh";
  fs::create_directories(beh);
  const auto stem = subject + "_" + session + "_task-" + task;
  for (const auto& table : tables) {
    if (table.name == "sessions") continue;
    const bool isEvents = table.name == "events";
    const auto part = partOf(isEvents ? asBidsEvents(table) : table, sitting);
    if (part.rows.empty()) continue;
    auto sidecar = sidecarOf(part, levels);
    if (!isEvents) sidecar["TaskName"] = task;
    const auto name = isEvents ? stem + "_events" : stem + "_acq-" + table.name + "_beh";
    writeWithSidecar(beh / name, part, std::move(sidecar));
  }
}

Json bidsDescription(Study& study, const ExportOptions& options) {
  Json json{
      {"Name", study.protocol().protocol.study.title},
      {"BIDSVersion", "1.8.0"},
      {"DatasetType", "raw"},
      {"GeneratedBy", {{{"Name", "palpate"}, {"Version", appVersion()}}}},
      {"palpate", Json::parse(headAsJson(study, options))}};
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

std::size_t writeBids(Study& study, const fs::path& folder, const ExportOptions& options) {
  const auto tables = exportTables(study, options);
  const auto& sessions = tables.front();
  const auto levels = levelsOf(study, options);
  const auto task = bidsLabel(study.protocol().protocol.study.id);
  for (const auto& row : sessions.rows) {
    const BidsSitting sitting{textOf(row[0]), std::get<std::int64_t>(row[1])};
    writeSitting(folder, sitting, task, tables, levels);
    if (sitting.second != 1) continue;
    const auto subject = "sub-" + bidsLabel(sitting.first);
    const auto theirs = sessionsOf(sessions, sitting.first);
    writeWithSidecar(folder / subject / (subject + "_sessions"), theirs, sidecarOf(theirs, levels));
  }
  const auto people = participantsOf(sessions);
  writeWithSidecar(folder / "participants", people, sidecarOf(people, levels));
  const auto source = folder / "sourcedata";
  fs::create_directories(source);
  const auto items = itemsTable(study);
  writeWithSidecar(source / "items", items, sidecarOf(items, levels));
  if (options.hasTraces) writeTraces(study, source / "traces", options);
  writeNewFile(
      (folder / "dataset_description.json").string(),
      bidsDescription(study, options).dump(2) + "\n");
  writeNewFile(
      (folder / "README.md").string(),
      readmeOf(study, options, tables, "sub-…/ses-…/beh/…_acq-responses_beh.tsv"));
  return sessions.rows.size();
}

}  // namespace study
