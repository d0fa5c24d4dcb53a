// The columns of responses.csv and texts.csv.
#include <initializer_list>

#include "questionnaires/model/answer.h"
#include "questionnaires/model/instrument.h"
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
  return questionnaires::keyed(*row.item, *point);
}

Cell givenResponse(const ExportedAnswer& row) {
  return row.band.empty() ? row.response : Cell(row.band);
}

std::string labelOfResponse(const ExportedAnswer& row) {
  if (row.item == nullptr) return {};
  return questionnaires::labelOf(*row.item, row.record->answer.response, row.labelLanguage);
}

/// A getter of a member of the stored answer.
template <typename Member>
auto howGiven(Member member) {
  return [member](const ExportedAnswer& row) { return std::invoke(member, row.record->answer); };
}

/// The step of the answer. Public folders contain only what enough people share.
Columns<ExportedAnswer> columnsOfAnsweredStep() {
  return {
      participantColumn<ExportedAnswer>().inPublic("Drawn for this folder; leads nowhere"),
      sessionNumberColumn<ExportedAnswer>(),
      cohortColumn<ExportedAnswer>().inPublicIfTold(kCohortColumn),
      siteColumn<ExportedAnswer>().inPublicIfTold(kSiteColumn),
      runModeColumn<ExportedAnswer>(),
      stepNumberColumn<ExportedAnswer>(),
      attemptColumn<ExportedAnswer>(),
      blockColumn<ExportedAnswer>().inPublic(),
      positionColumn<ExportedAnswer>().inPublicIfTold(
          kOrderColumn, "Position of the alternative in its block, from 1"),
      alternativeColumn<ExportedAnswer>(),
      conditionCodeColumn<ExportedAnswer>().inPublic(),
      conditionColumn<ExportedAnswer>().inPublic()};
}

/// What was asked.
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
      C("item_id", Text{}, "Question", howGiven(&GivenAnswer::item)).inPublic()};
}

/// How it counts.
Columns<ExportedAnswer> columnsOfUse() {
  using namespace holds;
  return {
      {"language",
       Text{},
       "Of the question as it is worded here",
       howGiven(&GivenAnswer::language)},
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
       howGiven(&GivenAnswer::itemOrder)},
      C("item_type", OneOf{ValueList::ItemTypes}, itemTypesInWords(), itemTypeOf).inPublic(),
      C("key", Integer{}, "1: a high answer is good; -1: a low one is", keyOf).inPublic(),
      C("response",
        FreeText{},
        "As given: a point, a number, the id of an option. A number about the person is a band "
        "(\"25 to 29\") if the export is not exact",
        givenResponse)
          .inPublic("A point, a number, the id of an option; of alternatives, the condition code"),
      C("response_keyed", Integer{}, "Points only: reversed where the key is -1", keyedResponseOf)
          .inPublic(),
      C("response_label",
        FreeText{},
        "What the response is called in the language it was given in",
        labelOfResponse)
          .inPublic("What the response is called, in one language for everybody"),
      {"first_touch_s",
       Number{"s"},
       "From the page's appearance to the first touch of the item",
       howGiven(&GivenAnswer::firstTouch)},
      {"response_time_s",
       Number{"s"},
       "… to the last change of the answer",
       howGiven(&GivenAnswer::responseTime)},
      {"n_changes",
       Integer{},
       "How often it was changed after the first touch",
       howGiven(&GivenAnswer::changes)}};
}

/// The trial between two answers depends on the rendering, and so does the time between them.
Column<ExportedAnswer> savedColumn() {
  return Column<ExportedAnswer>(
             "saved_utc",
             holds::Utc{},
             "When it was on the disk, ISO 8601, UTC",
             [](const ExportedAnswer& row) { return row.record->savedUtc; })
      .revealsCondition()
      .exact();
}

Columns<ExportedAnswer> joined(std::initializer_list<Columns<ExportedAnswer>> parts) {
  Columns<ExportedAnswer> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

Table<ExportedAnswer> responseTable() {
  return {
      .name = "responses",
      .description =
          "One row per answer that is no text. An item that was not answered has no row: "
          "it is missing.",
      .columns = joined(
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
      .columns = joined({columnsOfAnsweredStep(), columnsOfQuestion(), text, columnsOfUse()}),
      .isOnRequest = true};
}

}  // namespace study
