#include "study/app/erasure/person_page.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "questionnaires/model/answer.h"
#include "study/export/export_rows.h"
#include "study/report/erasure_certificate.h"
#include "study/report/html_text.h"
#include "study/storage/stored_values.h"

namespace study::app {
namespace {

using report::escaped;
using Row = std::vector<std::string>;

std::string htmlRow(const Row& row, const char* cell) {
  std::string html = "<tr>";
  for (const auto& text : row) {
    html += fmt::format("<{0} class=\"words\">{1}</{0}>", cell, escaped(text));
  }
  return html + "</tr>\n";
}

/// A heading and a table; a sentence in its place if it has no rows.
std::string part(const std::string& title, const Row& head, const std::vector<Row>& rows) {
  const auto heading = "<h2>" + escaped(title) + "</h2>\n";
  if (rows.empty()) return heading + "<p>Nothing is stored.</p>\n";
  auto html = heading + "<table><thead>" + htmlRow(head, "th") + "</thead><tbody>\n";
  for (const auto& row : rows) html += htmlRow(row, "td");
  return html + "</tbody></table>\n";
}

/// A table of the export, by the names of its columns.
std::string part(const std::string& title, const ExportedTable& table) {
  Row head;
  for (const auto& column : table.columns) head.push_back(column.name);
  std::vector<Row> rows;
  for (const auto& cells : table.rows) {
    auto& row = rows.emplace_back();
    for (const auto& cell : cells) row.push_back(textOfCell(cell));
  }
  return part(title, head, rows);
}

std::string namesPart(Study& study, const std::string& participant) {
  if (study.identities().isLocked()) {
    return "<h2>Names</h2>\n<p>" + std::to_string(study.identities().count(participant)) +
           " are stored behind a passphrase that was not given.</p>\n";
  }
  std::vector<Row> rows;
  for (const auto& name : study.identities().names(participant)) {
    rows.push_back({name.item, name.text});
  }
  return part("Names", {"question", "answer"}, rows);
}

std::string answersPart(Study& study, const ExportOptions& options) {
  const StudyRows stored(study, options);
  auto answers = stored.answers();
  for (auto& text : stored.texts()) answers.push_back(std::move(text));
  std::ranges::stable_sort(answers, {}, [](const auto& row) { return row.record->savedUtc; });
  std::vector<Row> rows;
  for (const auto& row : answers) {
    const auto& given = row.record->answer;
    const auto label = row.item == nullptr || !row.chosen.empty()
                           ? std::string(row.chosen)
                           : questionnaires::labelOf(*row.item, given.response, given.language);
    const auto response = textOfCell(row.response);
    rows.push_back(
        {row.item == nullptr ? given.item : row.item->text.in(given.language),
         label.empty() || label == response ? response : response + ": " + label,
         row.alternative ? std::to_string(*row.alternative) : "",
         options.isBlinded ? "" : row.record->savedUtc});
  }
  return part("Answers", {"question", "answer", "about alternative", "saved (UTC)"}, rows);
}

/// The events without a session that name the participant: consent copies, exports, an erasure.
std::string studyEventsPart(Study& study, const std::string& participant) {
  std::vector<Row> rows;
  for (const auto& event : study.events().read()) {
    const bool isAboutThem =
        !event.visit && storage::storedText(event.values, "participant") == participant;
    if (!isAboutThem) continue;
    rows.push_back({asUtc(event.when.wall), std::string(event.name()), storage::describe(event)});
  }
  return part("What was done with these data", {"time (UTC)", "event", "detail"}, rows);
}

std::string copiesPart(Study& study, const std::string& participant) {
  std::vector<Row> rows;
  for (const auto& copy : copiesNotErased(study, {}, participant)) {
    rows.push_back({copy.what, report::inWords(copy)});
  }
  if (study.isCollected() || !study.station().isNone()) {
    rows.push_back({"pushes", "the study's server, and every folder that is pulled from it"});
  }
  return part("Copies that the study knows of", {"made by", "where"}, rows);
}

}  // namespace

std::string personPage(Study& study, const ExportOptions& options) {
  const auto& title = study.protocol().protocol.study.title;
  const auto& participant = options.participant;
  std::string html = fmt::format(
      "<h1>{}</h1>\n<p>What this study stores about the participant {}, on {}. The same data are "
      "in "
      "the tables beside this page; README.md says what they hold.</p>\n",
      escaped(title),
      escaped(participant),
      asUtc(study.clock().now().wall));
  if (options.isBlinded) {
    html +=
        "<p class=\"note\">What was felt, measured and noted in each trial, and the times of "
        "answers, are stored too. They are not given here, because they tell which condition was "
        "which.</p>\n";
  } else {
    html +=
        "<p class=\"note\">The samples of each trial are in the folder <a "
        "href=\"traces/\">traces</a>.</p>\n";
  }
  html += namesPart(study, participant);
  for (const auto& table : exportTables(study, options)) {
    if (table.name == "sessions") html += part("Sessions", table);
    if (table.name == "trials") html += part("Trials", table);
    if (table.name == "events") html += part("Events of the sessions", table);
  }
  html += answersPart(study, options) + studyEventsPart(study, participant) +
          copiesPart(study, participant);
  return report::htmlPage(title, html);
}

}  // namespace study::app
