#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/answer_table.h"
#include "base/message.h"

namespace analysis {

/// All texts of flags: "id" says what was found, "id.why" why it matters, "id.remedy" what to do,
/// and "source.…" names a place in the manual.
inline constexpr auto kFlagMessages = std::to_array<base::MessageKind>({
    {"alpha_rounded", "A p value lies between alpha per test {:.6f} and its rounded form {:.3f}."},
    {"alpha_rounded.remedy", "Compare with the unrounded threshold, as is done here."},
    {"alpha_rounded.title", "A rounded threshold that decides"},
    {"alpha_rounded.why", "Rounding the threshold decides about significance."},
    {"answered_otherwise.remedy",
     "Look at the participants of each version by themselves: the table of sessions in an export "
     "names the version. Ask what is changed under an id of its own, or in a new study."},
    {"answered_otherwise.title", "Questions or conditions that were changed between participants"},
    {"answered_otherwise.why",
     "Answers to different things are pooled; a difference, or that there is none, may come from "
     "the change."},
    {"bimodal", "Answers fall into two camps: "},
    {"bimodal.method", "{} (variance {:.2f}, at most {:.2f} with one peak)"},
    {"bimodal.remedy",
     "Look at the distribution, and at who is in which camp; report counts beside means."},
    {"bimodal.title", "Answers with two peaks"},
    {"bimodal.why", "The mean then says what nobody thinks."},
    {"colon", ": "},
    {"comma", ", "},
    {"constant_group", "Everybody gave the same answer to everything about: {}."},
    {"constant_group.remedy", "Report the counts; use exact tests of the paired differences."},
    {"constant_group.title", "Answers without variation"},
    {"constant_group.why",
     "Tests that divide by the scatter are not defined, or see certainty where there are few "
     "answers."},
    {"family_not_declared",
     "The protocol did not declare these comparisons as they are before the first participant."},
    {"family_not_declared.remedy",
     "Declare the family in the protocol's analysis plan before the first participant; report what "
     "is here as exploratory."},
    {"family_not_declared.title", "Comparisons that were not declared beforehand"},
    {"family_not_declared.why",
     "Which tests are run, and how many, may then depend on what the data look like; p values lose "
     "their meaning."},
    {"full_stop", "."},
    {"items_not_common_to_methods", "The methods were judged by different statements."},
    {"items_not_common_to_methods.remedy", "Ask the same statements about every method."},
    {"items_not_common_to_methods.title", "Different statements about the methods"},
    {"items_not_common_to_methods.why",
     "A difference may lie in the wording as well as in the method."},
    {"late_ticks", "In {} of {} trials the force loop was late more often than is borne."},
    {"late_ticks.remedy", "Look at the trials' verdicts; repeat the analysis without them."},
    {"late_ticks.title", "A late force loop"},
    {"late_ticks.why", "People may have felt the computer instead of the method."},
    {"missing_cells", "{} of {} answers are missing, in {} of {} pairs of participant and method."},
    {"missing_cells.one",
     "{} of {} answers is missing, in {} of {} pairs of participant and method."},
    {"missing_cells.remedy",
     "Paired tests leave out participants who lack a method altogether; the mixed model uses all "
     "that there is."},
    {"missing_cells.title", "Missing answers"},
    {"missing_cells.why",
     "Means of fewer answers scatter more, and who leaves out what is rarely chance."},
    {"n_below_minimum_for_alpha",
     "With {} people who judged both methods of a pair no exact paired test can give a p below "
     "{:.4g}; the family of {} asks for {:.4g}."},
    {"n_below_minimum_for_alpha.one",
     "With {} person who judged both methods of a pair no exact paired test can give a p below "
     "{:.4g}; the family of {} asks for {:.4g}."},
    {"n_below_minimum_for_alpha.remedy",
     "More participants (palpate plan says how many), fewer comparisons, or an overall test "
     "(Friedman) first."},
    {"n_below_minimum_for_alpha.title", "Too few participants for an exact test to be significant"},
    {"n_below_minimum_for_alpha.why",
     "Such a test cannot be significant with any answers. A t-test of two people or more can, but "
     "takes differences as normal, which so few people cannot show."},
    {"order_not_counterbalanced", "How often a method came at a position goes from {} to {}."},
    {"order_not_counterbalanced.remedy",
     "Let the orders be balanced (latinSquare, balancedLatinSquare, complete), and plan N as a "
     "multiple of their number."},
    {"order_not_counterbalanced.title", "Orders that are not balanced"},
    {"order_not_counterbalanced.why",
     "Practice, fatigue and contrast with what came before then count for one method and against "
     "another."},
    {"other_scale.remedy",
     "Look at these answers by themselves: exports have them, and say that they are not included. "
     "Ask on a changed scale under an id of its own, or in a new study."},
    {"other_scale.title", "Participants who answered on another scale"},
    {"other_scale.why",
     "The points of two scales do not mean the same, so the answers are not pooled: the results "
     "are those of the newest version of the protocol."},
    {"paired_data_unpaired_test",
     "The same people judged every method, and the pooled tests take them for different people."},
    {"paired_data_unpaired_test.remedy", "Read the paired tests."},
    {"paired_data_unpaired_test.title", "Paired answers in unpaired tests"},
    {"paired_data_unpaired_test.why",
     "What a person always says more or less of goes into the scatter instead of cancelling."},
    {"pseudo_replication",
     "{} answers of {} people are treated as {} independent observations in the pooled tests"},
    {"pseudo_replication.design_effect",
     "; answers of one person about one method correlate with ICC = {:.2f}, so that each method's "
     "mean has a design effect of {:.2f}"},
    {"pseudo_replication.one",
     "{} answers of {} person are treated as {} independent observations in the pooled tests"},
    {"pseudo_replication.remedy", "Read the tests on participants' means, or the mixed model."},
    {"pseudo_replication.title", "Several answers of one person counted as independent"},
    {"pseudo_replication.why",
     "Answers of one person go together. Where people differ in their taste for a method, pooled "
     "tests find differences that are not there (up to 35 % instead of 5 % in simulations); where "
     "they only differ in leniency, pooled tests overlook real ones."},
    {"relative_item_without_referent", "Statements compare with what was felt before: {}."},
    {"relative_item_without_referent.remedy",
     "Ask about each method by itself, or fix the order and say so."},
    {"relative_item_without_referent.title",
     "Statements that compare with the alternative felt before"},
    {"relative_item_without_referent.why",
     "With another order they compare with another method, and the first method with none."},
    {"saturated", "In {} of {} trials the scene asked for more force than the device may give"},
    {"saturated.method", "“{}” in {} of {}"},
    {"saturated.remedy",
     "Compare the felt curves, and say in the paper which methods were cut off. In a next version, "
     "take scenes that stay below the limit: the force of bone can be scaled alike for every "
     "condition ('force_scale'), that of a recorded cut cannot."},
    {"saturated.title", "Forces cut off at the device’s limit"},
    {"saturated.why", "Where forces are cut off, methods feel more alike than they are."},
    {"semicolon", "; "},
    {"source.not_defined", "Palpate’s manual, Statistics: what is not defined"},
    {"source.planning", "Palpate’s manual, Statistics: planning"},
    {"source.published_analysis", "Palpate’s manual, Statistics: the published analysis, point {}"},
    {"source.punch_paper", "The punch paper's 0.017 for 0.05/3"},
    {"source.trial_verdicts", "Palpate’s manual, Running a study: trial verdicts"},
    {"source.versions", "Palpate’s manual, The protocol format: versions"},
});

/// A caveat that is shown beside a result.
struct Flag {
  std::string_view id;              ///< "pseudo_replication": as tables and exports name it
  std::vector<base::Message> what;  ///< what was found: the parts of one sentence
  base::Message why;                ///< why it matters
  base::Message remedy;             ///< what to do
  /// Where it is explained: in the manual, or in a work, which is verbatim as
  /// study::report::works() names it ("Hurlbert 1984").
  std::vector<base::Message> source;
  bool concernsPooledTests = false;  ///< it concerns pooled tests only
  /// Whether it concerns the rendering: the rendered forces were not those of the compared methods.
  bool concernsRendering = false;

  /// A short heading for display.
  base::Message title() const;

  /// The sentence `what` in English.
  std::string inEnglish() const;
};

/// A method with trials whose scene asked for more force than the device may give.
struct SaturatedMethod {
  std::string title;
  std::size_t saturated = 0;  ///< number of trials in which the force was limited
  std::size_t trials = 0;     ///< number of all trials of the method
};

/// A method that a participant felt: indices into the answer table, and the position in its round.
struct Felt {
  std::size_t participant = 0;
  std::size_t method = 0;
  std::size_t round = 0;
  int position = 0;  ///< from 1
};

/// Facts about a study that its answer table does not contain.
struct StudyFacts {
  /// Whether the report also has unpaired tests that treat all answers as independent.
  bool isPooled = true;
  /// Display names; if empty, the names in the table are used.
  std::vector<std::string> methodTitles;
  bool isDeclared = true;  ///< whether the protocol declared the comparisons before there were data
  double alpha = 0.05;     ///< of the family
  std::optional<double> threshold;  ///< significance level of the smallest p of the family;
                                    ///< std::nullopt: alpha / tests
  std::size_t tests = 1;            ///< number of tests in the family
  bool hasSameStatements = true;    ///< whether the same statements are asked about every method
  std::vector<Felt> felt;
  /// Indices of the statements that compare with what was felt before.
  std::vector<std::size_t> comparativeStatements;
  std::vector<double> pValues;  ///< p values of the family's tests, unrounded
  /// Expected number of answers per participant, by method; empty: unknown.
  std::vector<std::size_t> expected;
  std::size_t trials = 0;
  std::size_t lateTrials = 0;  ///< number of trials whose loop was late too often
  /// The methods with trials whose scene asked for more force than the device may give.
  std::vector<SaturatedMethod> saturated;
  std::vector<base::Message> otherScale;  ///< why answers of participants were left out
  /// What was changed between participants whose answers are compared.
  std::vector<base::Message> changes;
};

/// All flags of the answers of one cohort, the most important first (docs/statistics.md, "What is
/// to be said against the published analysis").
std::vector<Flag> flagsOf(const AnswerTable& table, const StudyFacts& facts);

}  // namespace analysis
