#include <algorithm>
#include <set>

#include "questionnaires/model/answer.h"
#include "study/export/k_anonymity.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr std::size_t kFewestPeople = 2;  // a number of one person is that person's answer

/// Writes the part of a report that shows the answers to each item, and what participants wrote.
class ItemsWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    for (const auto& instrument : section_.instruments) {
      numbers(instrument);
      numbersByAlternative(instrument);
      choices(instrument);
      figures(instrument);
    }
    const auto leftOut = count(
        leftOut_,
        "{} row is left out, because its numbers would be of one person alone.",
        "{} rows are left out, because their numbers would be of one person alone.");
    if (html_.empty() && leftOut_ == 0) return {};
    if (leftOut_ > 0) put("<p class=\"note\">{}</p>", leftOut);
    if (leftOut_ > 0 && !hasTable_) return std::move(html_);
    note(
        "Answers as they were given, not reversed. Numbers are of participants’ means; choices are "
        "counted by form. Choices between alternatives are among the preferences.");
    if (isAnythingHidden_) {
      note(
          "To protect anonymity, these tables have no mean of one person alone, and options that "
          "one person chose are counted together as “other answers”. What all of a cohort answered "
          "alike is the answer of each. Other tables and figures, of ratings, scores and votes, "
          "show single people too.");
    }
    return std::move(html_);
  }

  std::string quotes() {
    if (!section_.hasQuotes) return {};
    for (const auto& instrument : section_.instruments) quotesOf(instrument, false);
    const auto own = std::exchange(html_, {});
    for (const auto& instrument : section_.instruments) quotesOf(instrument, true);
    const auto title = say("What the operator wrote down");
    if (html_.empty()) return own;
    return own + "<h4>" + title + "</h4>\n" + html_;
  }

 private:
  template <typename Condition>
  std::vector<const ItemSummary*> summariesOf(
      const questionnaires::Instrument& instrument, Condition&& isWanted) const {
    std::vector<const ItemSummary*> found;
    for (const auto& summary : section_.results.answers.items) {
      if (summary.instrument == instrument.id && isWanted(summary)) found.push_back(&summary);
    }
    return found;
  }

  std::string titleOf(const questionnaires::Instrument& instrument) const {
    return escaped(instrument.title.in(section_.words.language()));
  }

  std::string questionOf(
      const questionnaires::Instrument& instrument, const std::string& id) const {
    const auto* item = instrument.item(id);
    return escaped(item == nullptr ? id : report::questionOf(*item, section_.words.language()));
  }

  /// Numbers that are not about an alternative: a row for each question, a column for each cohort.
  void numbers(const questionnaires::Instrument& instrument) {
    const auto summaries =
        summariesOf(instrument, [](const auto& one) { return one.mean && one.condition.empty(); });
    const auto& cohorts = section_.results.flow;
    // The different numbers of participants whose means a cohort's column has.
    std::vector<std::set<std::size_t>> people(cohorts.size());
    std::vector<std::pair<std::string, std::vector<std::string>>> questions;  // cell by cohort
    std::vector<std::vector<std::size_t>> sizes;                              // n of each cell
    for (const auto* one : summaries) {
      if (questions.empty() || questions.back().first != one->item) {
        questions.emplace_back(one->item, std::vector<std::string>(cohorts.size()));
        sizes.emplace_back(cohorts.size());
      }
      const auto place = static_cast<std::size_t>(
          std::ranges::find(cohorts, one->cohort, &CohortFlow::cohort) - cohorts.begin());
      const auto mean = meanOf(*one);
      questions.back().second[place] = mean;
      sizes.back()[place] = one->values.size();
      if (!mean.empty()) people[place].insert(one->values.size());
    }
    const auto ofPeople = [](std::size_t n) { return fmt::format(", {} = {}", kN, n); };
    std::vector<std::string> columns{say("Question")};
    for (std::size_t i = 0; i < cohorts.size(); ++i) {
      const bool isSame = people[i].size() == 1;
      columns.push_back(
          cohort(cohorts[i].cohort) + (isSame ? ofPeople(*people[i].begin()) : std::string()));
    }
    table(captionOfNumbers(instrument, summaries), columns);
    const bool areEndsCommon = haveSameEnds(itemsOf(instrument, summaries));
    for (std::size_t q = 0; q < questions.size(); ++q) {
      auto& [item, cells] = questions[q];
      if (std::ranges::all_of(cells, [](const auto& cell) { return cell.empty(); })) {
        ++leftOut_;
        continue;
      }
      hasTable_ = true;
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (!cells[i].empty() && people[i].size() > 1) cells[i] += ofPeople(sizes[q][i]);
      }
      cells.insert(
          cells.begin(),
          questionOf(instrument, item) +
              (areEndsCommon ? std::string() : endsInBrackets(*instrument.item(item))));
      row(cells);
    }
    endTable();
  }

  /// A row for each question and cohort, a column for each alternative.
  void numbersByAlternative(const questionnaires::Instrument& instrument) {
    std::vector<std::string> columns{say("Cohort"), kN};
    for (const auto& one : section_.protocol.conditions) columns.push_back(escaped(one.title));
    const auto rows =
        summariesOf(instrument, [](const auto& one) { return one.mean && !one.condition.empty(); });
    table(captionOfNumbers(instrument, rows), columns);
    const std::string* item = nullptr;
    for (auto at = rows.begin(); at != rows.end();) {
      const auto& first = **at;
      if (item == nullptr || *item != first.item) group(questionOf(instrument, first.item));
      item = &first.item;
      std::size_t people = 0;
      std::vector<std::string> cells(columns.size());
      for (; at != rows.end() && (*at)->item == first.item && (*at)->cohort == first.cohort; ++at) {
        people = std::max(people, (*at)->values.size());
        cells[static_cast<std::size_t>(section_.conditionIndex((*at)->condition)) + 2] =
            meanOf(**at);
      }
      cells[0] = cohort(first.cohort);
      cells[1] = std::to_string(people);
      if (people < kFewestPeople) {
        ++leftOut_;
        continue;
      }
      hasTable_ = true;
      row(cells);
    }
    endTable();
  }

  static std::vector<const questionnaires::Item*> itemsOf(
      const questionnaires::Instrument& instrument,
      const std::vector<const ItemSummary*>& summaries) {
    std::vector<const questionnaires::Item*> items;
    for (const auto* one : summaries) {
      if (const auto* item = instrument.item(one->item)) items.push_back(item);
    }
    return items;
  }

  bool haveSameEnds(const std::vector<const questionnaires::Item*>& items) const {
    const auto& language = section_.words.language();
    return std::ranges::all_of(items, [&](const auto* item) {
      return endsOf(*item, language) == endsOf(*items.front(), language);
    });
  }

  /// " (Perfect – Failure)"; empty if the scale has no words, or if they are the question.
  std::string endsInBrackets(const questionnaires::Item& item) const {
    const auto [low, high] = endsOf(item, section_.words.language());
    const bool isQuestion = item.text.in(section_.words.language()).empty();
    return low.empty() || high.empty() || isQuestion ? std::string()
                                                     : escaped(" (" + low + " – " + high + ")");
  }

  std::string captionOfNumbers(
      const questionnaires::Instrument& instrument,
      const std::vector<const ItemSummary*>& summaries) const {
    const auto scale = scaleInWords(itemsOf(instrument, summaries), section_.words);
    return titleOf(instrument) + say(": every item by itself, M with SD in brackets") +
           (scale.empty() ? scale : "; " + escaped(scale));
  }

  /// The mean of several people with its deviation; empty for one person.
  std::string meanOf(const ItemSummary& summary) {
    const bool isHidden = summary.values.size() < kFewestPeople;
    isAnythingHidden_ = isAnythingHidden_ || isHidden;
    return isHidden ? std::string() : withDeviation(summary.mean, summary.standardDeviation);
  }

  void choices(const questionnaires::Instrument& instrument) {
    const auto rows = summariesOf(instrument, [](const auto& one) { return !one.options.empty(); });
    table(
        titleOf(instrument) + say(": how often each option was chosen"),
        {say("Cohort"), textHeading(say("About")), kN, textHeading(say("Chosen"))});
    const std::string* item = nullptr;
    for (const auto* one : rows) {
      if (item == nullptr || *item != one->item) group(questionOf(instrument, one->item));
      item = &one->item;
      const auto chosen = chosenIn(instrument, *one);
      if (chosen.empty()) {
        ++leftOut_;
        continue;
      }
      hasTable_ = true;
      row(
          {cohort(one->cohort),
           one->condition.empty() ? std::string() : condition(one->condition),
           std::to_string(one->answers),
           chosen});
    }
    endTable();
  }

  /// The figures of an instrument's items, with a sentence that refers to them.
  void figures(const questionnaires::Instrument& instrument) {
    std::string references;
    for (const auto& one : section_.figures.items) {
      if (one.instrument != instrument.id) continue;
      references += (references.empty() ? "" : ", ") + reference(keyOf(one));
    }
    if (references.empty()) return;
    put("<p>{} {}.</p>", say("Its answers by alternative:"), references);
    for (const auto& one : section_.figures.items) {
      if (one.instrument != instrument.id) continue;
      const bool isChoice = !instrument.item(one.item)->options.empty();
      const auto* caption =
          isChoice
              ? "“{}”: how often each answer was given, by cohort and alternative."
              : "“{}”, by participants’ means: the box holds the middle half, with the median; the "
                "diamond is the mean. Dots are single people, where there are at most fifty.";
      captioned(
          one.svg,
          fmt::format(
              fmt::runtime(escaped(section_.words(caption))), questionOf(instrument, one.item)),
          keyOf(one));
    }
  }

  static std::string keyOf(const ItemFigure& figure) {
    return "item-" + figure.instrument + "-" + figure.item;
  }

  /// "left (3), right (12)", without options that were not chosen; empty if one person answered. In
  /// answers about the participants themselves, rare options are hidden as in a public release.
  std::string chosenIn(const questionnaires::Instrument& instrument, const ItemSummary& summary) {
    const auto* item = instrument.item(summary.item);
    Values chosen;
    for (const auto& [id, times] : summary.options) chosen.insert(chosen.end(), times, id);
    if (summary.condition.empty()) chosen = suppressRareValues(chosen, kFewestPeople);
    std::string text;
    const auto add = [&](const std::string& label, std::ptrdiff_t times) {
      if (times > 0) text += (text.empty() ? "" : ", ") + label + fmt::format(" ({})", times);
    };
    for (const auto& [id, times] : summary.options) {
      const auto label =
          item == nullptr ? id : questionnaires::labelOf(*item, id, section_.words.language());
      add(label.empty() ? id : label, std::ranges::count(chosen, id));
    }
    const auto others = std::ranges::count(chosen, "");
    isAnythingHidden_ = isAnythingHidden_ || others > 0;
    if (text.empty() && others < static_cast<std::ptrdiff_t>(kFewestPeople)) return text;
    add(section_.words("other answers"), others);
    return escaped(text);
  }

  /// A paragraph for each question and alternative.
  /// @param areNotes  of the operator, instead of what participants wrote
  void quotesOf(const questionnaires::Instrument& instrument, bool areNotes) {
    const auto& quotes = section_.results.answers.quotes;
    for (auto at = quotes.begin(); at != quotes.end();) {
      const auto& first = *at;
      const auto end = std::find_if(at, quotes.end(), [&](const auto& q) {
        return q.instrument != first.instrument || q.item != first.item ||
               q.condition != first.condition || q.isNote != first.isNote;
      });
      std::string said;
      while (at != end) {
        const auto next = std::find_if(at, end, [&](const auto& q) { return q != *at; });
        said += (said.empty() ? "“" : " · “") + escaped(at->text) + "”";
        if (next - at > 1) said += fmt::format(" × {}", next - at);
        at = next;
      }
      if (first.instrument != instrument.id || first.isNote != areNotes) continue;
      const auto& about = first.condition;
      put("<p><b>{}</b> {}{}</p>",
          questionOf(instrument, first.item),
          about.empty() ? about : "<em>" + condition(about) + "</em>: ",
          said);
    }
  }

  bool isAnythingHidden_ = false;
  bool hasTable_ = false;    ///< whether any row is written
  std::size_t leftOut_ = 0;  ///< rows whose numbers would be of one person
};

}  // namespace

std::string itemsAsHtml(const ReportSection& section) {
  return ItemsWriter(section).all();
}

std::string quotesAsHtml(const ReportSection& section) {
  return ItemsWriter(section).quotes();
}

}  // namespace study::report
