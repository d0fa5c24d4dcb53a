#include "study/storage/answer_repository.h"

#include <sstream>

#include "base/joined.h"
#include "study/storage/protocol_repository.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

constexpr const char* kAnswerColumns =
    "item, item_order, kind, point, number, text, first_touch_s, response_s, changes, language";

GivenAnswer answerIn(const Statement& row) {
  return {
      .item = row.text(0),
      .response = restored(
          {.kind = row.text(2),
           .point = row.optionalNumber(3),
           .number = row.optionalReal(4),
           .text = row.optionalText(5)}),
      .itemOrder = static_cast<int>(row.number(1)),
      .firstTouch = row.real(6),
      .responseTime = row.real(7),
      .changes = static_cast<int>(row.number(8)),
      .language = row.text(9)};
}

}  // namespace

ResponseColumns stored(const questionnaires::Response& response) {
  if (const auto* point = std::get_if<std::int64_t>(&response)) {
    return {.kind = "point", .point = *point};
  }
  if (const auto* number = std::get_if<double>(&response)) {
    return {.kind = "number", .number = *number};
  }
  if (const auto* text = std::get_if<std::string>(&response))
    return {.kind = "text", .text = *text};
  const auto& ids = std::get<std::vector<std::string>>(response);
  return {.kind = "choices", .text = base::joined(ids, " ")};
}

questionnaires::Response restored(const ResponseColumns& response) {
  if (response.kind == "point") return response.point.value_or(0);
  if (response.kind == "number") return response.number.value_or(0.0);
  if (response.kind == "text") return response.text.value_or("");
  std::vector<std::string> ids;
  std::istringstream joined(response.text.value_or(""));
  for (std::string id; joined >> id;) ids.push_back(id);
  return ids;
}

void AnswerRepository::put(
    const VisitKey& visit, const GivenAnswer& answer, const std::string& utc) {
  // An update keeps the stored first_touch_s. After a crash the page is shown again, and a person
  // may answer it in fewer seconds; response_s is then raised to first_touch_s, which it must not
  // precede.
  Statement put(
      database_,
      "INSERT INTO answer (session_id, step, attempt, " + std::string(kAnswerColumns) +
          ", saved_utc) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
          "ON CONFLICT (session_id, step, attempt, item) DO UPDATE SET kind = excluded.kind, "
          "point = excluded.point, number = excluded.number, text = excluded.text, "
          "response_s = max(excluded.response_s, first_touch_s), changes = excluded.changes, "
          "language = excluded.language, saved_utc = excluded.saved_utc");
  const auto response = stored(answer.response);
  put.bindAll(
      visit,
      answer.item,
      answer.itemOrder,
      response.kind,
      response.point,
      response.number,
      response.text,
      answer.firstTouch,
      answer.responseTime,
      answer.changes,
      answer.language,
      utc);
  put.run();
}

void AnswerRepository::remove(const VisitKey& visit, std::string_view item) {
  Statement remove(
      database_,
      "DELETE FROM answer WHERE session_id = ? AND step = ? AND attempt = ? AND item = ?");
  remove.bindAll(visit, item);
  remove.run();
}

std::optional<GivenAnswer> AnswerRepository::find(
    const VisitKey& visit, std::string_view item) const {
  Statement find(
      database_,
      "SELECT " + std::string(kAnswerColumns) +
          " FROM answer WHERE session_id = ? AND step = ? AND attempt = ? AND item = ?");
  find.bindAll(visit, item);
  return find.step() ? std::optional(answerIn(find)) : std::nullopt;
}

std::vector<GivenAnswer> AnswerRepository::of(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT " + std::string(kAnswerColumns) +
          " FROM answer WHERE session_id = ? AND step = ? AND attempt = ? "
          "ORDER BY item_order");
  select.bindAll(visit);
  std::vector<GivenAnswer> answers;
  while (select.step()) answers.push_back(answerIn(select));
  return answers;
}

base::NamedArguments valuesOf(const GivenAnswer& answer) {
  constexpr std::size_t kLongest = 200;
  const auto response = stored(answer.response);
  base::NamedArguments values{{"item", answer.item}};
  if (response.point) {
    values.emplace_back("point", *response.point);
  } else if (response.number) {
    values.emplace_back("number", *response.number);
  } else if (const auto text = response.text.value_or(""); text.size() <= kLongest) {
    values.emplace_back("text", text);
  } else {
    values.emplace_back("sha256", sha256(text));
  }
  return values;
}

}  // namespace study::storage
