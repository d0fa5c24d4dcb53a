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
    for (const auto& summary : s_.results.instruments) instrument(summary);
    return std::move(html_);
  }

 private:
  void instrument(const InstrumentSummary& summary) {
    const auto& all = s_.instruments;
    const auto found = std::find_if(
        all.begin(), all.end(), [&](const auto& i) { return i.id == summary.instrument; });
    if (found == all.end()) return;
    const std::string title = escaped(found->title.in(s_.words.language()));
    if (!summary.scores.empty()) scores(*found, title, summary);
    if (!summary.acceptable.empty()) acceptability(*found, title, summary);
    if (!found->consistency) return;
    put("<p>{}</p>",
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
    table(
        title + say(": scores of participants"),
        {say("Score"), say("About"), "n", say("Mean"), say("SD"), say("95 % CI"), say("No score")});
    std::string last;
    for (const auto& score : summary.scores) {
      if (score.values.empty() && score.missing == 0) continue;
      if (score.cohort != last) rowOver(cohort(score.cohort), 7);
      last = score.cohort;
      row(
          {escaped(instrument.score(score.score)->title.in(s_.words.language())),
           score.condition.empty() ? say(score.occasion) : condition(score.condition),
           std::to_string(score.values.size()),
           cellOf(score.mean, 2),
           cellOf(score.standardDeviation, 2),
           cellOf(score.interval),
           score.missing > 0 ? std::to_string(score.missing) : ""});
    }
    endTable();
  }

  void acceptability(
      const questionnaires::Instrument& instrument,
      const std::string& title,
      const InstrumentSummary& summary) {
    table(
        title + say(": participants at or above the threshold of acceptability"),
        {say("Statement"),
         say("Cohort"),
         say("About"),
         say("From"),
         "n",
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
