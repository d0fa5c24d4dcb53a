#include "study/export/statistics_row.h"

namespace study {

std::vector<Column> statisticsColumns() {
  return {
      {"run_mode", "live, pilot or simulated"},
      {"cohort", "Group of participants"},
      {"cohort2", "The other group, where two are compared"},
      {"family_id", "Comparisons that belong together"},
      {"instrument", "Questionnaire"},
      {"score", "Of a questionnaire: which of its scores"},
      {"item_id", "Question"},
      {"occasion", "before, after or change, where a score counts the change"},
      {"acceptable_from", "From which answer on an item counts as acceptable"},
      {"n_missing", "Forms that answered some of a score's items and gave no score"},
      {"blocks", "Phases whose answers count, separated by spaces"},
      {"m", "Tests in the family"},
      {"group1", "Condition code; the sign is group1 - group2 (cohort - cohort2)"},
      {"group2", "Condition code"},
      {"groups", "Condition codes of an overall test, separated by spaces"},
      {"design", "unpaired, paired or mixed"},
      {"unit", "answer or participant"},
      {"method",
       "welch, paired_t, sign_flip, signed_rank, mixed_model, ordinal_model, friedman, rm_anova, "
       "mann_whitney, brunner_munzel, order_slope, cronbach_alpha, shapiro_wilk, brown_forsythe, "
       "tost, bayes_factor, omega_total; not of a family: score, acceptability, felt_difference"},
      {"declared",
       "Whether the protocol declared it, before the first participant; all else is exploratory"},
      {"n1", "Units in group 1; pairs or participants where the design is paired"},
      {"n2", "Units in group 2"},
      {"mean1", "Mean of group 1"},
      {"mean2", "Mean of group 2"},
      {"sd1", "Standard deviation of group 1, with n - 1"},
      {"sd2", "Standard deviation of group 2, with n - 1"},
      {"estimate",
       "Mean difference, of signed_rank Hodges and Lehmann's; log odds ratio; slope over "
       "positions; of felt_difference the mean over participants [N]"},
      {"se", "Its standard error"},
      {"statistic_name", "t, z, V, U, chi2, F, W"},
      {"statistic", "Its value"},
      {"df", "Degrees of freedom; of F its first"},
      {"df2", "Second degrees of freedom of F"},
      {"p", "Two-sided; of tost the larger of two one-sided ones; not corrected"},
      {"log10_p", "Decimal logarithm of p"},
      {"p_permutation", "Of Friedman's test: exact, all permutations within people"},
      {"epsilon", "Greenhouse and Geisser's: how spherical the conditions are"},
      {"p_epsilon", "Of rm_anova: p with both degrees of freedom times epsilon"},
      {"equivalence_bound", "Of tost: differences below it count as none [points]"},
      {"p_adj_method", "bonferroni, holm, hochberg, hommel, bh, by, holm-sidak or none"},
      {"p_adj", "Corrected for the family"},
      {"alpha", "Of the family"},
      {"alpha_per_test", "alpha / m, for the adjusted interval"},
      {"conf_level", "Confidence of the intervals"},
      {"conf_low", "Confidence interval of the estimate; of a score its mean's"},
      {"conf_high", "…"},
      {"conf_low_adj", "… at 1 - alpha_per_test"},
      {"conf_high_adj", "…"},
      {"effect_name",
       "g_z, cliff_delta, kendall_w, partial_eta2, odds_ratio, cronbach_alpha, omega_total, "
       "rank_biserial, bf10, share or rms_pooled [N]"},
      {"effect", "Its value"},
      {"effect_low", "Its confidence interval"},
      {"effect_high", "…"},
      {"flags", "What a reader has to know, separated by spaces"},
      {"reason", "Why something is missing"}};
}

}  // namespace study
