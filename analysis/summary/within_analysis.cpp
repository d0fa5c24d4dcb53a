#include "analysis/summary/within_analysis.h"

#include <algorithm>
#include <stdexcept>

#include "analysis/models/fixed_effects.h"
#include "analysis/registry/registry.h"
#include "analysis/registry/test_rows.h"

namespace analysis {
namespace {

/// The factor made of one column of the answers.
template <typename IndexOf>
Factor factorBy(
    const std::string& name,
    const AnswerTable& table,
    const std::vector<std::string>& names,
    IndexOf indexOfAnswer) {
  std::vector<std::string> labels;
  labels.reserve(table.answers.size());
  for (const auto& answer : table.answers) labels.push_back(names[indexOfAnswer(answer)]);
  return factorOf(name, labels, names);
}

/// Adjusts the p values of one test over all rows.
void adjustTest(
    std::vector<WithinComparison>& rows, std::size_t place, const WithinOptions& options) {
  std::vector<std::optional<double>> pValues;
  for (const auto& row : rows) pValues.push_back(row.tests[place].p);
  const auto adjusted = options.adjustment ? adjust(pValues, *options.adjustment) : pValues;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto& test = rows[i].tests[place];
    test.adjusted = adjusted[i];
    if (adjusted[i]) test.isSignificant = *adjusted[i] <= options.alpha;
  }
}

/// Computes one cohort's comparisons.
class WithinComparer {
 public:
  WithinComparer(
      const AnswerTable& table, std::span<const DeclaredPair> pairs, const WithinOptions& options)
      : table_(table), pairs_(pairs), options_(options) {}

  WithinAnalysis all() {
    result_.tests = pairs_.size();
    if (!pairs_.empty()) {
      result_.alphaPerTest =
          options_.adjustment ? alphaPerTest(options_.alpha, pairs_.size()) : options_.alpha;
    }
    overall();
    fitMixedModels();
    for (const auto& pair : pairs_) row(pair);
    const auto places = result_.rows.empty() ? 0 : result_.rows.front().tests.size();
    for (std::size_t place = 0; place < places; ++place) {
      if (result_.rows.front().tests[place].isInFamily) adjustTest(result_.rows, place, options_);
    }
    return std::move(result_);
  }

 private:
  void overall() {
    std::vector<std::size_t> every(table_.methods.size());
    for (std::size_t i = 0; i < every.size(); ++i) every[i] = i;
    const auto complete = completeCaseMeans(table_, every);
    result_.participants = complete.participants.size();
    for (const std::size_t place : complete.excludedParticipants) {
      result_.excludedParticipants.push_back(table_.participants[place]);
    }
    if (every.size() < 2) return;
    TestData data;
    for (std::size_t i = 0; i < every.size(); ++i) {
      data.values.push_back({.name = table_.methods[i], .values = complete.of(i)});
    }
    for (const auto& test : statisticalTests()) {
      if (test.use == StudyUse::Conditions) addTest(result_.overall, test, data);
    }
  }

  void fitMixedModels() {
    if (table_.answers.empty()) {
      result_.mixed.reason = result_.ordinal.reason = reason("no_answers");
      return;
    }
    design_ = mixedDesignOf(table_);
    result_.mixed = fitLinearMixedModel(design_->scores, design_->fixed, design_->random);
    if (!table_.isPointScale) {
      result_.ordinal.reason = base::messageOf<kWithinMessages>("no_points_to_order");
      return;
    }
    if (table_.highest - table_.lowest >= kMostPointsOfOrdinalModel) {
      result_.ordinal.reason =
          base::messageOf<kWithinMessages>("too_many_points_for_order", kMostPointsOfOrdinalModel);
      return;
    }
    std::vector<int> levels;
    for (const auto& answer : table_.answers) levels.push_back(static_cast<int>(answer.score));
    result_.ordinal = fitCumulativeLinkMixedModel(levels, design_->fixed, design_->random);
    for (const auto& method : table_.methods) {
      const HighAnswerEvent asked{
          .factor = kMethodFactorName, .group = method, .from = table_.lowestPointAboveMiddle()};
      result_.probabilities.push_back(answerProbabilityRow(
          result_.ordinal, design_->fixed, levels, asked, 1.0 - options_.alpha));
      result_.probabilities.back().id = "answer_probability";
    }
  }

  void row(const DeclaredPair& pair) {
    WithinComparison row{.group1 = pair.first, .group2 = pair.second};
    const auto complete = completeCaseMeans(
        table_, {indexOfMethod(table_, pair.first), indexOfMethod(table_, pair.second)});
    const TestData data{
        .values = {
            {.name = pair.first, .values = complete.of(0)},
            {.name = pair.second, .values = complete.of(1)}}};
    for (const auto& test : statisticalTests()) {
      if (test.use == StudyUse::Pairs || test.use == StudyUse::PairsOutsideFamily) {
        addTest(row.tests, test, data);
      }
    }
    row.tests.push_back(mixedContrast(pair));
    row.tests.push_back(ordinalContrast(pair));
    result_.rows.push_back(std::move(row));
  }

  /// Adds the rows of a test; skips an equivalence test if no bound was declared.
  void addTest(std::vector<TestRow>& rows, const StatisticalTest& test, const TestData& data) {
    const bool needsBound = test.form == StatisticalTest::Form::NeedsBound;
    if (needsBound && !options_.equivalenceBound) return;
    TestSettings settings{.level = 1.0 - options_.alpha};
    if (result_.alphaPerTest) settings.adjustedLevel = 1.0 - *result_.alphaPerTest;
    if (needsBound) settings.bound = options_.equivalenceBound;
    for (auto& row : computeTest(test, data, settings)) {
      row.isInFamily = test.use == StudyUse::Pairs;
      // Exact tests and Friedman's are defined for one participant, but meaningless.
      if (row.p && data.values.front().values.size() < 2) {
        row.p.reset();
        row.log10P.reset();
        row.reason = reason("two_participants_needed");
      }
      rows.push_back(std::move(row));
    }
  }

  TestRow modelRow(
      TestRow row, std::string_view id, const DeclaredPair& pair, const Reason& whyNot) const {
    row.id = id;
    row.group1 = pair.first;
    row.group2 = pair.second;
    row.n1 = table_.answers.size();
    row.isInFamily = true;
    if (!whyNot.empty()) row.reason = whyNot;
    return row;
  }

  /// Why a fitted model has no difference of a pair.
  Reason whyNoContrast(bool hasFit, const Reason& whyNoFit, const DeclaredPair& pair) const {
    if (!hasFit) return whyNoFit;
    return hasLevels(design_->fixed, pair) ? Reason() : reason("no_answers_to_method");
  }

  template <typename Fit>
  auto contrastOf(const Fit& fit, const DeclaredPair& pair) const {
    return contrast(
        fit,
        pair.first + " - " + pair.second,
        design_->fixed.difference(kMethodFactorName, pair.first, pair.second));
  }

  TestRow mixedContrast(const DeclaredPair& pair) const {
    const auto& model = result_.mixed;
    const auto whyNot = whyNoContrast(model.fit.has_value(), model.reason, pair);
    TestRow row;
    if (whyNot.empty()) row = rowOf(contrastOf(*model.fit, pair), table_.answers.size());
    return modelRow(std::move(row), "mixed_model", pair, whyNot);
  }

  TestRow ordinalContrast(const DeclaredPair& pair) const {
    const auto& model = result_.ordinal;
    const auto whyNot = whyNoContrast(model.fit.has_value(), model.reason, pair);
    TestRow row;
    if (whyNot.empty()) {
      row = rowOf(contrastOf(*model.fit, pair), table_.answers.size(), 1.0 - options_.alpha);
    }
    return modelRow(std::move(row), "ordinal_model", pair, whyNot);
  }

  const AnswerTable& table_;
  std::span<const DeclaredPair> pairs_;
  const WithinOptions& options_;
  std::optional<MixedDesign> design_;
  WithinAnalysis result_;
};

}  // namespace

MixedDesign mixedDesignOf(const AnswerTable& table) {
  MixedDesign design{.fixed = FixedEffects(table.answers.size()), .random = {}, .scores = {}};
  for (const auto& answer : table.answers) design.scores.push_back(answer.score);
  const auto method = factorBy(
      kMethodFactorName, table, table.methods, [](const auto& answer) { return answer.method; });
  design.fixed.add(method);
  const auto round =
      factorBy("round", table, table.rounds, [](const auto& answer) { return answer.round; });
  if (round.levels.size() > 1) design.fixed.add(round);
  const auto participant =
      factorBy("participant", table, table.participants, [](const auto& answer) {
        return answer.participant;
      });
  design.random.push_back(participant);
  auto taste = interactionOf(participant, method);
  taste.name = "participant:method";
  if (taste.levels.size() < table.answers.size()) design.random.push_back(std::move(taste));
  return design;
}

bool hasLevels(const FixedEffects& fixed, const DeclaredPair& pair) {
  const auto& levels = fixed.factor(kMethodFactorName).levels;
  const auto isThere = [&](const std::string& name) {
    return std::ranges::find(levels, name) != levels.end();
  };
  return isThere(pair.first) && isThere(pair.second);
}

std::size_t indexOfMethod(const AnswerTable& table, const std::string& method) {
  const auto found = std::ranges::find(table.methods, method);
  if (found == table.methods.end()) {
    throw std::invalid_argument("a pair names a method that is not there");
  }
  return static_cast<std::size_t>(found - table.methods.begin());
}

WithinAnalysis compareWithin(
    const AnswerTable& table, std::span<const DeclaredPair> pairs, const WithinOptions& options) {
  return WithinComparer(table, pairs, options).all();
}

}  // namespace analysis
