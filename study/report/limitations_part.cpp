#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>

#include "base/joined.h"
#include "base/search.h"
#include "study/report/html_writer.h"
#include "study/report/references.h"
#include "study/report/study_parts.h"

namespace study::report {
namespace {

/// The index of the last of kFlagsBySeverity that weighs more than a disclosure (kDisclosures).
constexpr std::ptrdiff_t kLastSeverityBeforeDisclosures = 3;

/// Warnings about files that say nothing about results.
constexpr std::array<std::string_view, 18> kFileWarnings{
    "no_normals",
    "normals_without_direction",
    "knee_never_seen",
    "device_not_used",
    "condition_not_used",
    "no_text",
    "no_texts_in",
    "language_not_listed",
    "texts_not_listed",
    "language_of_windows",
    "braces_not_known",
    "date_not_iso",
    "blank_left",
    "blank_left_in",
    "text_not_used",
    "instrument_not_asked",
    "hides_library_instrument",
    "items_not_analysed"};

/// Warnings of the protocol's check, each with the flag below which it stands where it is raised.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kWarningsOfFlags{
    {{"unlike_statements", "items_not_common_to_methods"},
     {"pooled_answers", "pseudo_replication"},
     {"same_order", "order_not_counterbalanced"},
     {"no_previous", "relative_item_without_referent"}}};

/// Warnings about what tells conditions apart.
constexpr std::array<std::string_view, 5> kDisclosures{
    "labels_tell", "order_tells", "statements_tell", "blocks_tell", "seed_tells"};

/// All kinds of flags, the heaviest first.
constexpr std::array<std::string_view, 15> kFlagsBySeverity{
    "items_not_common_to_methods",
    "n_below_minimum_for_alpha",
    "pseudo_replication",
    "constant_group",
    "family_not_declared",
    "answered_otherwise",
    "other_scale",
    "order_not_counterbalanced",
    "relative_item_without_referent",
    "missing_cells",
    "paired_data_unpaired_test",
    "bimodal",
    "alpha_rounded",
    "late_ticks",
    "saturated"};

/// Flags that concern tests or distributions, which a study of one participant does not have.
constexpr std::array<std::string_view, 6> kFlagsThatNeedSeveralPeople{
    "n_below_minimum_for_alpha",
    "pseudo_replication",
    "paired_data_unpaired_test",
    "bimodal",
    "constant_group",
    "alpha_rounded"};

/// A sentence that describes a limitation, and the ids of the cohorts to which it applies.
struct LimitationFinding {
  std::string sentence;
  std::vector<std::string> cohorts;
};

/// A kind of flag, with what was found in each cohort and family.
struct Limitation {
  const analysis::Flag* flag;
  std::vector<LimitationFinding> found;
};

/// A limitation as it is printed.
struct Point {
  std::string title;
  std::string more;  ///< for the list on the first page; empty: the title says enough
  std::string explanation;
  std::vector<std::string> list{};  ///< below the explanation
};

/// Writes what weakens the answer: the first page has a title for each point, and the appendix
/// explains each, in the same order.
class LimitationsWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  /// The caveats on the rendering: the answer is then about something other than the methods. They
  /// come before the weaknesses.
  std::string renderingCaveats() {
    for (const auto& limitation : limitations()) {
      if (!limitation.flag->concernsRendering) continue;
      for (const auto& found : limitation.found) {
        put("<p><strong>{}</strong></p>", sentenceOf(limitation, found));
      }
    }
    return std::move(html_);
  }

  std::string weaknessesInBrief() {
    if (section_.results.completed() == 0) return {};
    const bool isOfOne = section_.results.completed() == 1;
    const auto weakens = say("What weakens the answer");
    const auto limits = say("Limitations");
    put("<h3>{}</h3>", isOfOne ? limits : weakens);
    std::string items;
    for (const auto& point : points()) {
      items += "<li>" + point.title + (point.more.empty() ? "" : ": " + point.more) + "</li>";
    }
    if (!items.empty()) put("<ul>{}</ul>", items);
    const bool hasFlags = !limitations().empty();
    const auto none =
        say("None of {} checks of the trials and of the compared answers found anything; "
            "“Limitations” in the appendix says what they look for.",
            std::ranges::count_if(kFlagsBySeverity, [&](auto id) { return isLookedFor(id); }));
    const auto singlePersonText = say("The checks of the compared answers need more participants.");
    const auto explained = say("All of it is explained in the appendix, under “Limitations”.");
    put("<p class=\"note\">{}</p>", hasFlags ? explained : isOfOne ? singlePersonText : none);
    return std::move(html_);
  }

  std::string all() {
    if (section_.results.completed() == 0) return {};
    put("<dl class=\"flags\">");
    for (const auto& [title, more, explanation, list] : points()) {
      std::string items;
      for (const auto& item : list) items += "<li>" + item + ".</li>";
      put("<dt>{}</dt><dd>{}{}</dd>",
          title,
          explanation.empty() ? std::string() : "<p>" + explanation + "</p>",
          items.empty() ? items : "<ul>" + items + "</ul>");
    }
    put("</dl>");
    putChecksWithoutFinding(limitations());
    return std::move(html_);
  }

  /// The flags that all() explains, with their sources.
  std::vector<const analysis::Flag*> explainedFlags() const {
    std::vector<const analysis::Flag*> flags;
    for (const auto& limitation : limitations()) flags.push_back(limitation.flag);
    return flags;
  }

 private:
  /// "Hurlbert, 1984; Palpate’s manual, Statistics: planning": works as in the list of references.
  std::string sourcesOf(const analysis::Flag& flag) const {
    return base::joined(flag.source, "; ", [&](const auto& source) {
      return escaped(
          source.key().empty() ? authorsAndYear(base::describe(source)) : section_.words(source));
    });
  }

  /// All limitations, the heaviest first.
  std::vector<Point> points() const {
    auto points = sampleSize();
    if (section_.sessionsWithForces > 0 && !section_.protocol.isOpenLabel) {
      points.push_back(operatorSawForces());
    }
    const auto told = disclosures();
    const auto found = limitations();
    const auto isHeavy = [](const auto& one) {
      return severityOf(one) <= kLastSeverityBeforeDisclosures;
    };
    for (const auto& one : found) {
      if (isHeavy(one)) points.push_back(pointOf(one));
    }
    if (told) points.push_back(*told);
    for (const auto& one : found) {
      if (!isHeavy(one)) points.push_back(pointOf(one));
    }
    if (const auto all = notConfirmed(false); !all.empty()) {
      const auto title = say("Significant by the declared test only");
      points.push_back({title, notConfirmed(true), all + "."});
    }
    if (const auto all = foundByOthers(); !all.empty()) {
      points.push_back({say("Significant by other tests only"), {}, all + "."});
    }
    if (const auto chance = families(); !chance.empty()) {
      points.push_back({say("Corrections within each family and cohort"), {}, chance + "."});
    }
    auto remarks = otherWarnings(told.has_value());
    const auto title = count(remarks.size(), "{} remark on the design", "{} remarks on the design");
    if (!remarks.empty()) points.push_back({title, {}, {}, std::move(remarks)});
    return points;
  }

  Point operatorSawForces() const {
    return {
        say("The operator saw the forces in {} of {} sessions",
            section_.sessionsWithForces,
            section_.results.completed()),
        {},
        say("Conditions differ in their forces: who sees them may guess which alternative is "
            "which, and let the participant know without meaning to.")};
  }

  Point pointOf(const Limitation& limitation) const {
    const auto& flag = *limitation.flag;
    std::string sentences;
    for (const auto& one : limitation.found) sentences += sentenceOf(limitation, one) + " ";
    if (flag.concernsRendering) sentences.clear();  // the first page has them
    const bool isOfAll = cohortsIn(limitation).size() == cohortsWithPeople().size();
    Point point{
        inWords(flag.title()),
        isOfAll ? std::string() : escaped(titlesOf(cohortsIn(limitation))),
        fmt::format(
            "{}{} <span class=\"source\">({})</span>",
            sentences,
            inWords(flag.why),
            sourcesOf(flag))};
    for (const auto& warning : section_.warnings) {
      if (flagOf(warning) == flag.id) addNew(point.list, warning);
    }
    return point;
  }

  /// The flag that tells what a warning does; empty if none does.
  static std::string_view flagOf(const questionnaires::Problem& warning) {
    const auto key = warning.what.key();
    const auto told =
        std::ranges::find(kWarningsOfFlags, key, [](const auto& one) { return one.first; });
    return told == kWarningsOfFlags.end() ? std::string_view() : told->second;
  }

  /// By what a reader of the protocol could tell conditions apart.
  std::optional<Point> disclosures() const {
    const auto disclosed = disclosuresInWords(section_);
    if (disclosed.empty()) return std::nullopt;
    Point point{
        say("A reader of the protocol could tell conditions apart by {}", disclosed),
        {},
        say("Labels hide a method only from those who do not know the protocol. Who knows it, such "
            "as staff, may know which method is judged, and what they expect can show in "
            "answers.")};
    for (const auto& warning : section_.warnings) {
      if (base::contains(kDisclosures, warning.what.key())) addNew(point.list, warning);
    }
    return point;
  }

  static std::ptrdiff_t severityOf(const Limitation& limitation) {
    return std::ranges::find(kFlagsBySeverity, limitation.flag->id) - kFlagsBySeverity.begin();
  }

  /// The cohorts in which only one person completed, in a study of several.
  std::string singleParticipantsInWords() const {
    std::vector<std::string> alone;
    for (const auto& flow : section_.results.flow) {
      if (flow.completed == 1) alone.push_back(flow.cohort);
    }
    const auto only = say("One participant only");
    const auto each = say("One participant only in: {}", titlesOf(alone));
    return alone.empty() ? std::string() : section_.results.completed() == 1 ? only : each;
  }

  /// "Orthopaedic surgeons 1 of 6"; empty if all that were planned completed.
  std::string missingParticipantsInWords() const {
    std::string fewer;
    for (const auto& flow : section_.results.flow) {
      const auto* planned = section_.protocol.cohort(flow.cohort);
      if (planned == nullptr || flow.completed >= planned->planned) continue;
      fewer +=
          (fewer.empty() ? "" : ", ") +
          say("{} {} of {}", section_.cohortTitle(flow.cohort), flow.completed, planned->planned);
    }
    return fewer;
  }

  std::vector<Point> sampleSize() const {
    std::vector<Point> points;
    const auto alone = singleParticipantsInWords();
    const auto singlePersonText =
        say("The numbers are those of one person: nothing can be compared, and they show "
            "how this person rated, scored and voted. Answers to other single items are left out, "
            "and so are scores from which one could be worked out.");
    if (!alone.empty()) points.push_back({alone, {}, singlePersonText});
    const auto fewer = missingParticipantsInWords();
    const auto early =
        say("Differences are known less well than planned; where the results decided when to stop, "
            "p values lose their meaning.");
    const bool isOfOne = section_.results.completed() == 1;
    if (!fewer.empty()) {
      points.push_back(
          {say("Fewer participants than planned"),
           fewer,
           fewer + "." + (isOfOne ? std::string() : " " + early)});
    }
    return points;
  }

  /// Which significant results of declared paired t-tests no exact test finds, too; empty if none.
  /// @param isBrief  whether to name only a few
  std::string notConfirmed(bool isBrief) const {
    constexpr std::size_t kFew = 3;
    int significant = 0;
    std::vector<std::string> alone;
    for (const auto& family : section_.results.families) {
      if (!family.isDeclared || !family.isNamed("paired_t")) continue;
      for (const auto& part : family.cohorts) {
        for (const auto& row : part.within.rows) {
          if (!row.test("paired_t").isSignificant.value_or(false)) continue;
          ++significant;
          const auto isFound = [&](const char* id) {
            return row.test(id).isSignificant.value_or(false);
          };
          if (isFound("sign_flip") || isFound("signed_rank")) continue;
          alone.push_back(withExactTests(family, part, row));
        }
      }
    }
    const auto sentence = count(
        alone.size(),
        "{} of {} significant differences is not significant by either exact test (exploratory)",
        "{} of {} significant differences are not significant by either exact test (exploratory)",
        significant);
    if (alone.empty()) return {};
    return isBrief && alone.size() > kFew ? sentence
                                          : sentence + ": " + listed(alone, section_.words);
  }

  /// Which differences tests within people find that were not declared, and the declared one does
  /// not; empty if none.
  std::string foundByOthers() const {
    std::vector<std::string> all;
    for (const auto& family : section_.results.families) {
      if (!family.isDeclared || isPooled(Profile::Declared, family.family)) continue;
      const auto declared = study::idOf(family.family.test);
      for (const auto& part : family.cohorts) {
        for (const auto& row : part.within.rows) {
          if (!row.test(declared).p || row.test(declared).isSignificant.value_or(false)) continue;
          std::string tests;
          for (const auto& test : row.tests) {
            if (!test.isInFamily || !test.isSignificant.value_or(false)) continue;
            tests += (tests.empty() ? "" : ", ") + section_.words(shortNameOf(test.id)) + " " +
                     formatPWithSymbol(
                         test.adjusted ? test.adjusted : test.p,
                         test.adjusted ? nameOf(family.family.correction) : std::string_view(),
                         section_.wording);
          }
          if (!tests.empty()) all.push_back(withSubscripts(differenceIn(part, row) + tests + ")"));
        }
      }
    }
    if (all.empty()) return {};
    const auto sentence = count(
        all.size(),
        "{} difference is significant only by tests that were not declared (exploratory)",
        "{} differences are significant only by tests that were not declared (exploratory)");
    return sentence + ": " + listed(all, section_.words);
  }

  /// "KF − FEM (Surgeons: ": a difference, and who differed.
  std::string differenceIn(const CohortResult& part, const analysis::WithinComparison& row) const {
    return escaped(
        section_.conditionTitle(row.group1) + " − " + section_.conditionTitle(row.group2) + " (" +
        section_.cohortTitle(part.cohort) + ": ");
  }

  /// "KF − FEM (Surgeons: p_Holm = .047; exact .060 and .066)"
  std::string withExactTests(
      const FamilyResult& family,
      const CohortResult& part,
      const analysis::WithinComparison& row) const {
    const auto pOf = [&](const char* id) {
      const auto& test = row.test(id);
      return test.adjusted ? test.adjusted : test.p;
    };
    return withSubscripts(
        say("{} − {} ({}: {}; exact {} and {})",
            section_.conditionTitle(row.group1),
            section_.conditionTitle(row.group2),
            section_.cohortTitle(part.cohort),
            formatPWithSymbol(pOf("paired_t"), nameOf(family.family.correction), section_.wording),
            formatP(pOf("sign_flip"), section_.wording),
            formatP(pOf("signed_rank"), section_.wording)));
  }

  /// The chance of a false finding in any cohort and family; empty if there is one of each.
  std::string families() const {
    std::set<std::string> cohorts;
    double alpha = 0.0;
    std::size_t tested = 0;
    for (const auto& family : section_.results.families) {
      bool isTested = false;
      for (const auto& part : family.cohorts) {
        const auto rows = declaredIn(family, part);
        if (std::ranges::none_of(rows, &Declared::isDefined)) continue;
        cohorts.insert(part.cohort);
        isTested = true;
      }
      if (!isTested) continue;
      ++tested;
      const bool isCorrected = !nameOf(family.family.correction).empty();
      const auto comparisons = static_cast<double>(family.family.comparisons.size());
      alpha += family.family.alpha * (isCorrected ? 1.0 : comparisons);
    }
    // families of one cohort are of the same people, cohorts are independent
    const double chance =
        1.0 - std::pow(1.0 - std::min(alpha, 1.0), static_cast<double>(cohorts.size()));
    const auto sentence = say(
        "p is corrected within each of {} analyses (families by cohorts): if all methods were "
        "alike, tests that keep their α would call at least one significant in up to {:.0f} % of "
        "such studies",
        tested * cohorts.size(),
        100.0 * chance);
    return tested * cohorts.size() < 2 ? std::string() : sentence;
  }

  /// Whether a study can have this weakness: only a later version of the protocol changes
  /// questions.
  bool isPossible(std::string_view id) const {
    return section_.history.versions > 1 || (id != "answered_otherwise" && id != "other_scale");
  }

  /// Whether this weakness can be looked for: in simulated time no tick is late, and a study of one
  /// participant has neither tests nor distributions.
  bool isLookedFor(std::string_view id) const {
    if (!isPossible(id)) return false;
    if (id == "late_ticks") return section_.quality.worstLateness.has_value();
    return section_.results.completed() != 1 || !base::contains(kFlagsThatNeedSeveralPeople, id);
  }

  /// Which weaknesses were not found, or could not be looked for; not of a single participant.
  void putChecksWithoutFinding(const std::vector<Limitation>& found) {
    if (section_.results.completed() == 1) return;
    std::string absent;
    std::string unknown;
    for (const auto id : kFlagsBySeverity) {
      const auto isSame = [&](const auto& other) { return other.flag->id == id; };
      if (!isPossible(id) || std::ranges::any_of(found, isSame)) continue;
      auto& titles = isLookedFor(id) ? absent : unknown;
      titles += (titles.empty() ? "" : "; ") + inWords(analysis::Flag{.id = id}.title());
    }
    std::string text;
    const auto lookedFor = say("Looked for in the answers that are compared, and not found:");
    const auto couldNot = say("Could not be looked for:");
    if (!absent.empty()) text = lookedFor + " " + absent + ".";
    if (!unknown.empty()) text += (text.empty() ? "" : " ") + couldNot + " " + unknown + ".";
    if (!text.empty()) put("<p>{}</p>", text);
  }

  /// All limitations of the families, each kind once. Flags on pooled tests are left out if the
  /// protocol declares no pooled test, because the report then has none.
  std::vector<Limitation> limitations() const {
    std::vector<Limitation> all;
    for (const auto& family : section_.results.families) {
      const auto title = section_.words.say("“{}”", family.family.title) + ": ";
      for (const auto& raised : flagsByKind(family, isPooled(Profile::Declared, family.family))) {
        if (section_.results.completed() == 1 &&
            base::contains(kFlagsThatNeedSeveralPeople, raised.flag->id))
          continue;
        auto same = std::ranges::find_if(
            all, [&](const auto& other) { return other.flag->id == raised.flag->id; });
        if (same == all.end()) same = all.insert(all.end(), {raised.flag, {}});
        const bool isNamed =
            section_.results.families.size() > 1 && !raised.flag->concernsRendering;
        for (const auto& [cohort, flag] : raised.found) {
          add(same->found, cohort, *flag, isNamed ? title : std::string());
        }
      }
    }
    std::ranges::stable_sort(all, {}, severityOf);
    return all;
  }

  void add(
      std::vector<LimitationFinding>& found,
      const std::string& cohort,
      const analysis::Flag& flag,
      std::string what) const {
    for (const auto& part : flag.what) what += section_.inWords(part);
    auto same = std::ranges::find(found, what, &LimitationFinding::sentence);
    if (same == found.end()) same = found.insert(found.end(), {what, {}});
    if (!base::contains(same->cohorts, cohort)) same->cohorts.push_back(cohort);
  }

  std::vector<std::string> cohortsWithPeople() const {
    std::vector<std::string> ids;
    for (const auto& flow : section_.results.flow) {
      if (flow.completed > 0) ids.push_back(flow.cohort);
    }
    return ids;
  }

  /// The cohorts with people to which a limitation applies.
  std::vector<std::string> cohortsIn(const Limitation& limitation) const {
    auto ids = cohortsWithPeople();
    std::erase_if(ids, [&](const auto& id) {
      return std::ranges::none_of(
          limitation.found, [&](const auto& found) { return base::contains(found.cohorts, id); });
    });
    return ids;
  }

  std::string titlesOf(const std::vector<std::string>& cohorts) const {
    std::vector<std::string> titles;
    for (const auto& id : cohorts) titles.push_back(section_.cohortTitle(id));
    return listed(titles, section_.words);
  }

  /// What was found, after the names of the cohorts to which it applies.
  std::string sentenceOf(const Limitation& limitation, const LimitationFinding& found) const {
    const auto each = say("In each cohort") + ": ";
    const auto cohorts = cohortsWithPeople().size();
    const bool isOfAll = limitation.found.size() == 1 && cohortsIn(limitation).size() == cohorts;
    const auto who = cohorts == 1 ? std::string()
                     : isOfAll    ? each
                                  : escaped(titlesOf(found.cohorts)) + ": ";
    return who + escaped(found.sentence);
  }

  /// What the check of the protocol says about its design, and no other point does.
  /// @param hasDisclosures  whether a point has those that tell conditions apart
  std::vector<std::string> otherWarnings(bool hasDisclosures) const {
    const auto found = limitations();
    const auto isFound = [&](std::string_view flag) {
      return std::ranges::any_of(found, [&](const auto& one) { return one.flag->id == flag; });
    };
    std::vector<std::string> all;
    for (const auto& warning : section_.warnings) {
      const auto key = warning.what.key();
      if (base::contains(kFileWarnings, key) ||
          (hasDisclosures && base::contains(kDisclosures, key)))
        continue;
      if (!isFound(flagOf(warning))) addNew(all, warning);
    }
    return all;
  }

  void addNew(std::vector<std::string>& all, const questionnaires::Problem& warning) const {
    auto sentence = placeOf(warning) + inWords(warning.what);
    if (std::ranges::find(all, sentence) == all.end()) all.push_back(std::move(sentence));
  }

  /// The title of the condition or block to which a warning belongs, unless it names it itself.
  std::string placeOf(const questionnaires::Problem& warning) const {
    const auto& path = warning.path;
    const auto isNamed = [&](const std::string& id) {
      return std::ranges::any_of(warning.what.arguments(), [&](const auto& argument) {
        const auto* text = std::get_if<std::string>(&argument);
        return text != nullptr && *text == id;
      });
    };
    const auto indexIn = [&](const std::string& list) -> std::size_t {
      const auto at = path.find("$." + list + "[");
      if (at != 0) return std::string::npos;
      return static_cast<std::size_t>(std::atoi(path.c_str() + list.size() + 3));
    };
    const auto& phases = section_.protocol.phases;
    const auto& conditions = section_.protocol.conditions;
    if (const auto i = indexIn("phases"); i < phases.size()) {
      const bool isBlock = phases[i].type == protocols::PhaseType::Block;
      return isBlock && !isNamed(phases[i].id) ? escaped(section_.blockTitle(phases[i].id)) + ": "
                                               : std::string();
    }
    if (const auto i = indexIn("conditions"); i < conditions.size()) {
      if (isNamed(conditions[i].id)) return {};
      return escaped(conditions[i].title) + ": ";
    }
    return {};
  }
};

}  // namespace

std::string caveatsOfRenderingAsHtml(const ReportSection& section) {
  return LimitationsWriter(section).renderingCaveats();
}

std::string weaknessesAsHtml(const ReportSection& section) {
  return LimitationsWriter(section).weaknessesInBrief();
}

std::vector<const analysis::Flag*> explainedFlags(const ReportSection& section) {
  return LimitationsWriter(section).explainedFlags();
}

std::string limitationsAsHtml(const ReportSection& section) {
  return LimitationsWriter(section).all();
}

}  // namespace study::report
