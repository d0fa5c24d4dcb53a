#include "study/export/public_tables.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <stdexcept>

#include <sodium.h>

#include "questionnaires/model/instrument.h"
#include "study/export/codebook.h"
#include "study/export/public_people.h"
#include "study/storage/answer_repository.h"
#include "study/words/counted.h"

namespace study {
namespace {

using questionnaires::Item;
using questionnaires::ItemType;

/// A number below @p bound that nobody can work out.
std::size_t drawn(std::size_t bound) {
  return randombytes_uniform(static_cast<std::uint32_t>(bound));
}

template <typename T>
void shuffle(std::vector<T>& rows) {
  for (std::size_t left = rows.size(); left > 1; --left)
    std::swap(rows[left - 1], rows[drawn(left)]);
}

/// Ids that mean nothing: "R7K2M9QXTA", each another.
std::vector<std::string> drawnIds(std::size_t count) {
  constexpr std::string_view kLetters = "ABCDEFGHJKMNPQRSTVWXYZ23456789";
  constexpr int kLength = 9;
  std::set<std::string> ids;
  std::vector<std::string> drawnOnes;
  while (drawnOnes.size() < count) {
    std::string id = "R";
    for (int i = 0; i < kLength; ++i) id += kLetters[drawn(kLetters.size())];
    if (ids.insert(id).second) drawnOnes.push_back(id);
  }
  return drawnOnes;
}

bool isWords(const Item& item) {
  return item.type == ItemType::ShortText || item.type == ItemType::LongText;
}

Cell textCell(const std::string& text) {
  return text.empty() ? Cell() : Cell(text);
}

/// Lays out what may be told.
class PublicTables {
 public:
  PublicTables(Study& study, const ExportOptions& options)
      : study_(study),
        options_(options),
        people_(study, options.runMode.value_or(RunMode::Live)),
        release_(publicRelease(study, options)),
        ids_(drawnIds(people_.count())),
        codes_(conditionCodes(study)),
        allocation_(storage::Records(study.database()).allocation()) {}

  DataTable participants() const {
    DataTable table{
        .name = "participants",
        .description = "One row per person, in no order. Of each at least " +
                       std::to_string(release_.k) + " people the same is told.",
        .columns = {{"participant_id", "Drawn for this folder; leads nowhere"}},
        .rows = {}};
    for (const auto& column : release_.columns) {
      if (column.level) table.columns.push_back(described(column));
    }
    for (std::size_t person = 0; person < people_.count(); ++person) {
      auto& row = table.rows.emplace_back(std::vector<Cell>{ids_[person]});
      for (const auto& column : release_.columns) {
        if (column.level) row.push_back(textCell(column.values[person]));
      }
    }
    shuffle(table.rows);
    return table;
  }

  DataTable responses() const {
    DataTable table{
        .name = "responses",
        .description = "One row per answer, in no order. An item that was not answered has no row.",
        .columns = columnsOfResponses(),
        .rows = {}};
    for (const auto& answer : people_.answers()) {
      if (const auto* item = itemToTell(answer)) table.rows.push_back(rowOf(answer, *item));
    }
    shuffle(table.rows);
    return table;
  }

 private:
  bool isTold(const char* column) const {
    const auto* known = release_.column(column);
    return known != nullptr && known->level;
  }

  std::vector<Column> columnsOfResponses() const {
    std::vector<Column> columns{{"participant_id", "Drawn for this folder; leads nowhere"}};
    if (isTold(kCohortColumn)) columns.push_back({"cohort", "Group of participants"});
    columns.push_back({"block", "Phase of the protocol"});
    if (isTold(kOrderColumn))
      columns.push_back({"position", "Position of the alternative in its block, from 1"});
    columns.push_back(
        {"condition_code", "Which rendering it was, as a code that means the same in every row"});
    if (!options_.isBlinded) columns.push_back({"condition", "Which rendering it was"});
    const std::vector<Column> more{
        {"instrument", "Questionnaire"},
        {"item_id", "Question"},
        {"item_type", std::string(kItemTypeInWords)},
        {"key", "1: a high answer is good; -1: a low one is"},
        {"response", "A point, a number, the id of an option; of alternatives, the condition code"},
        {"response_keyed", "Points only: reversed where the key is -1"},
        {"response_label", "What the response is called, in one language for everybody"}};
    columns.insert(columns.end(), more.begin(), more.end());
    return columns;
  }

  Column described(const ReleasedColumn& column) const {
    if (column.name == kCohortColumn) return {column.name, "Group of participants"};
    if (column.name == kOrderColumn)
      return {column.name, "Conditions in the order in which they were felt, block by block"};
    for (const auto& question : people_.questions()) {
      if (question.column() != column.name) continue;
      const auto& language = study_.protocol().protocol.languages.front();
      return {
          .name = column.name,
          .description =
              question.item->text.in(language) + " Empty: not answered, or told by too few",
          .levels = question.coarsening.values(*column.level)};
    }
    throw std::logic_error("nobody knows the column " + column.name);
  }

  /// Nothing where the answer stays at home.
  const Item* itemToTell(const storage::AnswerRecord& answer) const {
    const auto& kind = answer.step.kind;
    if (kind != "form" && kind != "questionnaire" && kind != "preference") return nullptr;
    const auto session = sessionOf(answer);
    const auto* instrument =
        study_.protocol(people_.sessions()[session].protocol).instrument(answer.step.instrument);
    const auto* item = instrument == nullptr ? nullptr : instrument->item(answer.answer.item);
    if (item == nullptr || isWords(*item)) return nullptr;
    return kind == "form" && isAboutThePerson(*item) ? nullptr : item;
  }

  std::size_t sessionOf(const storage::AnswerRecord& answer) const {
    return people_.personOf(answer.step.visit.session).value();
  }

  std::string codeOf(const std::string& condition) const {
    const auto code = codes_.find(condition);
    return code == codes_.end() ? std::string() : code->second;
  }

  /// What was felt as the alternative that an answer names.
  std::string preferred(const storage::AnswerRecord& answer, const std::string& label) const {
    const auto* phase = study_.protocol().protocol.phase(answer.step.phase);
    if (phase == nullptr) return {};
    int number = 0;
    std::from_chars(label.data(), label.data() + label.size(), number);
    const auto felt = allocation_.find({answer.step.visit.session, phase->block, number});
    return felt == allocation_.end() ? std::string() : codeOf(felt->second);
  }

  Cell responseOf(const storage::AnswerRecord& answer, const Item& item) const {
    const auto stored = storage::stored(answer.answer.response);
    if (stored.point) return *stored.point;
    if (stored.number) return *stored.number;
    const auto text = stored.text.value_or("");
    const bool isAlternative =
        item.optionSource == questionnaires::OptionSource::Alternatives && !text.empty();
    return textCell(isAlternative ? preferred(answer, text) : text);
  }

  std::vector<Cell> rowOf(const storage::AnswerRecord& answer, const Item& item) const {
    const auto& step = answer.step;
    const std::size_t person = sessionOf(answer);
    std::vector<Cell> row{ids_[person]};
    if (isTold(kCohortColumn))
      row.push_back(textCell(release_.column(kCohortColumn)->values[person]));
    row.push_back(step.phase);
    if (isTold(kOrderColumn)) {
      const bool isKnown = !release_.column(kOrderColumn)->values[person].empty();
      row.push_back(isKnown && step.position > 0 ? Cell(std::int64_t{step.position}) : Cell());
    }
    row.push_back(textCell(codeOf(step.condition)));
    if (!options_.isBlinded) row.push_back(textCell(step.condition));
    const auto* point = std::get_if<std::int64_t>(&answer.answer.response);
    const auto& language = study_.protocol().protocol.languages.front();
    const std::vector<Cell> more{
        step.instrument,
        item.id,
        std::string(questionnaires::nameOf(item.type)),
        std::int64_t{item.key},
        responseOf(answer, item),
        point == nullptr ? Cell() : Cell(questionnaires::keyed(item, *point)),
        textCell(questionnaires::labelOf(item, answer.answer.response, language))};
    row.insert(row.end(), more.begin(), more.end());
    return row;
  }

  Study& study_;
  const ExportOptions& options_;
  PublicPeople people_;
  Release release_;
  std::vector<std::string> ids_;
  std::map<std::string, std::string> codes_;
  std::map<storage::Records::Alternative, std::string> allocation_;
};

}  // namespace

Release publicRelease(Study& study, const ExportOptions& options) {
  const PublicPeople people(study, options.runMode.value_or(RunMode::Live));
  const auto k = options.publicClass.value();
  auto release = released(people.identifiers(), people.count(), k);
  if (release) return std::move(*release);
  throw storage::StorageError(
      words::counted(people.count(), "person has", "people have") +
      " completed a session, and in a public folder each has to be one of at least " +
      std::to_string(k) +
      " of whom the same is told. Publish the report's tables instead of the answers, or wait "
      "until more people have taken part.");
}

std::vector<DataTable> publicTables(Study& study, const ExportOptions& options) {
  const PublicTables tables(study, options);
  return {tables.participants(), tables.responses()};
}

}  // namespace study
