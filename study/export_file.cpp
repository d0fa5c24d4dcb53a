#include <cerrno>
#include <cstdlib>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "study/export.h"
#include "study/new_file.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json asJson(const Cell& cell) {
  if (const auto* flag = std::get_if<bool>(&cell)) return *flag;
  if (const auto* whole = std::get_if<std::int64_t>(&cell)) return *whole;
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return nullptr;
}

Json asJson(const DataTable& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json object;
    for (std::size_t i = 0; i < row.size(); ++i) object[table.columns[i].name] = asJson(row[i]);
    rows.push_back(std::move(object));
  }
  return rows;
}

Json headOf(Study& study, const ExportOptions& options) {
  const auto& metadata = study.protocol().protocol.study;
  Json head;
  head["study_id"] = metadata.id;
  head["title"] = metadata.title;
  head["study_uuid"] = study.uuid();
  head["protocol_version"] = metadata.version;
  head["protocol_hash"] = study.protocols().current().sha256;
  head["app_version"] = appVersion();
  head["blinded"] = options.isBlinded;
  head["export_format"] = 1;
  return head;
}

std::string codebook(
    Study& study, const ExportOptions& options, const std::vector<DataTable>& tables) {
  Json json = headOf(study, options);
  for (const auto& table : tables) {
    Json columns = Json::array();
    for (const auto& column : table.columns) {
      columns.push_back({{"name", column.name}, {"description", column.description}});
    }
    json["tables"][table.name] = {{"description", table.description}, {"columns", columns}};
  }
  return json.dump(2) + "\n";
}

std::string readme(Study& study, const ExportOptions& options) {
  std::string text =
      "# " + study.protocol().protocol.study.title + "\n\n" + "Exported by palpate " +
      std::string(appVersion()) + ".\n\n" +
      "- One row per answer in `responses.csv`; keys in every table: `participant_id`, "
      "`session_num`, `step_num`, `attempt`.\n"
      "- UTF-8, decimal points, lines end with LF; an empty cell is a missing value.\n"
      "- Free text that begins with = + - @ has an apostrophe before it, so that no "
      "spreadsheet takes it for a formula; the JSON export has it as it was written.\n"
      "- What a column holds is written in `codebook.json`.\n"
      "- Nothing in this folder names a person.\n";
  text += options.isBlinded
              ? "- Blinded: `condition_code` says which rows belong together, not which rendering "
                "they are. 'palpate export --unblind --reason \"…\"' says it.\n"
              : "- Not blinded: `condition` says which rendering was felt.\n";
  return text;
}

void writeTables(Study& study, const fs::path& folder, const ExportOptions& options) {
  const auto tables = exportTables(study, options);
  if (options.format == ExportFormat::Json) {
    Json json = headOf(study, options);
    for (const auto& table : tables) json[table.name] = asJson(table);
    writeNewFile((folder / "study.json").string(), json.dump(1) + "\n");
  } else {
    for (const auto& table : tables)
      writeNewFile((folder / (table.name + ".csv")).string(), asCsv(table));
  }
  writeNewFile((folder / "codebook.json").string(), codebook(study, options, tables));
  writeNewFile((folder / "README.md").string(), readme(study, options));
}

/// An empty folder beside @p target that nobody else has.
fs::path folderBeside(const fs::path& target) {
  std::error_code error;
  const auto parent = fs::absolute(target).parent_path();
  fs::create_directories(parent, error);
  std::string name = (parent / (target.filename().string() + ".unfinished-XXXXXX")).string();
  if (error || mkdtemp(name.data()) == nullptr) {
    const auto why = error ? error.message() : std::generic_category().message(errno);
    throw storage::StorageError(
        "Could not make the folder " + target.string() + " (" + why + "). Choose another place.");
  }
  fs::permissions(name, fs::perms(0755), error);
  return name;
}

}  // namespace

void exportStudy(
    Study& study,
    const std::string& folder,
    const ExportOptions& options,
    const std::string& reason) {
  fs::path target = fs::path(folder).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();  // "out/" means "out"
  std::error_code error;
  if (fs::exists(target, error)) {
    throw storage::StorageError(
        folder + " is there already. Nothing is ever overwritten: choose another folder.");
  }
  if (!options.isBlinded && reason.empty()) {
    throw storage::StorageError(
        "To say which rendering was felt needs a reason: it goes into the audit trail.");
  }
  if (!options.isBlinded) study.note("unblinded_export", reason);
  const fs::path unfinished = folderBeside(target);
  try {
    writeTables(study, unfinished, options);
    fs::rename(unfinished, target, error);
    if (error)
      throw storage::StorageError("Could not finish " + folder + " (" + error.message() + ").");
  } catch (...) {
    fs::remove_all(unfinished, error);
    throw;
  }
}

}  // namespace study
