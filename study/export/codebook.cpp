#include "study/export/codebook.h"

#include <algorithm>
#include <set>

#include "questionnaires/model/answer.h"
#include "questionnaires/model/instrument.h"
#include "study/export/value_lists.h"

namespace study {
namespace {

using questionnaires::Item;
using questionnaires::ItemType;

/// A row of items.csv: an item in one language.
struct ExportedItem {
  std::string protocolHash = {};  ///< empty unless items of several versions are exported
  std::string instrument = {};
  std::string version;
  std::string id;
  int number = 1;  ///< its position in the questionnaire
  ItemType type = ItemType::Number;
  std::optional<int> key;
  std::string relativeTo;
  std::optional<double> lowest;
  std::optional<double> highest;
  std::string language;
  std::string text;
  std::string leftText;
  std::string rightText;
  std::string scale;

  bool operator==(const ExportedItem&) const = default;
};

/// @param hasVersions  whether it has the items of several versions of the protocol
Table<ExportedItem> itemTable(bool hasVersions) {
  using namespace holds;
  using Row = ExportedItem;
  Table<Row> table{
      .name = "items",
      .description = "One row per item and language: what was asked, and on which scale.",
      .columns = {
          {"instrument", Text{}, "Questionnaire", &Row::instrument},
          {"instrument_version", Text{}, "Its version", &Row::version},
          {"item_id", Text{}, "Question", &Row::id},
          {"item_num", Integer{}, "Where it stands in its questionnaire, from 1", &Row::number},
          {"item_type",
           OneOf{ValueList::ItemTypes},
           itemTypesInWords(),
           [](const Row& row) { return questionnaires::nameOf(row.type); }},
          {"key", Integer{}, "1: a high answer is good; -1: a low one is", &Row::key},
          {"relative_to",
           Text{},
           "previous: it compares with what was felt just before",
           &Row::relativeTo},
          {"lowest", Number{}, "Lowest point or number", &Row::lowest},
          {"highest", Number{}, "Highest point or number", &Row::highest},
          {"language", Text{}, "Of the question as it is worded here", &Row::language},
          {"text", Text{}, "The question", &Row::text},
          {"left_text", Text{}, "The word at the low end", &Row::leftText},
          {"right_text", Text{}, "The word at the high end", &Row::rightText},
          {"scale", Text{}, "Points or options in their order, with their labels", &Row::scale}}};
  if (hasVersions) {
    table.description =
        "One row per item, language and version of the protocol: what was asked, "
        "and on which scale.";
    table.columns.insert(
        table.columns.begin(),
        {"protocol_hash", Text{}, "The version, as in sessions", &Row::protocolHash});
  }
  table.inPublic = table.description;
  for (auto& column : table.columns) column = std::move(column).inPublic();
  return table;
}

bool isPoint(const Item& item) {
  return questionnaires::answerKindOf(item.type) == questionnaires::AnswerKind::Point;
}

/// The points or options of an item in order: "1=strongly disagree; 5=strongly agree".
std::string scaleOf(const Item& item, const std::string& language) {
  std::string text;
  const auto add = [&](const std::string& value, const std::string& label) {
    text += (text.empty() ? "" : "; ") + value + (label.empty() ? "" : "=" + label);
  };
  if (isPoint(item)) {
    for (int point = item.scale.lowest; point <= item.scale.highest(); ++point) {
      add(std::to_string(point), questionnaires::labelOf(item, std::int64_t{point}, language));
    }
  }
  for (const auto& option : item.options) add(option.id, option.text.in(language));
  return text;
}

ExportedItem itemRow(
    const questionnaires::Instrument& instrument,
    int number,
    const Item& item,
    const std::string& language) {
  ExportedItem row{
      .instrument = instrument.id,
      .version = instrument.version,
      .id = item.id,
      .number = number,
      .type = item.type,
      .key = item.key,
      .relativeTo = item.comparedWith == questionnaires::Reference::Previous ? "previous" : "",
      .language = language,
      .text = item.withholds(questionnaires::WordingField::Text) ? "" : item.text.in(language),
      .leftText = item.leftText.in(language),
      .rightText = item.rightText.in(language),
      .scale = scaleOf(item, language)};
  if (const auto range = questionnaires::rangeOf(item)) {
    row.lowest = range->low;
    row.highest = range->high;
  }
  return row;
}

/// The number of cuts with the physical tool. The operator counts them; no questionnaire asks for
/// them.
ExportedItem benchmarkRow() {
  return {
      .id = "physical-cuts",
      .language = "en",
      .text = "Cuts that were made with the physical tool"};
}

std::vector<ExportedItem> itemRows(const protocols::LoadedProtocol& loaded) {
  std::vector<ExportedItem> rows;
  for (const auto& instrument : loaded.instruments) {
    for (const auto& language : instrument.languages) {
      int number = 0;
      for (const auto& item : instrument.items) {
        rows.push_back(itemRow(instrument, ++number, item, language));
      }
    }
  }
  const bool hasBenchmark = std::ranges::any_of(loaded.protocol.phases, [](const auto& phase) {
    return phase.type == protocols::PhaseType::Benchmark;
  });
  if (hasBenchmark) rows.push_back(benchmarkRow());
  return rows;
}

/// A row of columns.csv: one value of a column.
struct ColumnValue {
  const ExportedTable* table = nullptr;
  const ExportedColumn* column = nullptr;
  Level level;
};

Table<ColumnValue> columnTable() {
  using namespace holds;
  using Row = ColumnValue;
  return {
      .name = "columns",
      .description = "One row per column of a table; of one with a closed list, one per value.",
      .columns = {
          {"table",
           Text{},
           "Name of the file, without its ending",
           [](const Row& row) { return row.table->name; }},
          {"column", Text{}, "Name of the column", [](const Row& row) { return row.column->name; }},
          {"type",
           Text{},
           "text, integer, number, boolean or date_time",
           [](const Row& row) { return nameOf(row.column->type); }},
          {"unit_symbol",
           Text{},
           "Unit of its numbers; empty: it has none, or the device decides",
           [](const Row& row) { return row.column->unit; }},
          {"description",
           Text{},
           "What it holds",
           [](const Row& row) { return row.column->description; }},
          {"value",
           Text{},
           "What may stand in it, in the natural order; empty: no closed list",
           [](const Row& row) { return row.level.value; }},
          {"label", Text{}, "What that stands for", [](const Row& row) {
             return row.level.label;
           }}}};
}

}  // namespace

ExportedTable columnsTable(const std::vector<ExportedTable>& tables) {
  std::vector<ColumnValue> rows;
  for (const auto& table : tables) {
    for (const auto& column : table.columns) {
      if (column.levels.empty()) rows.push_back({&table, &column, {}});
      for (const auto& level : column.levels) rows.push_back({&table, &column, level});
    }
  }
  return exportedTable(columnTable(), rows, {});
}

ExportedTable itemsTable(Study& study, const Readers& readers) {
  auto rows = itemRows(study.protocol());
  const auto current = study.protocols().current();
  std::set<ProtocolId> earlier;  // with other items
  for (const auto& session : study.sessions().all()) earlier.insert(session.protocol);
  std::erase_if(earlier, [&](auto id) { return itemRows(study.protocol(id)) == rows; });
  for (auto& row : rows) row.protocolHash = earlier.empty() ? "" : current.sha256;
  for (const auto id : earlier) {
    const auto hash = study.protocols().load(id).sha256;
    for (auto& row : itemRows(study.protocol(id))) {
      row.protocolHash = hash;
      rows.push_back(std::move(row));
    }
  }
  return exportedTable(itemTable(!earlier.empty()), rows, readers);
}

}  // namespace study
