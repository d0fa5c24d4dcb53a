#include "analysis/summary/within_analysis.h"

#include <algorithm>
#include <stdexcept>

#include "analysis/models/fixed_effects.h"
#include "analysis/numerics/exact_arithmetic.h"

namespace analysis {
namespace {

constexpr const char* kMethod = "method";

std::size_t placeOf(const AnswerTable& table, const std::string& method) {
  const auto found = std::find(table.methods.begin(), table.methods.end(), method);
  if (found == table.methods.end()) {
    throw std::invalid_argument("a pair names a method that is not there");
  }
  return static_cast<std::size_t>(found - table.methods.begin());
}

/// The labels of one column of the answers.
template <typename PlaceOf>
Factor factorBy(
    const std::string& name,
    const AnswerTable& table,
    const std::vector<std::string>& names,
    PlaceOf placeOfAnswer) {
  std::vector<std::string> labels;
  labels.reserve(table.answers.size());
  for (const auto& answer : table.answers) labels.push_back(names[placeOfAnswer(answer)]);
  return factorOf(name, labels, names);
}

/// score ~ method [+ round] + (1 | participant) + (1 | participant:method); a round, and the second
/// intercept, only where there are several answers to tell them apart.
struct MixedDesign {
  FixedEffects fixed;
  std::vector<Factor> random;
  std::vector<double> scores;
};

MixedDesign designOf(const AnswerTable& table) {
  MixedDesign design{.fixed = FixedEffects(table.answers.size()), .random = {}, .scores = {}};
  for (const auto& answer : table.answers) design.scores.push_back(answer.score);
  const auto method =
      factorBy(kMethod, table, table.methods, [](const auto& answer) { return answer.method; });
  design.fixed.add(method);
  const auto round =
      factorBy("round", table, table.rounds, [](const auto& answer) { return answer.round; });
  if (round.levels.size() > 1) design.fixed.add(round);
  const auto participant =
      factorBy("participant", table, table.participants, [](const auto& answer) {
        return answer.participant;
      });
  design.random.push_back(participant);
  auto taste = crossing(participant, method);
  taste.name = "participant:method";
  if (taste.levels.size() < table.answers.size()) design.random.push_back(std::move(taste));
  return design;
}

/// Adjusts what @p member holds over all rows.
void adjustOver(
    std::vector<WithinComparison>& rows,
    AdjustedP WithinComparison::*member,
    const WithinOptions& options) {
  std::vector<std::optional<double>> pValues;
  for (const auto& row : rows) pValues.push_back((row.*member).p);
  const auto adjusted = options.adjustment ? adjust(pValues, *options.adjustment) : pValues;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto& value = rows[i].*member;
    value.adjusted = adjusted[i];
    if (adjusted[i]) value.isSignificant = *adjusted[i] <= options.alpha;
  }
}

/// One cohort's comparisons in the making.
class Comparing {
 public:
  Comparing(
      const AnswerTable& table, std::span<const DeclaredPair> pairs, const WithinOptions& options)
      : table_(table), pairs_(pairs), options_(options) {}

  WithinAnalysis all() {
    result_.tests = pairs_.size();
    if (!pairs_.empty()) {
      result_.alphaPerTest =
          options_.adjustment ? alphaPerTest(options_.alpha, pairs_.size()) : options_.alpha;
    }
    overall();
    mixed();
    for (const auto& pair : pairs_) row(pair);
    for (auto member :
         {&WithinComparison::pairedP,
          &WithinComparison::signFlipP,
          &WithinComparison::signedRankP,
          &WithinComparison::mixedP,
          &WithinComparison::ordinalP}) {
      adjustOver(result_.rows, member, options_);
    }
    return std::move(result_);
  }

 private:
  void overall() {
    std::vector<std::size_t> every(table_.methods.size());
    for (std::size_t i = 0; i < every.size(); ++i) every[i] = i;
    const auto complete = completeMeans(table_, every);
    result_.participants = complete.participants.size();
    for (const std::size_t place : complete.leftOut) {
      result_.leftOut.push_back(table_.participants[place]);
    }
    if (every.size() < 2) return;
    result_.friedman = friedmanTest(complete.means);
    result_.anova = repeatedMeasuresAnova(complete.means);
  }

  void mixed() {
    if (table_.answers.empty()) {
      result_.mixed.reason = result_.ordinal.reason = reason("no_answers");
      return;
    }
    design_ = designOf(table_);
    result_.mixed = fitLinearMixedModel(design_->scores, design_->fixed, design_->random);
    std::vector<int> levels;
    for (const auto& answer : table_.answers) levels.push_back(answer.score);
    result_.ordinal = fitCumulativeLinkMixedModel(levels, design_->fixed, design_->random);
  }

  void row(const DeclaredPair& pair) {
    WithinComparison row{.group1 = pair.first, .group2 = pair.second};
    const auto complete =
        completeMeans(table_, {placeOf(table_, pair.first), placeOf(table_, pair.second)});
    const auto first = complete.of(0);
    const auto second = complete.of(1);
    for (std::size_t i = 0; i < first.size(); ++i) row.differences.push_back(first[i] - second[i]);
    row.differences = withoutRoundingNoise(row.differences);
    row.paired = pairedTTest(first, second);
    row.interval = confidenceInterval(row.paired, 1.0 - options_.alpha);
    row.adjustedInterval = confidenceInterval(row.paired, 1.0 - *result_.alphaPerTest);
    row.effects = effectSizes(row.paired, 1.0 - options_.alpha);
    row.signFlip = signFlipTest(row.differences);
    row.signedRank = signedRankTest(row.differences);
    row.location = hodgesLehmann(row.differences, 1.0 - options_.alpha);
    row.bayes = jzsBayesFactor(row.paired);
    if (const auto bound = options_.equivalenceBound) {
      row.equivalence = equivalenceTest(row.paired, {.lower = -*bound, .upper = *bound});
    }
    if (result_.mixed.fit) {
      row.mixed = mixedContrast(pair);
    } else {
      row.mixed.reason = result_.mixed.reason;
    }
    row.ordinal = ordinalContrast(pair);
    if (row.ordinal) {
      row.ordinalP.p = row.ordinal->p;
    } else {
      row.ordinalReason =
          result_.ordinal.fit ? reason("no_answers_to_method") : result_.ordinal.reason;
    }
    row.pairedP.p = row.paired.p;
    row.signFlipP.p = row.signFlip.p;
    row.signedRankP.p = row.signedRank.p;
    row.mixedP.p = row.mixed.p;
    result_.rows.push_back(std::move(row));
  }

  bool hasAnswers(const DeclaredPair& pair) const {
    const auto& levels = design_->fixed.factor(kMethod).levels;
    const auto isThere = [&](const std::string& name) {
      return std::find(levels.begin(), levels.end(), name) != levels.end();
    };
    return isThere(pair.first) && isThere(pair.second);
  }

  std::optional<WaldEstimate> ordinalContrast(const DeclaredPair& pair) const {
    if (!result_.ordinal.fit || !hasAnswers(pair)) return std::nullopt;
    return contrast(
        *result_.ordinal.fit,
        pair.first + " - " + pair.second,
        design_->fixed.difference(kMethod, pair.first, pair.second));
  }

  TEstimate mixedContrast(const DeclaredPair& pair) const {
    if (!hasAnswers(pair)) {
      TEstimate missing;
      missing.reason = reason("no_answers_to_method");
      return missing;
    }
    return contrast(
        *result_.mixed.fit,
        pair.first + " - " + pair.second,
        design_->fixed.difference(kMethod, pair.first, pair.second));
  }

  const AnswerTable& table_;
  std::span<const DeclaredPair> pairs_;
  const WithinOptions& options_;
  std::optional<MixedDesign> design_;
  WithinAnalysis result_;
};

}  // namespace

WithinAnalysis compareWithin(
    const AnswerTable& table, std::span<const DeclaredPair> pairs, const WithinOptions& options) {
  return Comparing(table, pairs, options).all();
}

}  // namespace analysis
