// The columns of responses.csv, texts.csv and wide.csv.
#include <algorithm>
#include <cctype>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "questionnaires/model/answer.h"
#include "questionnaires/model/instrument.h"
#include "questionnaires/scoring/scoring.h"
#include "study/export/study_columns.h"
#include "study/export/value_lists.h"

namespace study {
namespace {

std::string_view itemTypeOf(const ExportedAnswer& row) {
  return row.item == nullptr ? std::string_view() : questionnaires::nameOf(row.item->type);
}

std::optional<int> keyOf(const ExportedAnswer& row) {
  return row.item == nullptr ? std::nullopt : std::optional(row.item->key);
}

std::optional<std::int64_t> keyedResponseOf(const ExportedAnswer& row) {
  const auto* point = std::get_if<std::int64_t>(&row.record->answer.response);
  if (row.item == nullptr || point == nullptr) return std::nullopt;
  return questionnaires::keyedPoint(*row.item, *point);
}

Cell givenResponse(const ExportedAnswer& row) {
  return row.band.empty() ? row.response : Cell(row.band);
}

std::string labelOfResponse(const ExportedAnswer& row) {
  if (row.item == nullptr) return {};
  if (!row.chosen.empty()) return std::string(row.chosen);
  return questionnaires::labelOf(*row.item, row.record->answer.response, row.labelLanguage);
}

/// A getter for a member of the stored answer (GivenAnswer).
template <typename Member>
auto answerMember(Member member) {
  return [member](const ExportedAnswer& row) { return std::invoke(member, row.record->answer); };
}

/// The columns that describe the step in which an answer was given. Public folders contain only the
/// columns whose values enough people share.
Columns<ExportedAnswer> columnsOfAnsweredStep() {
  return {
      participantColumn<ExportedAnswer>().inPublic("Drawn for this folder; leads nowhere"),
      sessionNumberColumn<ExportedAnswer>(),
      cohortColumn<ExportedAnswer>().inPublicIfReleased(kCohortColumn),
      siteColumn<ExportedAnswer>().inPublicIfReleased(kSiteColumn),
      runModeColumn<ExportedAnswer>(),
      stepNumberColumn<ExportedAnswer>(),
      attemptColumn<ExportedAnswer>(),
      blockColumn<ExportedAnswer>().inPublic(),
      positionColumn<ExportedAnswer>().inPublicIfReleased(
          kOrderColumn, "Position of the alternative in its block, from 1"),
      alternativeColumn<ExportedAnswer>(),
      conditionCodeColumn<ExportedAnswer>().inPublic(),
      conditionColumn<ExportedAnswer>().inPublic()};
}

/// The columns on the item that was answered.
Columns<ExportedAnswer> columnsOfQuestion() {
  using namespace holds;
  using C = Column<ExportedAnswer>;
  return {
      C("instrument",
        Text{},
        "Questionnaire",
        [](const ExportedAnswer& row) {
          return row.record->step.instrument;
        }).inPublic(),
      C("item_id", Text{}, "Question", answerMember(&GivenAnswer::item)).inPublic()};
}

/// The columns on whether and how the statistics use an answer.
Columns<ExportedAnswer> columnsOfUse() {
  using namespace holds;
  return {
      {"language",
       Text{},
       "Of the question as it is worded here",
       answerMember(&GivenAnswer::language)},
      includedColumn<ExportedAnswer>(
          [](const ExportedAnswer& row) { return row.excluded.empty(); }),
      {"exclude_reason", Text{}, "Why they do not", &ExportedAnswer::excluded}};
}

Columns<ExportedAnswer> columnsOfAnswer() {
  using namespace holds;
  using C = Column<ExportedAnswer>;
  return {
      {"item_order",
       Integer{},
       "Where it stood on its page, from 1",
       answerMember(&GivenAnswer::itemOrder)},
      C("item_type", OneOf{ValueList::ItemTypes}, itemTypesInWords(), itemTypeOf).inPublic(),
      C("key", Integer{}, "1: a high answer is good; -1: a low one is", keyOf).inPublic(),
      C("response",
        FreeText{},
        "As given: a point, a number, the id of an option; in a vote, the alternative. A number "
        "about the person is a band (\"25 to 29\") if the export is not exact",
        givenResponse)
          .inPublic("A point, a number, the id of an option; of alternatives, the condition code"),
      C("response_keyed", Integer{}, "Points only: reversed where the key is -1", keyedResponseOf)
          .inPublic(),
      C("response_label",
        FreeText{},
        "What the response is called in the language it was given in; in a vote, the condition (if "
        "blinded, its code) that the participant had felt as that alternative",
        labelOfResponse)
          .inPublic("What the response is called, in one language for everybody"),
      {"first_touch_s",
       Number{"s"},
       "From the page's appearance to the first touch of the item",
       answerMember(&GivenAnswer::firstTouch)},
      {"response_time_s",
       Number{"s"},
       "… to the last change of the answer",
       answerMember(&GivenAnswer::responseTime)},
      {"n_changes",
       Integer{},
       "How often it was changed after the first touch",
       answerMember(&GivenAnswer::changes)}};
}

/// The time of saving. Blinded folders leave it out, because the time between two answers depends
/// on the rendering of the trial between them.
Column<ExportedAnswer> savedColumn() {
  return Column<ExportedAnswer>(
             "saved_utc",
             holds::Utc{},
             "When it was on the disk, ISO 8601, UTC",
             [](const ExportedAnswer& row) { return row.record->savedUtc; })
      .revealsCondition()
      .exact();
}

Columns<ExportedAnswer> concatenated(std::initializer_list<Columns<ExportedAnswer>> parts) {
  Columns<ExportedAnswer> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// The instruments of blocks, in the order of the protocol.
std::vector<const questionnaires::Instrument*> instrumentsOfBlocks(
    const protocols::LoadedProtocol& loaded) {
  std::vector<const questionnaires::Instrument*> all;
  for (const auto& phase : loaded.protocol.phases) {
    for (const auto& asked : phase.trials.questionnaires) {
      const auto* instrument = loaded.instrument(asked.instrument);
      if (std::ranges::count(all, instrument) == 0) all.push_back(instrument);
    }
  }
  return all;
}

/// The names of columns for questions and scores in the wide table.
class WideNames {
 public:
  explicit WideNames(const protocols::LoadedProtocol& loaded) {
    for (const auto* instrument : instrumentsOfBlocks(loaded)) {
      for (const auto& item : instrument->items) add({instrument->id, item.id, false});
      for (const auto& score : instrument->scores) add({instrument->id, score.id, true});
    }
  }

  /// Empty for an item that only an earlier version of the protocol has.
  std::string ofItem(const std::string& instrument, const std::string& item) const {
    return nameOfKey({instrument, item, false});
  }
  std::string ofScore(const std::string& instrument, const std::string& score) const {
    return nameOfKey({instrument, score, true});
  }

 private:
  struct Key {
    std::string instrument;
    std::string id;
    bool isScore;
    auto operator<=>(const Key&) const = default;
  };

  std::string nameOfKey(const Key& key) const {
    const auto found = names_.find(key);
    return found == names_.end() ? std::string() : found->second;
  }

  /// Adds a name of letters, digits and underscores, which every program accepts:
  /// "nasa_tlx_raw__mental_demand". If names are equal after that, or differ only in case (which
  /// SPSS ignores), a number is appended.
  void add(const Key& key) {
    auto name = key.instrument + "__" + (key.isScore ? "score_" : "") + key.id;
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    auto unique = name;
    for (int number = 2; !usedNames_.insert(lowerCase(unique)).second; ++number) {
      unique = name + "_" + std::to_string(number);
    }
    names_.emplace(key, unique);
  }

  static std::string lowerCase(std::string text) {
    std::ranges::transform(
        text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
  }

  std::map<Key, std::string> names_;
  std::set<std::string> usedNames_;
};

Column<ExportedForms> itemColumn(
    const std::string& name,
    const questionnaires::Instrument& instrument,
    const questionnaires::Item& item,
    const std::string& language) {
  using namespace holds;
  const auto cell = [name](const ExportedForms& row) {
    const auto found = row.cells.find(name);
    return found == row.cells.end() ? Cell() : found->second;
  };
  const auto& text = item.text.in(language);
  const auto description =
      "As given to item " + item.id + " of " + instrument.id + (text.empty() ? "" : ": " + text);
  switch (answerKindOf(item.type)) {
    case questionnaires::AnswerKind::Point:
      return {name, Integer{}, description, cell};
    case questionnaires::AnswerKind::Number:
      return {name, Number{}, description, cell};
    default:
      return {name, FreeText{}, description, cell};
  }
}

Column<ExportedForms> scoreColumn(
    const std::string& name,
    const questionnaires::Instrument& instrument,
    const questionnaires::Score& score) {
  return {
      name,
      holds::Number{},
      "Score " + score.id + " of " + instrument.id + "; empty where too few items were answered",
      [name](const ExportedForms& row) {
        const auto found = row.cells.find(name);
        return found == row.cells.end() ? Cell() : found->second;
      }};
}

}  // namespace

Table<ExportedForms> wideTable(const protocols::LoadedProtocol& loaded) {
  using C = ExportedForms;
  Columns<C> columns{
      participantColumn<C>(),
      sessionNumberColumn<C>(),
      cohortColumn<C>(),
      siteColumn<C>(),
      runModeColumn<C>(),
      blockColumn<C>(),
      positionColumn<C>(),
      alternativeColumn<C>(),
      conditionCodeColumn<C>(),
      conditionColumn<C>()};
  const auto& language = loaded.protocol.languages.front();
  const WideNames names(loaded);
  for (const auto* instrument : instrumentsOfBlocks(loaded)) {
    for (const auto& item : instrument->items) {
      const bool isText = answerKindOf(item.type) == questionnaires::AnswerKind::Text;
      if (!isText && !item.isIdentifying) {
        columns.push_back(
            itemColumn(names.ofItem(instrument->id, item.id), *instrument, item, language));
      }
    }
    for (const auto& score : instrument->scores) {
      columns.push_back(scoreColumn(names.ofScore(instrument->id, score.id), *instrument, score));
    }
  }
  return {
      .name = "wide",
      .description =
          "One row per participant, block and alternative, with a column for each question and "
          "each "
          "score: the answers that the statistics count, as they were given.",
      .columns = std::move(columns)};
}

std::vector<ExportedForms> wideRows(
    const protocols::LoadedProtocol& loaded, const std::vector<ExportedAnswer>& answers) {
  const WideNames names(loaded);
  using Key = std::tuple<SessionId, std::string_view, int>;
  std::map<Key, std::size_t> places;
  std::vector<ExportedForms> rows;
  struct Form {
    const questionnaires::Instrument* asked = nullptr;
    std::vector<questionnaires::Answer> answers;
  };
  std::vector<std::map<std::string, Form>> forms;  // by instrument
  for (const auto& answer : answers) {
    const bool counts = answer.excluded.empty() && answer.alternative && answer.position;
    if (!counts || answer.record->step.kind != StepKind::Questionnaire) continue;
    const Key key{answer.owner.session, answer.block, *answer.alternative};
    const auto [found, isNew] = places.try_emplace(key, rows.size());
    if (isNew) {
      rows.push_back({answer, {}});
      forms.emplace_back();
    }
    const auto& instrument = answer.record->step.instrument;
    const auto& item = answer.record->answer.item;
    // only numbers; a band of a number about the person is text
    if (answer.band.empty()) {
      const auto name = names.ofItem(instrument, item);
      if (!name.empty()) rows[found->second].cells[name] = answer.response;
    }
    auto& form = forms[found->second][instrument];
    form.asked = answer.instrument;
    form.answers.push_back({item, answer.record->answer.response});
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto* instrument : instrumentsOfBlocks(loaded)) {
      const auto& form = forms[i][instrument->id];
      if (form.asked == nullptr) continue;
      for (const auto& score : instrument->scores) {
        const auto* own = protocols::comparableScore(*form.asked, *instrument, score);
        if (own == nullptr) continue;
        const auto result = questionnaires::scoreValue(*form.asked, *own, form.answers);
        if (result) rows[i].cells[names.ofScore(instrument->id, score.id)] = *result;
      }
    }
  }
  return rows;
}

Table<ExportedAnswer> responseTable() {
  return {
      .name = "responses",
      .description =
          "One row per answer that is no text. An item that was not answered has no row: "
          "it is missing.",
      .columns = concatenated(
          {columnsOfAnsweredStep(),
           columnsOfQuestion(),
           columnsOfAnswer(),
           columnsOfUse(),
           {savedColumn()}}),
      .inPublic = "One row per answer, in no order. An item that was not answered has no row."};
}

Table<ExportedAnswer> textTable() {
  const Columns<ExportedAnswer> text{
      {"response_text", holds::FreeText{}, "As it was written", &ExportedAnswer::response}};
  return {
      .name = "texts",
      .description = "One row per text that a participant wrote as an answer.",
      .columns = concatenated({columnsOfAnsweredStep(), columnsOfQuestion(), text, columnsOfUse()}),
      .isFreeTextTable = true};
}

}  // namespace study
