#include <algorithm>
#include <set>

#include "questionnaires/model/answer.h"
#include "study/export/k_anonymity.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

constexpr std::size_t kFewestPeople = 2;  // a number of one person is that person's answer

/// Writes the part of a report that shows the answers to each item, and what participants wrote.
class ItemsWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    for (const auto& instrument : section_.instruments) {
      numbersByAlternative(instrument);
      choices(instrument);
      figures(instrument);
    }
    numbers();
    const auto notes = notesInWords();
    if (hasTable_) html_ = "<p class=\"note\">" + notes + "</p>\n" + html_;
    return std::move(html_);
  }

  /// What the tables show, and what they leave out.
  std::string notesInWords() const {
    const auto given =
        say("Answers as they were given, not reversed. Numbers are of participants’ means; choices "
            "are counted by form. Choices between alternatives are among the preferences.");
    const auto reversed =
        say("(R): a high answer is bad; scores and comparisons take it reversed.");
    const auto missing =
        say("Where n is smaller than the cohort, the others left the question open; a cohort "
            "without a row has no answers that can be shown.");
    const auto hidden =
        say("To protect anonymity, these tables have no mean of one person alone, and options that "
            "one person chose are counted together as “other answers”, with the next rarest where "
            "a difference would give them away. Other tables and figures, of ratings, scores and "
            "votes, show single people too.");
    const auto leftOut = count(
        leftOut_,
        "{} row is left out, because it would show one person alone, or nothing.",
        "{} rows are left out, because they would show one person alone, or nothing.");
    const auto simulated =
        say("Simulated answers about people are drawn at random, and may not fit their cohort.");
    std::string text = given;
    if (section_.results.runMode == RunMode::Simulated) text += " " + simulated;
    if (isAnythingReversed_) text += " " + reversed;
    if (isAnythingMissing_) text += " " + missing;
    if (isAnythingHidden_) text += " " + hidden;
    if (leftOut_ > 0) text += " " + leftOut;
    return text;
  }

  std::string quotes() {
    if (!section_.hasQuotes) return {};
    const auto& all = section_.results.answers.quotes;
    const auto alike =
        say("Each of the {} texts is only “{}”.",
            all.size(),
            all.empty() ? std::string() : all.front().text);
    const auto placeholders = say("Simulated participants write nothing.");
    const bool isSimulated = section_.results.runMode == RunMode::Simulated;
    if (areAlike(all)) return "<p>" + (isSimulated ? placeholders : alike) + "</p>\n";
    for (const auto& instrument : section_.instruments) writeQuotes(instrument, false);
    const auto own = std::exchange(html_, {});
    for (const auto& instrument : section_.instruments) writeQuotes(instrument, true);
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
    if (item == nullptr) return escaped(id);
    return escaped(withCurlyQuotes(report::questionOf(*item, section_.words.language())));
  }

  /// The question of a number, marked if a high answer to it is bad.
  std::string markedQuestionOf(
      const questionnaires::Instrument& instrument, const std::string& id) {
    const auto* item = instrument.item(id);
    const bool isReversed = item != nullptr && item->key < 0;
    isAnythingReversed_ = isAnythingReversed_ || isReversed;
    return questionOf(instrument, id) + (isReversed ? " (R)" : "");
  }

  /// The numbers of one question that is not about an alternative.
  struct Question {
    const questionnaires::Instrument* instrument;
    std::string item;
    std::vector<std::string> cells;  ///< by cohort
    std::vector<std::size_t> sizes;  ///< number of participants of each cell
  };

  std::vector<Question> questionsAskedOnce() {
    const auto& cohorts = section_.results.flow;
    std::vector<Question> questions;
    for (const auto& instrument : section_.instruments) {
      const auto summaries = numbersOf(instrument);
      for (const auto* one : summaries) {
        const bool isNew = questions.empty() || questions.back().instrument != &instrument ||
                           questions.back().item != one->item;
        if (isNew) {
          questions.push_back(
              {&instrument,
               one->item,
               std::vector<std::string>(cohorts.size()),
               std::vector<std::size_t>(cohorts.size())});
        }
        const auto place = static_cast<std::size_t>(
            std::ranges::find(cohorts, one->cohort, &CohortFlow::cohort) - cohorts.begin());
        questions.back().cells[place] = meanOf(*one);
        questions.back().sizes[place] = one->values.size();
      }
    }
    const auto isLeftOut = [](const auto& question) {
      return std::ranges::all_of(question.cells, [](const auto& cell) { return cell.empty(); });
    };
    leftOut_ += static_cast<std::size_t>(std::ranges::count_if(questions, isLeftOut));
    std::erase_if(questions, isLeftOut);
    return questions;
  }

  std::vector<const ItemSummary*> numbersOf(const questionnaires::Instrument& instrument) const {
    return summariesOf(
        instrument, [](const auto& one) { return one.mean && one.condition.empty(); });
  }

  /// All numbers that are not about an alternative: a row for each question, a column for each
  /// cohort.
  void numbers() {
    auto questions = questionsAskedOnce();
    if (questions.empty()) return;
    hasTable_ = true;
    const auto sizeInWords = [](std::size_t n) { return fmt::format(", {} = {}", kN, n); };
    std::vector<std::string> columns{say("Question")};
    for (std::size_t i = 0; i < section_.results.flow.size(); ++i) {
      std::set<std::size_t> people;  // the different numbers of participants in the column
      for (const auto& one : questions) {
        if (!one.cells[i].empty()) people.insert(one.sizes[i]);
      }
      const bool isSame = people.size() == 1;
      columns.push_back(
          cohort(section_.results.flow[i].cohort) +
          (isSame ? sizeInWords(*people.begin()) : std::string()));
      for (auto& one : questions) {
        if (!one.cells[i].empty() && !isSame) one.cells[i] += sizeInWords(one.sizes[i]);
      }
    }
    table(say("Questions that were asked once, M with SD in brackets"), columns);
    const questionnaires::Instrument* last = nullptr;
    for (auto& [instrument, item, cells, sizes] : questions) {
      const auto summaries = numbersOf(*instrument);
      if (instrument != last) group(titleOf(*instrument) + scaleOf(*instrument, summaries));
      last = instrument;
      const bool areEndsCommon = haveSameEnds(itemsOf(*instrument, summaries));
      cells.insert(
          cells.begin(),
          markedQuestionOf(*instrument, item) +
              (areEndsCommon ? std::string() : endsInBrackets(*instrument->item(item))));
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
    std::vector<Line> lines;
    for (auto at = rows.begin(); at != rows.end();) {
      const auto& first = **at;
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
      add(lines, {markedQuestionOf(instrument, first.item), first.cohort, std::move(cells)});
    }
    table(captionOfNumbers(instrument, rows), columns);
    const std::string* question = nullptr;
    for (const auto& line : lines) {
      if (question == nullptr || *question != line.question) group(line.question);
      question = &line.question;
      row(line.cells);
    }
    endTable();
  }

  /// A row of numbersByAlternative().
  struct Line {
    std::string question;
    std::string cohort;
    std::vector<std::string> cells;  ///< the cohort, the number of people, the alternatives
  };

  /// Adds a row below the others of its question. What the same people of a cohort said to the same
  /// statement about other alternatives is in the same row.
  static void add(std::vector<Line>& lines, Line line) {
    auto after = lines.end();
    for (auto other = lines.begin(); other != lines.end(); ++other) {
      if (other->question != line.question) continue;
      after = other + 1;
      bool isFree = other->cohort == line.cohort && other->cells[1] == line.cells[1];
      for (std::size_t i = 2; i < line.cells.size(); ++i) {
        isFree = isFree && (line.cells[i].empty() || other->cells[i].empty());
      }
      if (!isFree) continue;
      for (std::size_t i = 2; i < line.cells.size(); ++i) other->cells[i] += line.cells[i];
      return;
    }
    lines.insert(after, std::move(line));
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
      return scaleEndWords(*item, language) == scaleEndWords(*items.front(), language);
    });
  }

  /// " (Perfect – Failure)"; empty if the scale has no words, or if they are the question.
  std::string endsInBrackets(const questionnaires::Item& item) const {
    const auto [low, high] = scaleEndWords(item, section_.words.language());
    const bool isQuestion = item.text.in(section_.words.language()).empty();
    return low.empty() || high.empty() || isQuestion ? std::string()
                                                     : escaped(" (" + low + " – " + high + ")");
  }

  std::string captionOfNumbers(
      const questionnaires::Instrument& instrument,
      const std::vector<const ItemSummary*>& summaries) const {
    return titleOf(instrument) + say(": every item by itself, M with SD in brackets") +
           scaleOf(instrument, summaries);
  }

  /// "; scale from 0 to 100"; empty if the items have no common scale.
  std::string scaleOf(
      const questionnaires::Instrument& instrument,
      const std::vector<const ItemSummary*>& summaries) const {
    const auto scale = scaleInWords(itemsOf(instrument, summaries), section_.words);
    return scale.empty() ? scale : "; " + escaped(scale);
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
      isAnythingMissing_ = isAnythingMissing_ || isMissing(*one);
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
              : "“{}”, by participants’ means: dots are single people, where there are at most "
                "fifty; the upright line is the median, the diamond the mean; the box, of ten "
                "people "
                "or more, holds the middle half.";
      putFigure(
          one.svg,
          fmt::format(
              fmt::runtime(escaped(section_.words(caption))), questionOf(instrument, one.item)),
          keyOf(one));
    }
  }

  static std::string keyOf(const ItemFigure& figure) {
    return "item-" + figure.instrument + "-" + figure.item;
  }

  /// Whether people of a cohort left a question about themselves open.
  bool isMissing(const ItemSummary& summary) const {
    const auto& cohorts = section_.results.flow;
    const auto flow = std::ranges::find(cohorts, summary.cohort, &CohortFlow::cohort);
    return summary.condition.empty() && flow != cohorts.end() &&
           summary.answers < static_cast<std::size_t>(flow->completed);
  }

  /// "left (3), right (12)", without options that were not chosen; empty if one person answered, or
  /// if all options are hidden. In answers about the participants themselves, rare options are
  /// hidden as in a public release.
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
    if (text.empty()) return text;
    add(section_.words("other answers"), others);
    return escaped(text);
  }

  /// A paragraph for each question and alternative.
  /// @param areNotes  of the operator, instead of what participants wrote
  void writeQuotes(const questionnaires::Instrument& instrument, bool areNotes) {
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

  /// Whether there are several texts and all are the same, as in simulated sessions.
  static bool areAlike(const std::vector<Quote>& quotes) {
    return quotes.size() > 1 && std::ranges::all_of(quotes, [&](const auto& quote) {
             return quote.text == quotes.front().text;
           });
  }

  bool isAnythingHidden_ = false;
  bool isAnythingReversed_ = false;
  bool isAnythingMissing_ = false;
  bool hasTable_ = false;    ///< whether any row is written
  std::size_t leftOut_ = 0;  ///< rows that would show one person, or hidden options alone
};

}  // namespace

std::string itemsAsHtml(const ReportSection& section) {
  return ItemsWriter(section).all();
}

std::string quotesAsHtml(const ReportSection& section) {
  return ItemsWriter(section).quotes();
}

}  // namespace study::report
