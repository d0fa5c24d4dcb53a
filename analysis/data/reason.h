#pragma once

#include <array>
#include <utility>

#include "base/message.h"

namespace analysis {

/// Why a number is missing.
using Reason = base::Message;

/// All reasons. The argument {} of a reason about a group is the number of the group, 1 or 2.
inline constexpr auto kReasons = std::to_array<base::MessageKind>({
    {"a_group_has_no_deviation",
     "a group has fewer than two values, and no standard deviation of its own"},
    {"a_group_is_constant",
     "a group is constant: Glass's delta cannot be measured by its standard deviation"},
    {"a_group_is_empty", "a group has no values"},
    {"a_p_too_small", "a p is too small for a double; its logarithm holds"},
    {"all_answers_same", "all answers are the same: there is nothing to explain"},
    {"all_highest",
     "all answers to '{}' of '{}' are {}, the highest that was given: its effect is infinite"},
    {"all_lowest",
     "all answers to '{}' of '{}' are {}, the lowest that was given: its effect is infinite"},
    {"all_ratings_same", "all ratings are the same: there is nothing to agree on"},
    {"all_treatments_tied", "every block ties all treatments: there is no order to test"},
    {"all_values_equal", "all values are equal: there is no order to test"},
    {"all_values_same", "all values are the same: there is no spread to test"},
    {"alpha_needs_two", "alpha needs two respondents and two items"},
    {"as_many_levels",
     "'{}' has as many levels as there are answers: its intercepts cannot be told apart from the "
     "residuals"},
    {"bayes_factor_beyond_double", "the Bayes factor is beyond a double; its logarithm holds"},
    {"beyond_1e100", "t is beyond 1e100"},
    {"both_constant_no_deviation",
     "both groups are constant: there is no standard deviation to measure a difference by"},
    {"conditions_not_told_apart",
     "no participant tells the conditions apart: there is no spread to test"},
    {"constant_differ", "both groups are constant and differ: t is infinite, and p is not defined"},
    {"constant_equal",
     "both groups are constant and equal: there is no spread to hold a difference against"},
    {"constant_groups_differ",
     "all groups are constant and differ: F is infinite, and p is not defined"},
    {"dependent_effect",
     "the fixed effect '{}' cannot be told apart from the others: it is a combination of them"},
    {"difference_beyond_double", "a difference is beyond what a double can hold"},
    {"difference_beyond_double_df",
     "a difference is beyond what a double can hold; t, degrees of freedom and p hold all the "
     "same"},
    {"differences_same", "all differences are the same: t is infinite, and p is not defined"},
    {"equally_far_from_median",
     "in every group, all values lie equally far from the median: there is nothing to test their "
     "spread by"},
    {"fewer_than_two", "group {} has fewer than two values"},
    {"group_empty_needs_two", "group {} has no values, and the test needs two in each group"},
    {"group_is_empty", "group {} has no values"},
    {"group_of_one_needs_two", "group {} has one value only, and the test needs two in each group"},
    {"groups_too_large", "the groups are too large to be ranked in whole numbers"},
    {"improper_omega", "a hint at most: its factor explains a statement completely"},
    {"item_without_variance",
     "everybody answers item {} alike: it has no correlation with the others"},
    {"likelihood_too_flat",
     "the likelihood is too flat in the variances to give degrees of freedom"},
    {"moment_beyond_double",
     "a mean or a variance is beyond what a double can hold; t and p hold all the same"},
    {"no_answers", "there are no answers"},
    {"no_answers_to_method", "one of the methods has no answers"},
    {"no_blocks", "nobody judged all methods"},
    {"no_differences", "there are no differences"},
    {"no_loadings", "the loadings of one factor could not be found"},
    {"no_maximum",
     "no maximum of the likelihood was found within 200 steps: the answers tell too little about "
     "the random intercepts, or separate completely"},
    {"no_overlap", "the groups do not overlap: W is infinite, and p is not defined"},
    {"no_overlap_no_interval", "the groups do not overlap: there is no interval"},
    {"no_pairs", "there are no pairs"},
    {"no_residual",
     "the raters differ by constants only, or not at all: F is infinite, and the intervals are not "
     "defined"},
    {"no_shape", "all values are the same: they have no shape"},
    {"no_sign_to_flip", "every difference is zero: there is no sign to flip"},
    {"no_sign_to_test", "every difference is zero: there is no sign to test"},
    {"no_spread_beyond_fixed",
     "the answers do not vary beyond the fixed effects: there is no spread to hold a difference "
     "against"},
    {"no_standard_error",
     "the standard error is zero: there is nothing to hold the estimate against"},
    {"no_variance_beyond_fixed", "the answers do not vary beyond the fixed effects"},
    {"nobody_answered", "nobody has answered"},
    {"nobody_changed", "nobody changed"},
    {"nobody_voted", "nobody has voted"},
    {"nothing_left_of_intercept", "the fixed effects leave nothing of the random intercept '{}'"},
    {"one_block", "one block alone cannot show F, nor how far blocks agree"},
    {"one_degree_of_freedom", "one degree of freedom is too few for the correction of d"},
    {"one_level", "'{}' has one level only: there is nothing to compare"},
    {"one_pair", "a comparison needs two participants, and has one"},
    {"one_position_each",
     "every method came at one position only: order and method cannot be told apart"},
    {"one_random_level", "'{}' has one level only: how its levels vary cannot be estimated"},
    {"one_row_or_column", "all counts are in one row or one column: there is nothing to compare"},
    {"one_side_of_level",
     "no answer is below {}, or none reaches it: the model tells no probability of it"},
    {"one_value_each", "every group has one value only: there is no spread within them"},
    {"p_too_small", "p is too small for a double; its logarithm holds"},
    {"pairs_equal", "all pairs are equal: there is no spread to hold a difference against"},
    {"same_change", "all participants change in the same way: F is infinite, and p is not defined"},
    {"same_grouping",
     "'{}' and '{}' group the answers alike: their variances cannot be told apart"},
    {"same_to_all", "everybody said the same to all options: there is nothing to compare"},
    {"separated",
     "the answers separate completely: an effect has no finite estimate, as where all answers to a "
     "combination of levels are the highest or the lowest"},
    {"sizes_too_unlike", "the differences are too unlike in size to be added exactly"},
    {"students_t_undefined",
     "Student's t is not defined or infinite: there is too little spread or data for a Bayes "
     "factor"},
    {"subject_means_same",
     "all subjects have the same mean: an average of ratings cannot tell them apart"},
    {"sum_beyond_double",
     "a sum of squares is beyond what a double can hold; F and p hold all the same"},
    {"sums_same", "all respondents have the same sum: it has no variance to share"},
    {"t_too_large", "t is too large for a double, and p too small"},
    {"three_items_needed", "one factor needs three items to be determined"},
    {"three_respondents_needed", "a factor needs three respondents"},
    {"three_to_5000_values", "the test is made for 3 to 5000 values"},
    {"too_few_answers", "there are {} answers for {} fixed effects, and more answers are needed"},
    {"too_few_clusters", "there is less than one degree of freedom: too few clusters"},
    {"too_few_levels", "there is less than one degree of freedom: too few participants or levels"},
    {"too_many_answers", "there are too many answers for an exact p; that of χ² holds"},
    {"too_many_averages", "there are too many differences for all their averages"},
    {"too_many_blocks", "there are too many blocks for an exact p; that of χ² holds"},
    {"too_many_changes", "there are too many changes to count their outcomes"},
    {"too_many_counts", "there are too many counts for an exact p"},
    {"too_many_differences", "there are too many differences for an exact p"},
    {"too_many_differences_asymptotic",
     "there are too many differences for an exact p; the asymptotic one holds"},
    {"too_many_standard_errors",
     "the difference is more than 1e100 standard errors: too many for an interval"},
    {"too_many_tables", "there are too many tables for an exact p"},
    {"too_many_to_flip", "there are too many differences to flip all of their signs"},
    {"too_many_values", "there are too many values for an exact p; the asymptotic one holds"},
    {"too_many_votes", "there are too many votes for an exact p; that of χ² holds"},
    {"two_conditions_needed", "the test needs two conditions"},
    {"two_groups_needed", "the test needs two groups"},
    {"two_pairs_only", "two pairs are too few for the correction of d"},
    {"two_participants_needed", "the test needs two participants"},
    {"two_sites_needed", "fewer than two sites have a difference with a standard error"},
    {"two_subjects_needed", "an intraclass correlation needs two subjects and two ratings of each"},
    {"two_values_needed", "variance and interval need two values in each group"},
    {"variance_beyond_double",
     "a variance is beyond what a double can hold; t, degrees of freedom and p hold all the same"},
    {"variances_not_estimated",
     "the variances could not be estimated: no residual variance is left within the levels of the "
     "random intercepts, or the answers tell too little about them"},
});

/// A reason of kReasons with its arguments: reason("one_level", factor.name).
template <typename... Arguments>
Reason reason(base::CheckedKey<kReasons, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kReasons>(key, std::forward<Arguments>(arguments)...);
}

}  // namespace analysis
