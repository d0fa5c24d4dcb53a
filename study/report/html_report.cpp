#include "study/report/html_report.h"

#include <algorithm>

#include "study/report/html_text.h"
#include "study/report/numbering.h"
#include "study/report/study_parts.h"
#include "study/session/study.h"

namespace study::report {
namespace {

/// The keys of the captions in @p html whose tag is @p caption; those that have none get one that
/// begins with @p prefix.
std::vector<std::string> keysOf(
    std::string& html, std::string_view caption, const std::string& prefix) {
  constexpr std::string_view kId = " id=\"";
  std::vector<std::string> keys;
  for (auto at = html.find(caption); at != std::string::npos; at = html.find(caption, at + 1)) {
    const auto end = at + caption.size();
    if (html[end] == '>') {
      html.insert(end, std::string(kId) + prefix + std::to_string(keys.size()) + '"');
    }
    const auto begin = end + kId.size();
    keys.push_back(html.substr(begin, html.find('"', begin) - begin));
  }
  return keys;
}

/// "Table A3 to Table A5".
std::string rangeOf(const std::vector<std::string>& keys, const words::Words& words) {
  const auto reference = [](const std::string& key) { return "<a href=\"#" + key + "\"></a>"; };
  if (keys.size() == 1) return reference(keys.front());
  return reference(keys.front()) + " " + escaped(words("to")) + " " + reference(keys.back());
}

/// The parts of the appendix, each with its tables and figures.
std::string contentsOf(std::vector<AppendixPart>& parts, const words::Words& words) {
  std::string items;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    items += "<li>" + escaped(parts[i].heading);
    std::string before = ": ";
    for (const std::string caption : {"<caption", "<figcaption"}) {
      const auto prefix = "part-" + std::to_string(i) + "-" + caption.substr(1) + "-";
      const auto keys = keysOf(parts[i].html, caption, prefix);
      if (keys.empty()) continue;
      items += before + rangeOf(keys, words);
      before = "; ";
    }
    items += "</li>";
  }
  return "<ul>" + items + "</ul>\n";
}

/// The page of one study: first the answer, then all other parts, which are collapsed.
std::string asHtml(const ReportSection& section) {
  std::string html = headAsHtml(section) + participantsAsHtml(section) + answerAsHtml(section);
  auto parts = appendixOf(section);
  html += "<h2 class=\"appendix\">" + escaped(section.words("Appendix")) + "</h2>\n" +
          contentsOf(parts, section.words);
  for (const auto& part : parts) {
    html += "<details><summary><h3>" + escaped(part.heading) + "</h3></summary>\n" + part.html +
            "</details>\n";
  }
  return html;
}

std::string daysOf(const ReportSection& section) {
  if (section.results.runMode == RunMode::Simulated) return {};
  return section.firstDay == section.lastDay ? section.firstDay
                                             : section.firstDay + " – " + section.lastDay;
}

/// Who made the study, when, and with which version: "NTNU · 2026-11-02 – 2026-11-26 · palpate
/// 0.2".
std::string bylineOf(const ReportSection& section) {
  std::string line;
  for (const auto& part : section.protocol.study.organizations) line += part + " · ";
  const auto days = daysOf(section);
  if (!days.empty()) line += days + " · ";
  line += section.protocol.study.id + " " + section.protocol.study.version + " · palpate " +
          std::string(appVersion());
  return "<p class=\"byline\">" + escaped(line) + "</p>\n";
}

/// The footer of every page, so that a single printed page says from which study it is, when the
/// sessions were, and whether they were simulated or pilot sessions.
std::string footOf(const std::vector<ReportSection>& sections, const std::string& title) {
  const auto hasMode = [&](RunMode mode) {
    return std::ranges::any_of(
        sections, [&](const auto& section) { return section.results.runMode == mode; });
  };
  const auto& first = sections.front();
  std::string foot;
  if (hasMode(RunMode::Simulated)) foot += first.words("SIMULATED") + " · ";
  if (hasMode(RunMode::Pilot)) foot += first.words("PILOT") + " · ";
  foot += title;
  const auto days = daysOf(first);
  return sections.size() == 1 && !days.empty() ? foot + " · " + days : foot;
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
            bylineOf(section) + numbering.numbered(asHtml(section), section.words);
  }
  return htmlPage(title, body, words.language(), footOf(sections, title));
}

}  // namespace study::report
