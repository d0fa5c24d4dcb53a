#include "study/report/html_report.h"

#include "study/report/html_text.h"
#include "study/report/study_parts.h"

namespace study::report {

std::string asHtml(const std::vector<ReportSection>& sections) {
  const bool isOne = sections.size() == 1;
  const auto& words = sections.front().words;
  const std::string title =
      isOne ? sections.front().protocol.study.title : words("Face-validity studies");
  std::string body =
      "<h1>" + escaped(isOne ? words("Results of a face-validity study") : title) + "</h1>\n";
  for (const auto& section : sections) {
    for (const auto part : kStudyParts) body += part(section);
  }
  return htmlPage(title, body, words.language());
}

}  // namespace study::report
