#include <algorithm>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

class InstrumentWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    if (s_.results.instruments.empty()) return {};
    table(
        say("Scores of participants"),
        {say("Score"),
         ofWords(say("Cohort")),
         ofWords(say("About")),
         kN,
         kM,
         kSd,
         say("95 % CI"),
         say("No score")});
    forEach([&](const auto&... of) { scores(of...); });
    endTable();
    forEach([&](const auto&... of) { acceptability(of...); });
    forEach([&](const auto&... of) { contradictions(of...); });
    return std::move(html_);
  }

 private:
  template <typename Do>
  void forEach(Do&& write) const {
    for (const auto& summary : s_.results.instruments) {
      const auto found =
          std::ranges::find(s_.instruments, summary.instrument, &questionnaires::Instrument::id);
      if (found == s_.instruments.end()) continue;
      write(*found, escaped(found->title.in(s_.words.language())), summary);
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
      row(
          {escaped(instrument.score(score.score)->title.in(s_.words.language())),
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
         ofWords(say("Cohort")),
         ofWords(say("About")),
         say("From"),
         kN,
         say("Acceptable"),
         say("95 % CI")});
    for (const auto& item : summary.acceptable) {
      const auto* asked = instrument.item(item.item.itemId);
      const auto& interval = item.interval;
      row(
          {escaped(asked == nullptr ? item.item.itemId : asked->text.in(s_.words.language())),
           cohort(item.cohort),
           item.condition.empty() ? std::string() : condition(item.condition),
           fmt::format("{:g}", item.item.acceptableFrom),
           std::to_string(item.item.answered),
           item.item.share ? fmt::format("{:.0f} %", 100.0 * *item.item.share) : std::string(),
           interval
               ? fmt::format("[{:.0f} %, {:.0f} %]", 100.0 * interval->low, 100.0 * interval->high)
               : std::string()});
    }
    endTable();
  }
};

}  // namespace

std::string instrumentsAsHtml(const ReportSection& section) {
  return InstrumentWriter(section).all();
}

}  // namespace study::report
