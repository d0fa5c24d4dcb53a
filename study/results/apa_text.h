#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/summary/within_analysis.h"
#include "protocols/model/protocol.h"
#include "study/words/words.h"

namespace study {

/// A number with @p digits decimals, halves of its decimal value rounded away from zero: 3.125 is
/// "3.13"; "–" if there is none, "∞" if it is infinite. The minus is the sign, not a hyphen, and
/// zero has none: −0.004 is "0.00". All tables and figures use this function, so that they agree.
std::string rounded(const std::optional<double>& value, int digits);

/// A number with the minus sign "−" in place of a hyphen before it.
std::string withMinusSign(std::string number);

/// A Bayes factor with three significant digits; "> 1000" for all larger values.
std::string formatBayesFactor(double bayesFactor);

/// @p number with "= " before it, unless it begins with a relation sign: "= .021", "< .001", ">
///     1000".
std::string withRelationSign(const std::string& number);

/// "[0.41, 2.42]"; "–" if there is no interval.
std::string formatInterval(const std::optional<analysis::Interval>& interval);

/// The style in which sentences report numbers: "p = .021, [0.41, 2.42]" (APA, 7th edition), or "P
/// = 0.021, 0.41 to 2.42" (most medical journals that use Vancouver references).
enum class Wording { Apa, Vancouver };

/// A p value: ".021", "< .001", "> .999"; "0.021", "< 0.001", "> 0.999"; "–" if there is none.
std::string formatP(const std::optional<double>& p, Wording wording = Wording::Apa);

/// The style that is named "apa" or "vancouver".
Wording wordingNamed(std::string_view name) noexcept;

/// "p = .021", "p_Holm < .001"; "P = 0.021", "P_Holm < 0.001".
std::string formatPWithSymbol(
    const std::optional<double>& p,
    std::string_view correction = {},
    Wording wording = Wording::Apa);

/// "[0.41, 2.42]" (Apa); "0.41 to 2.42" (Vancouver).
std::string formatInterval(
    const std::optional<analysis::Interval>& interval, Wording wording, const words::Words& words);

/// The subscript of p for a correction: "Holm", "Bonferroni"; empty for no correction.
std::string_view nameOf(protocols::CorrectionType correction) noexcept;

/// A test that a protocol may declare: "paired t-test of participants' means".
std::string testInWords(protocols::TestType test, const words::Words& words = {});

/// A family's declared test and correction: "paired t-test of participants' means, Holm
/// correction".
std::string declaredInWords(const protocols::Family& family, const words::Words& words = {});

/// The sentences of one comparison within participants: one on the paired t-test, one on the exact
/// tests, and one each on the mixed models and on equivalence if they were computed. An undefined
/// result is reported with the reason.
std::vector<std::string> apaLines(
    const analysis::WithinComparison& row,
    const protocols::Family& family,
    const words::Words& words = {},
    Wording wording = Wording::Apa);

/// The overall tests of a cohort: Friedman, repeated-measures ANOVA, the mixed models' variances.
std::vector<std::string> apaLines(
    const analysis::WithinAnalysis& analysis,
    const protocols::Family& family,
    const words::Words& words = {},
    Wording wording = Wording::Apa);

}  // namespace study
