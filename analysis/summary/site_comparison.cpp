#include "analysis/summary/site_comparison.h"

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "analysis/registry/test_rows.h"

namespace analysis {
namespace {

class SiteComparer {
 public:
  SiteComparer(const AnswerTable& table, std::span<const std::string> sites, double level)
      : table_(table), sites_(sites), level_(level) {
    if (sites.size() != table.participants.size()) {
      throw std::invalid_argument("each participant has a site");
    }
    count();
    fitModels();
  }

  SiteAnalysis all(std::span<const DeclaredPair> pairs) {
    for (const auto& pair : pairs) result_.rows.push_back(comparisonOf(pair));
    return std::move(result_);
  }

 private:
  void count() {
    std::map<std::string, std::vector<std::vector<double>>> scores;  // by site and method
    for (const auto& site : sites_) scores[site].resize(table_.methods.size());
    for (const auto& answer : table_.answers) {
      scores.at(sites_[answer.participant])[answer.method].push_back(answer.score);
    }
    for (const auto& [site, methods] : scores) {
      auto& one = result_.answers.emplace_back(SiteAnswers{.site = site});
      one.participants = static_cast<std::size_t>(std::ranges::count(sites_, site));
      for (const auto& method : methods) one.methods.push_back(table_.sampleOf(method));
    }
  }

  void fitModels() {
    if (table_.answers.empty()) {
      result_.fixedSites.reason = result_.randomSites.reason = reason("no_answers");
      return;
    }
    std::vector<std::string> labels;
    for (const auto& answer : table_.answers) labels.push_back(sites_[answer.participant]);
    const auto site = factorOf("site", labels);
    design_ = mixedDesignOf(table_);
    auto random = design_->random;
    random.push_back(site);
    random.push_back(interactionOf(site, design_->fixed.factor(kMethodFactorName)));
    random.back().name = "site:method";
    result_.randomSites = fitLinearMixedModel(design_->scores, design_->fixed, random);
    fixedWithSites_ = design_->fixed;
    fixedWithSites_->add(site);
    result_.fixedSites = fitLinearMixedModel(design_->scores, *fixedWithSites_, design_->random);
  }

  SiteComparison comparisonOf(const DeclaredPair& pair) const {
    SiteComparison row{.group1 = pair.first, .group2 = pair.second};
    row.sites = differencesOf(pair);
    pool(row);
    row.fixedSites = contrastOf(result_.fixedSites, fixedWithSites_, pair);
    row.randomSites = contrastOf(
        result_.randomSites, design_ ? std::optional(design_->fixed) : std::nullopt, pair);
    return row;
  }

  std::vector<SiteDifference> differencesOf(const DeclaredPair& pair) const {
    const auto complete = completeCaseMeans(
        table_, {indexOfMethod(table_, pair.first), indexOfMethod(table_, pair.second)});
    std::vector<SiteDifference> differences;
    for (const auto& site : std::set<std::string>(sites_.begin(), sites_.end())) {
      std::vector<double> first;
      std::vector<double> second;
      for (std::size_t i = 0; i < complete.participants.size(); ++i) {
        if (sites_[complete.participants[i]] != site) continue;
        first.push_back(complete.means[i][0]);
        second.push_back(complete.means[i][1]);
      }
      auto test = pairedTTest(first, second);
      const auto interval = confidenceInterval(test, level_);
      differences.push_back({.site = site, .test = std::move(test), .interval = interval});
    }
    return differences;
  }

  /// Whether the site is pooled. A standard error that is only rounding noise of the means would
  /// get nearly all of the weight.
  static bool isPooled(const SiteDifference& site) {
    constexpr double kRounding = 1e-9;  // [points]
    return site.test.meanDifference && site.test.standardError.value_or(0.0) > kRounding;
  }

  void pool(SiteComparison& row) const {
    std::vector<EstimateWithError> known;
    std::vector<SiteDifference*> pooledSites;
    for (auto& site : row.sites) {
      if (!isPooled(site)) continue;
      known.push_back({*site.test.meanDifference, *site.test.standardError});
      pooledSites.push_back(&site);
    }
    if (known.size() < 2) {
      row.reason = reason("two_sites_needed");
      return;
    }
    row.pooled = pooled(known, level_);
    const auto& reml = row.pooled->reml;
    for (std::size_t i = 0; i < known.size(); ++i) {
      const double error = known[i].standardError;
      pooledSites[i]->weight =
          reml.standardError * reml.standardError / (error * error + reml.tauSquared);
    }
    const auto without = leaveOneOut(known, level_);
    for (std::size_t i = 0; i < without.size(); ++i) {
      row.leaveOneOut.push_back({pooledSites[i]->site, without[i]});
    }
  }

  TestRow contrastOf(
      const LinearMixedResult& model,
      const std::optional<FixedEffects>& fixed,
      const DeclaredPair& pair) const {
    TestRow row;
    if (!model.fit) {
      row.reason = model.reason;
    } else if (!hasLevels(*fixed, pair)) {
      row.reason = reason("no_answers_to_method");
    } else {
      const auto estimate = contrast(
          *model.fit,
          pair.first + " - " + pair.second,
          fixed->difference(kMethodFactorName, pair.first, pair.second));
      row = rowOf(estimate, table_.answers.size());
      row.interval = confidenceInterval(estimate, level_);
    }
    row.id = "mixed_model";
    row.group1 = pair.first;
    row.group2 = pair.second;
    return row;
  }

  const AnswerTable& table_;
  std::span<const std::string> sites_;
  double level_;
  std::optional<MixedDesign> design_;
  std::optional<FixedEffects> fixedWithSites_;
  SiteAnalysis result_;
};

}  // namespace

SiteAnalysis compareSites(
    const AnswerTable& table,
    std::span<const std::string> sites,
    std::span<const DeclaredPair> pairs,
    double level) {
  return SiteComparer(table, sites, level).all(pairs);
}

}  // namespace analysis
