#include <cmath>

#include "analysis/registry/registry.h"
#include "study/export/statistics_row.h"
#include "study/export/study_tables.h"

namespace study {
namespace {

using Row = StatisticsRow;
using analysis::TestRow;

/// std::nullopt for infinite numbers; their row has the reason.
std::optional<double> finite(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? value : std::nullopt;
}

/// A getter for a member of the row's test.
template <typename Value>
auto testMember(Value TestRow::*member) {
  return [member](const Row& row) { return row.test.*member; };
}

/// A getter for the name of a number of the row's test.
auto nameOfNumber(analysis::NamedNumber TestRow::*number) {
  return [number](const Row& row) { return (row.test.*number).name; };
}
auto valueOfNumber(analysis::NamedNumber TestRow::*number) {
  return [number](const Row& row) { return finite((row.test.*number).value); };
}

/// A getter for a number that only some tests have.
auto additionalMember(const char* name) {
  return [name](const Row& row) { return row.test.additionalNumber(name); };
}

/// A getter for one end of an interval; missing without an interval.
auto endOf(std::optional<analysis::Interval> TestRow::*interval, double analysis::Interval::*end) {
  return [interval, end](const Row& row) {
    const auto& known = row.test.*interval;
    return known ? finite((*known).*end) : std::nullopt;
  };
}

/// A getter for the mean of one of two groups.
auto meanOf(std::size_t group) {
  return [group](const Row& row) {
    return row.test.moments ? (*row.test.moments)[group].mean : std::nullopt;
  };
}
auto deviationOf(std::size_t group) {
  return [group](const Row& row) {
    auto variance = row.test.moments ? (*row.test.moments)[group].variance : std::nullopt;
    if (variance) *variance = std::sqrt(*variance);
    return variance;
  };
}

/// A row of every registered test of studies, computed from made-up data, to get the names of its
/// statistic and effect size.
std::vector<analysis::TestRow> exampleRows() {
  std::vector<analysis::TestRow> rows;
  const analysis::TestData data{
      .values = {
          {.name = "a", .values = {1.0, 2.0, 4.0}}, {.name = "b", .values = {2.0, 3.0, 7.0}}}};
  for (const auto& test : analysis::statisticalTests()) {
    if (test.use == analysis::StudyUse::None) continue;
    const bool needsBound = test.form == analysis::StatisticalTest::Form::NeedsBound;
    analysis::TestSettings settings;
    if (needsBound) settings.bound = 1.0;
    for (auto& row : computeTest(test, data, settings)) rows.push_back(std::move(row));
  }
  return rows;
}

/// The distinct names that @p nameOf returns for the rows: "t, z, V".
template <typename NameOf>
std::string distinctNames(
    std::string text, const std::vector<analysis::TestRow>& rows, const NameOf& nameOf) {
  for (const auto& row : rows) {
    const std::string name(nameOf(row));
    const auto isListed = (", " + text + ",").find(", " + name + ",") != std::string::npos;
    if (!name.empty() && !isListed) text += ", " + name;
  }
  return text;
}

}  // namespace

Columns<StatisticsRow> statisticsColumns() {
  using namespace holds;
  using analysis::Interval;
  const auto tests = exampleRows();
  return {
      {"run_mode", OneOf{ValueList::RunModes}, kRunModeDescription, &Row::runMode},
      {"cohort", OneOf{ValueList::Cohorts}, kCohortDescription, &Row::cohort},
      {"site",
       OneOf{ValueList::Sites},
       "Where the session took place; empty: of all. Methods site_answers (the answers to group1 "
       "at a site), site_difference (a site's participants' means) and pooled_sites (these pooled: "
       "random effects by REML, Knapp and Hartung's standard error; n1 counts sites, the effect i2 "
       "is the share of the variance that is between sites)",
       &Row::site},
      {"cohort2", Text{}, "The other group, where two are compared", &Row::cohort2},
      {"family_id", Text{}, "Comparisons that belong together", &Row::family},
      {"instrument", Text{}, "Questionnaire", &Row::instrument},
      {"score", Text{}, "Of a questionnaire: which of its scores", &Row::score},
      {"item_id", Text{}, "Question", &Row::item},
      {"option", Text{}, "Of item_option: which answer", &Row::option},
      {"occasion",
       Text{},
       "before, after or change, where a score counts the change",
       &Row::occasion},
      {"acceptable_from",
       Number{},
       "From which answer on an item counts as acceptable; of answer_probability, an answer as "
       "high",
       &Row::acceptableFrom},
      {"n_missing",
       Integer{},
       "Forms that answered some of a score's items and gave no score",
       &Row::missing},
      {"blocks", Text{}, "Phases whose answers count, separated by spaces", &Row::blocks},
      {"items",
       Text{},
       "Questions whose answers a family compares, separated by spaces; empty where it compares a "
       "score",
       &Row::items},
      {"m", Integer{}, "Tests in the family", &Row::tests},
      {"group1",
       Text{},
       "Condition code; the sign is group1 - group2 (cohort - cohort2)",
       &Row::group1},
      {"group2", Text{}, "Condition code", &Row::group2},
      {"groups", Text{}, "Condition codes of an overall test, separated by spaces", &Row::groups},
      {"design", Text{}, "unpaired, paired or mixed", &Row::design},
      {"unit", Text{}, "answer or participant", &Row::unit},
      {"method",
       Text{},
       distinctNames(
           "welch, paired_t, sign_flip, signed_rank, mixed_model, ordinal_model, friedman, "
           "rm_anova, mann_whitney, brunner_munzel, order_slope, cronbach_alpha, shapiro_wilk, "
           "brown_forsythe, tost, bayes_factor, omega_total, answer_probability",
           tests,
           [](const auto& row) { return row.id; }) +
           "; not of a family: score, acceptability, felt_difference, and of every question by "
           "itself, "
           "as answered: item (numbers; n1 participants), item_option (choices; n1 forms)",
       testMember(&TestRow::id)},
      {"declared",
       Boolean{},
       "Whether the protocol declared it, before the first participant; all else is "
       "exploratory",
       &Row::isDeclared},
      {"n1",
       Integer{},
       "Units in group 1; pairs or participants where the design is paired",
       testMember(&TestRow::n1)},
      {"n2", Integer{}, "Units in group 2", testMember(&TestRow::n2)},
      {"mean1", Number{}, "Mean of group 1", meanOf(0)},
      {"mean2", Number{}, "Mean of group 2", meanOf(1)},
      {"sd1", Number{}, "Standard deviation of group 1, with n - 1", deviationOf(0)},
      {"sd2", Number{}, "Standard deviation of group 2, with n - 1", deviationOf(1)},
      {"estimate",
       Number{},
       "Mean difference, of signed_rank Hodges and Lehmann's; log odds ratio; of "
       "answer_probability the logit, whose probability is the effect; slope over positions; of "
       "felt_difference the mean over participants [N]; of "
       "item the median",
       [](const Row& row) { return row.test.estimate.value; }},
      {"se", Number{}, "Its standard error", testMember(&TestRow::standardError)},
      {"statistic_name",
       Text{},
       distinctNames(
           "t, z, V, U, chi2, F, W, observed_share",
           tests,
           [](const auto& row) { return row.statistic.name; }),
       nameOfNumber(&TestRow::statistic)},
      {"statistic", Number{}, "Its value", valueOfNumber(&TestRow::statistic)},
      {"df", Number{}, "Degrees of freedom; of F its first", testMember(&TestRow::df)},
      {"df2", Number{}, "Second degrees of freedom of F", testMember(&TestRow::df2)},
      {"p",
       Number{},
       "Two-sided; of tost the larger of two one-sided ones; not corrected",
       testMember(&TestRow::p)},
      {"log10_p", Number{}, "Decimal logarithm of p", testMember(&TestRow::log10P)},
      {"p_permutation",
       Number{},
       "Of Friedman's test: exact, all permutations within people",
       additionalMember("p_permutation")},
      {"epsilon",
       Number{},
       "Greenhouse and Geisser's: how spherical the conditions are",
       additionalMember("epsilon")},
      {"p_epsilon",
       Number{},
       "Of rm_anova: p with both degrees of freedom times epsilon",
       additionalMember("p_epsilon")},
      {"equivalence_bound",
       Number{},
       "Of tost: differences below it count as none [points]",
       additionalMember("equivalence_bound")},
      {"p_adj_method",
       Text{},
       "bonferroni, holm, hochberg, hommel, bh, by, holm-sidak or none",
       &Row::adjustment},
      {"p_adj", Number{}, "Corrected for the family", testMember(&TestRow::adjusted)},
      {"alpha", Number{}, "Of the family", &Row::alpha},
      {"alpha_per_test", Number{}, "alpha / m, for the adjusted interval", &Row::alphaPerTest},
      {"conf_level", Number{}, "Confidence of the intervals", &Row::level},
      {"conf_low",
       Number{},
       "Confidence interval of the estimate; of a score its mean's",
       endOf(&TestRow::interval, &Interval::low)},
      {"conf_high", Number{}, "…", endOf(&TestRow::interval, &Interval::high)},
      {"conf_low_adj",
       Number{},
       "… at 1 - alpha_per_test",
       endOf(&TestRow::adjustedInterval, &Interval::low)},
      {"conf_high_adj", Number{}, "…", endOf(&TestRow::adjustedInterval, &Interval::high)},
      {"effect_name",
       Text{},
       distinctNames(
           "g_z, cliff_delta, kendall_w, partial_eta2, odds_ratio, cronbach_alpha, omega_total, "
           "rank_biserial, bf10, probability",
           tests,
           [](const auto& row) { return row.effect.name; }) +
           ", share or rms_pooled [N]",
       nameOfNumber(&TestRow::effect)},
      {"effect", Number{}, "Its value", valueOfNumber(&TestRow::effect)},
      {"effect_low",
       Number{},
       "Its confidence interval",
       endOf(&TestRow::effectInterval, &Interval::low)},
      {"effect_high", Number{}, "…", endOf(&TestRow::effectInterval, &Interval::high)},
      {"flags", Text{}, "What a reader has to know, separated by spaces", &Row::flags},
      {"reason", Text{}, "Why something is missing", [](const Row& row) {
         return base::describe(row.test.reason);
       }}};
}

}  // namespace study
