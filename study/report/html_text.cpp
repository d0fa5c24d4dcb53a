#include "study/report/html_text.h"

#include <algorithm>

namespace study::report {
namespace {

constexpr const char* kStyle = R"css(
body { font: 16px/1.5 Carlito, Calibri, "Source Sans 3", "Open Sans", "DejaVu Sans", sans-serif; color: #1a1a1a; background: #fff;
       max-width: 60rem; margin: 2rem auto; padding: 0 1.5rem; }
h1 { font-size: 1.9rem; line-height: 1.25; margin-bottom: .3rem; } .byline { color: #444; margin: 0 0 1.2rem; } h2 { font-size: 1.5rem; margin-top: 3rem;
     border-bottom: 2px solid #1f4e79; padding-bottom: .2rem; } h3 { font-size: 1.2rem; margin-top: 1.8rem; } h4 { font-size: 1rem; margin: 1.3rem 0 .3rem; }
table { border-collapse: collapse; margin: 1rem 0 1.4rem; font-size: .92rem; font-variant-numeric: tabular-nums; border-bottom: 2px solid #1a1a1a; } table + .note { margin-top: -1rem; margin-bottom: 1.6rem; }
caption { text-align: left; font-weight: 600; padding-bottom: .3rem; }
th, td { padding: .2rem .7rem; text-align: right; }
th:first-child, td:first-child { text-align: left; padding-left: 0; } thead th { border-top: 2px solid #1a1a1a; border-bottom: 1px solid #1a1a1a; }
td { white-space: nowrap; } td.words, th.words { text-align: left; } td.words, td:first-child { white-space: normal; } tr.yes td { font-weight: 600; }
.banner { background: #8a1c1c; color: #fff; padding: .6rem 1rem; border-radius: .3rem; font-weight: 600; }
.pilot { background: #7a5200; }
.note { color: #444; font-size: .92rem; } .verdict { font-size: 1.15rem; font-weight: 600; } dl.flags dt { font-weight: 600; }
dl.flags dd { margin: 0 0 .8rem 1.2rem; } dl.flags p { margin: .15rem 0; } .source { color: #444; font-size: .85rem; } .reference { font-size: .92rem; margin: .2rem 0; } li { margin: .25rem 0; }
details { border-top: 1px solid #ccc; padding: .2rem 0; } summary { cursor: pointer; } summary h3 { display: inline-block; margin: .6rem 0; }
figure { margin: 1rem 0 1.6rem; } figure svg { max-width: 100%; height: auto; } svg text { font-family: Carlito, Calibri, "Source Sans 3", "Open Sans", "DejaVu Sans", sans-serif; }
figcaption { color: #333; font-size: .92rem; } code { font-size: .85em; word-break: break-all; }
@media print { body { margin: 0; max-width: none; } table, figure { break-inside: avoid; } }
)css";

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string withCurlyQuotes(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool opens = i == 0 || text[i - 1] == ' ' || text[i - 1] == '(';
    if (text[i] == '\'') {
      result += opens ? "‘" : "’";
    } else {
      result += text[i];
    }
  }
  return result;
}

std::string withSubscripts(std::string html) {
  const auto lower = [&](std::string_view before, std::string_view plain) {
    std::string::size_type at = 0;
    while ((at = html.find(plain, at)) != std::string::npos) {
      const auto begin = at + before.size();
      const auto skipped = html[begin] == '_' ? begin + 1 : begin;
      const auto end = std::min(html.find(' ', begin), html.size());
      const std::string sub = "<sub>" + html.substr(skipped, end - skipped) + "</sub>";
      html.replace(begin, end - begin, sub);
      at = begin + sub.size();
    }
  };
  lower("p", "p_");
  lower("P", "P_");
  lower("g", "g_z");
  lower("BF", "BF10");
  return html;
}

std::string htmlPage(
    std::string_view title,
    std::string_view body,
    std::string_view language,
    std::string_view foot) {
  std::string html = "<!DOCTYPE html>\n<html lang=\"" + std::string(language) + "\">";
  html +=
      "<head><meta charset=\"utf-8\">"
      "<meta name=\"viewport\" content=\"width=device-width\"><title>";
  html += escaped(title);
  html += "</title>";
  if (!foot.empty()) html += "<meta name=\"foot\" content=\"" + escaped(foot) + "\">";
  html += "<style>";
  html += kStyle;
  html += "</style></head><body>\n";
  html += body;
  return html + "</body></html>\n";
}

}  // namespace study::report
