#include <algorithm>
#include <cmath>
#include <set>

#include "base/joined.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/answer_tables.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr double kPrintedAsZero = 0.005;  // a difference of less is "0.00"

bool isAnyDefined(const FamilyResult& family, const CohortResult& cohort) {
  return std::ranges::any_of(declaredIn(family, cohort), &Declared::isDefined);
}

/// Whether the test that the protocol names does not find a difference.
bool isInDoubt(const Declared& row) {
  return !row.test->isSignificant.value_or(true);
}

/// Writes the answer of a study.
class AnswerWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    const auto* family = mainFamily(section_);
    const auto see = family == nullptr || mainSvg(*family).empty()
                         ? withReferences("The answer: {}", {"answer"})
                         : withReferences("The answer: {} and {}", {"answer-figure", "answer"});
    const auto untested =
        family == nullptr || mainSvg(*family).empty()
            ? withReferences("What was answered: {}", {"answer"})
            : withReferences("What was answered: {} and {}", {"answer-figure", "answer"});
    const auto nothingYet = say("The answer");
    put("<h3>{}</h3>", family == nullptr ? nothingYet : isAnyTested() ? see : untested);
    if (family == nullptr) {
      paragraph("Nothing can be compared yet: no completed session has answers to compare.");
    } else {
      sentences();
      putPooledWarning();
      html_ += caveatsOfRenderingAsHtml(section_);
    }
    if (family != nullptr) mainFigure(*family);
    if (family != nullptr && !isAnyTested()) means();
    html_ += weaknessesAsHtml(section_);
    if (family != nullptr && isAnyTested()) {
      comparisons();
    }
    return std::move(html_);
  }

 private:
  template <typename Do>
  void forEachAnswered(Do&& visit) const {
    for (const auto& family : section_.results.families) {
      for (const auto& part : family.cohorts) {
        if (hasAnswers(part)) visit(family, part);
      }
    }
  }

  // --- Sentences ---

  void sentences() {
    forEachAnswered([&](const auto& family, const auto& part) {
      const auto text = sentenceOf(family, part);
      put("<p>{}: {}{}</p>", cohortLabelOf(family, part), meansInWords(family, part), text);
    });
  }

  /// "Interpolation 3.44, KF 3.13, FEM 2.41 on average; ", the highest first, or only of the
  /// alternative that the sentences are about; empty if nothing is tested, or if not all
  /// differences are of the same people (the table has the means of each pair).
  std::string meansInWords(const FamilyResult& family, const CohortResult& part) const {
    if (!isAnyDefined(family, part)) return {};
    const auto rows = declaredIn(family, part);
    auto tested = conditionsOf(section_.protocol, family.family);
    std::erase_if(tested, [&](const auto& id) {
      return std::ranges::none_of(
          rows, [&](const auto& row) { return row.isDefined() && row.has(id); });
    });
    const auto [fewest, most] = peopleComparedIn(family, part);
    const auto people = whoJudged(family, part, tested);
    if (people && (fewest != most || people->participants.size() != most)) return {};
    std::vector<std::pair<double, std::string>> all;
    const auto mainAlternative = mainAlternativeOf(family);
    for (const auto& id : tested) {
      if (!mainAlternative.empty() && id != mainAlternative) continue;
      if (const auto mean = meanOf(family, part, id, tested)) all.emplace_back(-*mean, id);
    }
    std::ranges::stable_sort(all, {}, [](const auto& one) { return one.first; });
    const auto text = base::joined(all, ", ", [&](const auto& one) {
      return condition(one.second) + " " + rounded(-one.first, 2);
    });
    return text.empty() ? text : text + " " + say("on average") + "; ";
  }

  /// Writes the main weakness of pooled tests next to their p values.
  void putPooledWarning() {
    if (!areAnswersPooled(section_)) return;
    paragraph(
        "As the protocol declares, these tests take all answers of a person as independent: their "
        "p may be far too small. Within people: {}, exploratory; the appendix has more.",
        testInWords(protocols::TestType::PairedT, section_.words));
  }

  /// "Orthopaedic surgeons (6 participants)", or "(2 to 5 participants)" where not all were
  /// compared in each comparison; with the family's title if there are several.
  std::string cohortLabelOf(const FamilyResult& family, const CohortResult& part) const {
    const auto [fewest, most] = peopleComparedIn(family, part);
    const auto& title = section_.cohortTitle(part.cohort);
    const auto same = escaped(
        section_.words.count(most, "{1} ({0} participant)", "{1} ({0} participants)", title));
    const auto range = say("{} ({} to {} participants)", title, fewest, most);
    const auto& who = fewest == most ? same : range;
    return section_.results.families.size() > 1 ? say("“{}”", family.family.title) + ", " + who
                                                : who;
  }

  std::string sentenceOf(const FamilyResult& family, const CohortResult& part) const {
    const auto all = declaredIn(family, part);
    if (!isAnyDefined(family, part)) {
      return all.empty() ? std::string() : notTestedInWords(all.front());
    }
    const auto mainAlternative = mainAlternativeOf(family);
    const auto untested =
        std::ranges::find_if(all, [&](const auto& row) { return row.has(mainAlternative); });
    std::vector<Declared> rows;              // that are said one by one
    std::vector<std::string> otherFindings;  // significant differences of other rows
    for (const auto& row : all) {
      if (!row.isDefined()) continue;
      const bool isSaid = mainAlternative.empty() || row.has(mainAlternative);
      if (isSaid) rows.push_back(row);
      if (isSaid || !isBold(family, row)) continue;
      const auto& higher = section_.conditionTitle(higherMethodOf(row));
      const auto& lower = section_.conditionTitle(isSecondHigher(row) ? row.group1 : row.group2);
      otherFindings.push_back(section_.words.say("{} was rated higher than {}", higher, lower));
    }
    const bool areAllInDoubt = rows.size() > 1 && std::ranges::all_of(rows, isInDoubt);
    std::string text;
    std::string subject;  // the method with the higher rating in the clause before
    for (const auto& row : rows) {
      text += (text.empty() ? "" : "; ") +
              inWords(family, row, subject, !areAllInDoubt && isInDoubt(row));
      subject = higherMethodOf(row);
    }
    const auto none = say("no difference is significant.");
    const auto noneOfIts = say("none of its differences is significant.");
    if (areAllInDoubt) text = (mainAlternative.empty() ? none : noneOfIts) + " " + text;
    if (text.empty() && untested != all.end()) return notTestedInWords(*untested);
    constexpr std::size_t kFew = 3;
    const auto named =
        section_.words.say("Also significant: {}.", base::joined(otherFindings, "; "));
    const auto counted = section_.words.say(
        "{} differences between other methods are significant: see the table.",
        otherFindings.size());
    const auto& others = otherFindings.size() > kFew ? counted : named;
    const auto leftOut = leftOutIn(family, part).size();
    const auto missing =
        count(leftOut, "{} comparison could not be tested.", "{} comparisons could not be tested.");
    return text + "." + (otherFindings.empty() ? std::string() : " " + escaped(others)) +
           (leftOut > 0 ? " " + missing : std::string());
  }

  std::string notTestedInWords(const Declared& row) const {
    return say("nothing can be tested: {}.", section_.words(row.test->reason));
  }

  static bool isSecondHigher(const Declared& row) { return *row.difference->estimate.value < 0.0; }
  static const std::string& higherMethodOf(const Declared& row) {
    return isSecondHigher(row) ? row.group2 : row.group1;
  }

  /// The clause on one comparison. It names the method with the higher rating first, unless that is
  /// the subject of the clause before.
  /// @param saysDoubt  whether the clause says that the difference is not significant
  std::string inWords(
      const FamilyResult& family,
      const Declared& row,
      const std::string& subject,
      bool saysDoubt) const {
    const double sign = isSecondHigher(row) ? -1.0 : 1.0;
    const auto& higher = section_.conditionTitle(higherMethodOf(row));
    const auto& lower = section_.conditionTitle(isSecondHigher(row) ? row.group1 : row.group2);
    auto interval = row.difference->interval;
    if (interval && isSecondHigher(row))
      interval = analysis::Interval{-interval->high, -interval->low};
    std::string numbers;
    if (interval) {
      numbers = section_.words.say(
                    "{:g} % CI {}",
                    100.0 * (1.0 - family.family.alpha),
                    formatInterval(interval, section_.wording, section_.words)) +
                ", ";
    }
    numbers += formatP(family, *row.test);
    if (family.isNamed("welch")) numbers += "; " + withinPeople(family, *row.withinPeople, sign);
    if (row.equivalenceP) {
      numbers += "; TOST " + formatPWithSymbol(row.equivalenceP, {}, section_.wording);
    }
    const auto points =
        withUnit(section_, family.family, rounded(sign * *row.difference->estimate.value, 2));
    const auto clear = say("{} was rated {} higher than {} ({})", higher, points, lower, numbers);
    const auto unclear =
        say("{} was rated {} higher than {} (not significant: {})", higher, points, lower, numbers);
    const auto alsoClear = say("{} higher than {} ({})", points, lower, numbers);
    const auto alsoUnclear = say("{} higher than {} (not significant: {})", points, lower, numbers);
    const auto alike = say("the means of {} and {} are the same ({})", higher, lower, numbers);
    if (std::abs(*row.difference->estimate.value) < kPrintedAsZero) return withSubscripts(alike);
    const bool isSameSubject = higherMethodOf(row) == subject;
    if (isSameSubject) return withSubscripts(saysDoubt ? alsoUnclear : alsoClear);
    return withSubscripts(saysDoubt ? unclear : clear);
  }

  /// The same difference by the paired t-test, beside that of pooled answers.
  std::string withinPeople(
      const FamilyResult& family, const analysis::TestRow& test, double sign) const {
    if (!test.p || !test.interval) return section_.words("not testable within people");
    const auto interval =
        sign > 0.0 ? *test.interval : analysis::Interval{-test.interval->high, -test.interval->low};
    return section_.words.say(
               "within people {}, {:g} % CI {}",
               rounded(sign * test.estimate.value.value_or(0.0), 2),
               100.0 * (1.0 - family.family.alpha),
               formatInterval(interval, section_.wording, section_.words)) +
           ", " + formatP(family, test);
  }

  std::string formatP(const FamilyResult& family, const analysis::TestRow& test) const {
    const auto correction = nameOf(family.family.correction);
    const bool isAdjusted = test.adjusted && !correction.empty();
    return isAdjusted ? formatPWithSymbol(test.adjusted, correction, section_.wording)
                      : formatPWithSymbol(test.p, {}, section_.wording);
  }

  // --- Figure and table ---

  std::string mainSvg(const FamilyResult& family) const {
    const auto place = static_cast<std::size_t>(&family - section_.results.families.data());
    const auto& all = section_.figures.families;
    const auto figures = place < all.size() ? all[place] : FamilyFigures{};
    const auto kind = *mainFigureOf(section_, family);
    return kind == MainFigure::Differences ? figures.mainEffects
           : kind == MainFigure::Answers   ? figures.answers
                                           : figures.participantMeans;
  }

  void mainFigure(const FamilyResult& family) {
    const auto kind = *mainFigureOf(section_, family);
    auto caption = kind == MainFigure::Differences
                       ? escaped(differencesCaption(family, section_.words))
                   : kind == MainFigure::Answers ? say(kAnswersCaption)
                                                 : say(kParticipantMeansCaption);
    const auto others = withReferences("Only of the method rated highest; {} has all.", {"answer"});
    if (kind == MainFigure::Differences && showsSomeOnly(family)) caption += " " + others;
    putFigure(mainSvg(family), caption, "answer-figure");
  }

  /// Whether the figure beside the answer leaves out comparisons.
  bool showsSomeOnly(const FamilyResult& family) const {
    const auto mainAlternative = mainAlternativeOf(family);
    return !mainAlternative.empty() && std::ranges::any_of(family.cohorts, [&](const auto& part) {
      return std::ranges::any_of(
          declaredIn(family, part), [&](const auto& row) { return !row.has(mainAlternative); });
    });
  }

  bool isAnyTested() const {
    bool isAny = false;
    forEachAnswered(
        [&](const auto& family, const auto& part) { isAny = isAny || isAnyDefined(family, part); });
    return isAny;
  }

  /// The heading of the intervals' column, with their confidence level if it is the same for all
  /// families.
  std::string headingOfIntervals() const {
    const auto percent =
        say("{:g} % CI", 100.0 * (1.0 - section_.results.families.front().family.alpha));
    const auto mixed = say("CI at 1 − α");
    const auto same = [&](const auto& other) {
      return other.family.alpha == section_.results.families.front().family.alpha;
    };
    return std::ranges::all_of(section_.results.families, same) ? percent : mixed;
  }

  /// The caption, followed by the scale that all families have in common, if there is such a
  /// scale.
  std::string withCommonScale(const std::string& caption) const {
    const auto& all = section_.results.families;
    const auto scale = scaleInWords(section_, all.front().family);
    const bool isCommon = std::ranges::all_of(
        all, [&](const auto& other) { return scaleInWords(section_, other.family) == scale; });
    return isCommon ? withScale(caption, all.front().family) : caption;
  }

  /// The caption of the table of comparisons; with the declared test if that is the
  /// same for all families.
  std::string captionOfComparisons() const {
    const auto& all = section_.results.families;
    const auto declared = declaredInWords(all.front().family, section_.words);
    const bool isSame = std::ranges::all_of(all, [&](const auto& other) {
      return declaredInWords(other.family, section_.words) == declared;
    });
    const auto mixed = say("The declared comparisons: means, and p after correction");
    const auto named = say("Declared: {}", declared);
    const auto later = say("The comparisons: means, and p after correction");
    if (!std::ranges::all_of(all, &FamilyResult::isDeclared)) return later;
    return isSame ? named : mixed;
  }

  /// The name of the effect size, if all comparisons have the same; empty otherwise.
  std::string commonEffect() const {
    std::set<std::string> names;
    forEachAnswered([&](const auto& family, const auto& part) {
      for (const auto& row : declaredIn(family, part)) {
        const auto& effect = row.difference->effect;
        if (row.isDefined() && effect.value) names.emplace(effect.name);
      }
    });
    return names.size() == 1 ? *names.begin() : std::string();
  }

  void comparisons() {
    const auto effect = commonEffect();
    table(
        withCommonScale(captionOfComparisons()),
        {say("Comparison"),
         say("Difference"),
         headingOfIntervals(),
         effect.empty() ? say("Effect size") : withSubscripts(effect),
         headingOfP()},
        "answer");
    bool isAnyBold = false;
    bool isAnyOfTwoPeople = false;  // too few for g_z
    bool isAnyLeftOut = false;
    bool differInPeople = false;
    forEachAnswered([&](const auto& family, const auto& part) {
      if (!isAnyDefined(family, part)) {
        rowOver(cohortLabelOf(family, part) + ": " + say("not tested"));
        return;
      }
      rowOver(cohortLabelOf(family, part));
      const auto [fewest, most] = peopleComparedIn(family, part);
      differInPeople = differInPeople || (fewest != most && !family.isNamed("welch"));
      for (const auto& comparison : declaredIn(family, part)) {
        if (!comparison.isDefined()) {
          notTestedRow(comparison);
          isAnyLeftOut = true;
          continue;
        }
        comparisonRow(family, part, comparison, effect.empty());
        isAnyBold = isAnyBold || isBold(family, comparison);
        isAnyOfTwoPeople =
            isAnyOfTwoPeople || (!family.isNamed("welch") && !comparison.difference->effect.value);
      }
    });
    endTable();
    const bool isCorrected = std::ranges::any_of(section_.results.families, [](const auto& family) {
      return !nameOf(family.family.correction).empty();
    });
    const auto order =
        say("The method with the higher mean over all cohorts comes first. Differences are taken "
            "before rounding.");
    const auto ofBoth = say("Means here are of the participants who judged both methods.");
    const auto standardised = withSubscripts(say(
        "{} is the mean difference over the SD of the differences, corrected for small samples.",
        "g_z"));
    const auto uncorrected = say(
        "p is corrected for all comparisons under one heading, intervals are not: one without 0 "
        "may come with a p above α.");
    const auto ofTested =
        say("p is corrected for the comparisons under one heading that were tested, intervals are "
            "not: one without 0 may come with a p above α.");
    const auto student =
        say("Intervals are Student’s, of the mean difference; p is of an exact test, so that the "
            "two may disagree about 0.");
    const bool isAnyExact = std::ranges::any_of(section_.results.families, [](const auto& family) {
      return family.isNamed("sign_flip") || family.isNamed("signed_rank");
    });
    const auto ofTwoPeople = withSubscripts(say("{} needs three participants.", "g_z"));
    const auto bold = say("Bold: p ≤ α.");
    put("<p class=\"note\">{}{}{}{}{}{}{}</p>",
        order,
        isAnyExact ? " " + student : std::string(),
        differInPeople ? " " + ofBoth : std::string(),
        effect == "g_z" ? " " + standardised : std::string(),
        effect == "g_z" && isAnyOfTwoPeople ? " " + ofTwoPeople : std::string(),
        isCorrected ? " " + (isAnyLeftOut ? ofTested : uncorrected) : std::string(),
        isAnyBold ? " " + bold : std::string());
  }

  static bool isBold(const FamilyResult& family, const Declared& comparison) {
    return family.isDeclared && comparison.test->isSignificant.value_or(false);
  }

  /// "p", with the correction if it is the same for all families.
  std::string headingOfP() const {
    const auto& all = section_.results.families;
    const auto correction = all.front().family.correction;
    const bool isCommon = std::ranges::all_of(
        all, [&](const auto& other) { return other.family.correction == correction; });
    const std::string symbol = section_.wording == Wording::Vancouver ? "<i>P</i>" : kP;
    const auto name = isCommon ? nameOf(correction) : std::string_view();
    return name.empty() ? symbol : symbol + "<sub>" + std::string(name) + "</sub>";
  }

  /// A comparison without numbers, with the reason.
  void notTestedRow(const Declared& comparison) {
    const auto& reason = comparison.test->reason;
    row({condition(comparison.group1) + " vs. " + condition(comparison.group2)},
        reason.empty() ? say("not tested") : notDefined(reason));
  }

  void comparisonRow(
      const FamilyResult& family,
      const CohortResult& part,
      const Declared& comparison,
      bool namesEffect) {
    const auto& [group1, group2, difference, test, withinPeople, people, equivalenceP] = comparison;
    const auto& effect = difference->effect;
    const auto p = cellOfP(
        test->adjusted && !nameOf(family.family.correction).empty() ? test->adjusted : test->p);
    row(
        {withMeans(family, part, group1, group2),
         rounded(difference->estimate.value, 2),
         cellOf(difference->interval),
         !effect.value ? std::string()
         : namesEffect
             ? withSubscripts(fmt::format("{} = {}", effect.name, rounded(effect.value, 2)))
             : rounded(effect.value, 2),
         isBold(family, comparison) ? "<strong>" + p + "</strong>" : p});
  }

  /// "Interpolation (4.25) vs. FEM (2.81)", see meanOf().
  std::string withMeans(
      const FamilyResult& family,
      const CohortResult& part,
      const std::string& first,
      const std::string& second) const {
    const auto named = [&](const std::string& id) {
      const auto mean = meanOf(family, part, id, {first, second});
      return condition(id) + (mean ? " (" + rounded(*mean, 2) + ")" : std::string());
    };
    return named(first) + " vs. " + named(second);
  }

  /// The means of the participants who judged all of @p methods; std::nullopt where all answers are
  /// pooled.
  static std::optional<analysis::CompleteCaseMeans> whoJudged(
      const FamilyResult& family,
      const CohortResult& part,
      const std::vector<std::string>& methods) {
    std::vector<std::size_t> places;
    for (const auto& method : methods) {
      const auto place = std::ranges::find(part.table.methods, method);
      places.push_back(static_cast<std::size_t>(place - part.table.methods.begin()));
    }
    if (family.isNamed("welch") || std::ranges::max(places) == part.table.methods.size()) {
      return std::nullopt;
    }
    return analysis::completeCaseMeans(part.table, places);
  }

  /// The mean of a method that the declared test compares: of all answers, or of the means of the
  /// participants who judged all of @p methods.
  static std::optional<double> meanOf(
      const FamilyResult& family,
      const CohortResult& part,
      const std::string& id,
      const std::vector<std::string>& methods) {
    if (const auto people = whoJudged(family, part, methods)) {
      const auto place = std::ranges::find(methods, id) - methods.begin();
      return analysis::summarise(people->of(static_cast<std::size_t>(place))).mean;
    }
    const auto one = std::ranges::find(part.conditions, id, &analysis::NamedSample::name);
    return one == part.conditions.end() ? std::nullopt : one->answers.mean();
  }

  void means() {
    table(
        withCommonScale(say("The mean of each method")),
        {say("Method"), kM, say("Answers")},
        "answer");
    forEachAnswered([&](const auto& family, const auto& part) {
      rowOver(cohortLabelOf(family, part));
      for (const auto& one : part.conditions) {
        if (one.answers.total() == 0) continue;
        row(
            {condition(one.name),
             rounded(one.answers.mean(), 2),
             std::to_string(one.answers.total())});
      }
    });
    endTable();
  }
};

}  // namespace

bool areAnswersPooled(const ReportSection& section) {
  return std::ranges::any_of(section.results.families, [](const auto& family) {
    const bool isTested = std::ranges::any_of(
        family.cohorts, [&](const auto& part) { return isAnyDefined(family, part); });
    if (!isTested || !isPooled(Profile::Declared, family.family)) return false;
    return std::ranges::any_of(flagsByKind(family, true), [](const auto& raised) {
      return raised.flag->id == "pseudo_replication";
    });
  });
}

bool hasAnswers(const CohortResult& cohort) {
  return std::ranges::any_of(
      cohort.conditions, [](const auto& condition) { return condition.answers.total() > 0; });
}

std::string differencesCaption(const FamilyResult& family, const words::Words& words) {
  const double percent = 100.0 * (1.0 - family.family.alpha);
  const auto plain =
      words.say("Mean differences within people with uncorrected {:g} % intervals.", percent);
  const auto corrected = words.say(
      "Mean differences within people: the thick line is the {:g} % interval, the thin one is as "
      "wide as Bonferroni’s correction asks of all comparisons.",
      percent);
  const auto shaded = words("Shaded are differences that count as none.");
  const bool isCorrected = family.family.correction == protocols::CorrectionType::Bonferroni;
  return (isCorrected ? corrected : plain) +
         (family.family.equivalenceBound ? " " + shaded : std::string());
}

analysis::ShapiroWilkResult normalityOf(
    const CohortResult& cohort, const analysis::WithinComparison& comparison) {
  const auto& methods = cohort.table.methods;
  const auto placeOf = [&](const std::string& id) {
    return static_cast<std::size_t>(std::ranges::find(methods, id) - methods.begin());
  };
  const std::vector places{placeOf(comparison.group1), placeOf(comparison.group2)};
  if (std::ranges::max(places) == methods.size()) return {};
  const auto means = analysis::completeCaseMeans(cohort.table, places);
  std::vector<double> differences;
  for (const auto& of : means.means) differences.push_back(of[0] - of[1]);
  return analysis::shapiroWilkTest(differences);
}

std::optional<MainFigure> mainFigureOf(const ReportSection& section, const FamilyResult& family) {
  if (&family != mainFamily(section)) return std::nullopt;
  const bool hasDifferences = std::ranges::any_of(family.cohorts, [&](const auto& cohort) {
    return std::ranges::any_of(cohort.within.rows, [](const auto& row) {
      return row.test("paired_t").interval.has_value();
    });
  });
  if (hasDifferences && !family.isNamed("welch")) return MainFigure::Differences;
  return isShownByPoint(family) ? MainFigure::Answers : MainFigure::ParticipantMeans;
}

const FamilyResult* mainFamily(const ReportSection& section) {
  const auto& all = section.results.families;
  const auto found = std::ranges::find_if(
      all, [](const auto& family) { return std::ranges::any_of(family.cohorts, hasAnswers); });
  return found == all.end() ? nullptr : &*found;
}

std::string mainAlternativeOf(const FamilyResult& family) {
  const auto isCompared = [&](const std::string& id) {
    return std::ranges::any_of(family.cohorts, [&](const auto& part) {
      return std::ranges::any_of(declaredIn(family, part), [&](const auto& row) {
        return row.isDefined() && row.has(id);
      });
    });
  };
  constexpr std::size_t kFew = 3;  // all are shown; those of pooled answers have long sentences
  if (!family.isNamed("welch") && family.family.comparisons.size() <= kFew) return {};
  const auto best = highestRatedIn(family);
  return isCompared(best) ? best : std::string();
}

std::string answerAsHtml(const ReportSection& section) {
  return AnswerWriter(section).all();
}

}  // namespace study::report
