#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "study/export/codebook.h"
#include "study/export/export_parts.h"
#include "study/export/named_people.h"
#include "study/export/public_tables.h"
#include "study/export/study_tables.h"
#include "study/words/counted.h"

namespace study {
namespace {

using Json = nlohmann::ordered_json;

/// A line on data that scenes render or show: a cut, a material, a knee. Blinded exports omit their
/// name, which may reveal a condition.
std::string describe(const protocols::SceneDataSource& source, const ExportOptions& options) {
  if (!options.isBlinded) return "- Felt from " + protocols::describe(source) + ".\n";
  if (!source.isSynthetic) return "";
  return "- SYNTHETIC: a " + source.kind +
         " that was felt is one that nobody recorded or measured.\n";
}

/// The number of sessions in the folder, and their run mode.
std::string sessionsInWords(const ExportOptions& options, std::size_t sessions) {
  const std::string mode = options.runMode ? std::string(nameOf(*options.runMode)) + " " : "";
  if (!options.participant.empty()) return "Sessions of " + options.participant + " alone.";
  if (sessions == 0) return "No " + mode + "session is in this folder: its tables are empty.";
  std::string words = words::counted(sessions, mode + "session") +
                      (options.runMode ? ", and no others." : "; `run_mode` says of each.");
  if (options.runMode == RunMode::Simulated) {
    words += " Nobody took part: these answers say nothing about any method.";
  }
  if (options.runMode == RunMode::Pilot) words += " They are not for publication.";
  return words;
}

/// Lines on the details that were left out according to @p options.
std::string detailInWords(const ExportOptions& options) {
  std::string text;
  if (!options.isExact) {
    text +=
        "- Coarse: numbers about people (age, years) are bands, and sessions have the day of the "
        "study in place of dates. `--exact` exports them as they are.\n";
  }
  if (!options.hasTexts) {
    text +=
        "- What participants and operators wrote is not in this folder. `--texts` exports it, in a "
        "table of its own.\n";
  }
  return text;
}

/// How an export format writes tables, for the README.
struct FormatFacts {
  ExportFormat format;
  const char* missing;     ///< how missing values are written
  const char* dictionary;  ///< where columns are described
  const char* more;        ///< other properties; empty: none
};
constexpr const char* kEmptyCell = "an empty cell";
constexpr const char* kCodebook = "`codebook.json`";
constexpr const char* kSidecarFile = "the JSON file of the same name beside each table";
constexpr std::array kFormats{
    FormatFacts{ExportFormat::Csv, kEmptyCell, kCodebook, ""},
    FormatFacts{
        ExportFormat::Json,
        "`null`",
        kCodebook,
        "- Each table is an array of `study.json`, each row an object in it.\n"},
    FormatFacts{ExportFormat::PsychDs, kEmptyCell, kSidecarFile, ""},
    FormatFacts{
        ExportFormat::Bids,
        "`n/a`",
        kSidecarFile,
        "- BIDS 1.8.0: cells are separated by tabs; tabs and new lines in free texts have become "
        "spaces. Whose a table below `beh` is, and of which session, says its path (`sub-…`, "
        "`ses-…`): it has no column for that. Questions and traces are in `sourcedata/`.\n"},
    FormatFacts{ExportFormat::R, kEmptyCell, kCodebook, ""},
    FormatFacts{ExportFormat::Python, kEmptyCell, kCodebook, ""}};

const FormatFacts& factsOf(ExportFormat format) {
  return *std::ranges::find_if(kFormats, [&](const auto& facts) { return facts.format == format; });
}

/// A script in an export, for the README.
struct ScriptFacts {
  std::string_view name;
  const char* purpose;
};
constexpr std::array kScripts{
    ScriptFacts{"read_tables.R", "reads the tables with their types and values in order."},
    ScriptFacts{"read_tables.py", "reads the tables with their types and values in order."},
    ScriptFacts{
        "analysis.R",
        "computes the rows of the tables `statistics` and `votes` again from the answers. It needs "
        "R alone. Mixed models too where lmerTest and ordinal are there (`sudo apt install "
        "r-cran-lmertest r-cran-ordinal`); where not, it says so."},
    ScriptFacts{
        "analysis.py",
        "computes the rows of the tables `statistics` and `votes` again from the answers. It needs "
        "Python 3.8 or later with NumPy and SciPy (no pandas): `sudo apt install python3-scipy` on "
        "Debian and Ubuntu, elsewhere `python3 -m pip install scipy`. Where they are missing it "
        "says so."}};

std::string scriptsInWords(const ExportOptions& options, const FolderContents& contents) {
  std::string text;
  for (const auto& path : contents.scripts) {
    const auto script = std::ranges::find_if(
        kScripts, [&](const auto& known) { return path.ends_with(known.name); });
    const auto* program = path.ends_with(".R") ? "Rscript " : "python3 ";
    text += "- `" + path + "` (`" + program + path + "`) " + script->purpose + "\n";
  }
  if (options.publicClassSize || !options.participant.empty()) return text;
  if (options.isBlinded) {
    if (contents.scripts.empty()) return text;
    return text +
           "- To compute the tests again needs to know who was compared with whom, which tells "
           "what codes stand for: unblinded there is a script.\n";
  }
  const bool hasTests = std::ranges::any_of(contents.tables, [](const auto& table) {
    return table.file.find("statistics") != std::string::npos;
  });
  if (!hasTests || contents.scripts.empty()) {
    text += std::string("- Not in this format: ") +
            (hasTests ? "scripts that compute the tests again"
                      : "tests, votes and scripts that compute them again") +
            ". `--format csv`, `psych-ds`, `r` and `python` have them.\n";
  }
  return text;
}

/// The README's section on the tables.
std::string tablesInWords(const std::vector<WrittenTable>& tables) {
  std::string text = "\n## Tables\n\n| table | keys | what |\n|---|---|---|\n";
  for (const auto& table : tables) {
    std::string keys;
    for (const auto& key : table.keys) keys += (keys.empty() ? "`" : ", `") + key + "`";
    text += "| `" + table.file + "` | " + keys + " | " + table.description + " |\n";
  }
  return text + "\nRows of two tables belong together where the keys that both have are equal.\n";
}

/// The README's section on the columns of traces.
std::string tracesInWords() {
  const auto table = traceTable();
  std::string text = "\n## Traces\n\n" + table.description + "\n\n| column | what |\n|---|---|\n";
  for (const auto& column : table.columns) {
    text += "| `" + column.name() + "` | " + column.description() + " |\n";
  }
  return text;
}

/// Whether the folder contains the study's name and the head of its audit trail. A public folder
/// must not lead to its study. A folder of simulated sessions needs no proof of origin, and must
/// not help to identify a folder of real sessions.
bool namesItsStudy(const ExportOptions& options) {
  return options.runMode != RunMode::Simulated && !options.publicClassSize;
}

Json levelsAsJson(const std::vector<Level>& levels) {
  Json json = Json::array();
  for (const auto& level : levels) json.push_back({{"value", level.value}, {"label", level.label}});
  return json;
}

}  // namespace

std::string exportMetadataAsJson(Study& study, const ExportOptions& options) {
  const auto& metadata = study.protocol().protocol.study;
  Json head;
  head["study_id"] = metadata.id;
  head["title"] = metadata.title;
  if (namesItsStudy(options)) head["study_uuid"] = study.uuid();
  head["protocol_version"] = metadata.version;
  head["protocol_hash"] = study.protocols().current().sha256;
  head["app_version"] = appVersion();
  const auto disclosures = disclosuresOf(study);
  head["blinded"] = options.isBlinded && disclosures.empty();
  if (options.isBlinded && !disclosures.empty()) {
    head["not_blinded_because"] = base::describe(disclosures);
  }
  head["coarse"] = !options.isExact;
  head["texts"] = options.hasTexts;
  head["run_mode"] = options.runMode ? nameOf(*options.runMode) : "all";
  if (namesItsStudy(options)) head["audit_trail"] = study.events().headAsText();
  if (!options.codes.empty()) head["codes"] = options.codes;
  if (options.publicClassSize) head["k"] = *options.publicClassSize;
  head["felt_from"] = Json::array();
  for (const auto& source : study.protocol().sources) {
    Json entry{{"kind", source.kind}, {"synthetic", source.isSynthetic}};
    if (!options.isBlinded) {
      entry["file"] = source.file;
      entry["title"] = base::describe(source.title);
      entry["origin"] = protocols::describeOrigin(source);
      entry["conditions"] = source.conditions;
    }
    head["felt_from"].push_back(std::move(entry));
  }
  head["export_format"] = 1;
  return head.dump();
}

std::string readmeLineOnBlinding(Study& study, const ExportOptions& options) {
  if (!options.isBlinded) return "- Not blinded: `condition` says which rendering was felt.\n";
  const auto disclosures = disclosuresOf(study);
  if (!disclosures.empty()) {
    return "- Not blinded, although conditions have codes. With the protocol one can tell which "
           "rendering a code stands for: " +
           base::describe(disclosures) + ".\n";
  }
  return "- Blinded: `condition_code` says which rows belong together, not which rendering they "
         "are." +
         std::string(
             options.publicClassSize ? "\n"
                                     : " 'palpate export --unblind --reason \"…\"' says it.\n");
}

std::string codeSetInWords(const ExportOptions& options) {
  if (options.codes.empty()) return {};
  return "- Codes are drawn for this folder: in other exports they stand for other renderings. "
         "`palpate export --codes-of` this folder, with or without `--unblind`, has the same.\n";
}

std::string formatInWords(const ExportOptions& options) {
  const auto& facts = factsOf(options.format);
  std::string text = std::string("- UTF-8, decimal points, lines end with LF; ") + facts.missing +
                     " is a missing value.\n";
  if (options.format != ExportFormat::Json) {
    text +=
        "- Free text that begins with = + - @ has an apostrophe before it, so that no spreadsheet "
        "takes it for a formula; the JSON export has it as it was written.\n";
  }
  return text + facts.more + "- What a column holds is written in " + facts.dictionary + ".\n";
}

WrittenTable writtenTable(const std::string& file, const ExportedTable& table) {
  constexpr std::array kKeys{"participant_id", "session_id", "session_num", "step_num", "attempt"};
  WrittenTable written{.file = file, .description = table.description, .keys = {}};
  for (const auto& column : table.columns) {
    if (std::ranges::find(kKeys, column.name) != kKeys.end()) written.keys.push_back(column.name);
  }
  return written;
}

std::string readmeOf(Study& study, const ExportOptions& options, const FolderContents& contents) {
  if (options.publicClassSize) {
    return publicReadme(study, options, publicRelease(study, options)) + "\n" +
           scriptsInWords(options, contents) + tablesInWords(contents.tables);
  }
  std::string text = "# " + study.protocol().protocol.study.title + "\n\n" +
                     "Exported by palpate " + std::string(appVersion()) + ".\n\n" + "- " +
                     sessionsInWords(options, contents.sessions) + "\n" + formatInWords(options);
  if (options.participant.empty()) text += identifiabilityInWords(study, options);
  text += detailInWords(options);
  if (namesItsStudy(options)) {
    text += "- The study's audit trail had " + study.events().headAsText() +
            ". `palpate study verify --expect` finds whether it goes on from there.\n";
  }
  text += readmeLineOnBlinding(study, options) + codeSetInWords(options);
  if (options.isBlinded) {
    text +=
        "- Not in this folder: what was measured in trials, when answers were saved, when sessions "
        "ended and why, events, traces. They depend on the rendering.\n";
  }
  for (const auto& source : study.protocol().sources) text += describe(source, options);
  return text + scriptsInWords(options, contents) + tablesInWords(contents.tables) +
         (options.hasTraces ? tracesInWords() : std::string());
}

std::string codebookAsJson(
    Study& study, const ExportOptions& options, const std::vector<ExportedTable>& tables) {
  Json json = Json::parse(exportMetadataAsJson(study, options));
  for (const auto& table : tables) {
    Json columns = Json::array();
    for (const auto& column : table.columns) {
      Json entry{{"name", column.name}, {"type", nameOf(column.type)}};
      if (!column.unit.empty()) entry["unit"] = column.unit;
      entry["description"] = column.description;
      if (!column.levels.empty()) entry["levels"] = levelsAsJson(column.levels);
      columns.push_back(std::move(entry));
    }
    json["tables"][table.name] = {{"description", table.description}, {"columns", columns}};
  }
  return json.dump(2) + "\n";
}

}  // namespace study
