#include "study/results.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

#include "questionnaires/answer.h"
#include "study/storage/records.h"

namespace study {
namespace {

using questionnaires::ItemType;
using storage::AnswerRecord;
using storage::Records;
using storage::SessionRecord;

/// All that results are computed from, read once.
class Computation {
 public:
  Computation(Study& study, RunMode mode)
      : mode_(mode), loaded_(study.protocol()), records_(study.database()) {
    for (auto& session : records_.sessions()) {
      if (session.runMode == nameOf(mode)) sessions_.emplace(session.id, session);
    }
    for (auto& answer : records_.answers()) {
      const auto session = sessions_.find(answer.step.visit.session);
      const bool counts = session != sessions_.end() && session->second.status == "completed" &&
                          answer.step.visitStatus == "finished";
      if (counts) answers_.push_back(std::move(answer));
    }
    allocation_ = records_.allocation();
  }

  Results all() {
    Results results{.runMode = mode_};
    for (const auto& cohort : loaded_.protocol.cohorts) results.flow.push_back(flowOf(cohort.id));
    for (const auto& family : loaded_.protocol.analysis.families) {
      results.families.push_back(resultOf(family));
    }
    for (const auto& phase : loaded_.protocol.phases) {
      if (phase.type != protocols::PhaseType::Preference) continue;
      for (const auto& cohort : loaded_.protocol.cohorts) {
        results.votes.push_back(votesOf(phase, cohort.id));
      }
    }
    return results;
  }

 private:
  CohortFlow flowOf(const std::string& cohort) const {
    CohortFlow flow{.cohort = cohort};
    for (const auto& [id, session] : sessions_) {
      if (session.cohort != cohort) continue;
      ++flow.enrolled;
      if (session.status == "completed") ++flow.completed;
      if (session.status == "in_progress") ++flow.inProgress;
      if (session.status == "declined") ++flow.declined;
      if (session.status == "withdrawn") ++flow.withdrawn;
      if (session.status == "rejected") ++flow.rejected;
      if (session.status == "aborted_hardware") ++flow.abortedHardware;
    }
    return flow;
  }

  /// The conditions that a family compares, in the protocol's order.
  std::vector<std::string> conditionsOf(const protocols::Family& family) const {
    std::set<std::string> named;
    for (const auto& pair : family.comparisons) named.insert({pair.first, pair.second});
    std::vector<std::string> conditions;
    for (const auto& condition : loaded_.protocol.conditions) {
      if (named.count(condition.id) > 0) conditions.push_back(condition.id);
    }
    return conditions;
  }

  const std::string& cohortOf(const AnswerRecord& answer) const {
    return sessions_.at(answer.step.visit.session).cohort;
  }

  FamilyResult resultOf(const protocols::Family& family) const {
    FamilyResult result{.family = family, .cohorts = {}};
    std::vector<analysis::DeclaredPair> pairs;
    for (const auto& pair : family.comparisons) pairs.push_back({pair.first, pair.second});
    for (const auto& cohort : loaded_.protocol.cohorts) {
      CohortResult part{.cohort = cohort.id, .conditions = {}, .comparisons = {}};
      for (const auto& condition : conditionsOf(family)) {
        part.conditions.push_back({condition, countsOf(family, cohort.id, condition)});
      }
      part.comparisons = analysis::comparePairwise(part.conditions, pairs, family.alpha);
      if (family.correction == protocols::CorrectionType::None) withoutCorrection(part, family);
      result.cohorts.push_back(std::move(part));
    }
    return result;
  }

  /// Every comparison stands for itself.
  static void withoutCorrection(CohortResult& part, const protocols::Family& family) {
    part.comparisons.alphaPerTest = family.alpha;
    for (auto& row : part.comparisons.rows) {
      row.adjustedP = row.welch.p;
      row.adjustedInterval = row.interval;
      if (row.welch.p) row.isSignificant = *row.welch.p <= family.alpha;
    }
  }

  bool isOf(const protocols::Family& family, const AnswerRecord& answer) const {
    const auto& blocks = family.blocks;
    return answer.step.kind == "questionnaire" && answer.step.instrument == family.instrument &&
           (blocks.empty() ||
            std::find(blocks.begin(), blocks.end(), answer.step.phase) != blocks.end());
  }

  analysis::LikertCounts countsOf(
      const protocols::Family& family,
      const std::string& cohort,
      const std::string& condition) const {
    const auto& instrument = *loaded_.instrument(family.instrument);
    const auto likert =
        std::find_if(instrument.items.begin(), instrument.items.end(), [](const auto& item) {
          return item.type == ItemType::Likert;
        });
    analysis::LikertCounts counts(likert->scale.lowest, likert->scale.highest());
    for (const auto& answer : answers_) {
      if (!isOf(family, answer) || answer.step.condition != condition) continue;
      if (cohortOf(answer) != cohort) continue;
      const auto* item = instrument.item(answer.answer.item);
      const auto* point = std::get_if<std::int64_t>(&answer.answer.response);
      if (item == nullptr || item->type != ItemType::Likert || point == nullptr) continue;
      counts.add(static_cast<int>(questionnaires::keyed(*item, *point)));
    }
    return counts;
  }

  /// What an alternative was in a session; empty where it was nothing.
  std::string feltAs(SessionId session, const std::string& block, const std::string& label) const {
    int number = 0;
    std::from_chars(label.data(), label.data() + label.size(), number);
    const auto felt = allocation_.find({session, block, number});
    return felt == allocation_.end() ? std::string() : felt->second;
  }

  VoteResult votesOf(const protocols::Phase& phase, const std::string& cohort) const {
    const auto& block = loaded_.protocol.phase(phase.block)->trials;
    VoteResult result{
        .cohort = cohort,
        .phase = phase.id,
        .block = phase.block,
        .votes = analysis::VoteCounts(block.conditions)};
    const auto* instrument = loaded_.instrument(phase.instrument);
    for (const auto& answer : answers_) {
      if (answer.step.phase != phase.id || cohortOf(answer) != cohort) continue;
      const auto* item = instrument->item(answer.answer.item);
      const auto* label = std::get_if<std::string>(&answer.answer.response);
      const bool isVote = item != nullptr && label != nullptr &&
                          item->optionSource == questionnaires::OptionSource::Alternatives;
      if (!isVote) continue;
      const auto felt = feltAs(answer.step.visit.session, phase.block, *label);
      const auto& options = block.conditions;
      if (std::find(options.begin(), options.end(), felt) != options.end()) result.votes.add(felt);
    }
    return result;
  }

  RunMode mode_;
  const protocols::LoadedProtocol& loaded_;
  Records records_;
  std::map<SessionId, SessionRecord> sessions_;
  std::vector<AnswerRecord> answers_;
  std::map<Records::Alternative, std::string> allocation_;
};

}  // namespace

int Results::completed() const {
  int total = 0;
  for (const auto& cohort : flow) total += cohort.completed;
  return total;
}

Results computeResults(Study& study, RunMode mode) {
  return Computation(study, mode).all();
}

}  // namespace study
