#include "study/report/html_report.h"

#include "study/report/html_text.h"
#include "study/report/numbering.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

/// The answer of a study, then everything else, folded.
std::string asHtml(const ReportSection& section) {
  std::string html = headAsHtml(section) + participantsAsHtml(section) + answerAsHtml(section);
  html += "<h2 class=\"appendix\">" + escaped(section.words("Appendix")) + "</h2>\n";
  for (const auto& part : appendixOf(section)) {
    html += "<details><summary><h3>" + escaped(part.heading) + "</h3></summary>\n" + part.html +
            "</details>\n";
  }
  return html;
}

}  // namespace

std::string asHtml(const std::vector<ReportSection>& sections) {
  const bool isOne = sections.size() == 1;
  const auto& words = sections.front().words;
  const std::string title =
      isOne ? sections.front().protocol.study.title : words("Face-validity studies");
  std::string body = isOne ? "" : "<h1>" + escaped(title) + "</h1>\n";
  Numbering numbering;
  for (const auto& section : sections) {
    const std::string element = isOne ? "h1" : "h2";
    body += "<" + element + ">" + escaped(section.protocol.study.title) + "</" + element + ">\n" +
            numbering.numbered(asHtml(section), section.words);
  }
  return htmlPage(title, body, words.language());
}

}  // namespace study::report
