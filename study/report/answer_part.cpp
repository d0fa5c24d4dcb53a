#include <algorithm>
#include <cmath>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

constexpr std::size_t kMostInASentence = 2;  // comparisons; the table has all of them

bool isAnyDefined(const FamilyResult& family, const CohortResult& cohort) {
  return std::ranges::any_of(declaredIn(family, cohort), &Declared::isDefined);
}

/// Writes the answer of a study.
class AnswerWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    heading("The answer");
    const auto* family = mainFamily(section_);
    if (family == nullptr) {
      paragraph("Nothing can be compared yet: no completed session has answers to compare.");
    } else {
      sentences();
      pooledAnswers();
      html_ += caveatsOfRenderingAsHtml(section_);
      references(*family);
    }
    if (family != nullptr) {
      mainFigure(*family);
      tableOfAnswers();
    }
    return std::move(html_) + weaknessesAsHtml(section_);
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
      put("<p>{}: {}</p>", cohortLabelOf(family, part), text);
    });
  }

  /// Writes the main weakness of pooled tests next to their p values.
  void pooledAnswers() {
    const bool isRepeated = std::ranges::any_of(section_.results.families, [](const auto& family) {
      if (!isPooled(Profile::Declared, family.family)) return false;
      return std::ranges::any_of(flagsByKind(family, true), [](const auto& raised) {
        return raised.flag->id == "pseudo_replication";
      });
    });
    if (!isRepeated) return;
    paragraph(
        "As the protocol declares, these tests take all answers of a person as independent: their "
        "p may be far too small. “Within people” in the appendix compares people.");
  }

  /// "Orthopaedic surgeons (6 participants)"; with the family's title if there are several.
  std::string cohortLabelOf(const FamilyResult& family, const CohortResult& part) const {
    const auto complete = part.within.participants;  // who judged every method
    const auto who = escaped(section_.words.count(
        complete > 0 ? complete : part.table.participants.size(),
        "{1} ({0} participant)",
        "{1} ({0} participants)",
        section_.cohortTitle(part.cohort)));
    return section_.results.families.size() > 1 ? say("“{}”", family.family.title) + ", " + who
                                                : who;
  }

  std::string sentenceOf(const FamilyResult& family, const CohortResult& part) const {
    auto rows = declaredIn(family, part);
    if (!isAnyDefined(family, part)) {
      return rows.empty()
                 ? std::string()
                 : say("nothing can be tested: {}.", section_.words(rows.front().test->reason));
    }
    std::erase_if(rows, [](const auto& row) { return !row.isDefined(); });
    std::ranges::stable_sort(
        rows, [](const auto& a, const auto& b) { return a.effect() > b.effect(); });
    std::string text;
    for (std::size_t i = 0; i < std::min(rows.size(), kMostInASentence); ++i) {
      text += (i > 0 ? "; " : "") + inWords(family, rows[i]);
    }
    return text + ".";
  }

  /// The sentence on one comparison. It names the method with the higher rating first.
  std::string inWords(const FamilyResult& family, const Declared& row) const {
    const bool isTurned = *row.difference->estimate.value < 0.0;
    const double sign = isTurned ? -1.0 : 1.0;
    const auto& higher = section_.conditionTitle(isTurned ? row.group2 : row.group1);
    const auto& lower = section_.conditionTitle(isTurned ? row.group1 : row.group2);
    auto interval = row.difference->interval;
    if (interval && isTurned) interval = analysis::Interval{-interval->high, -interval->low};
    std::string numbers;
    if (interval) {
      numbers = section_.words.say(
                    "{:g} % CI {}",
                    100.0 * (1.0 - family.family.alpha),
                    formatInterval(interval, section_.wording, section_.words)) +
                ", ";
    }
    if (const auto& effect = row.difference->effect; effect.value) {
      numbers += fmt::format("{} = {}, ", effect.name, rounded(sign * *effect.value, 2));
    }
    numbers += formatP(family, *row.test);
    const bool isInDoubt = family.isDeclared && !row.test->isSignificant.value_or(true);
    return withSubscripts(
        say(isInDoubt ? "{} was rated {} points higher than {}, which is not significant ({})"
                      : "{} was rated {} points higher than {} ({})",
            higher,
            rounded(sign * *row.difference->estimate.value, 2),
            lower,
            numbers));
  }

  std::string formatP(const FamilyResult& family, const analysis::TestRow& test) const {
    const auto correction = nameOf(family.family.correction);
    const bool isAdjusted = test.adjusted && !correction.empty();
    return isAdjusted ? formatPWithSymbol(test.adjusted, correction, section_.wording)
                      : formatPWithSymbol(test.p, {}, section_.wording);
  }

  // --- Figure and table ---

  void references(const FamilyResult& family) {
    put("<p>{}</p>",
        mainSvg(family).empty() ? withReferences("See {}.", {"answer"})
                                : withReferences("See {} and {}.", {"answer-figure", "answer"}));
  }

  std::string mainSvg(const FamilyResult& family) const {
    const auto place = static_cast<std::size_t>(&family - section_.results.families.data());
    const auto& all = section_.figures.families;
    const auto figures = place < all.size() ? all[place] : FamilyFigures{};
    const auto kind = *mainFigureOf(section_, family);
    return kind == MainFigure::Differences ? figures.effects
           : kind == MainFigure::Answers   ? figures.answers
                                           : figures.participantMeans;
  }

  void mainFigure(const FamilyResult& family) {
    const auto kind = *mainFigureOf(section_, family);
    const auto caption = kind == MainFigure::Differences ? differencesCaption(family)
                         : kind == MainFigure::Answers   ? kAnswersCaption
                                                         : kParticipantMeansCaption;
    figure(mainSvg(family), caption, "answer-figure");
  }

  void tableOfAnswers() {
    bool isAnyTested = false;
    forEachAnswered([&](const auto& family, const auto& part) {
      isAnyTested = isAnyTested || isAnyDefined(family, part);
    });
    if (isAnyTested) {
      comparisons();
    } else {
      means();
    }
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

  /// The caption with the scale of all families; without it if theirs differ.
  std::string withCommonScale(const std::string& caption) const {
    const auto& all = section_.results.families;
    const auto scale = scaleInWords(section_, all.front().family);
    const bool isCommon = std::ranges::all_of(
        all, [&](const auto& other) { return scaleInWords(section_, other.family) == scale; });
    return isCommon ? withScale(caption, all.front().family) : caption;
  }

  void comparisons() {
    table(
        withCommonScale(
            say("The declared comparisons, with the mean of each method, and p after the declared "
                "correction")),
        {say("Comparison"),
         say("Difference"),
         headingOfIntervals(),
         say("Effect size"),
         section_.wording == Wording::Vancouver ? "<i>P</i>" : kP},
        "answer");
    forEachAnswered([&](const auto& family, const auto& part) {
      if (!isAnyDefined(family, part)) {
        rowOver(cohortLabelOf(family, part) + ": " + say("not tested"));
        return;
      }
      rowOver(cohortLabelOf(family, part));
      for (const auto& comparison : declaredIn(family, part)) {
        if (comparison.isDefined()) comparisonRow(family, part, comparison);
      }
    });
    endTable();
  }

  void comparisonRow(
      const FamilyResult& family, const CohortResult& part, const Declared& comparison) {
    const auto& [group1, group2, difference, test] = comparison;
    const auto& effect = difference->effect;
    const bool isBold = family.isDeclared && test->isSignificant.value_or(false);
    const auto p = cellOfP(
        test->adjusted && !nameOf(family.family.correction).empty() ? test->adjusted : test->p);
    row(
        {withMean(part, group1) + " vs. " + withMean(part, group2),
         rounded(difference->estimate.value, 2),
         cellOf(difference->interval),
         effect.value
             ? withSubscripts(fmt::format("{} = {}", effect.name, rounded(effect.value, 2)))
             : std::string(),
         isBold ? "<strong>" + p + "</strong>" : p});
  }

  /// "Interpolation (4.25)".
  std::string withMean(const CohortResult& part, const std::string& id) const {
    for (const auto& one : part.conditions) {
      if (one.name == id) return condition(id) + " (" + rounded(one.answers.mean(), 2) + ")";
    }
    return condition(id);
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

bool hasAnswers(const CohortResult& cohort) {
  return std::ranges::any_of(
      cohort.conditions, [](const auto& condition) { return condition.answers.total() > 0; });
}

std::string_view differencesCaption(const FamilyResult& family) {
  const bool isShaded = family.family.equivalenceBound.has_value();
  if (family.family.correction != protocols::CorrectionType::Bonferroni) {
    return isShaded ? kShadedDifferencesCaption : kDifferencesCaption;
  }
  return isShaded ? kShadedCorrectedDifferencesCaption : kCorrectedDifferencesCaption;
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

std::vector<Declared> declaredIn(const FamilyResult& family, const CohortResult& cohort) {
  std::vector<Declared> all;
  if (family.isNamed("welch")) {
    for (const auto& row : cohort.comparisons.rows) {
      all.push_back({row.group1, row.group2, &row, &row});
    }
    return all;
  }
  for (const auto& row : cohort.within.rows) {
    const auto& test = row.test(idOf(family.family.test));
    all.push_back({row.group1, row.group2, &row.test("paired_t"), &test});
  }
  return all;
}

std::string answerAsHtml(const ReportSection& section) {
  return AnswerWriter(section).all();
}

}  // namespace study::report
