#include <algorithm>
#include <array>

#include "base/joined.h"
#include "study/model/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/answer_tables.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

/// Writes the beginning of the page: notes for the reader, and the question.
class HeadWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    banner();
    const auto [finding, more, caveats] = conclusionOf(section_);
    if (!finding.empty()) put("<p class=\"verdict\">{}</p>", escaped(finding));
    if (!more.empty()) put("<p>{}</p>", escaped(more));
    if (!section_.results.families.empty()) heading("The question");
    for (const auto& family : section_.results.families) putDeclared(family);
    const auto changes = base::joined(planChangesInWords(section_), " ");
    if (!changes.empty()) put("<p>{}</p>", escaped(changes));
    const auto names =
        say("Titles of the study, of its methods and of what is compared are as in "
            "the protocol, which has them in one language.");
    const bool isTranslated = section_.words.language() != "en";
    if (isTranslated && !section_.results.families.empty()) put("<p class=\"note\">{}</p>", names);
    return std::move(html_);
  }

 private:
  void putDeclared(const FamilyResult& result) {
    const auto& family = result.family;
    std::vector<std::string> compared;
    for (const auto& id : conditionsOf(section_.protocol, family)) {
      const auto introduced = section_.introducedTitle(id);
      const bool isFirst = verdictOf(section_).find(introduced) == std::string::npos;
      compared.push_back(isFirst ? introduced : section_.conditionTitle(id));
    }
    const auto judged = whatIsCompared(family);
    // in sessions that are no participants' nothing says which version came before them
    const bool isBeforeAll =
        section_.history.versions == 1 || section_.results.runMode == RunMode::Live;
    const auto plan = say(
        result.isDeclared && !isBeforeAll
            ? "“{}”: {} are compared. The protocol declares: {}, α = {}."
        : result.isDeclared ? "“{}”: {} are compared. Declared before the first participant: {}, "
                              "α = {}."
        : isChanged(family.id)
            ? "“{}”: {} are compared. Changed after the first participant had begun, and "
              "exploratory: {}, α = {}."
            : "“{}”: {} are compared. Not declared before the first participant, and "
              "exploratory: {}, α = {}.",
        family.title,
        listed(compared, section_.words),
        declaredInWords(family, section_.words),
        exactDecimal(family.alpha));
    put("<p>{}{}</p>", plan, judged.empty() ? judged : " " + judged);
  }

  /// Whether a later version changed what the family declares.
  bool isChanged(const std::string& family) const {
    return std::ranges::any_of(section_.history.changes, [&](const auto& change) {
      return change.family == family && change.kind != FamilyChange::Kind::Added;
    });
  }

  /// "Compared are the answers to 6 questions (3 reversed) in round 1 and round 2; scale from 1 to
  /// 5.", or "Compared is the score “Realism” of 6 questions …"; without the rounds if no other
  /// round asks.
  std::string whatIsCompared(const protocols::Family& family) const {
    const auto* instrument = section_.instrument(family.instrument);
    if (instrument == nullptr) return {};
    const auto* score = instrument->score(family.score);
    auto items = protocols::comparedItems(family, instrument->items);
    if (score != nullptr) {
      for (const auto& id : score->items) items.push_back(*instrument->item(id));
    }
    const auto reversed = std::ranges::count_if(items, [&](const auto& item) {
      return item.key < 0 && (score == nullptr || score->reverseByKey);
    });
    std::vector<std::string> blocks;
    bool isAnyLeftOut = false;
    for (const auto& phase : section_.protocol.phases) {
      const bool isAsked =
          std::ranges::find(
              phase.trials.questionnaires,
              family.instrument,
              &protocols::ConditionQuestionnaire::instrument) != phase.trials.questionnaires.end();
      if (!isAsked) continue;
      if (family.usesBlock(phase.id)) {
        blocks.push_back(section_.blockTitle(phase.id));
      } else {
        isAnyLeftOut = true;
      }
    }
    if (items.empty() || blocks.empty()) return {};
    const auto answers = count(
        items.size(),
        "Compared are the answers to {} question ({} reversed)",
        "Compared are the answers to {} questions ({} reversed)",
        reversed);
    const auto ofScore = count(
        items.size(),
        "Compared is the score “{1}” of {0} question ({2} reversed)",
        "Compared is the score “{1}” of {0} questions ({2} reversed)",
        score == nullptr ? std::string() : score->title.in(section_.words.language()),
        reversed);
    const auto rounds = " " + say("in {}", listed(blocks, section_.words));
    const auto scale = escaped(withCurlyQuotes(scaleInWords(section_, family)));
    return (score == nullptr ? answers : ofScore) +
           (blocks.size() > 1 || isAnyLeftOut ? rounds : std::string()) +
           (scale.empty() ? "" : "; " + scale) + ".";
  }

  /// One banner for all that a reader must know before any number.
  void banner() {
    std::string text = escaped(withCurlyQuotes(originInWords(section_)));
    const auto made = syntheticInWords();
    const bool isOfPilotOnly = section_.results.runMode == RunMode::Pilot && made.empty();
    if (!made.empty()) text += (text.empty() ? "" : " ") + made;
    if (text.empty()) return;
    put("<p class=\"{}\">{}</p>", isOfPilotOnly ? "banner pilot" : "banner", text);
  }

  std::string syntheticInWords() const {
    std::string made;
    const auto add = [&](const std::vector<std::string>& ids, const std::string& source) {
      std::vector<std::string> conditions;
      for (const auto& id : ids) conditions.push_back(section_.conditionTitle(id));
      made += (made.empty() ? "" : "; ") +
              section_.words.say("{} (from: {})", listed(conditions, section_.words), source);
    };
    for (const auto& source : section_.sources) {
      if (source.isSynthetic) add(source.conditions, section_.words(source.title));
    }
    const auto parameters = section_.words("parameters of the protocol");
    if (made.empty()) return {};
    if (const auto others = withoutSource(section_); !others.empty()) add(others, parameters);
    return say(
        "SYNTHETIC, neither recorded nor measured: {}. See “How this was "
        "made”.",
        made);
  }
};

class ParticipantWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    heading("Participants");
    int enrolled = 0;
    bool isAnyErased = false;
    std::string cohorts;
    for (const auto& flow : section_.results.flow) {
      enrolled += flow.enrolled;
      isAnyErased = isAnyErased || flow.erased > 0;
      const auto* planned = section_.protocol.cohort(flow.cohort);
      const bool isPlanned = planned != nullptr && planned->planned > 0;
      if (flow.completed == 0 && !isPlanned) continue;
      const auto ofPlan = say("{} of {} planned", flow.completed, isPlanned ? planned->planned : 0);
      cohorts += (cohorts.empty() ? "" : ", ") + cohort(flow.cohort) + " " +
                 (isPlanned ? ofPlan : std::to_string(flow.completed));
    }
    put("<p>{}{}.</p>",
        count(
            enrolled,
            "{1} of {0} enrolled participant completed the session",
            "{1} of {0} enrolled participants completed their sessions",
            section_.results.completed()),
        cohorts.empty() ? cohorts : " (" + cohorts + ")");
    std::vector<std::string> headings{say("Cohort")};
    for (const auto& [column, count] : kColumns) headings.push_back(say(column));
    const bool didAllComplete = section_.results.completed() == enrolled;
    if (!didAllComplete) {
      table(say("Who took part"), headings);
      for (const auto& flow : section_.results.flow) add(cohort(flow.cohort), flow);
      endTable();
    }
    headings.front() = say("Site");
    table(say("Who took part, by site"), headings);
    for (const auto& [site, flow] : section_.results.siteFlow) add(escaped(site), flow);
    endTable();
    if (!didAllComplete) notes(isAnyErased);
    warnOfSinglePeople();
    return std::move(html_);
  }

 private:
  using Count = std::pair<std::string_view, int CohortFlow::*>;
  static constexpr std::array<Count, 8> kColumns{
      {{"Enrolled", &CohortFlow::enrolled},
       {"Completed", &CohortFlow::completed},
       {"In progress", &CohortFlow::inProgress},
       {"Declined", &CohortFlow::declined},
       {"Withdrawn", &CohortFlow::withdrawn},
       {"Rejected", &CohortFlow::rejected},
       {"Device failed", &CohortFlow::abortedHardware},
       {"Erased", &CohortFlow::erased}}};

  /// Warns of numbers that are one person's answers.
  void warnOfSinglePeople() {
    std::vector<std::string> alone;
    for (const auto& flow : section_.results.flow) {
      const bool isPerson = section_.results.runMode != RunMode::Simulated;
      if (isPerson && flow.completed == 1) alone.push_back(section_.cohortTitle(flow.cohort));
    }
    const auto warning =
        say("This report shows the answers of one person ({}): do not hand it on where this person "
            "may be recognised.",
            listed(alone, section_.words));
    const auto warnings =
        say("This report shows the answers of single people ({}): do not hand it on where they may "
            "be recognised.",
            listed(alone, section_.words));
    if (!alone.empty()) {
      put("<p><strong>{}</strong></p>", alone.size() == 1 ? warning : warnings);
    }
  }

  void add(const std::string& who, const CohortFlow& flow) {
    std::vector<std::string> cells{who};
    for (const auto& [column, count] : kColumns) {
      cells.push_back(flow.*count == 0 ? std::string() : std::to_string(flow.*count));
    }
    row(cells);
  }

  void notes(bool isAnyErased) {
    note(
        "Only completed sessions count below, and of these only steps that were finished and not "
        "repeated. Reasons for leaving are omitted to protect anonymity.");
    const auto erased = say(
        "Erased: answers and traces were deleted at the participant's request, and no number below "
        "contains them.");
    if (isAnyErased) put("<p class=\"note\">{}</p>", erased);
  }
};

}  // namespace

std::vector<std::string> withoutSource(const ReportSection& section) {
  std::vector<std::string> ids;
  for (const auto& one : section.protocol.conditions) {
    const bool hasSource = std::ranges::any_of(section.sources, [&](const auto& source) {
      return source.kind != kShownSourceKind &&
             std::ranges::find(source.conditions, one.id) != source.conditions.end();
    });
    if (!hasSource) ids.push_back(one.id);
  }
  return ids;
}

std::string headAsHtml(const ReportSection& section) {
  return HeadWriter(section).all();
}

std::string participantsAsHtml(const ReportSection& section) {
  return ParticipantWriter(section).all();
}

std::span<const CommonPart> commonParts() noexcept {
  static constexpr std::array kParts{
      CommonPart{"Preferences", preferencesAsHtml},
      CommonPart{"Questionnaires", instrumentsAsHtml},
      CommonPart{"Every item by itself", itemsAsHtml},
      CommonPart{"In participants’ own words", quotesAsHtml},
      CommonPart{"What each alternative felt like", renderingAsHtml},
      CommonPart{"Limitations", limitationsAsHtml},
      CommonPart{"Validity evidence", validityAsHtml},
      CommonPart{"Methods", methodsAsHtml}};
  return kParts;
}

std::vector<AppendixPart> appendixOf(const ReportSection& section) {
  std::vector<AppendixPart> parts;
  const auto& figures = section.figures.families;
  for (std::size_t i = 0; i < section.results.families.size(); ++i) {
    const auto& family = section.results.families[i];
    auto html = familyAsHtml(section, family, i < figures.size() ? figures[i] : FamilyFigures{});
    if (!html.empty()) parts.push_back({family.family.title, std::move(html)});
  }
  for (const auto& part : commonParts()) {
    if (auto html = part.html(section); !html.empty()) {
      parts.push_back({section.words(part.heading), std::move(html)});
    }
  }
  return parts;
}

}  // namespace study::report
