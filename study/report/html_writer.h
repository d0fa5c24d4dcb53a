#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "study/report/html_text.h"
#include "study/report/report_section.h"
#include "study/results/apa_text.h"

namespace study::report {

/// Symbols of statistics, in italics as the APA asks.
inline constexpr const char* kM = "<i>M</i>";
inline constexpr const char* kN = "<i>n</i>";
inline constexpr const char* kP = "<i>p</i>";
inline constexpr const char* kT = "<i>t</i>";
inline constexpr const char* kDf = "<i>df</i>";
inline constexpr const char* kW = "<i>W</i>";

/// Writes one part of a study's page. say() and count() translate with the section's words and
/// escape the text; put() takes markup.
class HtmlWriter {
 public:
  explicit HtmlWriter(const ReportSection& section) : section_(section) {}

 protected:
  template <typename... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    html_ += fmt::format(format, std::forward<Args>(args)...);
    html_ += '\n';
  }

  template <typename... Args>
  std::string say(std::string_view english, Args&&... args) const {
    return escaped(withCurlyQuotes(section_.words.say(english, std::forward<Args>(args)...)));
  }

  template <typename Number, typename... Args>
  std::string count(
      Number number, std::string_view one, std::string_view many, Args&&... args) const {
    return escaped(
        withCurlyQuotes(section_.words.count(number, one, many, std::forward<Args>(args)...)));
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

  /// Begins a table; endTable() writes it. The first column holds names.
  /// @param columns  the headings. Numbers are aligned right, cells below textHeading() left.
  /// @param key  for references, see reference(); empty: none
  void table(
      const std::string& caption,
      const std::vector<std::string>& columns,
      const std::string& key = {}) {
    caption_ = "<table><caption" + idOf(key) + ">" + caption;
    columns_ = columns;
    rows_.clear();
    group_.clear();
  }
  /// The heading of a column of words.
  static std::string textHeading(const std::string& heading) {
    return std::string(kTextHeading) + heading;
  }
  /// @param words  a text in one wide cell that spans the columns for which @p cells has no entry,
  ///               such as why there are no numbers
  void row(std::vector<std::string> cells, std::string words = {}) {
    if (!group_.empty()) rows_.push_back({{}, std::exchange(group_, {})});
    rows_.push_back({std::move(cells), std::move(words)});
  }
  void rowOver(const std::string& text) { row({}, "<em>" + text + "</em>"); }
  /// A line above the next rows, if any follow.
  void group(const std::string& text) { group_ = "<em>" + text + "</em>"; }
  /// Writes the table without the columns in which no row has a cell; nothing if no row has any.
  void endTable() {
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto hasCell = [&](const auto& row) {
        return i < row.first.size() && !row.first[i].empty();
      };
      if (i == 0 || std::ranges::any_of(rows_, hasCell)) used.push_back(i);
    }
    if (std::ranges::all_of(rows_, [](const auto& row) { return row.first.empty(); })) return;
    std::string heads;
    for (const auto i : used) {
      const bool isText = columns_[i].starts_with(kTextHeading);
      heads += (isText ? "" : "<th>") + columns_[i] + "</th>";
    }
    put("{}</caption><thead><tr>{}</tr></thead><tbody>", caption_, heads);
    for (const auto& [cells, words] : rows_) {
      std::string all;
      std::size_t written = 0;
      for (const auto i : used) {
        if (i >= cells.size()) break;
        const bool isText = columns_[i].starts_with(kTextHeading);
        all += (isText ? "<td class=\"words\">" : "<td>") + cells[i] + "</td>";
        ++written;
      }
      if (!words.empty()) {
        all +=
            fmt::format("<td class=\"words\" colspan=\"{}\">{}</td>", used.size() - written, words);
      }
      put("<tr>{}</tr>", all);
    }
    put("</tbody></table>");
  }
  /// The text of a table cell; empty for an undefined value.
  static std::string cellOf(const std::optional<double>& value, int digits) {
    return value ? rounded(value, digits) : std::string();
  }
  /// "3.41 (1.09)"; the deviation of one value is not defined.
  static std::string withDeviation(
      const std::optional<double>& mean, const std::optional<double>& deviation) {
    return cellOf(mean, 2) + (deviation ? " (" + rounded(deviation, 2) + ")" : std::string());
  }
  std::string cellOf(const std::optional<analysis::Interval>& interval) const {
    return interval ? escaped(formatInterval(interval, section_.wording, section_.words))
                    : std::string();
  }
  std::string cellOfP(const std::optional<double>& p) const {
    return p ? escaped(formatP(p, section_.wording)) : std::string();
  }
  /// The part of a sentence that follows "p": "= .021" or "< .001".
  std::string equalsOfP(const std::optional<double>& p) const {
    return withRelationSign(formatP(p, section_.wording));
  }
  /// @param caption  in English: the text below the figure, or in its place.
  /// @param key  for references; empty: none
  void figure(const std::string& svg, std::string_view caption, const std::string& key = {}) {
    putFigure(svg, say(caption), key);
  }
  /// @param caption  in the language of the report, escaped.
  void putFigure(const std::string& svg, const std::string& caption, const std::string& key = {}) {
    const auto missing = say("(No figure: this palpate was built without Qt.)");
    if (svg.empty()) return put("<p class=\"note\">{} {}</p>", missing, caption);
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

  /// A caption, followed by the scale of what a family compares.
  std::string withScale(const std::string& caption, const protocols::Family& family) const {
    const auto scale = scaleInWords(section_, family);
    return scale.empty() ? caption : caption + "; " + escaped(scale);
  }

  /// A message, with titles in place of the ids in it.
  std::string inWords(const base::Message& message) const {
    return escaped(withCurlyQuotes(section_.inWords(message)));
  }
  std::string notDefined(const base::Message& reason) const {
    return escaped(section_.words.say("not defined: {}", section_.inWords(reason)));
  }
  std::string condition(const std::string& id) const {
    return escaped(section_.conditionTitle(id));
  }
  std::string cohort(const std::string& id) const { return escaped(section_.cohortTitle(id)); }

  const ReportSection& section_;
  std::string html_;

 private:
  static constexpr std::string_view kTextHeading = "<th class=\"words\">";

  static std::string idOf(const std::string& key) {
    return key.empty() ? std::string() : " id=\"" + key + "\"";
  }

  std::string caption_;  ///< of the table that was begun, with its tag
  std::string group_;    ///< to be written above the next row; empty: none
  std::vector<std::string> columns_;
  std::vector<std::pair<std::vector<std::string>, std::string>> rows_;
};

}  // namespace study::report
