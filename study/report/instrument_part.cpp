#include <algorithm>

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
    table(
        say("Scores of participants"),
        {say("Score"),
         textHeading(say("Cohort")),
         textHeading(say("About")),
         kN,
         kM,
         kSd,
         say("95 % CI"),
         say("No score")});
    forEach([&](const auto&... of) { scores(of...); });
    endTable();
    if (isBeyond_) {
      note(
          "Where an interval passes an end of the scale, in brackets after the score, it ends "
          "there.");
    }
    const auto* family = mainFamily(section_);
    if (hasConditionScore_ && family != nullptr && family->isNamed("welch")) {
      put("<p class=\"note\">{}</p>",
          withReferences(
              "A score is one number for each participant. {} takes all answers, so its means are "
              "others where participants gave different numbers of answers.",
              {"answer"}));
    }
    forEach([&](const auto&... of) { acceptability(of...); });
    forEach([&](const auto&... of) { contradictions(of...); });
    return std::move(html_);
  }

 private:
  template <typename Do>
  void forEach(Do&& write) const {
    for (const auto& summary : section_.results.instruments) {
      const auto found = std::ranges::find(
          section_.instruments, summary.instrument, &questionnaires::Instrument::id);
      if (found == section_.instruments.end()) continue;
      write(*found, escaped(found->title.in(section_.words.language())), summary);
    }
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

  void scores(
      const questionnaires::Instrument& instrument,
      const std::string& title,
      const InstrumentSummary& summary) {
    group(title);
    for (const auto& score : summary.scores) {
      if (score.values.empty() && score.missing == 0) continue;
      const auto& about = score.condition;
      const auto& occasion = score.occasion;
      const auto& kind = *instrument.score(score.score);
      const auto range = questionnaires::rangeOf(instrument, kind);
      const auto ends = range.low < range.high ? fmt::format(
                                                     " ({}–{})",
                                                     withMinusSign(exactly(range.low)),
                                                     withMinusSign(exactly(range.high)))
                                               : std::string();
      const auto& interval = score.interval;
      isBeyond_ =
          isBeyond_ || (interval && (interval->low < range.low || interval->high > range.high));
      hasConditionScore_ = hasConditionScore_ || !about.empty();
      row(
          {escaped(kind.title.in(section_.words.language())) + ends,
           cohort(score.cohort),
           !about.empty()     ? condition(about)
           : occasion.empty() ? occasion
                              : say(occasion),
           std::to_string(score.values.size()),
           cellOf(score.mean, 2),
           cellOf(score.standardDeviation, 2),
           cellOf(score.interval),
           score.missing > 0 ? std::to_string(score.missing) : ""});
    }
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

  bool isBeyond_ = false;
  bool hasConditionScore_ = false;
};

}  // namespace

std::string instrumentsAsHtml(const ReportSection& section) {
  return InstrumentWriter(section).all();
}

}  // namespace study::report
