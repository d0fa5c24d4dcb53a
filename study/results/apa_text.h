#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/summary/within_analysis.h"
#include "protocols/model/protocol.h"
#include "study/words/words.h"

namespace study {

/// A number with @p digits decimals, halves rounded to even; "–" if there is none, "∞" if it is
/// infinite. All tables and figures use this function, so that they agree.
std::string rounded(const std::optional<double>& value, int digits);

/// A Bayes factor with three significant digits; "> 1000" for all larger values.
std::string formatBayesFactor(double bayesFactor);

/// @p number with its relation sign: "= .021"; "< .001" and "> 1000" keep their own.
std::string withRelationSign(const std::string& number);

/// "[0.41, 2.42]"; "–" if there is no interval.
std::string formatInterval(const std::optional<analysis::Interval>& interval);

/// How sentences write numbers: "p = .021, [0.41, 2.42]" as the APA asks (7th edition), or "P =
/// 0.021, 0.41 to 2.42" as most medical journals do that have Vancouver's style of references.
enum class Wording { Apa, Vancouver };

/// A p value: ".021", "< .001"; "0.021", "< 0.001"; "–" if there is none.
std::string formatP(const std::optional<double>& p, Wording wording = Wording::Apa);

/// The wording named "apa" or "vancouver".
Wording wordingNamed(std::string_view name) noexcept;

/// "p = .021", "p_Holm < .001"; "P = 0.021", "P_Holm < 0.001".
std::string formatPWithSymbol(
    const std::optional<double>& p,
    std::string_view correction = {},
    Wording wording = Wording::Apa);

/// "[0.41, 2.42]" (Apa); "0.41 to 2.42" (Vancouver).
std::string formatInterval(
    const std::optional<analysis::Interval>& interval, Wording wording, const words::Words& words);

/// The subscript of p: "Holm", "Bonferroni"; empty for none.
std::string_view nameOf(protocols::CorrectionType correction) noexcept;

/// A family's declared test and correction: "paired t-test of participants' means, Holm
/// correction".
std::string declaredInWords(const protocols::Family& family, const words::Words& words = {});

/// A comparison within people: a line for the paired t-test, one for the exact tests, and one each
/// for the mixed models and for equivalence if there are any. An undefined result is given with the
/// reason.
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
