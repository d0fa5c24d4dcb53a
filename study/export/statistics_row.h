#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/test_row.h"
#include "study/export/column.h"
#include "study/results/rendered_force_curves.h"
#include "study/results/results.h"

namespace study {

/// A row of the statistics table: the result of a test, a score or a check, with what it is about.
struct StatisticsRow {
  RunMode runMode = RunMode::Live;
  std::string cohort;
  std::string site;        ///< empty: all sites
  std::string cohort2;     ///< the second cohort of a comparison
  std::string family;      ///< id of the family; empty for results without a family
  std::string instrument;  ///< id
  std::string blocks;      ///< ids of phases whose answers are used, separated by spaces
  std::string items;       ///< ids of the items that a family compares, separated by spaces
  std::string score;       ///< id of the questionnaire's score
  std::string item;        ///< id
  std::string option;      ///< id of the option of a choice
  std::string occasion;    ///< "before", "after", "change"
  std::optional<double> acceptableFrom;
  std::optional<std::size_t> missing;  ///< number of forms without a score
  std::string group1;                  ///< condition code
  std::string group2;                  ///< condition code
  std::string groups;                  ///< groups of an overall test, separated by spaces
  std::string_view design;
  std::string_view unit;
  std::optional<std::size_t> tests;  ///< number of tests in the family, m
  bool isDeclared = false;           ///< whether the protocol declared the test in time
  std::string_view adjustment;       ///< name of the correction for the size of the family
  std::optional<double> alpha;
  std::optional<double> alphaPerTest;
  std::optional<double> level;  ///< confidence level of the intervals
  std::string flags;            ///< names of flags, separated by spaces
  analysis::TestRow test;       ///< the result
};

Columns<StatisticsRow> statisticsColumns();

/// A row with the values that all rows of a family and cohort have in common: cohort, instrument,
/// blocks, items, and significance level.
StatisticsRow familyRow(const FamilyResult& result, const std::string& cohort);

/// Rows on a cohort as a whole: overall tests, effect of the position, reliability, and
/// distribution.
/// @param family  the result of familyRow()
/// @param codes  condition codes by condition id
std::vector<StatisticsRow> overallRows(
    const StatisticsRow& family,
    const CohortResult& cohort,
    const std::map<std::string, std::string>& codes);

/// Rows on the sites of a cohort with several sites: for each site the answers to each condition
/// and the difference of each comparison, and each comparison pooled over sites.
/// @param family  the result of familyRow()
std::vector<StatisticsRow> siteRows(
    const StatisticsRow& family,
    const CohortResult& cohort,
    const std::map<std::string, std::string>& codes);

/// Rows on questionnaires: one for each score, and one for each item with a threshold.
std::vector<StatisticsRow> instrumentRows(
    const std::vector<InstrumentSummary>& instruments,
    const std::map<std::string, std::string>& codes);

/// Descriptive rows on each answered item: one for a numeric item, and one for each option of a
/// choice. Numbers about the person are left out unless @p isExact is true.
std::vector<StatisticsRow> itemRows(
    const std::vector<ItemSummary>& items,
    const protocols::LoadedProtocol& loaded,
    const std::map<std::string, std::string>& codes,
    bool isExact);

/// The rendered forces of trials, or the reason why they cannot be read. A damaged trace must not
/// prevent the export of answers.
struct RenderedForceResult {
  std::vector<RenderedForceCurve> curves;
  base::Message reason;  ///< what is wrong with the traces, so that there are no curves; empty if
                         ///< they were read
};

RenderedForceResult renderedForceResult(Study& study, RunMode mode);

/// The differences of rendered forces: one row for each pair of conditions, over all cohorts; a
/// single row with the reason if traces cannot be read.
std::vector<StatisticsRow> renderedForceRows(
    const RenderedForceResult& forces, const std::map<std::string, std::string>& codes);

}  // namespace study
