#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/test_row.h"
#include "study/export/column.h"
#include "study/results/felt_curves.h"
#include "study/results/results.h"

namespace study {

/// A row of the statistics table: the result of a test, a score or a check, and its subject.
struct StatisticsRow {
  RunMode runMode = RunMode::Live;
  std::string cohort;
  std::string site;        ///< empty: all sites
  std::string cohort2;     ///< the second cohort of a comparison
  std::string family;      ///< its id; empty: none
  std::string instrument;  ///< its id
  std::string blocks;      ///< phases whose answers count, separated by spaces
  std::string score;       ///< of a questionnaire
  std::string item;        ///< its id
  std::string option;      ///< of a choice: its id
  std::string occasion;    ///< "before", "after", "change"
  std::optional<double> acceptableFrom;
  std::optional<std::size_t> missing;  ///< forms without a score
  std::string group1;                  ///< condition codes
  std::string group2;
  std::string groups;  ///< groups of an overall test, separated by spaces
  std::string_view design;
  std::string_view unit;
  std::optional<std::size_t> tests;  ///< m, in the family
  bool isDeclared = false;
  std::string_view adjustment;  ///< for the size of the family
  std::optional<double> alpha;
  std::optional<double> alphaPerTest;
  std::optional<double> level;  ///< confidence of the intervals
  std::string flags;            ///< separated by spaces
  analysis::TestRow test;       ///< the result
};

Columns<StatisticsRow> statisticsColumns();

/// A row with the values that all rows of a family and cohort share: cohort, instrument, blocks,
/// and level of significance.
StatisticsRow familyRow(
    const protocols::Family& family,
    const protocols::Protocol& protocol,
    const std::string& cohort);

/// Rows on a cohort as a whole: overall tests, effect of the position, reliability and
/// distribution.
/// @param family  by familyRow()
/// @param codes  of conditions
std::vector<StatisticsRow> overallRows(
    const StatisticsRow& family,
    const CohortResult& cohort,
    const std::map<std::string, std::string>& codes);

/// Rows on the sites of a cohort, if there are several: the answers to each condition and the
/// difference of each comparison at each site, and each comparison pooled over sites.
/// @param family  by familyRow()
std::vector<StatisticsRow> siteRows(
    const StatisticsRow& family,
    const CohortResult& cohort,
    const std::map<std::string, std::string>& codes);

/// Rows on questionnaires: one for each score, and one for each item with a threshold.
std::vector<StatisticsRow> instrumentRows(
    const std::vector<InstrumentSummary>& instruments,
    const std::map<std::string, std::string>& codes);

/// Descriptive rows on each answered item: one for each numeric item, and one for each option of a
/// choice. Numbers about the person are left out unless @p isExact.
std::vector<StatisticsRow> itemRows(
    const std::vector<ItemSummary>& items,
    const protocols::LoadedProtocol& loaded,
    const std::map<std::string, std::string>& codes,
    bool isExact);

/// The forces of trials, or why they cannot be read: a damaged trace must not prevent the export of
/// answers.
struct FeltResult {
  std::vector<FeltCurve> curves;
  base::Message reason;  ///< empty, or what is wrong with the traces; then there are no curves
};

FeltResult feltResult(Study& study, RunMode mode);

/// The differences of rendered forces: a row for each pair of conditions, over all cohorts; a
/// single row with the reason if traces cannot be read.
std::vector<StatisticsRow> feltRows(
    const FeltResult& felt, const std::map<std::string, std::string>& codes);

}  // namespace study
