#include "analysis/summary/flags.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "analysis/data/likert_counts.h"
#include "analysis/hypothesis_tests/attainable_p.h"
#include "analysis/summary/answer_checks.h"
#include "base/joined.h"

namespace analysis {
namespace {

using base::Message;

/// A message of kFlagMessages with its arguments.
template <typename... Arguments>
Message text(base::CheckedKey<kFlagMessages, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kFlagMessages>(key, std::forward<Arguments>(arguments)...);
}

/// The text "id.part" of kFlagMessages, which has no arguments.
Message partOf(std::string_view id, std::string_view part) {
  const auto key = std::string(id).append(".").append(part);
  return {*std::ranges::find(kFlagMessages, key, &base::MessageKind::key), {}};
}

/// Finds the flags of one cohort's answers; one function per kind of flag.
class FlagFinder {
 public:
  FlagFinder(const AnswerTable& table, const StudyFacts& facts) : table_(table), facts_(facts) {}

  std::vector<Flag> all() {
    if (!facts_.isDeclared) flagUndeclaredFamily();
    flagChanges("other_scale", facts_.otherScale);
    flagChanges("answered_otherwise", facts_.changes);
    if (table_.answers.empty()) return std::move(flags_);
    if (facts_.isPooled) flagPooling();
    flagStatements();
    flagOrder();
    flagScatter();
    flagSizes();
    flagMissingAnswers();
    flagTrials();
    return std::move(flags_);
  }

 private:
  void add(
      std::string_view id,
      std::vector<Message> what,
      std::vector<Message> source,
      bool concernsPooledTests = false,
      bool concernsRendering = false) {
    flags_.push_back(
        {id,
         std::move(what),
         partOf(id, "why"),
         partOf(id, "remedy"),
         std::move(source),
         concernsPooledTests,
         concernsRendering});
  }

  void flagUndeclaredFamily() {
    add("family_not_declared",
        {text("family_not_declared")},
        {Message::verbatim("Wagenmakers et al. 2012")});
  }

  void flagChanges(std::string_view id, const std::vector<Message>& changes) {
    if (changes.empty()) return;
    std::vector<Message> what;
    for (const auto& change : changes) {
      if (!what.empty()) what.push_back(text("semicolon"));
      what.push_back(change);
    }
    what.push_back(text("full_stop"));
    add(id, std::move(what), {text("source.versions")});
  }

  void flagPooling() {
    const auto dependence = dependenceOf(table_);
    if (hasRepeatedAnswers()) {
      std::vector<Message> what{
          dependence.participants == 1 ? text(
                                             "pseudo_replication.one",
                                             dependence.answers,
                                             dependence.participants,
                                             dependence.answers)
                                       : text(
                                             "pseudo_replication",
                                             dependence.answers,
                                             dependence.participants,
                                             dependence.answers)};
      if (dependence.designEffect) {
        what.push_back(text(
            "pseudo_replication.design_effect",
            *dependence.intraclassCorrelation,
            *dependence.designEffect));
      }
      what.push_back(text("full_stop"));
      add("pseudo_replication",
          std::move(what),
          {Message::verbatim("Hurlbert 1984"), Message::verbatim("Lazic et al. 2020")},
          true);
    }
    const auto methods = table_.methods.size();
    std::vector<std::size_t> every(methods);
    std::iota(every.begin(), every.end(), std::size_t{0});
    if (methods > 1 && !completeCaseMeans(table_, every).participants.empty()) {
      add("paired_data_unpaired_test",
          {text("paired_data_unpaired_test")},
          {Message::verbatim("Student 1908"), text("source.published_analysis", 2)},
          true);
    }
  }

  /// Whether any participant answered more than once about a method.
  bool hasRepeatedAnswers() const {
    std::set<std::pair<std::size_t, std::size_t>> seen;
    return std::ranges::any_of(table_.answers, [&](const auto& answer) {
      return !seen.insert({answer.participant, answer.method}).second;
    });
  }

  void flagStatements() {
    if (!facts_.hasSameStatements) {
      add("items_not_common_to_methods",
          {text("items_not_common_to_methods")},
          {text("source.published_analysis", 3)});
    }
    std::vector<std::string> relative;
    for (const std::size_t statement : facts_.comparativeStatements) {
      relative.push_back(table_.statements[statement]);
    }
    if (!relative.empty()) {
      add("relative_item_without_referent",
          {text("relative_item_without_referent", base::joined(relative, ", "))},
          {text("source.published_analysis", 4)});
    }
  }

  /// Counts what was felt: an answer that is missing does not make an order unbalanced.
  void flagOrder() {
    std::map<std::pair<std::size_t, int>, std::set<std::pair<std::size_t, std::size_t>>> people;
    std::set<std::size_t> rounds;
    int positions = 0;
    for (const auto& [participant, method, round, position] : facts_.felt) {
      // Over all rounds: a round and its mirror image balance positions.
      people[{method, position}].insert({round, participant});
      rounds.insert(round);
      positions = std::max(positions, position);
    }
    if (rounds.empty() || table_.methods.size() < 2) return;
    std::size_t least = SIZE_MAX;
    std::size_t most = 0;
    for (std::size_t method = 0; method < table_.methods.size(); ++method) {
      for (int position = 1; position <= positions; ++position) {
        const std::size_t times = people[{method, position}].size();
        least = std::min(least, times);
        most = std::max(most, times);
      }
    }
    // Each round is balanced separately, and its counts may differ by one. Of many people a little
    // more does not matter.
    constexpr std::size_t kMattersFrom = 20;  // a twentieth
    if (most - least <= std::max(rounds.size(), most / kMattersFrom)) return;
    add("order_not_counterbalanced",
        {text("order_not_counterbalanced", least, most)},
        {Message::verbatim("Williams 1949")});
  }

  void flagScatter() {
    std::vector<Message> camps{text("bimodal")};
    std::vector<std::string> constant;
    for (std::size_t method = 0; method < table_.methods.size(); ++method) {
      const auto answers = table_.sampleOf(method);
      if (answers.points() && exceedsUnimodalVariance(*answers.points()).value_or(false)) {
        const auto& counts = *answers.points();
        const double most =
            largestUnimodalVariance(counts.lowest(), counts.highest(), *counts.mean()) *
            static_cast<double>(counts.total()) / static_cast<double>(counts.total() - 1);
        if (camps.size() > 1) camps.push_back(text("comma"));
        camps.push_back(text("bimodal.method", titleOf(method), *counts.variance(), most));
      }
      if (answers.total() > 1 && answers.variance() == 0.0) {
        constant.push_back(titleOf(method));
      }
    }
    if (camps.size() > 1) {
      camps.push_back(text("full_stop"));
      add("bimodal", std::move(camps), {Message::verbatim("Liddell & Kruschke 2018")});
    }
    if (!constant.empty()) {
      add("constant_group",
          {text("constant_group", base::joined(constant, ", "))},
          {text("source.not_defined")});
    }
  }

  /// The largest number of participants, over all pairs, who judged both methods of the pair.
  std::size_t mostCompletePairs() const {
    std::size_t most = 0;
    for (std::size_t second = 1; second < table_.methods.size(); ++second) {
      for (std::size_t first = 0; first < second; ++first) {
        most = std::max(most, completeCaseMeans(table_, {first, second}).participants.size());
      }
    }
    return most;
  }

  void flagSizes() {
    const std::size_t pairs = mostCompletePairs();
    const double attainable = smallestSignFlipP(pairs).p;
    const double perTest = facts_.threshold.value_or(
        facts_.alpha / static_cast<double>(std::max<std::size_t>(facts_.tests, 1)));
    if (attainable > perTest) {
      add("n_below_minimum_for_alpha",
          {pairs == 1
               ? text("n_below_minimum_for_alpha.one", pairs, attainable, facts_.tests, perTest)
               : text("n_below_minimum_for_alpha", pairs, attainable, facts_.tests, perTest)},
          {Message::verbatim("Fisher 1935"), text("source.planning")});
    }
    const double rounded = std::round(perTest * 1000.0) / 1000.0;
    const bool isDecidedByRounding = std::ranges::any_of(
        facts_.pValues, [&](double p) { return (p <= perTest) != (p <= rounded); });
    if (isDecidedByRounding) {
      add("alpha_rounded", {text("alpha_rounded", perTest, rounded)}, {text("source.punch_paper")});
    }
  }

  void flagMissingAnswers() {
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
    add("missing_cells",
        {answers == 1 ? text("missing_cells.one", answers, expected, cells, given.size())
                      : text("missing_cells", answers, expected, cells, given.size())},
        {text("source.not_defined")});
  }

  void flagTrials() {
    if (facts_.lateTrials > 0) {
      add("late_ticks",
          {text("late_ticks", facts_.lateTrials, facts_.trials)},
          {text("source.trial_verdicts")},
          false,
          true);
    }
    if (!facts_.saturated.empty()) {
      add("saturated", saturatedInWords(), {text("source.trial_verdicts")}, false, true);
    }
  }

  std::vector<Message> saturatedInWords() const {
    std::size_t trials = 0;
    for (const auto& method : facts_.saturated) trials += method.saturated;
    std::vector<Message> what{text("saturated", trials, facts_.trials)};
    for (const auto& method : facts_.saturated) {
      what.push_back(what.size() == 1 ? text("colon") : text("comma"));
      what.push_back(text("saturated.method", method.title, method.saturated, method.trials));
    }
    what.push_back(text("full_stop"));
    return what;
  }

  const std::string& titleOf(std::size_t method) const {
    return facts_.methodTitles.empty() ? table_.methods[method] : facts_.methodTitles[method];
  }

  const AnswerTable& table_;
  const StudyFacts& facts_;
  std::vector<Flag> flags_;
};

}  // namespace

Message Flag::title() const {
  return partOf(id, "title");
}

std::string Flag::inEnglish() const {
  std::string text;
  for (const auto& part : what) text += base::describe(part);
  return text;
}

std::vector<Flag> flagsOf(const AnswerTable& table, const StudyFacts& facts) {
  return FlagFinder(table, facts).all();
}

}  // namespace analysis
