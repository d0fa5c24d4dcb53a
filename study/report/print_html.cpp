#include "study/report/print_html.h"

#include <array>
#include <regex>
#include <string>
#include <string_view>
#include <utility>

namespace study::report {
namespace {

/// Only font sizes are in pt.
constexpr std::string_view kStyleOnPaper = R"css(
body { font-size: 9pt; }
h1 { margin-top: 0px; margin-bottom: 2px; } h2 { margin-top: 16px; } h3 { margin-top: 8px; margin-bottom: 2px; } h4 { margin-top: 8px; margin-bottom: 3px; }
p { margin-top: 3px; margin-bottom: 4px; } ul { margin-top: 1px; margin-bottom: 4px; } li { margin-bottom: 1px; }
p.byline { font-size: 8pt; margin-top: 0px; margin-bottom: 4px; }
p.note, p.figcaption { font-size: 8pt; color: #444444; }
p.note { margin-bottom: 10px; }
p.figcaption { margin-bottom: 8px; }
p.reference { font-size: 7.5pt; margin-top: 0px; margin-bottom: 2px; }
p.verdict { font-size: 10pt; font-weight: bold; margin-top: 10px; margin-bottom: 6px; }
p.banner { background-color: #8a1c1c; color: #ffffff; font-weight: bold; margin-top: 10px; margin-bottom: 12px; margin-left: 8px; margin-right: 8px; }
p.pilot { background-color: #7a5200; }
td, th { font-size: 8pt; padding-left: 4px; padding-right: 4px; }
td.caption { font-size: 8pt; padding-left: 0px; padding-top: 12px; }
code { font-size: 7pt; }
)css";

/// Tags of the page, and what replaces them on paper. The title of a flag becomes a heading,
/// because a heading stays on the page of what follows it.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kPaperElements{
    {{"<dl class=\"flags\">", ""},
     {"</dl>", ""},
     {"<dt>", "<h4>"},
     {"</dt>", "</h4>"},
     {"<dd>", ""},
     {"</dd>", ""},
     {"<figure>", "<p>"},
     {"<figcaption>", "</p><p class=\"figcaption\">"},
     {"</figcaption></figure>", "</p>"}}};

std::string styleOnPaper(double scale) {
  static const std::regex kSize("([0-9.]+)pt");
  std::string style;
  auto rest = kStyleOnPaper.begin();
  for (std::cregex_iterator size(kStyleOnPaper.begin(), kStyleOnPaper.end(), kSize), end;
       size != end;
       ++size) {
    style.append(rest, (*size)[1].first);
    style += std::to_string(scale * std::stod((*size)[1]));
    rest = (*size)[1].second;
  }
  return style.append(rest, kStyleOnPaper.end());
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// The range from the first @p begin to the end of the next @p end, both included; npos for both if
/// there is none.
struct Span {
  std::string::size_type begin = std::string::npos;
  std::string::size_type end = std::string::npos;
};

Span spanOf(
    const std::string& text, std::string_view begin, std::string_view end, std::size_t from) {
  const auto first = text.find(begin, from);
  if (first == std::string::npos) return {};
  const auto last = text.find(end, first);
  if (last == std::string::npos) return {};
  return {first, last + end.size()};
}

void extractFigures(PrintHtml& page) {
  for (auto span = spanOf(page.html, "<svg", "</svg>", 0); span.begin != std::string::npos;
       span = spanOf(page.html, "<svg", "</svg>", span.begin)) {
    page.figures.push_back(page.html.substr(span.begin, span.end - span.begin));
    page.html.replace(
        span.begin,
        span.end - span.begin,
        "<img src=\"figure:" + std::to_string(page.figures.size() - 1) + "\">");
  }
}

/// Removes the tags that begin with @p begin, up to @p end; what stands between tags stays.
void dropTags(std::string& html, std::string_view begin, std::string_view end = ">") {
  for (auto span = spanOf(html, begin, end, 0); span.begin != std::string::npos;
       span = spanOf(html, begin, end, span.begin)) {
    html.erase(span.begin, span.end - span.begin);
  }
}

/// Removes links to tables and figures, but keeps their numbers, and opens parts that are collapsed
/// on the screen.
void unlinkAndUnfold(std::string& html) {
  for (const std::string_view element : {"table", "figure"}) {
    const auto open = "<" + std::string(element) + " id=\"" + std::string(element) + "-";
    for (auto span = spanOf(html, open, "\"", 0); span.begin != std::string::npos;
         span = spanOf(html, open, "\"", span.begin)) {
      const auto end = html.find('>', span.begin);
      html.replace(span.begin, end - span.begin, "<" + std::string(element));
    }
  }
  dropTags(html, "<a href=\"#");
  for (const std::string_view tag :
       {"</a>", "<details>", "</details>", "<summary>", "</summary>"}) {
    replaceAll(html, tag, "");
  }
  replaceAll(html, "<h2 class=\"appendix\">", "<h2 style=\"page-break-before: always\">");
}

/// The number of columns in the first row of a table's head, searched from @p at.
int columnCountAt(const std::string& html, std::size_t at) {
  const auto end = html.find("</tr>", at);
  int columns = 0;
  for (auto cell = html.find("<th", html.find("<tr>", at)); cell < end;
       cell = html.find("<th", cell + 1)) {
    constexpr std::string_view kSpan = "<th colspan=\"";
    columns += html.compare(cell, kSpan.size(), kSpan) == 0
                   ? std::stoi(html.substr(cell + kSpan.size()))
                   : 1;
  }
  return columns;
}

/// Moves a caption into the first row of its table's head, so that they stay on one page.
void moveCaptionsIntoHeads(std::string& html) {
  constexpr std::string_view kTable = "<table><caption>";
  constexpr std::string_view kEnd = "</caption><thead>";
  for (auto span = spanOf(html, kTable, kEnd, 0); span.begin != std::string::npos;
       span = spanOf(html, kTable, kEnd, span.begin + 1)) {
    const auto words = html.substr(
        span.begin + kTable.size(), span.end - kEnd.size() - span.begin - kTable.size());
    html.replace(
        span.begin,
        span.end - span.begin,
        "<table border=\"0\" cellspacing=\"0\" cellpadding=\"0\"><thead><tr><td class=\"caption\" "
        "colspan=\"" +
            std::to_string(columnCountAt(html, span.end)) + "\" align=\"left\">" + words +
            "</td></tr>");
  }
}

/// Aligns cells: the first of a row begins where the text does.
void alignCells(std::string& html) {
  constexpr std::string_view kFirst = " align=\"left\" style=\"padding-left: 0px\">";
  for (const std::string_view cell : {"td", "th"}) {
    const auto open = "<" + std::string(cell) + ">";
    const auto first = "<" + std::string(cell) + std::string(kFirst);
    replaceAll(html, "<tr>" + open, "<tr>" + first);
    replaceAll(html, "<tr>\n" + open, "<tr>\n" + first);
    replaceAll(html, "<tr class=\"yes\">" + open, "<tr style=\"font-weight: bold\">" + first);
    replaceAll(html, open, "<" + std::string(cell) + " align=\"right\">");
  }
  const auto words = "<td" + std::string(kFirst);
  replaceAll(html, "<tr><td class=\"words\">", "<tr>" + words);
  replaceAll(html, "<tr><td class=\"words\" ", "<tr>" + words.substr(0, words.size() - 1) + " ");
  replaceAll(html, "<th class=\"words\">", "<th align=\"left\">");
}

/// Keeps both ends of an interval on one line: "[0.41, 2.42]".
void keepIntervalsOnOneLine(std::string& html) {
  constexpr std::string_view kStops = ", ]";
  for (auto open = html.find('['); open != std::string::npos; open = html.find('[', open + 1)) {
    const auto gap = html.find_first_of(kStops, open + 1);
    if (gap == std::string::npos || gap == open + 1 || html.compare(gap, 2, ", ") != 0) continue;
    const auto end = html.find_first_of(kStops, gap + 2);
    if (end == std::string::npos || end == gap + 2 || html[end] != ']') continue;
    html.replace(gap, 2, ",&nbsp;");
  }
}

/// Prevents line breaks within "500 N/s", "F(3, 9)", "107–128", "round 1", "(0 to 100)".
void keepNumbersTogether(std::string& html) {
  static const std::regex kBeforeUnit("([0-9]) (N|s|mm|µs)(?=[ ,.;:)/·])");
  static const std::regex kWithinUnit("(N|N·m|mm)/s(?![a-z])");
  static const std::regex kDegrees("([A-Zt]\\([0-9.]+), (?=[0-9.]+\\))");
  static const std::regex kPages("([0-9])–(?=[0-9])");
  static const std::regex kRound("(round|Runde|runde) (?=[0-9])");
  static const std::regex kRange("\\(([−0-9.]+) to ([0-9.]+)\\)");
  html = std::regex_replace(html, kBeforeUnit, "$1&nbsp;$2");
  html = std::regex_replace(html, kWithinUnit, "$1/&#8288;s");
  html = std::regex_replace(html, kDegrees, "$1,&nbsp;");
  html = std::regex_replace(html, kPages, "$1–&#8288;");
  html = std::regex_replace(html, kRound, "$1&nbsp;");
  html = std::regex_replace(html, kRange, "($1&nbsp;to&nbsp;$2)");
}

/// Prevents line breaks within "p = .021", "[0.41, 2.42]", "95 %". Long codes may break anywhere.
void preventLineBreaks(std::string& html) {
  keepNumbersTogether(html);
  for (const std::string_view sign : {"=", "&lt;", "&gt;"}) {
    replaceAll(html, " " + std::string(sign) + " ", "&nbsp;" + std::string(sign) + "&nbsp;");
  }
  replaceAll(html, "&nbsp;.", "&nbsp;.&#8288;");  // Qt 6.4 would break before the digits
  replaceAll(html, " %", "&nbsp;%");
  replaceAll(html, "doi:", "doi:&#8288;");
  replaceAll(html, "-%-", "&#8209;%&#8209;");
  keepIntervalsOnOneLine(html);
  for (auto span = spanOf(html, "<code>", "</code>", 0); span.begin != std::string::npos;
       span = spanOf(html, "<code>", "</code>", span.end)) {
    constexpr std::size_t kPiece = 8;
    constexpr std::string_view kMayBreak = "&#8203;";
    const auto first = span.begin + std::string_view("<code>").size() + kPiece;
    for (auto at = first; at + std::string_view("</code>").size() < span.end;
         at += kPiece + kMayBreak.size()) {
      html.insert(at, kMayBreak);
      span.end += kMayBreak.size();
    }
  }
}

}  // namespace

PrintHtml toPrintHtml(std::string_view html, double scale) {
  PrintHtml page{.html = std::string(html), .figures = {}};
  auto& text = page.html;
  constexpr std::string_view kLanguage = "<html lang=\"";
  if (const auto at = spanOf(text, kLanguage, "\"", 0); at.begin != std::string::npos) {
    const auto begin = at.begin + kLanguage.size();
    page.language = text.substr(begin, text.find('"', begin) - begin);
  }
  constexpr std::string_view kFoot = "<meta name=\"foot\" content=\"";
  if (const auto at = spanOf(text, kFoot, "\">", 0); at.begin != std::string::npos) {
    const auto begin = at.begin + kFoot.size();
    page.foot = text.substr(begin, at.end - 2 - begin);
    for (const auto& [entity, sign] :
         {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}}) {
      replaceAll(page.foot, entity, sign);
    }
  }
  extractFigures(page);
  if (const auto style = spanOf(text, "<style>", "</style>", 0); style.begin != std::string::npos) {
    text.replace(
        style.begin, style.end - style.begin, "<style>" + styleOnPaper(scale) + "</style>");
  }
  unlinkAndUnfold(text);
  moveCaptionsIntoHeads(text);
  alignCells(text);
  for (const auto& [screen, paper] : kPaperElements) replaceAll(text, screen, paper);
  preventLineBreaks(text);
  return page;
}

}  // namespace study::report
