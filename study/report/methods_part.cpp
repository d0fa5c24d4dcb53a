#include <array>

#include "study/apa_text.h"
#include "study/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

using protocols::PhaseType;

class MethodsWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    heading("Methods");
    put("<p>{}</p>", procedure());
    put("<p>{}</p>", plan());
    put("<p>{}</p>", computation());
    heading("How this was made");
    put("<p>palpate {}; {} <em>{}</em>, {} {}, SHA-256 <code>{}</code>; {} <code>{}</code>, {} "
        "{}.</p>",
        appVersion(),
        say("protocol"),
        escaped(s_.protocol.study.id),
        say("version"),
        escaped(s_.protocol.study.version),
        s_.protocolHash,
        say("study"),
        s_.uuid,
        say("seed"),
        s_.seed);
    sources();
    instruments();
    return std::move(html_);
  }

 private:
  std::string titleOf(const std::string& instrument) const {
    for (const auto& i : s_.instruments) {
      if (i.id == instrument) return i.title.in(s_.words.language());
    }
    return instrument;
  }

  /// What a participant went through, block by block.
  std::string procedure() const {
    std::string text;
    for (const auto& phase : s_.protocol.phases) {
      if (phase.type == PhaseType::Block) text += block(phase) + " ";
      if (phase.type == PhaseType::Preference) {
        text += say("After {}, participants said which alternative they preferred ({}).",
                    phase.block,
                    titleOf(phase.instrument)) +
                " ";
      }
    }
    return text;
  }

  std::string block(const protocols::Phase& phase) const {
    constexpr std::array<std::string_view, 6> kOrders{
        "in a fixed order",
        "in the reverse order of another block",
        "in an order drawn for each participant",
        "in the orders of a Latin square",
        "in the orders of a balanced Latin square",
        "in all orders equally often"};
    std::string conditions;
    for (const auto& id : phase.trials.conditions) {
      conditions += (conditions.empty() ? "" : ", ") + s_.conditionTitle(id);
    }
    std::string text = say(
        "In {}, every participant felt {} alternatives ({}) {}, under anonymous labels, with at "
        "least {} cuts or strokes each.",
        phase.id,
        phase.trials.conditions.size(),
        conditions,
        s_.words(kOrders[static_cast<std::size_t>(phase.trials.order.type)]),
        phase.trials.minimumCuts);
    for (const auto& asked : phase.trials.questionnaires) {
      text += " " + say("After each of them they answered: {}.", titleOf(asked.instrument));
    }
    return text;
  }

  std::string plan() const {
    std::string text;
    for (const auto& family : s_.protocol.analysis.families) {
      text += say("Declared for “{}” in version {} of the protocol: {}, α = {}, {} comparisons.",
                  family.title,
                  s_.protocol.study.version,
                  declaredInWords(family, s_.words),
                  exactly(family.alpha),
                  family.comparisons.size()) +
              " ";
      if (family.equivalenceBound) {
        text += say("Differences below {:g} points count as none.", *family.equivalenceBound) + " ";
      }
    }
    if (s_.protocolVersions > 1) {
      text += say(
          "The protocol was changed during the study: there are {} versions of it, and what was "
          "declared after the first participant is exploratory, whatever is said above. The audit "
          "trail has each change with its reason.",
          s_.protocolVersions);
    }
    return text;
  }

  std::string computation() const {
    return say(
        "Means and variances (n − 1) come from integer counts; Welch’s t-test has real degrees of "
        "freedom; tests within people take each participant’s mean; exact tests count all "
        "arrangements, ties included; the linear mixed model is fitted by REML with "
        "Satterthwaite’s "
        "degrees of freedom, the ordinal one by Laplace’s approximation; p values are adjusted "
        "before they are rounded.");
  }

  void sources() {
    if (s_.sources.empty()) return;
    put("<p>{}</p><ul>", say("What was felt came from:"));
    for (const auto& source : s_.sources) {
      std::string conditions;
      for (const auto& id : source.conditions) {
        conditions += (conditions.empty() ? "" : ", ") + s_.conditionTitle(id);
      }
      put("<li>{}: {}</li>", escaped(protocols::inWords(source)), escaped(conditions));
    }
    put("</ul>");
  }

  void instruments() {
    put("<p>{}</p><ul>", say("Instruments:"));
    for (const auto& i : s_.instruments) {
      put("<li>{} ({}){}</li>",
          escaped(i.title.in(s_.words.language())),
          escaped(i.id),
          i.source.citation.empty() ? "" : ": " + escaped(i.source.citation));
    }
    put("</ul>");
  }
};

}  // namespace

std::string methodsAsHtml(const ReportSection& section) {
  return MethodsWriter(section).all();
}

}  // namespace study::report
