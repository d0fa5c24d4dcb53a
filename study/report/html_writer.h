#pragma once

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "study/report/html_text.h"
#include "study/report/report_section.h"
#include "study/results/apa_text.h"

namespace study::report {

/// Writes one part of a study's page. say() and count() translate with the section's words and
/// escape the text; put() takes markup.
class HtmlWriter {
 public:
  explicit HtmlWriter(const ReportSection& section) : s_(section) {}

 protected:
  template <typename... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    html_ += fmt::format(format, std::forward<Args>(args)...);
    html_ += '\n';
  }

  template <typename... Args>
  std::string say(std::string_view english, Args&&... args) const {
    return escaped(s_.words.say(english, std::forward<Args>(args)...));
  }

  template <typename Number, typename... Args>
  std::string count(
      Number number, std::string_view one, std::string_view many, Args&&... args) const {
    return escaped(s_.words.count(number, one, many, std::forward<Args>(args)...));
  }

  template <typename... Args>
  void heading(std::string_view english, Args&&... args) {
    put("<h3>{}</h3>", say(english, std::forward<Args>(args)...));
  }

  template <typename... Args>
  void paragraph(std::string_view english, Args&&... args) {
    put("<p>{}</p>", say(english, std::forward<Args>(args)...));
  }

  template <typename... Args>
  void note(std::string_view english, Args&&... args) {
    put("<p class=\"note\">{}</p>", say(english, std::forward<Args>(args)...));
  }

  /// Opens a table with a caption and a head; the first column holds names.
  /// @param key  for references, see reference(); empty: none
  void table(
      const std::string& caption,
      const std::vector<std::string>& columns,
      const std::string& key = {}) {
    std::string heads;
    for (const auto& column : columns) heads += "<th>" + column + "</th>";
    put("<table><caption{}>{}</caption><thead><tr>{}</tr></thead><tbody>",
        idOf(key),
        caption,
        heads);
  }
  void row(const std::vector<std::string>& cells) {
    std::string all;
    for (const auto& cell : cells) all += "<td>" + cell + "</td>";
    put("<tr>{}</tr>", all);
  }
  /// The text of a table cell; empty for an undefined value.
  static std::string cellOf(const std::optional<double>& value, int digits) {
    return value ? rounded(value, digits) : std::string();
  }
  std::string cellOf(const std::optional<analysis::Interval>& interval) const {
    return interval ? escaped(formatInterval(interval, s_.wording, s_.words)) : std::string();
  }
  std::string cellOfP(const std::optional<double>& p) const {
    return p ? escaped(formatP(p, s_.wording)) : std::string();
  }
  /// The part of a sentence that follows "p": "= .021" or "< .001".
  std::string equalsOfP(const std::optional<double>& p) const {
    return withRelationSign(formatP(p, s_.wording));
  }
  void rowOver(const std::string& text, std::size_t columns) {
    put("<tr><td colspan=\"{}\"><em>{}</em></td></tr>", columns, text);
  }
  void endTable() { put("</tbody></table>"); }

  /// @param caption  in English: the text below the figure, or in its place.
  /// @param key  for references; empty: none
  void figure(const std::string& svg, std::string_view caption, const std::string& key = {}) {
    if (svg.empty()) {
      put("<p class=\"note\">{} {}</p>",
          say("(No figure: this palpate was built without Qt.)"),
          say(caption));
      return;
    }
    captioned(svg, say(caption), key);
  }
  /// @param caption  in the language of the report, escaped.
  void captioned(const std::string& svg, const std::string& caption, const std::string& key) {
    put("<figure>{}<figcaption{}>{}</figcaption></figure>", svg, idOf(key), caption);
  }

  /// The number of a table or figure of this study: "Table 3" (numbering.h).
  static std::string reference(const std::string& key) { return "<a href=\"#" + key + "\"></a>"; }

  /// A sentence whose {} are replaced by references to the captions @p keys, in this order.
  std::string withReferences(std::string_view english, const std::vector<std::string>& keys) const {
    std::string text = say(english, "{}", "{}");
    for (const auto& key : keys) {
      const auto at = text.find("{}");
      if (at != std::string::npos) text.replace(at, 2, reference(key));
    }
    return text;
  }

  std::string condition(const std::string& id) const { return escaped(s_.conditionTitle(id)); }
  std::string cohort(const std::string& id) const { return escaped(s_.cohortTitle(id)); }

  const ReportSection& s_;
  std::string html_;

 private:
  static std::string idOf(const std::string& key) {
    return key.empty() ? std::string() : " id=\"" + key + "\"";
  }
};

}  // namespace study::report
