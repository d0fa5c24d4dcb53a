#include "study/results/apa_text.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace study {
namespace {

/// "p = .021", "p < .001".
std::string pEquals(const std::optional<double>& p) {
  return "p " + equalsInWords(pInWords(p));
}

/// "p = .021, p_Holm = .063".
std::string pBoth(const analysis::AdjustedP& p, const protocols::Family& family) {
  std::string words = pEquals(p.p);
  const auto name = nameOf(family.correction);
  if (p.p && !name.empty()) {
    words += fmt::format(", p_{} {}", name, equalsInWords(pInWords(p.adjusted)));
  }
  return words;
}

/// Degrees of freedom: whole ones without decimals.
std::string freedom(double df) {
  return df == std::floor(df) ? fmt::format("{:.0f}", df) : fmt::format("{:.2f}", df);
}

/// Writes the sentences of one language.
class ApaWriter {
 public:
  explicit ApaWriter(const words::Words& words) : w_(words) {}

  std::string paired(const analysis::WithinComparison& row, const protocols::Family& family) const {
    const auto& t = row.paired;
    if (!t.p) return w_.say("paired t-test not defined: {}", w_(t.reason));
    std::string line = w_.say(
        "t({}) = {}, {}, mean difference {}, {:g} % CI {}",
        freedom(*t.degreesOfFreedom),
        rounded(t.t, 2),
        pBoth(row.pairedP, family),
        rounded(t.meanDifference, 2),
        100.0 * (1.0 - family.alpha),
        intervalInWords(row.interval));
    if (row.effects.hedgesGz.value) {
      line += fmt::format(
          ", g_z = {} {}",
          rounded(row.effects.hedgesGz.value, 2),
          intervalInWords(row.effects.hedgesGz.interval));
    }
    return line;
  }

  std::string exact(const analysis::WithinComparison& row, const protocols::Family& family) const {
    std::string line = row.signFlip.p
                           ? w_.say("exact sign flip {}", pBoth(row.signFlipP, family))
                           : w_.say("sign flip not defined: {}", w_(row.signFlip.reason));
    line += "; ";
    line += row.signedRank.p ? w_.say(
                                   "signed rank V = {:g}, {}",
                                   row.signedRank.v.value_or(0.0),
                                   pBoth(row.signedRankP, family))
                             : w_.say("signed rank not defined: {}", w_(row.signedRank.reason));
    if (row.bayes.bf10) line += "; BF10 " + equalsInWords(evidenceInWords(*row.bayes.bf10));
    return line;
  }

  std::string mixed(const analysis::WithinComparison& row, const protocols::Family& family) const {
    if (!row.mixed.p) return w_.say("mixed model: no p value: {}", w_(row.mixed.reason));
    return w_.say(
        "mixed model: t({}) = {}, {}, difference {}",
        freedom(*row.mixed.degreesOfFreedom),
        rounded(row.mixed.t, 2),
        pBoth(row.mixedP, family),
        rounded(row.mixed.estimate, 2));
  }

  std::string ordinal(
      const analysis::WithinComparison& row, const protocols::Family& family) const {
    const auto& estimate = *row.ordinal;
    return w_.say(
        "ordinal mixed model: odds ratio {}, {:g} % CI {}, z = {}, {}",
        rounded(estimate.oddsRatio, 2),
        100.0 * (1.0 - family.alpha),
        intervalInWords(oddsRatioInterval(estimate, 1.0 - family.alpha)),
        rounded(estimate.z, 2),
        pBoth(row.ordinalP, family));
  }

  std::string equivalence(const analysis::EquivalenceResult& result) const {
    if (!result.p) return w_.say("equivalence not defined: {}", w_(result.reason));
    return w_.say("equivalent within ±{:g}: TOST {}", result.bounds.upper, pEquals(result.p));
  }

  std::string friedman(const analysis::FriedmanResult& friedman) const {
    if (!friedman.p) return w_.say("Friedman’s test not defined: {}", w_(friedman.reason));
    std::string line = fmt::format(
        "Friedman χ²({}) = {}, {}, W = {}",
        friedman.treatments - 1,
        rounded(friedman.chiSquared, 2),
        pEquals(friedman.p),
        rounded(friedman.kendallW, 2));
    if (friedman.exactP) line += w_.say(", exact {}", pEquals(friedman.exactP));
    return line;
  }

  std::string anova(const analysis::RepeatedMeasuresResult& anova) const {
    if (!anova.p) return w_.say("Repeated-measures ANOVA not defined: {}", w_(anova.reason));
    std::string line = w_.say(
        "Repeated-measures ANOVA F({:g}, {:g}) = {}, {}, partial η² = {}",
        *anova.degreesOfFreedom1,
        *anova.degreesOfFreedom2,
        rounded(anova.f, 2),
        pEquals(anova.p),
        rounded(anova.partialEtaSquared, 2));
    if (anova.pGreenhouseGeisser) {
      line += fmt::format(
          ", Greenhouse–Geisser ε = {}, {}",
          rounded(anova.greenhouseGeisser, 2),
          pEquals(anova.pGreenhouseGeisser));
    }
    return line;
  }

  std::string variances(const analysis::LinearMixedResult& mixed) const {
    if (!mixed.fit) return w_.say("Mixed model not fitted: {}", w_(mixed.reason));
    std::string list;
    for (const auto& component : mixed.fit->components) {
      list += fmt::format("{} {:.2f}", w_(component.name), component.variance);
      list += component.isSingular ? " " + w_("(at its bound)") + ", " : ", ";
    }
    return w_.say("Mixed model, variances: {}residual {:.2f}", list, mixed.fit->residualVariance);
  }

  std::string ordinal(const analysis::CumulativeLinkResult& ordinal) const {
    if (!ordinal.fit) return w_.say("Ordinal mixed model not fitted: {}", w_(ordinal.reason));
    std::string list;
    for (const auto& component : ordinal.fit->components) {
      list += fmt::format(
          "{}{} {:.2f}", list.empty() ? "" : ", ", w_(component.name), component.variance);
    }
    return w_.say("Ordinal mixed model (logit, Laplace), variances: {}", list);
  }

 private:
  const words::Words& w_;
};

}  // namespace

std::string rounded(const std::optional<double>& value, int digits) {
  if (!value || std::isnan(*value)) return "–";
  if (std::isinf(*value)) return *value > 0.0 ? "∞" : "-∞";
  return fmt::format("{:.{}f}", *value, digits);
}

std::string evidenceInWords(double bayesFactor) {
  return bayesFactor > 1000.0 ? "> 1000" : fmt::format("{:.3g}", bayesFactor);
}

std::string pInWords(const std::optional<double>& p) {
  if (!p) return "–";
  if (*p < 0.001) return "< .001";
  if (*p >= 0.9995) return "1.000";
  return fmt::format("{:.3f}", *p).substr(1);
}

std::string equalsInWords(const std::string& number) {
  const bool isBound = number.starts_with('<') || number.starts_with('>');
  return isBound ? number : "= " + number;
}

std::string intervalInWords(const std::optional<analysis::Interval>& interval) {
  if (!interval) return "–";
  // What a short line cannot hold is told by its size.
  constexpr double kLong = 1e5;
  const auto limit = [](double value) {
    return std::abs(value) < kLong || std::isinf(value) ? rounded(value, 2)
                                                        : fmt::format("{:.1e}", value);
  };
  return "[" + limit(interval->low) + ", " + limit(interval->high) + "]";
}

std::string_view nameOf(protocols::CorrectionType correction) noexcept {
  constexpr std::array<std::string_view, 8> kNames{
      "", "Bonferroni", "Holm", "Hochberg", "Hommel", "BH", "BY", "Holm–Šidák"};
  return kNames[static_cast<std::size_t>(correction)];
}

std::string declaredInWords(const protocols::Family& family, const words::Words& words) {
  constexpr std::array<std::string_view, 4> kTests{
      "Welch's t-test of all answers, pooled",
      "paired t-test of participants' means",
      "exact sign-flip test of participants' means",
      "exact signed rank test of participants' means"};
  const auto correction = nameOf(family.correction);
  return fmt::format(
      "{}, {}",
      words(kTests[static_cast<std::size_t>(family.test)]),
      correction.empty() ? words("no correction") : words.say("{} correction", correction));
}

std::vector<std::string> apaLines(
    const analysis::WithinComparison& row,
    const protocols::Family& family,
    const words::Words& words) {
  const ApaWriter writer(words);
  std::vector<std::string> lines{
      writer.paired(row, family), writer.exact(row, family), writer.mixed(row, family)};
  if (row.ordinal) lines.push_back(writer.ordinal(row, family));
  if (row.equivalence) lines.push_back(writer.equivalence(*row.equivalence));
  return lines;
}

std::vector<std::string> apaLines(
    const analysis::WithinAnalysis& analysis, const words::Words& words) {
  const ApaWriter writer(words);
  return {
      writer.friedman(analysis.friedman),
      writer.anova(analysis.anova),
      writer.variances(analysis.mixed),
      writer.ordinal(analysis.ordinal)};
}

}  // namespace study
