// The Psych-DS layout. File names are key-value pairs joined by underscores; keys have lower-case
// letters, values letters and digits.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "study/export/export_parts.h"
#include "study/model/new_file.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The name of the column's type in JSON and schema.org.
std::string_view jsonTypeOf(ColumnType type) {
  switch (type) {
    case ColumnType::Integer:
      return "integer";
    case ColumnType::Number:
      return "number";
    case ColumnType::Boolean:
      return "boolean";
    case ColumnType::Text:
    case ColumnType::DateTime:
      break;
  }
  return "string";
}

Json variableOf(const ExportedColumn& column) {
  Json variable{
      {"@type", "PropertyValue"},
      {"name", column.name},
      {"description", column.description},
      {"valueType", jsonTypeOf(column.type)}};
  if (!column.unit.empty()) variable["unitText"] = column.unit;
  for (const auto& level : column.levels) {
    variable["levels"].push_back({{"value", level.value}, {"label", level.label}});
  }
  return variable;
}

/// Every column once, because columns of the same name have the same meaning in all tables.
Json variablesOf(const std::vector<ExportedTable>& tables) {
  Json variables = Json::array();
  std::vector<std::string> seen;
  for (const auto& table : tables) {
    for (const auto& column : table.columns) {
      if (std::ranges::find(seen, column.name) != seen.end()) continue;
      seen.push_back(column.name);
      variables.push_back(variableOf(column));
    }
  }
  return variables;
}

Json descriptionOf(
    Study& study, const ExportOptions& options, const std::vector<ExportedTable>& tables) {
  const auto& metadata = study.protocol().protocol.study;
  Json json{
      {"@context", "https://schema.org/"},
      {"@type", "Dataset"},
      {"name", metadata.title},
      {"description",
       metadata.description.empty() || options.isBlinded ? metadata.title : metadata.description},
      {"variableMeasured", variablesOf(tables)}};
  json["palpate"] = Json::parse(exportMetadataAsJson(study, options));
  return json;
}

/// Whether a file of the protocol may be exported. Texts under third-party copyright (wording/) may
/// not, nor a path that leads out of the folder.
bool mayBeExported(const fs::path& name) {
  return name.is_relative() && name.begin() != name.end() && *name.begin() != "wording" &&
         std::ranges::none_of(name, [](const auto& part) { return part == ".."; });
}

void writeMaterials(Study& study, const fs::path& folder, const ExportOptions& options) {
  if (options.isBlinded || options.publicClassSize) return;
  fs::create_directories(folder);
  const auto stored = study.protocols().current();
  writeNewFile((folder / "study-protocol.json").string(), stored.text);
  for (const auto& file : stored.files) {
    const fs::path name(file.name);
    if (!mayBeExported(name)) continue;
    fs::create_directories((folder / name).parent_path());
    writeNewFile((folder / name).string(), file.text);
  }
}

}  // namespace

std::size_t writePsychDs(Study& study, const fs::path& folder, const ExportOptions& options) {
  const auto tables = tablesFor(study, options);
  FolderContents contents{.sessions = tables.front().rows.size(), .tables = {}};
  std::string prefix = "study-" + bidsLabel(study.protocol().protocol.study.id);
  // At a station, file names contain its site. Exports of several sites have a column for the site.
  const auto& site = study.station().site;
  if (!site.empty() && !options.publicClassSize) prefix += "_site-" + bidsLabel(site);
  const auto data = folder / "data";
  fs::create_directories(data);
  for (const auto& table : tables) {
    const std::string name = prefix + "_description-" + table.name + "_data";
    writeNewFile((data / (name + ".csv")).string(), asCsv(table));
    Json dictionary{{"description", table.description}, {"variableMeasured", variablesOf({table})}};
    writeNewFile((data / (name + ".json")).string(), dictionary.dump(2) + "\n");
    contents.tables.push_back(writtenTable("data/" + name + ".csv", table));
  }
  if (options.hasTraces) writeTraces(study, data / "raw", options);
  writeMaterials(study, folder / "materials", options);
  if (!options.isBlinded && !options.publicClassSize) {
    fs::create_directories(folder / "analysis");
    for (const auto& script : writeScripts(folder / "analysis", options))
      contents.scripts.push_back("analysis/" + script);
  }
  writeNewFile(
      (folder / "dataset_description.json").string(),
      descriptionOf(study, options, tables).dump(2) + "\n");
  writeNewFile((folder / "README.md").string(), readmeOf(study, options, contents));
  writeNewFile(
      (folder / "CHANGES.md").string(),
      "# Changes\n\n- Exported by palpate " + std::string(appVersion()) +
          "; nothing has been changed since.\n");
  return contents.sessions;
}

}  // namespace study
