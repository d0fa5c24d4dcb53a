#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/hypothesis_tests/t_tests.h"
#include "analysis/models/meta_analysis.h"
#include "analysis/summary/within_analysis.h"

namespace analysis {

/// The difference of two methods at one site, from its participants' means.
struct SiteDifference {
  std::string site;
  PairedTResult test;
  std::optional<Interval> interval;
  double weight = 0.0;  ///< weight of the site in the pooled difference (REML), 0 … 1; 0 if the
                        ///< site is not pooled
};

/// The answers at one site, one sample per method of the table.
struct SiteAnswers {
  std::string site;
  std::size_t participants = 0;
  std::vector<AnswerSample> methods;
};

/// The pooled difference of all sites but one.
struct LeaveOneOutEstimate {
  std::string site;  ///< the site left out
  PooledEstimate pooled;
};

/// Two methods, compared within participants at each site.
struct SiteComparison {
  std::string group1;
  std::string group2;
  std::vector<SiteDifference> sites;  ///< sorted by name
  std::optional<MetaAnalysis> pooled;
  Reason reason;  ///< why nothing is pooled
  std::vector<LeaveOneOutEstimate> leaveOneOut;
  TestRow fixedSites;   ///< from the model with site as a fixed effect
  TestRow randomSites;  ///< from the model with site as a random effect
};

/// One cohort's answers, site by site: in two stages (the difference at each site, then pooled),
/// and by two mixed models of all single answers, which add these terms to the model of
/// compareWithin():
///
///     + site                                  (fixed: sites differ in level)
///     + (1 | site) + (1 | site:method)        (random: they differ in level and in the effect)
struct SiteAnalysis {
  std::vector<SiteAnswers> answers;  ///< sorted by name
  std::vector<SiteComparison> rows;  ///< in the order of the pairs
  LinearMixedResult fixedSites;
  LinearMixedResult randomSites;
};

/// @param sites  the site of each participant of the table
/// @param level  of the intervals
/// @throws std::invalid_argument  for another number of sites, or a pair of methods that are not
///     there.
SiteAnalysis compareSites(
    const AnswerTable& table,
    std::span<const std::string> sites,
    std::span<const DeclaredPair> pairs,
    double level);

}  // namespace analysis
