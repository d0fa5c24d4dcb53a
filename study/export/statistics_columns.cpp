#include "analysis/registry/registry.h"
#include "study/export/statistics_row.h"
#include "study/export/study_tables.h"

namespace study {
namespace {

/// A getter of a cell by the column's name.
template <typename Holding>
Column<StatisticsRow> statisticsColumn(const char* name, Holding holding, std::string description) {
  return {name, holding, std::move(description), [name](const StatisticsRow& row) {
            const auto cell = row.find(name);
            return cell == row.end() ? Cell() : cell->second;
          }};
}

/// A row of every registered test of studies, from made-up data: for the names of its statistic and
/// effect.
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

/// "t, z, V": the different names that @p nameOf has for the rows.
template <typename NameOf>
std::string listed(
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
  const auto tests = exampleRows();
  return {
      statisticsColumn("run_mode", OneOf{ValueList::RunModes}, kRunModeInWords),
      statisticsColumn("cohort", OneOf{ValueList::Cohorts}, kCohortInWords),
      statisticsColumn("cohort2", Text{}, "The other group, where two are compared"),
      statisticsColumn("family_id", Text{}, "Comparisons that belong together"),
      statisticsColumn("instrument", Text{}, "Questionnaire"),
      statisticsColumn("score", Text{}, "Of a questionnaire: which of its scores"),
      statisticsColumn("item_id", Text{}, "Question"),
      statisticsColumn(
          "occasion", Text{}, "before, after or change, where a score counts the change"),
      statisticsColumn(
          "acceptable_from", Number{}, "From which answer on an item counts as acceptable"),
      statisticsColumn(
          "n_missing", Integer{}, "Forms that answered some of a score's items and gave no score"),
      statisticsColumn("blocks", Text{}, "Phases whose answers count, separated by spaces"),
      statisticsColumn("m", Integer{}, "Tests in the family"),
      statisticsColumn(
          "group1", Text{}, "Condition code; the sign is group1 - group2 (cohort - cohort2)"),
      statisticsColumn("group2", Text{}, "Condition code"),
      statisticsColumn("groups", Text{}, "Condition codes of an overall test, separated by spaces"),
      statisticsColumn("design", Text{}, "unpaired, paired or mixed"),
      statisticsColumn("unit", Text{}, "answer or participant"),
      statisticsColumn(
          "method",
          Text{},
          listed(
              "welch, paired_t, sign_flip, signed_rank, mixed_model, ordinal_model, friedman, "
              "rm_anova, mann_whitney, brunner_munzel, order_slope, cronbach_alpha, shapiro_wilk, "
              "brown_forsythe, tost, bayes_factor, omega_total",
              tests,
              [](const auto& row) { return row.id; }) +
              "; not of a family: score, acceptability, felt_difference"),
      statisticsColumn(
          "declared",
          Boolean{},
          "Whether the protocol declared it, before the first participant; all else is "
          "exploratory"),
      statisticsColumn(
          "n1", Integer{}, "Units in group 1; pairs or participants where the design is paired"),
      statisticsColumn("n2", Integer{}, "Units in group 2"),
      statisticsColumn("mean1", Number{}, "Mean of group 1"),
      statisticsColumn("mean2", Number{}, "Mean of group 2"),
      statisticsColumn("sd1", Number{}, "Standard deviation of group 1, with n - 1"),
      statisticsColumn("sd2", Number{}, "Standard deviation of group 2, with n - 1"),
      statisticsColumn(
          "estimate",
          Number{},
          "Mean difference, of signed_rank Hodges and Lehmann's; log odds ratio; slope over "
          "positions; of felt_difference the mean over participants [N]"),
      statisticsColumn("se", Number{}, "Its standard error"),
      statisticsColumn(
          "statistic_name",
          Text{},
          listed(
              "t, z, V, U, chi2, F, W", tests, [](const auto& row) { return row.statistic.name; })),
      statisticsColumn("statistic", Number{}, "Its value"),
      statisticsColumn("df", Number{}, "Degrees of freedom; of F its first"),
      statisticsColumn("df2", Number{}, "Second degrees of freedom of F"),
      statisticsColumn(
          "p", Number{}, "Two-sided; of tost the larger of two one-sided ones; not corrected"),
      statisticsColumn("log10_p", Number{}, "Decimal logarithm of p"),
      statisticsColumn(
          "p_permutation", Number{}, "Of Friedman's test: exact, all permutations within people"),
      statisticsColumn(
          "epsilon", Number{}, "Greenhouse and Geisser's: how spherical the conditions are"),
      statisticsColumn(
          "p_epsilon", Number{}, "Of rm_anova: p with both degrees of freedom times epsilon"),
      statisticsColumn(
          "equivalence_bound", Number{}, "Of tost: differences below it count as none [points]"),
      statisticsColumn(
          "p_adj_method", Text{}, "bonferroni, holm, hochberg, hommel, bh, by, holm-sidak or none"),
      statisticsColumn("p_adj", Number{}, "Corrected for the family"),
      statisticsColumn("alpha", Number{}, "Of the family"),
      statisticsColumn("alpha_per_test", Number{}, "alpha / m, for the adjusted interval"),
      statisticsColumn("conf_level", Number{}, "Confidence of the intervals"),
      statisticsColumn(
          "conf_low", Number{}, "Confidence interval of the estimate; of a score its mean's"),
      statisticsColumn("conf_high", Number{}, "…"),
      statisticsColumn("conf_low_adj", Number{}, "… at 1 - alpha_per_test"),
      statisticsColumn("conf_high_adj", Number{}, "…"),
      statisticsColumn(
          "effect_name",
          Text{},
          listed(
              "g_z, cliff_delta, kendall_w, partial_eta2, odds_ratio, cronbach_alpha, omega_total, "
              "rank_biserial, bf10",
              tests,
              [](const auto& row) { return row.effect.name; }) +
              ", share or rms_pooled [N]"),
      statisticsColumn("effect", Number{}, "Its value"),
      statisticsColumn("effect_low", Number{}, "Its confidence interval"),
      statisticsColumn("effect_high", Number{}, "…"),
      statisticsColumn("flags", Text{}, "What a reader has to know, separated by spaces"),
      statisticsColumn("reason", Text{}, "Why something is missing")};
}

}  // namespace study
