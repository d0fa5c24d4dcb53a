#include "study/report/document.h"

#include "study/report/html_text.h"

namespace study::report {
namespace {

void putTable(const DataTable& table, std::string& html) {
  if (table.description.empty()) return;
  html += "<table>\n<caption>" + escaped(table.description) + "</caption>\n<thead><tr>";
  for (const auto& column : table.columns) {
    html +=
        "<th>" + escaped(column.description.empty() ? column.name : column.description) + "</th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (const auto& cell : row) html += "<td>" + escaped(textOfCell(cell)) + "</td>";
    html += "</tr>\n";
  }
  html += "</tbody></table>\n";
}

}  // namespace

std::string asHtml(const Document& document) {
  std::string body = "<h1>" + escaped(document.title) + "</h1>\n";
  for (const auto& paragraph : document.lead) body += "<p>" + escaped(paragraph) + "</p>\n";
  for (const auto& part : document.parts) {
    body += "<h2>" + escaped(part.heading) + "</h2>\n";
    for (const auto& paragraph : part.paragraphs) body += "<p>" + escaped(paragraph) + "</p>\n";
    for (const auto& figure : part.figures) {
      if (figure.svg.empty()) continue;
      body += "<figure>" + figure.svg + "<figcaption>" + escaped(figure.caption) +
              "</figcaption></figure>\n";
    }
    for (const auto& table : part.tables) putTable(table, body);
  }
  return htmlPage(document.title, body);
}

}  // namespace study::report
