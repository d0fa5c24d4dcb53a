#include "study/results/results.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "analysis/data/vote_shares.h"
#include "analysis/hypothesis_tests/attainable_p.h"
#include "analysis/numerics/exact_arithmetic.h"
#include "analysis/registry/registry.h"
#include "base/search.h"
#include "study/model/trial_record.h"
#include "study/results/answer_tables.h"
#include "study/results/pooled_results.h"
#include "study/results/protocol_versions.h"
#include "study/session/analysis_plan_history.h"
#include "study/storage/records.h"

namespace study {
namespace {

using storage::AnswerRecord;
using storage::Records;
using storage::SessionRecord;

/// Reads all data of the results once, and computes them.
class Computation {
 public:
  Computation(Study& study, RunMode mode, PairOrder order)
      : mode_(mode),
        order_(order),
        loaded_(study.protocol()),
        versions_(study),
        records_(study.database()),
        history_(analysisPlanHistory(study)) {
    for (auto& session : records_.sessions()) {
      if (session.runMode != mode) continue;
      sites_.insert(session.site);
      siteOf_.emplace(session.participant, session.site);
      sessions_.emplace(session.id, session);
    }
    for (auto& answer : records_.answers()) {
      const auto session = sessions_.find(answer.step.visit.session);
      const bool counts =
          session != sessions_.end() && session->second.isCompleted() && answer.step.isFinished() &&
          versions_.isPooled(session->second.protocol, answer.step.instrument, answer.answer.item);
      if (counts) answers_.push_back(std::move(answer));
    }
    for (auto& trial : records_.trials()) {
      const auto session = sessions_.find(trial.step.visit.session);
      const bool counts = session != sessions_.end() && session->second.isCompleted() &&
                          trial.step.isFinished() && !trial.step.isOptionalRepetition();
      if (counts) trials_.push_back(std::move(trial));
    }
    allocation_ = records_.allocation();
    unfinishedTrials_ = records_.unfinishedTrials();
  }

  Results all() {
    Results results{.runMode = mode_};
    for (const auto& cohort : loaded_.protocol.cohorts) results.flow.push_back(flowOf(cohort.id));
    if (sites_.size() > 1) results.siteFlow = flowOfSites();
    for (const auto& family : loaded_.protocol.analysis.families) {
      results.families.push_back(resultOf(family));
    }
    for (const auto& phase : loaded_.protocol.phases) {
      if (phase.type != protocols::PhaseType::Preference) continue;
      for (const auto& cohort : loaded_.protocol.cohorts) {
        results.votes.push_back(votesOf(phase, cohort.id));
        if (sites_.size() < 2) continue;
        for (const auto& site : sites_) {
          results.siteVotes.push_back(votesOf(phase, cohort.id, site));
        }
      }
    }
    results.instruments = summariseInstruments(versions_, sessions_, answers_);
    results.answers = summariseItems(loaded_, sessions_, answers_, allocation_);
    results.changes = changesSince(versions_, people({}), [&](const auto& change) {
      return concernsResults(loaded_.protocol, change);
    });
    return results;
  }

 private:
  CohortFlow flowOf(const std::string& cohort) const {
    CohortFlow flow{.cohort = cohort};
    for (const auto& [id, session] : sessions_) {
      if (session.cohort != cohort) continue;
      flow.add(session.state);
    }
    return flow;
  }

  std::vector<std::pair<std::string, CohortFlow>> flowOfSites() const {
    std::map<std::string, CohortFlow> flows;
    for (const auto& [id, session] : sessions_) flows[session.site].add(session.state);
    return {flows.begin(), flows.end()};
  }

  std::vector<std::string> sitesOf(const std::vector<std::string>& participants) const {
    std::vector<std::string> sites;
    for (const auto& participant : participants) sites.push_back(siteOf_.at(participant));
    return sites;
  }

  /// The participants of a cohort who completed, with their versions. @param cohort  empty: of all
  VersionsOfPeople people(const std::string& cohort) const {
    VersionsOfPeople all;
    for (const auto& [id, session] : sessions_) {
      const bool isMeant = cohort.empty() || session.cohort == cohort;
      if (isMeant && session.isCompleted()) all[session.participant].insert(session.protocol);
    }
    return all;
  }

  /// Whether a change concerns what a family compares.
  bool concerns(const protocols::Family& family, const protocols::ChangedMeaning& change) const {
    if (change.aspect == protocols::ChangedMeaning::Aspect::Order) return false;
    if (change.instrument.empty()) {
      return base::contains(conditionsOf(loaded_.protocol, family), change.id);
    }
    if (change.instrument != family.instrument) return false;
    const auto& instrument = *loaded_.instrument(family.instrument);
    const auto* score = instrument.score(family.score);
    if (score != nullptr) {
      return change.id == score->id || base::contains(score->items, change.id);
    }
    return base::withId(protocols::comparedItems(family, instrument.items), change.id) != nullptr;
  }

  /// Whether answers of a version to the family are left out.
  bool hasOtherScale(const protocols::Family& family, ProtocolId version) const {
    return std::ranges::any_of(versions_.changesSince(version), [&](const auto& change) {
      return change.aspect == protocols::ChangedMeaning::Aspect::Scale && concerns(family, change);
    });
  }

  const std::string& cohortOf(const AnswerRecord& answer) const {
    return sessions_.at(answer.step.visit.session).cohort;
  }

  FamilyResult resultOf(const protocols::Family& family) const {
    FamilyResult result{.family = family, .isDeclared = history_.isDeclared(family.id)};
    for (const auto& cohort : loaded_.protocol.cohorts) {
      CohortResult part{.cohort = cohort.id, .table = tableOf(family, cohort.id)};
      part.conditions = pooledCounts(part.table);
      result.cohorts.push_back(std::move(part));
    }
    if (order_ == PairOrder::HigherFirst) putHigherFirst(result);
    std::vector<analysis::DeclaredPair> pairs;
    for (const auto& pair : result.family.comparisons) pairs.push_back({pair.first, pair.second});
    for (auto& part : result.cohorts) {
      part.comparisons =
          comparePooled(result.family, part.conditions, part.table.participants.size());
      part.within = analysis::compareWithin(
          part.table,
          pairs,
          {.alpha = family.alpha,
           .adjustment = adjustmentOf(family.correction),
           .equivalenceBound = family.equivalenceBound});
      part.checks = analysis::scaleChecks(part.table);
      part.position = analysis::positionEffect(part.table);
      part.flags = flagsOf(family, part);
      if (sites_.size() > 1) {
        const auto sites = sitesOf(part.table.participants);
        part.sites = analysis::compareSites(part.table, sites, pairs, 1.0 - family.alpha);
      }
    }
    result.between = betweenCohorts(result);
    return result;
  }

  static void putHigherFirst(FamilyResult& result) {
    for (auto& pair : result.family.comparisons) {
      const auto first = meanOfAll(result, pair.first);
      const auto second = meanOfAll(result, pair.second);
      if (first && second && *first < *second) std::swap(pair.first, pair.second);
    }
  }

  static std::vector<double> meansOf(const analysis::AnswerTable& table, std::size_t method) {
    std::vector<double> means;
    for (const auto& row : table.participantMeans()) {
      if (row[method]) means.push_back(*row[method]);
    }
    return analysis::withoutRoundingNoise(means);
  }

  static std::vector<analysis::TestRow> testsOf(
      const analysis::NamedValues& first, const analysis::NamedValues& second) {
    std::vector<analysis::TestRow> rows;
    const analysis::TestData data{.values = {first, second}};
    for (const auto& test : analysis::statisticalTests()) {
      if (test.use != analysis::StudyUse::Cohorts) continue;
      for (auto& row : computeTest(test, data, {})) rows.push_back(std::move(row));
    }
    return rows;
  }

  /// Every pair of cohorts, in each condition.
  static std::vector<BetweenResult> betweenCohorts(const FamilyResult& family) {
    std::vector<BetweenResult> results;
    const auto& cohorts = family.cohorts;
    for (std::size_t i = 0; i < cohorts.size(); ++i) {
      for (std::size_t j = i + 1; j < cohorts.size(); ++j) {
        for (std::size_t method = 0; method < cohorts[i].table.methods.size(); ++method) {
          const auto first = meansOf(cohorts[i].table, method);
          const auto second = meansOf(cohorts[j].table, method);
          results.push_back(
              {.condition = cohorts[i].table.methods[method],
               .cohort1 = cohorts[i].cohort,
               .cohort2 = cohorts[j].cohort,
               .tests = testsOf(
                   {.name = cohorts[i].cohort, .values = first},
                   {.name = cohorts[j].cohort, .values = second})});
        }
      }
    }
    return results;
  }

  analysis::AnswerTable tableOf(const protocols::Family& family, const std::string& cohort) const {
    const auto versionsOf = this->people(cohort);
    std::vector<std::string> people;
    for (const auto& [id, session] : sessions_) {
      const bool counts = session.cohort == cohort && session.isCompleted();
      if (counts && !base::contains(people, session.participant)) {
        people.push_back(session.participant);
      }
    }
    std::vector<ParticipantAnswer> answers;
    for (const auto& answer : answers_) {
      if (!isOf(family, answer) || cohortOf(answer) != cohort) continue;
      const auto& session = sessions_.at(answer.step.visit.session);
      answers.push_back(
          {&session.participant,
           &answer,
           versions_.of(session.protocol).instrument(answer.step.instrument)});
    }
    auto table = answerTable(loaded_, family, people, answers);
    const auto isLeftOut = [&](const std::string& participant) {
      const auto place = std::ranges::find(table.participants, participant);
      const auto index = static_cast<std::size_t>(place - table.participants.begin());
      return std::ranges::any_of(
                 versionsOf.at(participant),
                 [&](auto version) { return hasOtherScale(family, version); }) &&
             std::ranges::none_of(
                 table.answers, [&](const auto& one) { return one.participant == index; });
    };
    if (std::erase_if(people, isLeftOut) > 0) table = answerTable(loaded_, family, people, answers);
    return table;
  }

  static std::vector<std::optional<double>> declaredPValues(
      const protocols::Family& family, const CohortResult& part) {
    std::vector<std::optional<double>> pValues;
    if (family.test == protocols::TestType::Welch) {
      for (const auto& row : part.comparisons.rows) pValues.push_back(row.p);
    }
    for (const auto& row : part.within.rows) {
      if (const auto* test = analysis::findTest(row.tests, idOf(family.test))) {
        pValues.push_back(test->p);
      }
    }
    return pValues;
  }

  /// What the cohort's participants felt of what the family compares.
  std::vector<analysis::Felt> feltIn(const CohortResult& part) const {
    const auto& table = part.table;
    const auto placeIn = [](const std::vector<std::string>& names, const std::string& name) {
      return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
    };
    std::vector<analysis::Felt> felt;
    for (const auto& trial : trials_) {
      const auto& session = sessions_.at(trial.step.visit.session);
      const analysis::Felt one{
          .participant = placeIn(table.participants, session.participant),
          .method = placeIn(table.methods, trial.step.condition),
          .round = placeIn(table.rounds, trial.step.phase),
          .position = trial.step.position};
      const bool isOfFamily = session.cohort == part.cohort &&
                              one.participant < table.participants.size() &&
                              one.method < table.methods.size() && one.round < table.rounds.size();
      if (isOfFamily) felt.push_back(one);
    }
    return felt;
  }

  std::vector<analysis::Flag> flagsOf(
      const protocols::Family& family, const CohortResult& part) const {
    analysis::StudyFacts facts{
        .isPooled = true,  // flagsByKind() removes flags on pooled tests unless they are shown
        .isDeclared = history_.isDeclared(family.id),
        .alpha = family.alpha,
        .threshold = analysis::levelsOf(
                         family.alpha,
                         std::max<std::size_t>(family.comparisons.size(), 1),
                         adjustmentOf(family.correction))
                         .mostLenient,
        .tests = family.comparisons.size(),
        .hasSameStatements = asksSameStatements(loaded_, family),
        .felt = feltIn(part),
        .comparativeStatements = comparativeStatements(loaded_, family, part.table),
        .expected = completeAnswerCounts(loaded_, family, part.table)};
    using Aspect = protocols::ChangedMeaning::Aspect;
    const auto everybody = people(part.cohort);
    facts.otherScale = changesSince(versions_, everybody, [&](const auto& change) {
      return change.aspect == Aspect::Scale && concerns(family, change);
    });
    facts.changes = changesSince(versions_, everybody, [&](const auto& change) {
      return change.aspect != Aspect::Scale && concerns(family, change);
    });
    for (const auto& method : part.table.methods) {
      facts.methodTitles.push_back(loaded_.protocol.condition(method)->title);
    }
    if (family.correction == protocols::CorrectionType::Bonferroni) {
      for (const auto& p : declaredPValues(family, part)) {
        if (p) facts.pValues.push_back(*p);
      }
    }
    std::map<std::string, analysis::SaturatedMethod> methods;
    for (const auto& trial : trials_) {
      if (sessions_.at(trial.step.visit.session).cohort != part.cohort) continue;
      ++facts.trials;
      if (isOftenLate(trial.lateTicks.value_or(0), trial.ticks)) ++facts.lateTrials;
      auto& method = methods[trial.step.condition];
      ++method.trials;
      if (trial.saturated > 0.0) ++method.saturated;
    }
    for (const auto& condition : loaded_.protocol.conditions) {
      auto& method = methods[condition.id];
      method.title = condition.title;
      if (method.saturated > 0) facts.saturated.push_back(method);
    }
    return analysis::flagsOf(part.table, facts);
  }

  bool isOf(const protocols::Family& family, const AnswerRecord& answer) const {
    const auto& blocks = family.blocks;
    return answer.step.kind == StepKind::Questionnaire &&
           answer.step.instrument == family.instrument &&
           (blocks.empty() || base::contains(blocks, answer.step.phase));
  }

  /// @param site  empty: votes of all sites
  VoteResult votesOf(
      const protocols::Phase& phase,
      const std::string& cohort,
      const std::string& site = {}) const {
    const auto& block = loaded_.protocol.phase(phase.block)->trials;
    VoteResult result{
        .cohort = cohort,
        .site = site,
        .phase = phase.id,
        .block = phase.block,
        .votes = analysis::VoteCounts(block.conditions),
        .leftOut = 0,
        .test = {},
        .intervals = {}};
    const auto* instrument = loaded_.instrument(phase.instrument);
    for (const auto& answer : answers_) {
      if (answer.step.phase != phase.id || cohortOf(answer) != cohort) continue;
      const auto& session = sessions_.at(answer.step.visit.session);
      if (!site.empty() && session.site != site) continue;
      const auto* item = instrument->item(answer.answer.item);
      const auto* felt = chosenCondition(allocation_, answer, item, phase.block);
      if (felt == nullptr || !base::contains(block.conditions, *felt)) continue;
      if (unfinishedTrials_.contains({session.id, phase.block})) {
        ++result.leftOut;
      } else {
        result.votes.add(*felt);
      }
    }
    result.test = analysis::equalSharesTest(result.votes);
    for (const auto& share : result.votes.shares()) {
      result.intervals.push_back(analysis::wilsonInterval(share.votes, result.votes.total()));
    }
    return result;
  }

  RunMode mode_;
  PairOrder order_;
  const protocols::LoadedProtocol& loaded_;
  ProtocolVersions versions_;
  Records records_;
  AnalysisPlanHistory history_;
  std::set<std::string> sites_;
  std::map<std::string, std::string> siteOf_;  ///< of the first session, by participant
  std::map<SessionId, SessionRecord> sessions_;
  std::vector<AnswerRecord> answers_;
  std::vector<storage::StoredTrial> trials_;
  Records::Allocation allocation_;
  std::map<std::pair<SessionId, std::string>, int> unfinishedTrials_;
};

}  // namespace

void CohortFlow::add(SessionState state) {
  ++enrolled;
  switch (state) {
    case SessionState::Completed:
      ++completed;
      return;
    case SessionState::Declined:
      ++declined;
      return;
    case SessionState::Withdrawn:
      ++withdrawn;
      return;
    case SessionState::Rejected:
      ++rejected;
      return;
    case SessionState::AbortedHardware:
      ++abortedHardware;
      return;
    case SessionState::Erased:
      ++erased;
      return;
    default:
      ++inProgress;
  }
}

std::string_view idOf(protocols::TestType test) noexcept {
  constexpr std::array<std::string_view, 4> kIds{"welch", "paired_t", "sign_flip", "signed_rank"};
  return kIds[static_cast<std::size_t>(test)];
}

int Results::completed() const {
  int total = 0;
  for (const auto& cohort : flow) total += cohort.completed;
  return total;
}

bool isPooled(Profile profile, const protocols::Family& family) noexcept {
  return profile == Profile::AsPublished ||
         (profile == Profile::Declared && family.test == protocols::TestType::Welch);
}

std::vector<RaisedFlag> flagsByKind(const FamilyResult& family, bool hasPooledTests) {
  std::vector<RaisedFlag> raised;
  for (const auto& cohort : family.cohorts) {
    for (const auto& flag : cohort.flags) {
      if (flag.concernsPooledTests && !hasPooledTests) continue;
      auto same = std::ranges::find_if(
          raised, [&](const auto& other) { return other.flag->id == flag.id; });
      if (same == raised.end()) same = raised.insert(raised.end(), {&flag, {}});
      same->found.emplace_back(cohort.cohort, &flag);
    }
  }
  return raised;
}

std::optional<double> meanOfAll(const FamilyResult& family, const std::string& condition) {
  double answers = 0.0;
  double points = 0.0;
  for (const auto& part : family.cohorts) {
    for (const auto& one : part.conditions) {
      if (one.name != condition || one.answers.total() == 0) continue;
      answers += static_cast<double>(one.answers.total());
      points += static_cast<double>(one.answers.total()) * *one.answers.mean();
    }
  }
  return answers > 0.0 ? std::optional(points / answers) : std::nullopt;
}

Results computeResults(Study& study, RunMode mode, PairOrder order) {
  return Computation(study, mode, order).all();
}

}  // namespace study
