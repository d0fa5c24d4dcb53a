#include <algorithm>
#include <array>

#include "base/joined.h"
#include "protocols/validation/validation.h"
#include "study/model/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/references.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

using protocols::PhaseType;

/// A force model in words, with the works that it comes from.
struct ModelText {
  std::string_view english;
  std::string_view publications;
};

/// In the order of haptics::engine::ModelSpec.
constexpr std::array<ModelText, std::variant_size_v<haptics::engine::ModelSpec>> kModels{
    {{"linear interpolation of a cut", kPunchPaper},
     {"one-dimensional finite elements", kPunchPaper},
     {"interpolation and finite elements, fused by a Kalman filter", kPunchPaper},
     {"force over depth, blended between the curves of soft and hard bone", kReamingPaper},
     {"bone packed with spheres, which the reamer removes", kReamingPaper}}};

class MethodsWriter : HtmlWriter {
 public:
  explicit MethodsWriter(const ReportSection& section)
      : HtmlWriter(section), citations_(section.wording) {}

  std::string all() {
    const auto& description = section_.protocol.study.description;
    const auto described = say("The protocol describes the study as: “{}”", description);
    const auto synthetic =
        say("The curves were neither recorded nor measured here (“How this was made”).");
    const bool isSynthetic =
        std::ranges::any_of(section_.sources, &protocols::SceneDataSource::isSynthetic);
    put("<p>{} {} {}</p>",
        description.empty() ? std::string() : described,
        isSynthetic ? synthetic : std::string(),
        collection());
    put("<h4>{}</h4><p>{} {}</p>", say("Apparatus and force models"), apparatus(), models());
    put("<h4>{}</h4><p>{}{} {}</p>", say("Procedure"), procedure(), blinding(), exposure());
    put("<h4>{}</h4>{}", say("Analysis"), statisticsAsHtml(section_, citations_));
    put("<h4>{}</h4>", say("How this was made"));
    put("<p>palpate {}; {} {}, SHA-256 <code>{}</code>; {} <code>{}</code>, {} {}.</p>",
        appVersion(),
        say("version of the protocol"),
        escaped(section_.protocol.study.version),
        section_.protocolHash,
        say("study"),
        section_.uuid,
        say("seed"),
        section_.seed);
    auditTrail();
    sources();
    instruments();
    for (const auto* flag : explainedFlags(section_)) {
      for (const auto& source : flag->source) {
        if (source.key().empty()) citations_.cite(base::describe(source));
      }
    }
    put("<h4>{}</h4>", say("References"));
    for (const auto& entry : citations_.list(section_.words)) {
      put("<p class=\"reference\">{}</p>", entry);
    }
    return std::move(html_);
  }

 private:
  void auditTrail() {
    if (section_.trail.hash.empty()) return;
    put("<p>{}</p>",
        say("The study's audit trail had {} events when this was written, the last one with the "
            "hash {}: whether a study goes on from there can be verified.",
            section_.trail.events,
            storage::inGroupsOfFour(section_.trail.hash)));
    if (section_.commitment.empty()) return;
    put("<p>{}</p>",
        say("Orders and codes of the conditions were fixed when the study was made. What they were "
            "drawn from has the commitment {}: any other would have another one.",
            storage::inGroupsOfFour(section_.commitment)));
  }

  /// When and where the data were collected. Names what the study's texts lack.
  std::string collection() const {
    std::string text;
    if (section_.results.runMode == RunMode::Simulated) {
      text = say("The sessions were simulated: there are no dates of data collection.");
    } else if (!section_.firstDay.empty()) {
      text = section_.firstDay == section_.lastDay
                 ? say("Data were collected on {}.", section_.firstDay)
                 : say("Data were collected from {} to {}.", section_.firstDay, section_.lastDay);
    }
    const auto ethics = textOf("ethics");
    auto institution = textOf("institution");
    for (const auto& one : section_.protocol.study.organizations) {
      if (!institution.empty()) break;
      institution = one;
    }
    if (!institution.empty()) text += " " + say("Institution: {}.", institution);
    if (!ethics.empty()) text += " " + say("Ethics: {}.", ethics);
    const auto neither = say("The study names neither an institution nor an ethics reference.");
    const auto noInstitution = say("The study names no institution.");
    const auto noEthics = say("The study names no ethics reference.");
    if (institution.empty() && ethics.empty()) return text + " " + neither;
    if (institution.empty()) return text + " " + noInstitution;
    return ethics.empty() ? text + " " + noEthics : text;
  }

  /// What the laboratory wrote for the blank "[[key]]", without its full stop, because the
  /// sentence around it has one.
  std::string textOf(const std::string& key) const {
    const auto found = section_.protocol.texts.find(key);
    if (found == section_.protocol.texts.end()) return {};
    auto text = found->second.in(section_.words.language());
    if (text.ends_with('.')) text.pop_back();
    return text;
  }

  std::string apparatus() const {
    std::string text;
    for (const auto& device : section_.protocol.devices) {
      const auto& kind = *device.kind;
      const auto force =
          section_.words.say("{:g} N and {:g} N/s", device.maxForce, device.maxForceRate);
      const auto both = section_.words.say(
          "{:g} N and {:g} N/s, torques about it to {:g} N·m and {:g} N·m/s",
          device.maxForce,
          device.maxForceRate,
          device.maxTorque,
          device.maxTorqueRate);
      text += (text.empty() ? "" : " ") +
              say("Device: {}. Forces act along one axis ({}, nominally from {:g} to {:g}) and are "
                  "limited to {}.",
                  section_.words(kind.name),
                  section_.words(kind.shown.axis),
                  kind.shown.factor * kind.travel.least,
                  kind.shown.factor * kind.travel.most,
                  device.needsTorque ? both : force);
    }
    if (section_.quality.rate > 0.0) {
      text += " " + say("They were computed {:.0f} times a second.", section_.quality.rate);
    }
    return text;
  }

  /// The models of the conditions, each once. Models of the same works are cited together.
  std::string models() {
    std::string text;
    std::string publicationsToCite;  // for the clauses since the last citation
    const auto cite = [&] {
      if (!publicationsToCite.empty()) text += " " + citations_.cite(publicationsToCite) + ".";
      publicationsToCite.clear();
    };
    for (std::size_t kind = 0; kind < kModels.size(); ++kind) {
      const auto english =
          section_.words(kModels[kind].english);  // of every model, so that tests find missing ones
      std::string conditions;
      auto publications = std::string(kModels[kind].publications);
      for (const auto& one : section_.protocol.conditions) {
        if (one.model->index() != kind) continue;
        if (isAsPublished(*one.model) && !publications.ends_with(kPunchCode)) {
          publications += ", " + std::string(kPunchCode);
        }
        conditions += (conditions.empty() ? "" : ", ") + section_.conditionTitle(one.id);
      }
      if (conditions.empty()) continue;
      if (publications != publicationsToCite) cite();
      text += text.empty() ? "" : publicationsToCite.empty() ? " " : "; ";
      text += conditions + ": " + english;
      publicationsToCite = publications;
    }
    cite();
    return escaped(text);
  }

  /// Whether the model takes part of its behaviour from the published code.
  static bool isAsPublished(const haptics::engine::ModelSpec& model) {
    const auto parts = haptics::engine::partsOf(model);
    using haptics::models::Extrapolation;
    using haptics::models::ToolInterpolation;
    const bool isCut =
        parts.cut != nullptr && parts.cut->options.extrapolation == Extrapolation::AuthorsClamp;
    const bool isString = parts.elements != nullptr &&
                          parts.elements->parameters.weights == ToolInterpolation::AuthorsFirmware;
    return isCut || isString;
  }

  std::string blinding() const {
    const auto open = say("The protocol declares that conditions are not hidden.");
    const auto hidden =
        say("Participants and operators saw labels only; no condition was named during a session.");
    const auto seen =
        say("Participants saw labels only; no condition was named during a session. In {} of {} "
            "sessions the operator saw the forces, which differ between conditions.",
            section_.sessionsWithForces,
            section_.results.completed());
    const auto participants =
        say("Participants saw labels only; no condition was named during a session.");
    const auto blinded = section_.sessionsWithForces > 0              ? seen
                         : section_.results.runMode == RunMode::Pilot ? participants
                                                                      : hidden;
    const auto disclosed = disclosuresInWords(section_);
    const auto but =
        say("But a reader of the protocol could tell conditions apart by {} (“Limitations”).",
            disclosed);
    if (section_.protocol.isOpenLabel) return open;
    return disclosed.empty() ? blinded : blinded + " " + but;
  }

  /// How many trials, strokes and answers of each condition count.
  std::string exposure() const {
    const auto* family = mainFamily(section_);
    const bool isOfSeveral = family != nullptr && section_.results.families.size() > 1;
    const auto title =
        section_.words.say("“{}”", isOfSeveral ? family->family.title : std::string());
    const auto ofFamily = isOfSeveral ? " (" + title + ")" : std::string();
    std::vector<std::pair<std::string, std::string>> counts;  // condition, counts
    for (const auto& one : section_.quality.conditions) {
      std::uint64_t answers = 0;
      for (std::size_t i = 0; family != nullptr && i < family->cohorts.size(); ++i) {
        for (const auto& sample : family->cohorts[i].conditions) {
          if (sample.name == one.condition) answers += sample.answers.total();
        }
      }
      counts.emplace_back(
          section_.conditionTitle(one.condition),
          fmt::format(
              "{}, {}, {}",
              section_.words.count(one.trials, "{} trial", "{} trials"),
              section_.words.count(one.cuts, "{} cut or stroke", "{} cuts or strokes"),
              section_.words.count(answers, "{} answer", "{} answers") + ofFamily));
    }
    if (counts.empty()) return {};
    const auto isSame = [&](const auto& one) { return one.second == counts.front().second; };
    const auto listed =
        base::joined(counts, "; ", [](const auto& one) { return one.first + ": " + one.second; });
    const auto each = say("Counted for each alternative: {}.", counts.front().second);
    const auto all = say("Counted: {}.", listed);
    return std::ranges::all_of(counts, isSame) ? each : all;
  }

  /// The procedure for a participant, part by part.
  std::string procedure() const {
    std::string text;
    const auto simulated = say("The protocol prescribes what follows; all of it was simulated.");
    if (section_.results.runMode == RunMode::Simulated) text = simulated + " ";
    std::string last;                // what was done in the last block
    std::vector<std::string> forms;  // forms that directly follow each other
    const auto addForms = [&] {
      const auto sentence = say("They filled in {}.", listed(forms, section_.words));
      if (!forms.empty()) text += sentence + " ";
      forms.clear();
    };
    for (const auto& phase : section_.protocol.phases) {
      if (phase.type == PhaseType::Form) {
        forms.push_back(section_.words.say("“{}”", section_.titleOf(phase.instrument)));
        continue;
      }
      addForms();
      if (phase.type != PhaseType::Block) {
        text += phaseOutsideBlocks(phase) + " ";
        continue;
      }
      const auto done = block(phase);
      const auto title = section_.blockTitle(phase.id);
      const auto likewise = say("The same was done in {}.", title);
      text += (done == last ? likewise : say("In {}, {}", title, done)) + " ";
      last = done;
    }
    addForms();
    return text;
  }

  std::string phaseOutsideBlocks(const protocols::Phase& phase) const {
    const auto title =
        phase.instrument.empty() ? std::string() : section_.titleOf(phase.instrument);
    switch (phase.type) {
      case PhaseType::Information:
        return say("Participants read “{}”.", title);
      case PhaseType::Consent:
        return say("They gave their consent (“{}”).", title);
      case PhaseType::Benchmark:
        return benchmark(phase);
      case PhaseType::Preference:
        return preference(phase);
      case PhaseType::Break:
        return phase.seconds > 0.0 ? say("There was a break of at least {:g} s.", phase.seconds)
                                   : say("There was a break.");
      case PhaseType::Interview:
        return say("The operator asked “{}” and wrote down the answers.", title);
      case PhaseType::Debrief:
        return say("At the end they read “{}”.", title);
      case PhaseType::Form:
      case PhaseType::Block:
        break;
    }
    return {};
  }

  /// The physical tool that participants compared with.
  std::string benchmark(const protocols::Phase& phase) const {
    std::string text = count(
        phase.minimumCuts,
        "To have something to compare with, every participant made at least {} cut with the real "
        "tool.",
        "To have something to compare with, every participant made at least {} cuts with the real "
        "tool.");
    const auto& read = phase.text.in(section_.words.language());
    const bool hasBlanks = read.find("[[") != std::string::npos;
    if (!read.empty() && !hasBlanks) text += " " + say("They read: “{}”", read);
    return text;
  }

  std::string block(const protocols::Phase& phase) const {
    constexpr std::array<std::string_view, 6> kOrders{
        "in a fixed order",
        "in the reverse order of {}",
        "in an order drawn for each participant",
        "in the orders of a Latin square",
        "in the orders of a balanced Latin square",
        "in all orders equally often"};
    const auto titleOf = [&](const auto& id) { return section_.conditionTitle(id); };
    std::string text = section_.words.say(
        "every participant felt {} ({}) {}, under labels, with {} each.",
        section_.words.count(phase.trials.conditions.size(), "{} alternative", "{} alternatives"),
        base::joined(phase.trials.conditions, ", ", titleOf),
        section_.words.say(
            kOrders[static_cast<std::size_t>(phase.trials.order.type)],
            section_.blockTitle(phase.trials.order.of)),
        section_.words.count(
            phase.trials.minimumCuts, "at least {} cut or stroke", "at least {} cuts or strokes"));
    const auto& skipped = section_.quality.interrupted.skipped;
    if (const auto found = skipped.find(phase.id); found != skipped.end()) {
      text +=
          " " +
          section_.words.count(
              found->second, "Of these trials {} was skipped.", "Of these trials {} were skipped.");
    }
    for (const auto& asked : phase.trials.questionnaires) {
      text +=
          " " + section_.words.say(
                    "After each of them they answered “{}”.", section_.titleOf(asked.instrument));
    }
    return text;
  }

  std::string preference(const protocols::Phase& phase) const {
    std::string text =
        say("After {}, participants chose among the alternatives (“{}”).",
            section_.blockTitle(phase.block),
            section_.titleOf(phase.instrument));
    if (!phase.hasOptionalTrials) return text;
    return text + " " +
           say("Before, they could feel each of them once more, or go on without; nothing is "
               "computed from these trials.");
  }

  void sources() {
    list("What was felt came from:", false);
    list("What was seen came from:", true);
  }

  /// Writes a list of the sources of what scenes show on the screen, or of the forces that they
  /// render, each with its conditions.
  void list(std::string_view words, bool isShownOnScreen) {
    std::string lines;
    for (const auto& source : section_.sources) {
      if ((source.kind == kShownSourceKind) != isShownOnScreen) continue;
      const auto titleOf = [&](const auto& id) { return section_.conditionTitle(id); };
      const auto conditions = base::joined(source.conditions, ", ", titleOf);
      lines += fmt::format("<li>{}: {}</li>", describe(source), escaped(conditions));
    }
    const auto computed = say("parameters of the protocol; nothing was recorded or measured");
    std::vector<std::string> others;
    for (const auto& id : withoutSource(section_)) others.push_back(section_.conditionTitle(id));
    if (!isShownOnScreen && !others.empty()) {
      lines += fmt::format("<li>{}: {}</li>", computed, escaped(listed(others, section_.words)));
    }
    if (!lines.empty()) put("<p>{}</p><ul>{}</ul>", section_.words(words), lines);
  }

  std::string describe(const protocols::SceneDataSource& source) const {
    const auto title = section_.words(source.title);
    const auto kind = section_.words(source.kind);
    std::string text = source.isSynthetic ? say("SYNTHETIC") + ": " : "";
    text += source.file.empty() ? say("{} ({}, built into the program)", title, kind)
                                : say("{} ({} '{}')", title, kind, source.file);
    const auto origin = base::joined(source.origin, ", ", section_.words);
    return origin.empty() ? text : text + ", " + escaped(origin);
  }

  /// The instruments by their sources, each of which is written once.
  void instruments() {
    std::vector<std::pair<std::string, std::string>> titles;  // source, titles
    for (const auto& i : section_.instruments) {
      const auto& title = i.title.in(section_.words.language());
      const auto same =
          std::ranges::find(titles, i.source.citation, &std::pair<std::string, std::string>::first);
      if (same == titles.end()) {
        titles.emplace_back(i.source.citation, title);
      } else {
        same->second += ", " + title;
      }
    }
    put("<p>{}</p><ul>", say("Instruments:"));
    const auto palpates = section_.words("Palpate’s own wording.");
    const auto own = section_.words(kOwnWording);
    for (const auto& [source, named] : titles) {
      const auto said = source == kPalpatesWording ? palpates
                        : source == kOwnWording    ? own
                                                   : source;
      put("<li>{}{}</li>", escaped(named), said.empty() ? said : ": " + escaped(said));
    }
    put("</ul>");
  }

  Citations citations_;
};

}  // namespace

std::string disclosuresInWords(const ReportSection& section) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kWays{
      {{"labels_tell", "the number of an alternative"},
       {"order_tells", "the position in a fixed order"},
       {"statements_tell", "the statements that were asked"},
       {"blocks_tell", "the rounds in which they were felt"},
       {"seed_tells", "the seed in the protocol"}}};
  std::vector<std::string> ways;
  const auto disclosures = protocols::disclosuresOf(section.protocol);
  for (const auto& one : kWays) {
    const auto way = section.words(one.second);
    const bool isDisclosed = std::ranges::any_of(
        disclosures, [&](const auto& other) { return other.what.key() == one.first; });
    if (isDisclosed) ways.push_back(way);
  }
  return listed(ways, section.words);
}

std::string methodsAsHtml(const ReportSection& section) {
  return MethodsWriter(section).all();
}

}  // namespace study::report
