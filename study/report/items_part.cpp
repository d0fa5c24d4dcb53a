#include <algorithm>

#include "questionnaires/model/answer.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

/// Writes the part of a report that shows the answers to each item, and what participants wrote.
class ItemsWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    for (const auto& instrument : s_.instruments) {
      numbers(instrument);
      choices(instrument);
      figures(instrument);
    }
    if (html_.empty()) return {};
    note(
        "Answers as they were given, not reversed. Numbers are of participants’ means; choices are "
        "counted by form. Choices between alternatives are among the preferences.");
    return std::move(html_);
  }

  std::string quotes() {
    if (!s_.hasQuotes) return {};
    for (const auto& instrument : s_.instruments) quotesOf(instrument);
    return std::move(html_);
  }

 private:
  template <typename Condition>
  std::vector<const ItemSummary*> summariesOf(
      const questionnaires::Instrument& instrument, Condition&& isWanted) const {
    std::vector<const ItemSummary*> found;
    for (const auto& summary : s_.results.answers.items) {
      if (summary.instrument == instrument.id && isWanted(summary)) found.push_back(&summary);
    }
    return found;
  }

  std::string titleOf(const questionnaires::Instrument& instrument) const {
    return escaped(instrument.title.in(s_.words.language()));
  }

  /// The question; for an item with two opposite words, both words.
  std::string questionOf(
      const questionnaires::Instrument& instrument, const std::string& id) const {
    const auto* item = instrument.item(id);
    if (item == nullptr) return escaped(id);
    const auto& language = s_.words.language();
    const auto& text = item->text.in(language);
    if (!text.empty() && text.find("[[") == std::string::npos) return escaped(text);
    const auto& left = item->leftText.in(language);
    return left.empty() ? escaped(id) : escaped(left + " – " + item->rightText.in(language));
  }

  std::string aboutOf(const std::string& id) const {
    return id.empty() ? std::string() : condition(id);
  }

  void numbers(const questionnaires::Instrument& instrument) {
    const auto rows = summariesOf(instrument, [](const auto& one) { return one.mean.has_value(); });
    if (rows.empty()) return;
    table(
        titleOf(instrument) + say(": every item by itself"),
        {say("Cohort"), say("About"), "n", say("Mean"), say("SD"), say("Median"), say("Range")});
    constexpr std::size_t kColumns = 7;
    const std::string* item = nullptr;
    for (const auto* one : rows) {
      if (item == nullptr || *item != one->item) {
        rowOver(questionOf(instrument, one->item), kColumns);
      }
      item = &one->item;
      row(
          {cohort(one->cohort),
           aboutOf(one->condition),
           std::to_string(one->values.size()),
           rounded(one->mean, 2),
           cellOf(one->standardDeviation, 2),
           rounded(one->median, 2),
           fmt::format("{:.4g} … {:.4g}", *one->least, *one->most)});
    }
    endTable();
  }

  void choices(const questionnaires::Instrument& instrument) {
    const auto rows = summariesOf(instrument, [](const auto& one) { return !one.options.empty(); });
    if (rows.empty()) return;
    table(
        titleOf(instrument) + say(": how often each option was chosen"),
        {say("Cohort"), say("About"), "n", say("Chosen")});
    constexpr std::size_t kColumns = 4;
    const std::string* item = nullptr;
    for (const auto* one : rows) {
      if (item == nullptr || *item != one->item) {
        rowOver(questionOf(instrument, one->item), kColumns);
      }
      item = &one->item;
      put("<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"words\">{}</td></tr>",
          cohort(one->cohort),
          aboutOf(one->condition),
          one->answers,
          chosenIn(instrument, *one));
    }
    endTable();
  }

  /// The figures of an instrument's items, with a sentence that refers to them.
  void figures(const questionnaires::Instrument& instrument) {
    std::string references;
    for (const auto& one : s_.figures.items) {
      if (one.instrument != instrument.id) continue;
      references += (references.empty() ? "" : ", ") + reference(keyOf(one));
    }
    if (references.empty()) return;
    put("<p>{} {}.</p>", say("Its answers by alternative:"), references);
    for (const auto& one : s_.figures.items) {
      if (one.instrument != instrument.id) continue;
      const bool isChoice = !instrument.item(one.item)->options.empty();
      const auto* caption =
          isChoice ? "“{}”: how often each answer was given, by cohort and alternative."
                   : "“{}”: a dot is the mean of one participant’s answers; the box holds "
                     "the middle half, with the median; the diamond is the mean.";
      captioned(
          one.svg,
          fmt::format(fmt::runtime(escaped(s_.words(caption))), questionOf(instrument, one.item)),
          keyOf(one));
    }
  }

  static std::string keyOf(const ItemFigure& figure) {
    return "item-" + figure.instrument + "-" + figure.item;
  }

  /// "left 3, right 12", without the options that nobody chose.
  std::string chosenIn(
      const questionnaires::Instrument& instrument, const ItemSummary& summary) const {
    const auto* item = instrument.item(summary.item);
    std::string text;
    for (const auto& [id, times] : summary.options) {
      if (times == 0) continue;
      const auto label =
          item == nullptr ? id : questionnaires::labelOf(*item, id, s_.words.language());
      text +=
          (text.empty() ? "" : ", ") + (label.empty() ? id : label) + " " + std::to_string(times);
    }
    return escaped(text);
  }

  void quotesOf(const questionnaires::Instrument& instrument) {
    const std::string* item = nullptr;
    const std::string* about = nullptr;
    const auto& quotes = s_.results.answers.quotes;
    for (auto at = quotes.begin(); at != quotes.end();) {
      const auto& quote = *at;
      const auto next = std::find_if(at, quotes.end(), [&](const auto& q) { return q != quote; });
      const auto times = next - at;
      at = next;
      if (quote.instrument != instrument.id) continue;
      const bool isNewItem = item == nullptr || *item != quote.item;
      const bool isNew = isNewItem || *about != quote.condition;
      if (isNew && item != nullptr) put("</ul>");
      if (isNewItem) put("<h4>{}</h4>", questionOf(instrument, quote.item));
      if (isNew && !quote.condition.empty()) put("<p><em>{}</em></p>", condition(quote.condition));
      if (isNew) put("<ul>");
      put("<li>“{}”{}</li>", escaped(quote.text), times > 1 ? fmt::format(" × {}", times) : "");
      item = &quote.item;
      about = &quote.condition;
    }
    if (item != nullptr) put("</ul>");
  }
};

}  // namespace

std::string itemsAsHtml(const ReportSection& section) {
  return ItemsWriter(section).all();
}

std::string quotesAsHtml(const ReportSection& section) {
  return ItemsWriter(section).quotes();
}

}  // namespace study::report
