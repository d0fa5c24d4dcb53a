#include "analysis/summary/flags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "analysis/published/unimodal_bound.h"
#include "analysis/summary/answer_dependence.h"
#include "analysis/tests/attainable_p.h"

namespace analysis {
namespace {

/// With so many decimals.
std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::string asText(std::string text) {
  return text;
}
std::string asText(std::size_t count) {
  return std::to_string(count);
}

template <typename... Args>
Clause clause(std::string_view pattern, Args... arguments) {
  return {pattern, {asText(arguments)...}};
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// One cohort's answers, and what there is to say about them.
class Examination {
 public:
  Examination(const AnswerTable& table, const StudyFacts& facts) : table_(table), facts_(facts) {}

  std::vector<Flag> all() {
    if (!facts_.isDeclared) undeclared();
    if (table_.answers.empty()) return std::move(flags_);
    if (facts_.isPooled) pooled();
    statements();
    order();
    scatter();
    sizes();
    missing();
    trials();
    return std::move(flags_);
  }

 private:
  void undeclared() {
    flags_.push_back(
        {"family_not_declared",
         {clause("The protocol did not declare these comparisons as they are before the first "
                 "participant.")},
         "Which tests are run, and how many, may then depend on what the data look like; p values "
         "lose their meaning.",
         "Declare the family in the protocol's analysis plan before the first participant; report "
         "what is here as exploratory.",
         "Wagenmakers et al. 2012, 10.1177/1745691612463078"});
  }

  void pooled() {
    const auto dependence = dependenceOf(table_);
    if (hasSeveralInACell()) {
      std::vector<Clause> what{clause(
          dependence.participants == 1 ? "{} answers of {} person are treated as {} independent "
                                         "observations in the pooled tests"
                                       : "{} answers of {} people are treated as {} independent "
                                         "observations in the pooled tests",
          dependence.answers,
          dependence.participants,
          dependence.answers)};
      if (dependence.designEffect) {
        what.push_back(clause(
            "; answers of one person correlate with ICC = {}, design effect {}",
            fixed(*dependence.intraclassCorrelation, 2),
            fixed(*dependence.designEffect, 2)));
      }
      what.push_back(clause("."));
      flags_.push_back(
          {"pseudo_replication",
           std::move(what),
           "Answers of one person go together. Where people differ in their taste for a method, "
           "pooled tests find differences that are not there (up to 35 % instead of 5 % in "
           "simulations); where they only differ in leniency, pooled tests overlook real ones.",
           "Read the tests on participants' means, or the mixed model.",
           "Hurlbert 1984, 10.2307/1942661; Lazic et al. 2020, PMC7012913"});
    }
    const auto methods = table_.methods.size();
    std::vector<std::size_t> every(methods);
    for (std::size_t i = 0; i < methods; ++i) every[i] = i;
    if (methods > 1 && !completeMeans(table_, every).participants.empty()) {
      flags_.push_back(
          {"paired_data_unpaired_test",
           {clause(
               "The same people judged every method, and the pooled tests take them for different "
               "people.")},
           "What a person always says more or less of goes into the scatter instead of cancelling.",
           "Read the paired tests.",
           "Student 1908; docs/statistics.md, the published analysis, point 2"});
    }
  }

  /// Whether somebody answered more than once about a method.
  bool hasSeveralInACell() const {
    std::set<std::pair<std::size_t, std::size_t>> seen;
    return std::any_of(table_.answers.begin(), table_.answers.end(), [&](const auto& answer) {
      return !seen.insert({answer.participant, answer.method}).second;
    });
  }

  void statements() {
    std::map<std::size_t, std::set<std::size_t>> asked;
    for (const auto& answer : table_.answers) asked[answer.method].insert(answer.statement);
    const auto& first = asked.begin()->second;
    const bool areCommon =
        std::all_of(asked.begin(), asked.end(), [&](const auto& of) { return of.second == first; });
    if (!areCommon) {
      flags_.push_back(
          {"items_not_common_to_methods",
           {clause("The methods were judged by different statements.")},
           "A difference may lie in the wording as well as in the method.",
           "Ask the same statements about every method.",
           "docs/statistics.md, the published analysis, point 3"});
    }
    std::vector<std::string> relative;
    for (const std::size_t statement : facts_.relativeStatements) {
      relative.push_back(table_.statements[statement]);
    }
    if (!relative.empty()) {
      flags_.push_back(
          {"relative_item_without_referent",
           {clause("Statements compare with what was felt before: {}.", listed(relative))},
           "With another order they compare with another method, and the first method with none.",
           "Ask about each method by itself, or fix the order and say so.",
           "docs/statistics.md, the published analysis, point 4"});
    }
  }

  void order() {
    std::map<std::size_t, std::map<std::pair<std::size_t, int>, std::set<std::size_t>>> seen;
    for (const auto& answer : table_.answers) {
      seen[answer.round][{answer.method, answer.position}].insert(answer.participant);
    }
    // All rounds together: a round and its mirror image balance positions.
    std::map<std::pair<std::size_t, int>, std::size_t> felt;
    int positions = 0;
    for (const auto& [round, cells] : seen) {
      for (const auto& [cell, people] : cells) {
        felt[cell] += people.size();
        positions = std::max(positions, cell.second);
      }
    }
    std::size_t least = SIZE_MAX;
    std::size_t most = 0;
    for (std::size_t method = 0; method < table_.methods.size(); ++method) {
      for (int position = 1; position <= positions; ++position) {
        const auto cell = felt.find({method, position});
        const std::size_t times = cell == felt.end() ? 0 : cell->second;
        least = std::min(least, times);
        most = std::max(most, times);
      }
    }
    // Rounds are balanced each by itself, and each may be off by one.
    if (table_.methods.size() < 2 || most - least <= seen.size()) return;
    flags_.push_back(
        {"order_not_counterbalanced",
         {clause("How often a method came at a position goes from {} to {}.", least, most)},
         "Practice, fatigue and contrast with what came before then count for one method and "
         "against another.",
         "Let the orders be balanced (latinSquare, balancedLatinSquare, complete), and plan N "
         "as "
         "a multiple of their number.",
         "Williams 1949, 10.1071/CH9490149"});
  }

  void scatter() {
    std::vector<Clause> camps{clause("Answers fall into two camps: ")};
    std::vector<std::string> constant;
    for (std::size_t method = 0; method < table_.methods.size(); ++method) {
      const auto counts = table_.countsOf(method);
      if (isBeyondUnimodal(counts).value_or(false)) {
        const double most =
            largestUnimodalVariance(counts.lowest(), counts.highest(), *counts.mean()) *
            static_cast<double>(counts.total()) / static_cast<double>(counts.total() - 1);
        if (camps.size() > 1) camps.push_back(clause(", "));
        camps.push_back(clause(
            "{} (variance {}, at most {} with one peak)",
            titleOf(method),
            fixed(*counts.variance(), 2),
            fixed(most, 2)));
      }
      if (counts.total() > 1 && counts.variance() == 0.0) {
        constant.push_back(titleOf(method));
      }
    }
    if (camps.size() > 1) {
      camps.push_back(clause("."));
      flags_.push_back(
          {"bimodal",
           std::move(camps),
           "The mean then says what nobody thinks.",
           "Look at the distribution, and at who is in which camp; report counts beside means.",
           "Dharmadhikari & Joag-Dev 1988; Liddell & Kruschke 2018, 10.1016/j.jesp.2018.08.009"});
    }
    if (!constant.empty()) {
      flags_.push_back(
          {"constant_group",
           {clause("Everybody gave the same answer to everything about: {}.", listed(constant))},
           "Tests that divide by the scatter are not defined, or see certainty where there are few "
           "answers.",
           "Report the counts; use exact tests of the paired differences.",
           "docs/statistics.md, what is not defined"});
    }
  }

  /// How many people judged both methods of a pair, in the pair with the most of them.
  std::size_t mostCompletePairs() const {
    std::size_t most = 0;
    for (std::size_t second = 1; second < table_.methods.size(); ++second) {
      for (std::size_t first = 0; first < second; ++first) {
        most = std::max(most, completeMeans(table_, {first, second}).participants.size());
      }
    }
    return most;
  }

  void sizes() {
    const std::size_t pairs = mostCompletePairs();
    const double attainable = smallestSignFlipP(pairs).p;
    const double perTest = facts_.threshold.value_or(
        facts_.alpha / static_cast<double>(std::max<std::size_t>(facts_.tests, 1)));
    if (attainable > perTest) {
      flags_.push_back(
          {"n_below_minimum_for_alpha",
           {clause(
               pairs == 1 ? "With {} person who judged both methods of a pair no exact paired test "
                            "can give less than p = {}; the family of {} asks for {}."
                          : "With {} people who judged both methods of a pair no exact paired test "
                            "can give less than p = {}; the family of {} asks for {}.",
               pairs,
               fixed(attainable, 4),
               facts_.tests,
               fixed(perTest, 4))},
           "Such a test cannot be significant, whatever the answers are.",
           "More participants (palpate plan says how many), fewer comparisons, or an overall test "
           "(Friedman) first.",
           "Fisher 1935; docs/statistics.md, planning"});
    }
    const double rounded = std::round(perTest * 1000.0) / 1000.0;
    const bool isDecidedByRounding =
        std::any_of(facts_.pValues.begin(), facts_.pValues.end(), [&](double p) {
          return (p <= perTest) != (p <= rounded);
        });
    if (isDecidedByRounding) {
      flags_.push_back(
          {"alpha_rounded",
           {clause(
               "A p value lies between alpha per test {} and its rounded form {}.",
               fixed(perTest, 6),
               fixed(rounded, 3))},
           "Rounding the threshold decides about significance.",
           "Compare with the unrounded threshold, as is done here.",
           "The punch paper's 0.017 for 0.05/3"});
    }
  }

  void missing() {
    if (facts_.expected.empty()) return;
    const auto methods = table_.methods.size();
    std::vector<std::size_t> given(table_.participants.size() * methods);
    for (const auto& answer : table_.answers) ++given[answer.participant * methods + answer.method];
    std::size_t expected = 0;
    std::size_t cells = 0;
    std::size_t answers = 0;
    for (std::size_t i = 0; i < given.size(); ++i) {
      const std::size_t wanted = facts_.expected[i % methods];
      expected += wanted;
      if (given[i] >= wanted) continue;
      ++cells;
      answers += wanted - given[i];
    }
    if (cells == 0) return;
    flags_.push_back(
        {"missing_cells",
         {clause(
             answers == 1
                 ? "{} of {} answers is missing, in {} of {} pairs of participant and method."
                 : "{} of {} answers are missing, in {} of {} pairs of participant and method.",
             answers,
             expected,
             cells,
             given.size())},
         "Means of fewer answers scatter more, and who leaves out what is rarely chance.",
         "Paired tests leave out participants who lack a method altogether; the mixed model uses "
         "all that there is.",
         "Little & Rubin 2002"});
  }

  void trials() {
    if (facts_.lateTrials > 0) {
      flags_.push_back(
          {"late_ticks",
           {clause(
               "In {} of {} trials the force loop was late more often than is borne.",
               facts_.lateTrials,
               facts_.trials)},
           "People may have felt the computer instead of the method.",
           "Look at the trials' verdicts; repeat the analysis without them.",
           "Trial verdicts, docs/running-a-study.md"});
    }
    if (facts_.saturatedTrials > 0) {
      flags_.push_back(
          {"saturated",
           {clause(
               "In {} of {} trials the scene asked for more force than the device may give.",
               facts_.saturatedTrials,
               facts_.trials)},
           "Where forces are cut off, methods feel more alike than they are.",
           "Compare the felt curves; scale the force alike for every condition.",
           "Trial verdicts, docs/running-a-study.md"});
    }
  }

  const std::string& titleOf(std::size_t method) const {
    return facts_.methodTitles.empty() ? table_.methods[method] : facts_.methodTitles[method];
  }

  const AnswerTable& table_;
  const StudyFacts& facts_;
  std::vector<Flag> flags_;
};

}  // namespace

std::string filled(std::string_view pattern, const std::vector<std::string>& arguments) {
  std::string text;
  auto next = arguments.begin();
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    if (pattern.substr(i, 2) != "{}" || next == arguments.end()) {
      text += pattern[i];
      continue;
    }
    text += *next++;
    ++i;
  }
  return text;
}

std::string Flag::inEnglish() const {
  std::string text;
  for (const auto& [pattern, arguments] : what) text += filled(pattern, arguments);
  return text;
}

std::vector<Flag> flagsOf(const AnswerTable& table, const StudyFacts& facts) {
  return Examination(table, facts).all();
}

}  // namespace analysis
