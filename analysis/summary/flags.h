#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/data/answer_table.h"

namespace analysis {

/// Part of a sentence, so that it can be said in other languages.
struct Clause {
  std::string_view pattern;            ///< in English, with {} where something is put in
  std::vector<std::string> arguments;  ///< one for each
};

/// A pattern, in whichever language, with its arguments put in.
std::string filled(std::string_view pattern, const std::vector<std::string>& arguments);

/// What somebody who reads a result has to know about it.
struct Flag {
  std::string_view id;       ///< "pseudo_replication": as tables and exports name it
  std::vector<Clause> what;  ///< what was found, with its numbers
  std::string_view why;      ///< why it matters
  std::string_view remedy;   ///< what to do
  std::string_view source;   ///< who says so

  /// What was found.
  std::string inEnglish() const;
};

/// What an answer table does not know about the study that it comes from.
struct StudyFacts {
  bool isPooled = true;  ///< answers are tested as if independent in unpaired tests, too
  std::vector<std::string> methodTitles;  ///< for people; the table's names where there are none
  bool isDeclared = true;                 ///< by the protocol, before there were data
  double alpha = 0.05;                    ///< of the family
  std::optional<double> threshold;  ///< for the smallest p of the family; alpha / tests if not said
  std::size_t tests = 1;            ///< of the family
  std::vector<std::size_t> relativeStatements;  ///< places; they compare with what was felt before
  std::vector<double> pValues;                  ///< of the family's tests, unrounded
  std::vector<std::size_t> expected;  ///< answers of a participant, by method; empty: not known
  std::size_t trials = 0;
  std::size_t lateTrials = 0;       ///< whose loop was late more often than the protocol bears
  std::size_t saturatedTrials = 0;  ///< whose scene asked for more than the device may give
};

/// Everything that is to be said about the answers of one cohort, the weightiest first
/// (docs/statistics.md, "What is to be said against the published analysis").
std::vector<Flag> flagsOf(const AnswerTable& table, const StudyFacts& facts);

}  // namespace analysis
