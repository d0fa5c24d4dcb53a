#include "study/export/public_tables.h"

#include <numeric>
#include <set>
#include <stdexcept>

#include <sodium.h>

#include "questionnaires/model/instrument.h"
#include "study/export/condition_codes.h"
#include "study/export/export_parts.h"
#include "study/export/public_people.h"
#include "study/export/study_tables.h"
#include "study/storage/answer_repository.h"
#include "study/words/counted.h"

namespace study {
namespace {

using questionnaires::Item;

/// A random number below @p bound that cannot be predicted or derived from the study.
std::size_t randomBelow(std::size_t bound) {
  return randombytes_uniform(static_cast<std::uint32_t>(bound));
}

template <typename T>
void shuffle(std::vector<T>& rows) {
  for (std::size_t left = rows.size(); left > 1; --left)
    std::swap(rows[left - 1], rows[randomBelow(left)]);
}

/// Distinct random ids without meaning: "R7K2M9QXTA".
std::vector<std::string> drawnIds(std::size_t count) {
  constexpr std::string_view kLetters = "ABCDEFGHJKMNPQRSTVWXYZ23456789";
  constexpr int kLength = 9;
  std::set<std::string> ids;
  std::vector<std::string> distinct;
  while (distinct.size() < count) {
    std::string id = "R";
    for (int i = 0; i < kLength; ++i) id += kLetters[randomBelow(kLetters.size())];
    if (ids.insert(id).second) distinct.push_back(id);
  }
  return distinct;
}

bool isWords(const Item& item) {
  return questionnaires::answerKindOf(item.type) == questionnaires::AnswerKind::Text;
}

/// Computes the released tables.
class PublicTables {
 public:
  PublicTables(Study& study, const ExportOptions& options)
      : study_(study),
        people_(study, options.runMode.value_or(RunMode::Live)),
        release_(publicRelease(study, options)),
        readers_(readersOf(study, options)),
        ids_(drawnIds(people_.count())),
        codes_(conditionCodes(study, options.runMode.value_or(RunMode::Live))),
        allocation_(storage::Records(study.database()).allocation()) {
    for (const auto& column : release_.columns) {
      if (column.level) readers_.releasedIdentifiers.insert(column.name);
    }
  }

  ExportedTable participants() const {
    std::vector<std::size_t> people(people_.count());
    std::iota(people.begin(), people.end(), std::size_t{0});
    auto table = exportedTable(participantTable(), people, readers_);
    shuffle(table.rows);
    return table;
  }

  ExportedTable responses() const {
    std::vector<ExportedAnswer> rows;
    for (const auto& answer : people_.answers()) {
      if (const auto* item = releasableItem(answer)) rows.push_back(rowOf(answer, *item));
    }
    auto table = exportedTable(responseTable(), rows, readers_);
    shuffle(table.rows);
    return table;
  }

 private:
  /// One row for each person; a row is the index of a person.
  Table<std::size_t> participantTable() const {
    Table<std::size_t> table{
        .name = "participants",
        .description = {},
        .columns = {Column<std::size_t>(
                        "participant_id",
                        holds::Text{},
                        "Drawn for this folder; leads nowhere",
                        [this](std::size_t person) { return ids_[person]; })
                        .inPublic()},
        .inPublic = "One row per person, in no order. Of each at least " +
                    std::to_string(release_.k) + " people the same is told."};
    for (const auto& column : release_.columns) {
      if (column.level) table.columns.push_back(columnOf(column).inPublic());
    }
    return table;
  }

  Column<std::size_t> columnOf(const ReleasedColumn& column) const {
    const auto value = [&column](std::size_t person) { return column.values[person]; };
    if (column.name == kCohortColumn) {
      return {column.name, holds::OneOf{ValueList::Cohorts}, kCohortDescription, value};
    }
    if (column.name == kSiteColumn) {
      return {column.name, holds::OneOf{ValueList::Sites}, kSiteDescription, value};
    }
    if (column.name == kOrderColumn) {
      return {
          column.name,
          holds::Text{},
          "Conditions in the order in which they were felt, block by block",
          value};
    }
    for (const auto& question : people_.questions()) {
      if (question.column() != column.name) continue;
      const auto& language = study_.protocol().protocol.languages.front();
      return {
          column.name,
          holds::OneOfOwnList{question.hierarchy.values(*column.level)},
          question.item->text.in(language) + " Empty: not answered, or told by too few",
          value};
    }
    throw std::logic_error("no one knows the column " + column.name);
  }

  /// The item of an answer if its answers may be released; otherwise nullptr.
  const Item* releasableItem(const storage::AnswerRecord& answer) const {
    const bool isForm = answer.step.kind == StepKind::Form;
    const bool isOpinion =
        answer.step.kind == StepKind::Questionnaire || answer.step.kind == StepKind::Preference;
    if (!isForm && !isOpinion) return nullptr;
    const auto person = personOf(answer);
    const auto* instrument =
        study_.protocol(people_.sessions()[person].protocol).instrument(answer.step.instrument);
    const auto* item = instrument == nullptr ? nullptr : instrument->item(answer.answer.item);
    if (item == nullptr || isWords(*item)) return nullptr;
    return isForm && isQuasiIdentifier(*item) ? nullptr : item;
  }

  std::size_t personOf(const storage::AnswerRecord& answer) const {
    return people_.personOf(answer.step.visit.session).value();
  }

  std::string_view codeOf(const std::string& condition) const {
    const auto code = codes_.find(condition);
    return code == codes_.end() ? std::string_view() : code->second;
  }

  /// The condition code of the alternative that an answer chooses.
  std::string_view chosenCode(const storage::AnswerRecord& answer, const std::string& label) const {
    const auto* phase = study_.protocol().protocol.phase(answer.step.phase);
    if (phase == nullptr) return {};
    const auto* condition =
        conditionOf(allocation_, answer.step.visit.session, phase->block, label);
    return condition == nullptr ? std::string_view() : codeOf(*condition);
  }

  Cell responseOf(const storage::AnswerRecord& answer, const Item& item) const {
    const auto stored = storage::stored(answer.answer.response);
    if (stored.point) return *stored.point;
    if (stored.number) return *stored.number;
    const auto text = stored.text.value_or("");
    const bool isAlternative =
        item.optionSource == questionnaires::OptionSource::Alternatives && !text.empty();
    return holds::asCell(isAlternative ? chosenCode(answer, text) : std::string_view(text));
  }

  /// The released value of a person for the quasi-identifier @p identifier; empty if none is
  /// released.
  std::string_view releasedValue(const char* identifier, std::size_t person) const {
    const auto* column = release_.column(identifier);
    return column == nullptr || !column->level ? std::string_view() : column->values[person];
  }

  ExportedAnswer rowOf(const storage::AnswerRecord& answer, const Item& item) const {
    const auto& step = answer.step;
    const std::size_t person = personOf(answer);
    const bool isPlaceKnown = step.position > 0 && !releasedValue(kOrderColumn, person).empty();
    ExportedAnswer row;
    row.owner = {
        .participant = ids_[person],
        .cohort = releasedValue(kCohortColumn, person),
        .site = releasedValue(kSiteColumn, person)};
    row.block = step.phase;
    if (isPlaceKnown) row.position = step.position;
    row.conditionCode = codeOf(step.condition);
    row.condition = step.condition;
    row.record = &answer;
    row.item = &item;
    row.response = responseOf(answer, item);
    row.labelLanguage = study_.protocol().protocol.languages.front();
    return row;
  }

  Study& study_;
  PublicPeople people_;
  Release release_;
  Readers readers_;
  std::vector<std::string> ids_;
  std::map<std::string, std::string> codes_;
  storage::Records::Allocation allocation_;
};

}  // namespace

Release publicRelease(Study& study, const ExportOptions& options) {
  const PublicPeople people(study, options.runMode.value_or(RunMode::Live));
  const auto k = options.publicClassSize.value();
  auto release = computeRelease(people.identifiers(), people.count(), k);
  if (release) return std::move(*release);
  throw storage::StorageError(
      words::counted(people.count(), "person has", "people have") +
      " completed a session, and in a public folder each has to be one of at least " +
      std::to_string(k) +
      " of whom the same is told. Publish the report's tables instead of the answers, or wait "
      "until more people have taken part.");
}

std::vector<ExportedTable> publicTables(Study& study, const ExportOptions& options) {
  const PublicTables tables(study, options);
  return {tables.participants(), tables.responses()};
}

}  // namespace study
