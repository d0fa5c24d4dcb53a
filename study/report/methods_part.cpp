#include <algorithm>
#include <array>

#include "study/model/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

using protocols::PhaseType;

// the kind of sources that are shown on the screen; all other kinds are felt
constexpr std::string_view kSeenKind = "anatomy";

class MethodsWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    if (const auto& description = s_.protocol.study.description; !description.empty()) {
      put("<p>{}</p>", say("The protocol describes the study as: “{}”", description));
    }
    put("<p>{}</p>", procedure());
    put("<p>{}</p>", plan());
    put("<p>{}</p>", computation());
    put("<h4>{}</h4>", say("How this was made"));
    put("<p>palpate {}; {} {}, SHA-256 <code>{}</code>; {} <code>{}</code>, {} {}.</p>",
        appVersion(),
        say("version of the protocol"),
        escaped(s_.protocol.study.version),
        s_.protocolHash,
        say("study"),
        s_.uuid,
        say("seed"),
        s_.seed);
    trail();
    sources();
    instruments();
    return std::move(html_);
  }

 private:
  void trail() {
    if (s_.trail.hash.empty()) return;
    put("<p>{}</p>",
        say("The study's audit trail had {} events when this was written, the last one with the "
            "hash {}: whether a study goes on from there can be verified.",
            s_.trail.events,
            storage::inGroupsOfFour(s_.trail.hash)));
    if (s_.commitment.empty()) return;
    put("<p>{}</p>",
        say("Orders and codes of the conditions were fixed when the study was made. What they were "
            "drawn from has the commitment {}: any other would have another one.",
            storage::inGroupsOfFour(s_.commitment)));
  }

  /// The procedure for a participant, part by part.
  std::string procedure() const {
    std::string text;
    std::string last;  // what was done in the last block
    for (const auto& phase : s_.protocol.phases) {
      if (phase.type == PhaseType::Benchmark) text += benchmark(phase) + " ";
      if (phase.type == PhaseType::Preference) text += preference(phase) + " ";
      if (phase.type != PhaseType::Block) continue;
      const auto done = block(phase);
      const auto title = s_.blockTitle(phase.id);
      const auto likewise = say("So they did in {}.", title);
      text += (done == last ? likewise : say("In {}, {}", title, done)) + " ";
      last = done;
    }
    return text;
  }

  /// The physical tool that participants compared with.
  std::string benchmark(const protocols::Phase& phase) const {
    std::string text = count(
        phase.minimumCuts,
        "To have something to compare with, every participant made at least {} cut with the real "
        "tool.",
        "To have something to compare with, every participant made at least {} cuts with the real "
        "tool.");
    const auto& read = phase.text.in(s_.words.language());
    const bool hasBlanks = read.find("[[") != std::string::npos;
    if (!read.empty() && !hasBlanks) text += " " + say("They read: “{}”", read);
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
    std::string text = s_.words.say(
        "every participant felt {} ({}) {}, under anonymous labels, with {} each.",
        s_.words.count(phase.trials.conditions.size(), "{} alternative", "{} alternatives"),
        conditions,
        s_.words(kOrders[static_cast<std::size_t>(phase.trials.order.type)]),
        s_.words.count(
            phase.trials.minimumCuts, "at least {} cut or stroke", "at least {} cuts or strokes"));
    for (const auto& asked : phase.trials.questionnaires) {
      text += " " +
              s_.words.say("After each of them they answered “{}”.", s_.titleOf(asked.instrument));
    }
    return text;
  }

  std::string preference(const protocols::Phase& phase) const {
    std::string text =
        say("After {}, participants chose among the alternatives (“{}”).",
            s_.blockTitle(phase.block),
            s_.titleOf(phase.instrument));
    if (!phase.hasOptionalTrials) return text;
    return text + " " +
           say("Before, they could feel each of them once more, or go on without; nothing is "
               "computed from these trials.");
  }

  std::string plan() const {
    std::string text;
    for (const auto& family : s_.protocol.analysis.families) {
      text += say("Declared for “{}” in version {} of the protocol: {}, α = {}, {}.",
                  family.title,
                  s_.protocol.study.version,
                  declaredInWords(family, s_.words),
                  exactly(family.alpha),
                  s_.words.count(family.comparisons.size(), "{} comparison", "{} comparisons")) +
              " ";
      if (family.equivalenceBound) {
        text += say("Differences below {:g} points count as none.", *family.equivalenceBound) + " ";
      }
    }
    return text + changes();
  }

  /// The changes that later versions of the protocol made to the families.
  std::string changes() const {
    const auto& history = s_.history;
    if (history.versions < 2) return {};
    std::string text =
        say("There are {} versions of the protocol; the audit trail has each with its reason.",
            history.versions);
    for (const auto& change : history.changes) text += " " + describe(change);
    if (!history.changes.empty()) return text;
    return text + " " +
           (history.versionsSinceBegun == 0
                ? say("All of them are older than the first participant’s session.")
                : say("None that came after the first participant had begun changed what was "
                      "declared."));
  }

  std::string describe(const FamilyChange& change) const {
    const auto day = change.addedUtc.substr(0, change.addedUtc.find('T'));
    switch (change.kind) {
      case FamilyChange::Kind::Added:
        return say(
            "Version {} ({}) added “{}” after the first participant had begun{}",
            change.version,
            day,
            change.title,
            consequenceOf(change));
      case FamilyChange::Kind::Removed:
        return say(
            "Version {} ({}) dropped “{}”, which had been declared before.",
            change.version,
            day,
            change.title);
      case FamilyChange::Kind::Restored:
        return say(
            change.isHarmless
                ? "Version {} ({}) put “{}” back as it was declared, before anybody had begun with "
                  "the "
                  "change."
                : "Version {} ({}) put “{}” back as it was declared, but participants had begun "
                  "with the change: all of it is exploratory.",
            change.version,
            day,
            change.title);
      case FamilyChange::Kind::Changed:
        break;
    }
    std::string keys;
    for (const auto& key : change.keys) keys += (keys.empty() ? "" : ", ") + s_.words(key);
    return say(
        "Version {} ({}) changed “{}” after the first participant had begun ({}){}",
        change.version,
        day,
        change.title,
        keys,
        consequenceOf(change));
  }

  /// The consequence of a change for its family, as the end of a sentence.
  std::string consequenceOf(const FamilyChange& change) const {
    return s_.words(
        change.isHarmless ? "; it was put back as it was declared."
                          : ": all of it is exploratory.");
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
    list("What was felt came from:", false);
    list("What was seen came from:", true);
  }

  /// A list of the scenes' sources: those that are shown on the screen, or those that are felt.
  void list(std::string_view words, bool isOfSeen) {
    std::string lines;
    for (const auto& source : s_.sources) {
      if ((source.kind == kSeenKind) != isOfSeen) continue;
      std::string conditions;
      for (const auto& id : source.conditions) {
        conditions += (conditions.empty() ? "" : ", ") + s_.conditionTitle(id);
      }
      lines += fmt::format("<li>{}: {}</li>", describe(source), escaped(conditions));
    }
    if (!lines.empty()) put("<p>{}</p><ul>{}</ul>", s_.words(words), lines);
  }

  std::string describe(const protocols::SceneDataSource& source) const {
    const auto title = s_.words(source.title);
    const auto kind = s_.words(source.kind);
    std::string text = source.isSynthetic ? say("SYNTHETIC") + ": " : "";
    text += source.file.empty() ? say("{} ({}, built into the program)", title, kind)
                                : say("{} ({} '{}')", title, kind, source.file);
    std::string origin;
    for (const auto& part : source.origin) {
      origin += (origin.empty() ? "" : ", ") + s_.words(part);
    }
    return origin.empty() ? text : text + ", " + escaped(origin);
  }

  /// The instruments by their sources, each of which is written once.
  void instruments() {
    std::vector<std::pair<std::string, std::string>> titles;  // source, titles
    for (const auto& i : s_.instruments) {
      const auto& title = i.title.in(s_.words.language());
      const auto same =
          std::ranges::find(titles, i.source.citation, &std::pair<std::string, std::string>::first);
      if (same == titles.end()) {
        titles.emplace_back(i.source.citation, title);
      } else {
        same->second += ", " + title;
      }
    }
    put("<p>{}</p><ul>", say("Instruments:"));
    const auto own = s_.words("Palpate’s own wording.");
    for (const auto& [source, named] : titles) {
      const auto said = source == "Palpate's own wording." ? own : source;
      put("<li>{}{}</li>", escaped(named), said.empty() ? said : ": " + escaped(said));
    }
    put("</ul>");
  }
};

}  // namespace

std::string methodsAsHtml(const ReportSection& section) {
  return MethodsWriter(section).all();
}

}  // namespace study::report
