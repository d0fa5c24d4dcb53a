#include "study/export/codebook.h"

#include <algorithm>
#include <array>

#include "questionnaires/model/answer.h"
#include "questionnaires/model/instrument.h"

namespace study {
namespace {

using questionnaires::Item;
using questionnaires::ItemType;

constexpr auto kIntegers = std::to_array<std::string_view>(
    {"m",
     "n1",
     "n2",
     "n_missing",
     "alternative",
     "attempt",
     "cut_num",
     "cuts",
     "deadline_misses",
     "highest",
     "invalid_ticks",
     "item_num",
     "item_order",
     "key",
     "lost_samples",
     "lowest",
     "n_changes",
     "place",
     "position",
     "response_keyed",
     "session_num",
     "step_num",
     "ticks",
     "trace_samples",
     "votes",
     "votes_total"});
constexpr auto kNumbers = std::to_array<std::string_view>(
    {"acceptable_from",
     "alpha",
     "alpha_per_test",
     "conf_high",
     "conf_high_adj",
     "conf_level",
     "conf_low",
     "conf_low_adj",
     "df",
     "effect",
     "effect_high",
     "effect_low",
     "epsilon",
     "equivalence_bound",
     "estimate",
     "log10_p",
     "mean1",
     "mean2",
     "p",
     "p_adj",
     "p_epsilon",
     "p_permutation",
     "sd1",
     "sd2",
     "se",
     "statistic",
     "bottom_out_n",
     "bottom_out_travel",
     "contact_s",
     "duration_s",
     "first_touch_s",
     "interception_n",
     "interception_travel",
     "lateness_max_us",
     "lateness_p50_us",
     "lateness_p99_us",
     "loop_rate_hz",
     "nominal_rate_hz",
     "onset_s",
     "opening_n",
     "opening_travel",
     "peak_n",
     "response_time_s",
     "saturation_s",
     "slewed_s",
     "undefined_s",
     "yield_n",
     "yield_travel",
     "share",
     "share_low",
     "share_high",
     "share_low_exact",
     "share_high_exact",
     "p_exact",
     "chi2",
     "chi2_df",
     "p_chi2"});
constexpr auto kTimes =
    std::to_array<std::string_view>({"ended_utc", "saved_utc", "started_utc", "utc"});

template <typename Names>
bool holds(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<Level> coded(std::initializer_list<const char*> values) {
  std::vector<Level> levels;
  for (const char* value : values) levels.push_back({value, value});
  return levels;
}

std::vector<Level> typeLevels() {
  std::vector<Level> levels;
  for (const auto& type : questionnaires::kItemTypes) {
    levels.push_back({std::string(type.name), std::string(type.name)});
  }
  return levels;
}

/// "1=strongly disagree; 5=strongly agree": points and options in their order.
std::string scaleOf(const Item& item, const std::string& language) {
  std::string text;
  const auto add = [&](const std::string& value, const std::string& label) {
    text += (text.empty() ? "" : "; ") + value + (label.empty() ? "" : "=" + label);
  };
  const bool isPoint = item.type == ItemType::Likert || item.type == ItemType::SemanticDifferential;
  if (isPoint) {
    for (int point = item.scale.lowest; point <= item.scale.highest(); ++point) {
      add(std::to_string(point), questionnaires::labelOf(item, std::int64_t{point}, language));
    }
  }
  for (const auto& option : item.options) add(option.id, option.text.in(language));
  return text;
}

std::vector<Cell> rowOf(
    const questionnaires::Instrument& instrument,
    std::int64_t order,
    const Item& item,
    const std::string& language) {
  const bool isPoint = item.type == ItemType::Likert || item.type == ItemType::SemanticDifferential;
  const auto cell = [](const std::string& text) { return text.empty() ? Cell() : Cell(text); };
  return {
      instrument.id,
      instrument.version,
      item.id,
      order,
      std::string(questionnaires::nameOf(item.type)),
      std::int64_t{item.key},
      item.reference == questionnaires::Reference::Previous ? Cell(std::string("previous"))
                                                            : Cell(),
      isPoint ? Cell(std::int64_t{item.scale.lowest}) : Cell(),
      isPoint ? Cell(std::int64_t{item.scale.highest()}) : Cell(),
      language,
      item.withholds(questionnaires::WordingField::Text) ? Cell() : cell(item.text.in(language)),
      cell(item.leftText.in(language)),
      cell(item.rightText.in(language)),
      cell(scaleOf(item, language))};
}

/// All versions of the study's protocol, the newest first.
std::vector<const protocols::Protocol*> versionsOf(Study& study) {
  std::vector<const protocols::Protocol*> versions;
  for (const auto id : study.protocols().all()) versions.push_back(&study.protocol(id).protocol);
  std::reverse(versions.begin(), versions.end());
  return versions;
}

/// What is counted while the physical tool is felt: no questionnaire asks for it.
std::vector<Cell> benchmarkRow() {
  std::vector<Cell> row(14);
  row[2] = std::string("physical-cuts");
  row[3] = std::int64_t{1};
  row[4] = std::string("number");
  row[9] = std::string("en");
  row[10] = std::string("Cuts that were made with the physical tool");
  return row;
}

}  // namespace

std::string_view nameOf(ColumnType type) noexcept {
  constexpr std::array<std::string_view, 5> kNames{
      "text", "integer", "number", "boolean", "date_time"};
  return kNames[static_cast<std::size_t>(type)];
}

ColumnType typeOf(std::string_view column) noexcept {
  if (holds(kIntegers, column)) return ColumnType::Integer;
  if (holds(kNumbers, column)) return ColumnType::Number;
  if (holds(kTimes, column)) return ColumnType::DateTime;
  return column == "included" || column == "declared" ? ColumnType::Boolean : ColumnType::Text;
}

std::map<std::string, std::vector<Level>> levelsOf(Study& study, const ExportOptions& options) {
  std::map<std::string, std::vector<Level>> levels{
      {"run_mode", coded({"live", "pilot", "simulated"})},
      {"status",
       coded(
           {"in_progress", "completed", "declined", "withdrawn", "rejected", "aborted_hardware"})},
      {"qc_status", coded({"PASS", "WARN", "FAIL"})},
      {"item_type", typeLevels()}};
  // What the present version says comes first; what only older ones declare is in the data, too.
  const auto byCondition = conditionCodes(study);
  const auto add =
      [&](const std::string& column, const std::string& value, const std::string& label) {
        auto& known = levels[column];
        const bool isThere = std::any_of(
            known.begin(), known.end(), [&](const auto& level) { return level.value == value; });
        if (!isThere) known.push_back({value, label});
      };
  for (const auto* protocol : versionsOf(study)) {
    for (const auto& cohort : protocol->cohorts) add("cohort", cohort.id, cohort.title.in("en"));
    for (const auto& phase : protocol->phases) add("block", phase.id, phase.id);
    for (const auto& condition : protocol->conditions) {
      const auto& code = byCondition.at(condition.id);
      add("condition_code", code, options.isBlinded ? code : condition.title);
      if (!options.isBlinded) add("condition", condition.id, condition.title);
    }
  }
  auto& codes = levels["condition_code"];
  std::sort(codes.begin(), codes.end(), [](const auto& a, const auto& b) {
    return a.value.size() != b.value.size() ? a.value.size() < b.value.size() : a.value < b.value;
  });
  return levels;
}

std::vector<Level> levelsOf(
    const Column& column, const std::map<std::string, std::vector<Level>>& byName) {
  const auto known = byName.find(column.name);
  return !column.levels.empty() || known == byName.end() ? column.levels : known->second;
}

DataTable columnsTable(
    Study& study, const ExportOptions& options, const std::vector<DataTable>& tables) {
  DataTable result{
      .name = "columns",
      .description = "One row per column of a table; of one with a closed list, one per value.",
      .columns =
          {{"table", "Name of the file, without its ending"},
           {"column", "Name of the column"},
           {"type", "text, integer, number, boolean or date_time"},
           {"description", "What it holds"},
           {"value", "What may stand in it, in the natural order; empty: no closed list"},
           {"label", "What that stands for"}},
      .rows = {}};
  const auto byName = levelsOf(study, options);
  for (const auto& table : tables) {
    for (const auto& column : table.columns) {
      const std::vector<Cell> about{
          table.name, column.name, std::string(nameOf(typeOf(column.name))), column.description};
      auto values = levelsOf(column, byName);
      if (values.empty()) values.push_back({});
      for (const auto& value : values) {
        auto& row = result.rows.emplace_back(about);
        row.push_back(value.value.empty() ? Cell() : Cell(value.value));
        row.push_back(value.label.empty() ? Cell() : Cell(value.label));
      }
    }
  }
  return result;
}

DataTable itemsTable(Study& study) {
  DataTable table{
      .name = "items",
      .description = "One row per item and language: what was asked, and on which scale.",
      .columns = {
          {"instrument", "Questionnaire"},
          {"instrument_version", "Its version"},
          {"item_id", "Question"},
          {"item_num", "Where it stands in its questionnaire, from 1"},
          {"item_type", std::string(kItemTypeInWords)},
          {"key", "1: a high answer is good; -1: a low one is"},
          {"relative_to", "previous: it compares with what was felt just before"},
          {"lowest", "Lowest point"},
          {"highest", "Highest point"},
          {"language", "Of the question as it is worded here"},
          {"text", "The question"},
          {"left_text", "The word at the low end"},
          {"right_text", "The word at the high end"},
          {"scale", "Points or options in their order, with their labels"}}};
  for (const auto& instrument : study.protocol().instruments) {
    for (const auto& language : instrument.languages) {
      std::int64_t order = 0;
      for (const auto& item : instrument.items) {
        table.rows.push_back(rowOf(instrument, ++order, item, language));
      }
    }
  }
  const auto& phases = study.protocol().protocol.phases;
  const bool hasBenchmark = std::any_of(phases.begin(), phases.end(), [](const auto& phase) {
    return phase.type == protocols::PhaseType::Benchmark;
  });
  if (hasBenchmark) table.rows.push_back(benchmarkRow());
  return table;
}

}  // namespace study
