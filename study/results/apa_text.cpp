#include "study/results/apa_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "analysis/registry/registry.h"

namespace study {
namespace {

/// Degrees of freedom: whole numbers without decimals, others with two.
std::string formatDegreesOfFreedom(double df) {
  return df == std::floor(df) ? fmt::format("{:.0f}", df) : fmt::format("{:.2f}", df);
}

/// A confidence limit with two decimals; from 1e5 in exponent notation.
std::string formatLimit(double value) {
  constexpr double kLong = 1e5;
  return std::abs(value) < kLong || std::isinf(value) ? rounded(value, 2)
                                                      : withMinusSign(fmt::format("{:.1e}", value));
}

/// An odds ratio: two decimals, but two significant digits below 0.1, and as a limit from 1e5.
std::string formatRatio(const std::optional<double>& ratio) {
  if (!ratio || !(*ratio > 0.0) || *ratio >= 0.1) return ratio ? formatLimit(*ratio) : "–";
  if (*ratio < 1e-4) return withMinusSign(fmt::format("{:.1e}", *ratio));
  return rounded(ratio, 1 - static_cast<int>(std::floor(std::log10(*ratio))));
}

/// Writes the sentences of one language.
class ApaWriter {
 public:
  ApaWriter(const words::Words& words, Wording wording) : words_(words), wording_(wording) {}

  std::string pairedTTestSentence(
      const analysis::WithinComparison& row, const protocols::Family& family) const {
    const auto& t = row.test("paired_t");
    if (!t.p) return words_.say("paired t-test not defined: {}", words_(t.reason));
    std::string line = words_.say(
        "t({}) = {}, {}, mean difference {}, {:g} % CI {}",
        formatDegreesOfFreedom(*t.df),
        rounded(t.statistic.value, 2),
        formatRawAndAdjustedP(t, family),
        rounded(t.estimate.value, 2),
        100.0 * (1.0 - family.alpha),
        formatInterval(t.interval));
    if (t.effect.value) {
      line +=
          fmt::format(", g_z = {} {}", rounded(t.effect.value, 2), inBrackets(t.effectInterval));
    }
    return line;
  }

  std::string exactTestsSentence(
      const analysis::WithinComparison& row, const protocols::Family& family) const {
    const auto& flip = row.test("sign_flip");
    const auto& rank = row.test("signed_rank");
    std::string line = flip.p
                           ? words_.say("exact sign flip {}", formatRawAndAdjustedP(flip, family))
                           : words_.say("sign flip not defined: {}", words_(flip.reason));
    line += "; ";
    line += rank.p ? words_.say(
                         "signed rank V = {:g}, {}",
                         rank.statistic.value.value_or(0.0),
                         formatRawAndAdjustedP(rank, family))
                   : words_.say("signed rank not defined: {}", words_(rank.reason));
    if (const auto& bf10 = row.test("bayes_factor").effect.value) {
      line += "; BF10 " + withRelationSign(formatBayesFactor(*bf10));
    }
    return line;
  }

  std::string mixed(const analysis::TestRow& test, const protocols::Family& family) const {
    if (!test.p) return words_.say("mixed model: no p value: {}", words_(test.reason));
    return words_.say(
        "mixed model: t({}) = {}, {}, difference {}",
        formatDegreesOfFreedom(*test.df),
        rounded(test.statistic.value, 2),
        formatRawAndAdjustedP(test, family),
        rounded(test.estimate.value, 2));
  }

  std::string ordinal(const analysis::TestRow& test, const protocols::Family& family) const {
    return words_.say(
        "ordinal mixed model: odds ratio {}, {:g} % CI {}, z = {}, {}",
        formatRatio(test.effect.value),
        100.0 * (1.0 - family.alpha),
        formatIntervalOfRatio(test.effectInterval),
        rounded(test.statistic.value, 2),
        formatRawAndAdjustedP(test, family));
  }

  std::string equivalence(const analysis::TestRow& test) const {
    if (!test.p) return words_.say("equivalence not defined: {}", words_(test.reason));
    return words_.say(
        "equivalent within ±{:g}: TOST {}",
        test.additionalNumber("equivalence_bound").value_or(0.0),
        formatPWithSymbol(test.p));
  }

  std::string friedman(const analysis::TestRow& test) const {
    if (!test.p) return words_.say("Friedman’s test not defined: {}", words_(test.reason));
    std::string line = fmt::format(
        "Friedman χ²({:g}) = {}, {}, Kendall’s W = {}",
        test.df.value_or(0.0),
        rounded(test.statistic.value, 2),
        formatPWithSymbol(test.p),
        rounded(test.effect.value, 2));
    const auto exactP = test.additionalNumber("p_permutation");
    if (exactP) line += words_.say(", exact {}", formatPWithSymbol(exactP));
    return line;
  }

  std::string anova(const analysis::TestRow& test) const {
    if (!test.p) return words_.say("Repeated-measures ANOVA not defined: {}", words_(test.reason));
    std::string line = words_.say(
        "Repeated-measures ANOVA F({:g}, {:g}) = {}, {}, partial η² = {}",
        *test.df,
        *test.df2,
        rounded(test.statistic.value, 2),
        formatPWithSymbol(test.p),
        rounded(test.effect.value, 2));
    if (const auto p = test.additionalNumber("p_epsilon")) {
      line += fmt::format(
          ", Greenhouse–Geisser ε = {}, {}",
          rounded(test.additionalNumber("epsilon"), 2),
          formatPWithSymbol(p));
    }
    return line;
  }

  /// The sentence of a test that none of the functions above handles.
  std::string otherTest(const analysis::TestRow& test, const protocols::Family& family) const {
    const auto title = words_(analysis::statisticalTest(test.id).title);
    if (!test.reason.empty() && !test.p) return title + ": " + words_(test.reason);
    std::string line = title + ": ";
    const auto add = [&](const analysis::NamedNumber& number) {
      if (!number.name.empty()) {
        line += fmt::format("{} = {}, ", number.name, rounded(number.value, 2));
      }
    };
    add(test.statistic);
    add(test.effect);
    return line +
           (test.isInFamily ? formatRawAndAdjustedP(test, family) : formatPWithSymbol(test.p));
  }

  std::string variances(const analysis::LinearMixedResult& mixed) const {
    if (!mixed.fit) return words_.say("Mixed model not fitted: {}", words_(mixed.reason));
    std::string list;
    for (const auto& component : mixed.fit->components) {
      list += fmt::format("{} {:.2f}", words_(component.name), component.variance);
      list += component.isSingular ? " " + words_("(at its bound)") + ", " : ", ";
    }
    return words_.say(
        "Mixed model, variances: {}residual {:.2f}", list, mixed.fit->residualVariance);
  }

  std::string ordinal(const analysis::CumulativeLinkResult& ordinal) const {
    if (!ordinal.fit)
      return words_.say("Ordinal mixed model not fitted: {}", words_(ordinal.reason));
    std::string list;
    for (const auto& component : ordinal.fit->components) {
      list += fmt::format(
          "{}{} {:.2f}", list.empty() ? "" : ", ", words_(component.name), component.variance);
    }
    return words_.say("Ordinal mixed model (logit, Laplace), variances: {}", list);
  }

 private:
  std::string formatPWithSymbol(const std::optional<double>& p) const {
    return study::formatPWithSymbol(p, {}, wording_);
  }

  /// "p = .021, p_Holm = .063".
  std::string formatRawAndAdjustedP(
      const analysis::TestRow& test, const protocols::Family& family) const {
    const auto name = nameOf(family.correction);
    return test.p && !name.empty() ? formatPWithSymbol(test.p) + ", " +
                                         study::formatPWithSymbol(test.adjusted, name, wording_)
                                   : formatPWithSymbol(test.p);
  }

  std::string formatInterval(const std::optional<analysis::Interval>& interval) const {
    return study::formatInterval(interval, wording_, words_);
  }

  std::string formatIntervalOfRatio(const std::optional<analysis::Interval>& interval) const {
    if (!interval) return "–";
    const auto low = formatRatio(interval->low);
    const auto high = formatRatio(interval->high);
    return wording_ == Wording::Vancouver ? words_.say("{} to {}", low, high)
                                          : "[" + low + ", " + high + "]";
  }

  /// An interval in brackets: APA's "[0.41, 2.42]" as it is, Vancouver's "0.41 to 2.42" in
  /// parentheses.
  std::string inBrackets(const std::optional<analysis::Interval>& interval) const {
    const auto words = formatInterval(interval);
    return wording_ == Wording::Vancouver && interval ? "(" + words + ")" : words;
  }

  const words::Words& words_;
  Wording wording_;
};

}  // namespace

std::string rounded(const std::optional<double>& value, int digits) {
  if (!value || std::isnan(*value)) return "–";
  if (std::isinf(*value)) return *value > 0.0 ? "∞" : "−∞";
  // A tie lies a little to either side of itself: 1.125 may be 1.1249999999999996 as a difference.
  constexpr double kTie = 1e-12;
  auto text = fmt::format("{:.{}f}", *value * (1.0 + kTie), digits);
  const bool isZero = text.find_first_of("123456789") == std::string::npos;
  if (isZero && text.starts_with('-')) text.erase(0, 1);
  return withMinusSign(std::move(text));
}

std::string withMinusSign(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "−");
  return number;
}

std::string formatBayesFactor(double bayesFactor) {
  return bayesFactor > 1000.0 ? "> 1000" : fmt::format("{:.3g}", bayesFactor);
}

std::string formatP(const std::optional<double>& p, Wording wording) {
  const std::string_view zero = wording == Wording::Apa ? "" : "0";
  if (!p) return "–";
  if (*p < 0.001) return fmt::format("< {}.001", zero);
  if (*p > 0.999) return fmt::format("> {}.999", zero);
  return fmt::format("{}{}", zero, rounded(p, 3).substr(1));
}

std::string withRelationSign(const std::string& number) {
  const bool isBound = number.starts_with('<') || number.starts_with('>');
  return isBound ? number : "= " + number;
}

std::string formatInterval(const std::optional<analysis::Interval>& interval) {
  if (!interval) return "–";
  return "[" + formatLimit(interval->low) + ", " + formatLimit(interval->high) + "]";
}

std::string formatInterval(
    const std::optional<analysis::Interval>& interval, Wording wording, const words::Words& words) {
  if (!interval || wording == Wording::Apa) return formatInterval(interval);
  return words.say("{} to {}", formatLimit(interval->low), formatLimit(interval->high));
}

Wording wordingNamed(std::string_view name) noexcept {
  return name == "vancouver" ? Wording::Vancouver : Wording::Apa;
}

std::string formatPWithSymbol(
    const std::optional<double>& p, std::string_view correction, Wording wording) {
  const bool isApa = wording == Wording::Apa;
  const std::string name = isApa ? "p" : "P";
  return name + (correction.empty() ? "" : "_" + std::string(correction)) + " " +
         withRelationSign(formatP(p, wording));
}

std::string_view nameOf(protocols::CorrectionType correction) noexcept {
  constexpr std::array<std::string_view, 8> kNames{
      "", "Bonferroni", "Holm", "Hochberg", "Hommel", "BH", "BY", "Holm–Šidák"};
  return kNames[static_cast<std::size_t>(correction)];
}

std::string testInWords(protocols::TestType test, const words::Words& words) {
  constexpr std::array<std::string_view, 4> kTests{
      "Welch's t-test of all answers, pooled",
      "paired t-test of participants' means",
      "exact sign-flip test of participants' means",
      "exact signed rank test of participants' means"};
  return words(kTests[static_cast<std::size_t>(test)]);
}

std::string declaredInWords(const protocols::Family& family, const words::Words& words) {
  const auto correction = nameOf(family.correction);
  return fmt::format(
      "{}, {}",
      testInWords(family.test, words),
      correction.empty() ? words("no correction") : words.say("{} correction", correction));
}

std::vector<std::string> apaLines(
    const analysis::WithinComparison& row,
    const protocols::Family& family,
    const words::Words& words,
    Wording wording) {
  const ApaWriter writer(words, wording);
  std::vector<std::string> lines{
      writer.pairedTTestSentence(row, family), writer.exactTestsSentence(row, family)};
  constexpr std::array<std::string_view, 4> kReportedAlready{
      "paired_t", "sign_flip", "signed_rank", "bayes_factor"};
  for (const auto& test : row.tests) {
    if (std::ranges::find(kReportedAlready, test.id) != kReportedAlready.end()) continue;
    if (test.id == "tost") continue;  // appended last
    if (test.id == "mixed_model") {
      lines.push_back(writer.mixed(test, family));
    } else if (test.id == "ordinal_model") {
      if (test.p) lines.push_back(writer.ordinal(test, family));
    } else {
      lines.push_back(writer.otherTest(test, family));
    }
  }
  if (const auto* tost = analysis::findTest(row.tests, "tost")) {
    lines.push_back(writer.equivalence(*tost));
  }
  return lines;
}

std::vector<std::string> apaLines(
    const analysis::WithinAnalysis& analysis,
    const protocols::Family& family,
    const words::Words& words,
    Wording wording) {
  const ApaWriter writer(words, wording);
  std::vector<std::string> lines;
  for (const auto& test : analysis.overall) {
    if (test.id == "friedman") {
      lines.push_back(writer.friedman(test));
    } else if (test.id == "rm_anova") {
      lines.push_back(writer.anova(test));
    } else {
      lines.push_back(writer.otherTest(test, family));
    }
  }
  lines.push_back(writer.variances(analysis.mixed));
  lines.push_back(writer.ordinal(analysis.ordinal));
  return lines;
}

}  // namespace study
