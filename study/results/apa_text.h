#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/summary/within_analysis.h"
#include "protocols/model/protocol.h"
#include "study/words/words.h"

namespace study {

/// A number with so many decimals, halves to the even digit; "–" where there is none, "∞" where it
/// has no bounds. One function
/// for every table and figure, so that they agree.
std::string rounded(const std::optional<double>& value, int digits);

/// A Bayes factor to three digits; "> 1000" beyond what anybody would tell apart.
std::string evidenceInWords(double bayesFactor);

/// A p value as it stands in a text: ".021", "< .001"; "–" where there is none.
std::string pInWords(const std::optional<double>& p);

/// What stands after a letter: "= .021"; "< .001" and "> 1000" as they are.
std::string equalsInWords(const std::string& number);

/// "[0.41, 2.42]"; "–" where there is none.
std::string intervalInWords(const std::optional<analysis::Interval>& interval);

/// As a subscript of p: "Holm", "Bonferroni"; empty for none.
std::string_view nameOf(protocols::CorrectionType correction) noexcept;

/// What a family declares, in words: "paired t-test of participants' means, Holm correction".
std::string declaredInWords(const protocols::Family& family, const words::Words& words = {});

/// A comparison within people in the manner of the APA (7th edition): a line for the paired t-test,
/// one for the exact tests, and one each for the mixed models and for equivalence where there are.
/// What is not defined says why.
std::vector<std::string> apaLines(
    const analysis::WithinComparison& row,
    const protocols::Family& family,
    const words::Words& words = {});

/// The overall tests of a cohort: Friedman, repeated-measures ANOVA, the mixed models' variances.
std::vector<std::string> apaLines(
    const analysis::WithinAnalysis& analysis,
    const protocols::Family& family,
    const words::Words& words = {});

}  // namespace study
