#include <algorithm>
#include <map>
#include <set>

#include "base/joined.h"
#include "base/search.h"
#include "questionnaires/scoring/scoring.h"
#include "study/model/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

class InstrumentWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    if (section_.results.instruments.empty()) return {};
    scores();
    const auto range =
        say("In brackets after a score: its range, which may be another than the scale of the "
            "statements.");
    const auto beyond =
        say("Intervals are Student’s: they may pass an end of the range, and are not cut there.");
    put("<p class=\"note\">{}{}</p>", range, isIntervalBeyondScale_ ? " " + beyond : std::string());
    scoresOfOwnStatements();
    hiddenScores();
    const auto* family = mainFamily(section_);
    if (family != nullptr) leftOutOfScore(family->family);
    if (hasConditionScore_ && family != nullptr && family->isNamed("welch")) {
      put("<p class=\"note\">{}</p>",
          withReferences(
              "A score is one number for each participant. {} takes all answers, so its means are "
              "others where participants gave different numbers of answers.",
              {"answer"}));
    }
    forEach([&](const auto&... parts) { acceptability(parts...); });
    forEach([&](const auto&... parts) { contradictions(parts...); });
    return std::move(html_);
  }

 private:
  template <typename Do>
  void forEach(Do&& write) const {
    for (const auto& summary : section_.results.instruments) {
      const auto* found = section_.instrument(summary.instrument);
      if (found == nullptr) continue;
      write(*found, escaped(found->title.in(section_.words.language())), summary);
    }
  }

  /// Which instruments have statements of its own for each alternative, and so scores that are not
  /// of the same statements.
  void scoresOfOwnStatements() {
    forEach([&](const auto& instrument, const auto& title, const auto& summary) {
      std::map<std::string, std::set<std::string>> scoresOf;  // condition, its scores
      for (const auto& one : summary.scores) {
        const bool isAsked = !one.values.empty() || one.missing > 0;
        if (isAsked && !one.condition.empty()) scoresOf[one.condition].insert(one.score);
      }
      std::set<std::string> all;
      std::size_t sum = 0;
      for (const auto& [id, scores] : scoresOf) {
        all.insert(scores.begin(), scores.end());
        sum += scores.size();
      }
      if (scoresOf.size() < 2 || all.size() < sum || !isShown(instrument)) return;
      note(
          "“{}” asks different statements about each alternative, so each has a score of its own.",
          title);
    });
  }

  /// The scores without a row, because they would show a single answer of the only participant of
  /// a cohort.
  void hiddenScores() {
    const auto isAlone = [](const auto& flow) { return flow.completed == 1; };
    const bool isOfOldScale = section_.history.versions > 1;  // which leaves scores out as well
    if (std::ranges::none_of(section_.results.flow, isAlone) || isOfOldScale) return;
    std::vector<std::string> hidden;
    forEach([&](const auto& instrument, const auto& title, const auto& summary) {
      if (summary.forms == 0) return;
      const bool isAnyShown = isShown(instrument);
      for (const auto& score : instrument.scores) {
        if (std::ranges::find(summary.scores, score.id, &ScoreSummary::score) !=
            summary.scores.end())
          continue;
        const auto own = escaped(score.title.in(section_.words.language()));
        const auto& name = isAnyShown ? own : title;
        if (std::ranges::find(hidden, name) == hidden.end()) hidden.push_back(name);
      }
    });
    const auto list = base::joined(hidden, ", ");
    if (!hidden.empty()) {
      put("<p class=\"note\">{} {}</p>",
          say("Asked, but left out, because the answer of one person to a single item could be "
              "worked out:"),
          list);
    }
  }

  bool isShown(const questionnaires::Instrument& instrument) const {
    return std::ranges::any_of(section_.results.instruments, [&](const auto& summary) {
      return summary.instrument == instrument.id && !summary.scores.empty();
    });
  }

  /// The statements of a family's comparisons that the score of its instrument leaves out.
  void leftOutOfScore(const protocols::Family& family) {
    const auto* found = section_.instrument(family.instrument);
    const bool hasOneScore = found != nullptr && found->scores.size() == 1;
    if (!hasConditionScore_ || !hasOneScore || !family.score.empty()) return;
    const auto& score = found->scores.front();
    const auto compared = protocols::comparedItems(family, found->items);
    const bool hasAll = std::ranges::all_of(
        score.items, [&](const auto& id) { return base::withId(compared, id) != nullptr; });
    if (!hasAll) return;
    std::vector<std::string> others;
    for (const auto& item : compared) {
      if (std::ranges::find(score.items, item.id) != score.items.end()) continue;
      others.push_back(section_.words.say("“{}”", questionOf(item, section_.words.language())));
    }
    if (others.empty()) return;
    put("<p class=\"note\">{} {}</p>",
        withReferences("{} has more answers than the score, and other means.", {"answer"}),
        say("“{}” leaves out: {}",
            score.title.in(section_.words.language()),
            listed(others, section_.words)));
  }

  void contradictions(
      const questionnaires::Instrument& instrument,
      const std::string& title,
      const InstrumentSummary& summary) {
    if (!instrument.consistency) return;
    put("<p>{}: {}</p>",
        title,
        count(
            summary.contradictory,
            "{} of {} forms contradicts itself by the instrument’s own rule; none was left out.",
            "{} of {} forms contradict themselves by the instrument’s own rule; none was left out.",
            summary.forms));
  }

  /// A row of the table: one score, of all forms or of the forms about one condition or occasion.
  struct ScoreRow {
    const questionnaires::Instrument* instrument;
    std::string score;
    std::string conditionOrOccasion;             ///< condition or occasion
    std::vector<const ScoreSummary*> summaries;  ///< by cohort
  };

  std::vector<ScoreRow> scoreRows() const {
    const auto& cohorts = section_.results.flow;
    std::vector<ScoreRow> rows;
    forEach([&](const auto& instrument, const auto&, const auto& summary) {
      for (const auto& score : summary.scores) {
        if (score.values.empty() && score.missing == 0) continue;
        const auto& conditionOrOccasion =
            score.condition.empty() ? score.occasion : score.condition;
        auto same = std::ranges::find_if(rows, [&](const auto& row) {
          return row.instrument == &instrument && row.score == score.score &&
                 row.conditionOrOccasion == conditionOrOccasion;
        });
        if (same == rows.end()) {
          same = rows.insert(
              rows.end(),
              {&instrument,
               score.score,
               conditionOrOccasion,
               std::vector<const ScoreSummary*>(cohorts.size(), nullptr)});
        }
        const auto place =
            std::ranges::find(cohorts, score.cohort, &CohortFlow::cohort) - cohorts.begin();
        same->summaries[static_cast<std::size_t>(place)] = &score;
      }
    });
    return rows;
  }

  void scores() {
    const auto rows = scoreRows();
    const auto sizeInWords = [](std::size_t n) { return fmt::format(", {} = {}", kN, n); };
    std::vector<std::string> columns{say("Score"), textHeading(say("About"))};
    std::vector<bool> isNInHeading;  // by cohort
    for (std::size_t i = 0; i < section_.results.flow.size(); ++i) {
      std::set<std::size_t> people;
      for (const auto& one : rows) {
        if (one.summaries[i] != nullptr) people.insert(one.summaries[i]->values.size());
      }
      isNInHeading.push_back(people.size() == 1);
      columns.push_back(
          cohort(section_.results.flow[i].cohort) +
          (people.size() == 1 ? sizeInWords(*people.begin()) : std::string()));
    }
    const auto ofAll = say("Scores of participants: M with SD in brackets, and 95 % CI");
    const auto ofOne = say("Scores of the participant");
    table(section_.results.completed() == 1 ? ofOne : ofAll, columns);
    const questionnaires::Instrument* last = nullptr;
    for (const auto& [instrument, id, conditionOrOccasion, summaries] : rows) {
      const auto& score = *instrument->score(id);
      const auto range = questionnaires::rangeOf(*instrument, score);
      if (instrument != last) group(escaped(instrument->title.in(section_.words.language())));
      last = instrument;
      std::vector<std::string> cells{
          escaped(score.title.in(section_.words.language())) + scaleEndWords(range),
          aboutInWords(summaries)};
      for (std::size_t i = 0; i < summaries.size(); ++i) {
        const auto* one = summaries[i];
        cells.push_back(one == nullptr ? std::string() : scoreCell(*one, range));
        if (one != nullptr && !isNInHeading[i]) cells.back() += sizeInWords(one->values.size());
      }
      row(cells);
    }
    endTable();
  }

  /// " (1 to 5)"; empty for a score without a range.
  std::string scaleEndWords(const questionnaires::Range& range) const {
    if (range.low >= range.high) return {};
    return " (" +
           say("{} to {}",
               withMinusSign(exactDecimal(range.low)),
               withMinusSign(exactDecimal(range.high))) +
           ")";
  }

  /// The condition or the occasion that the scores of a row are about.
  std::string aboutInWords(const std::vector<const ScoreSummary*>& summaries) const {
    const auto* any =
        *std::ranges::find_if(summaries, [](const auto* one) { return one != nullptr; });
    if (!any->condition.empty()) return condition(any->condition);
    return any->occasion.empty() ? any->occasion : say(any->occasion);
  }

  /// "3.41 (1.09) [2.71, 4.10]", and how many have no score.
  std::string scoreCell(const ScoreSummary& score, const questionnaires::Range& range) {
    const auto& interval = score.interval;
    isIntervalBeyondScale_ =
        isIntervalBeyondScale_ ||
        (interval && (interval->low < range.low || interval->high > range.high));
    hasConditionScore_ = hasConditionScore_ || !score.condition.empty();
    const auto without = say("{} without a score", score.missing);
    const char* before = section_.wording == Wording::Vancouver ? ", " : " ";
    std::string text = withDeviation(score.mean, score.standardDeviation);
    if (interval) text += before + cellOf(interval);
    if (score.missing > 0) text += (text.empty() ? "" : ", ") + without;
    return text;
  }

  void acceptability(
      const questionnaires::Instrument& instrument,
      const std::string& title,
      const InstrumentSummary& summary) {
    table(
        title + say(": participants at or above the threshold of acceptability"),
        {say("Statement"),
         textHeading(say("Cohort")),
         textHeading(say("About")),
         say("From"),
         kN,
         say("Acceptable"),
         say("95 % CI")});
    for (const auto& item : summary.acceptable) {
      const auto* asked = instrument.item(item.item.itemId);
      const auto& interval = item.interval;
      row(
          {escaped(asked == nullptr ? item.item.itemId : asked->text.in(section_.words.language())),
           cohort(item.cohort),
           item.condition.empty() ? std::string() : condition(item.condition),
           fmt::format("{:g}", item.item.acceptableFrom),
           std::to_string(item.item.answered),
           item.item.share ? rounded(100.0 * *item.item.share, 0) + " %" : std::string(),
           interval ? fmt::format(
                          "[{} %, {} %]",
                          rounded(100.0 * interval->low, 0),
                          rounded(100.0 * interval->high, 0))
                    : std::string()});
    }
    endTable();
  }

  bool isIntervalBeyondScale_ = false;
  bool hasConditionScore_ = false;
};

}  // namespace

std::string instrumentsAsHtml(const ReportSection& section) {
  return InstrumentWriter(section).all();
}

}  // namespace study::report
