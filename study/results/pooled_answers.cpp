#include "study/results/pooled_answers.h"

#include <algorithm>
#include <future>

#include "questionnaires/model/answer.h"
#include "study/results/answer_tables.h"
#include "study/storage/completed_sessions.h"

namespace study {
PooledAnswers::PooledAnswers(Study& study, RunMode mode, std::int64_t worthAThread)
    : study_(study), mode_(mode), worthAThread_(worthAThread) {
  countAll();
}

void PooledAnswers::layOut() {
  loaded_ = &study_.protocol();
  families_.clear();
  placesOfACohort_ = 0;
  for (const auto& family : loaded_->protocol.analysis.families) {
    const auto table = answerTable(*loaded_, family, {}, {});
    families_.push_back({table.methods, table.lowest, table.highest, placesOfACohort_});
    placesOfACohort_ += table.methods.size() * families_.back().points();
  }
  uses_.assign(1, {});  // questions are counted from 1
}

std::vector<PooledAnswers::Use> PooledAnswers::usesOf(const storage::Question& question) const {
  std::vector<Use> uses;
  if (question.kind != nameOf(StepKind::Questionnaire)) return uses;
  for (std::size_t i = 0; i < families_.size(); ++i) {
    const auto& declared = loaded_->protocol.analysis.families[i];
    if (declared.instrument != question.instrument) continue;
    const auto table = answerTable(*loaded_, declared, {}, {});
    const auto holds = [](const std::vector<std::string>& names, const std::string& name) {
      return std::find(names.begin(), names.end(), name) != names.end();
    };
    const bool isCounted = holds(table.methods, question.condition) &&
                           holds(table.rounds, question.phase) &&
                           holds(table.statements, question.item);
    if (!isCounted) continue;
    const auto& conditions = families_[i].conditions;
    const auto condition = std::find(conditions.begin(), conditions.end(), question.condition);
    const auto place = static_cast<std::size_t>(condition - conditions.begin());
    const auto& item = *loaded_->instrument(declared.instrument)->item(question.item);
    uses.push_back(
        {.offset = questionnaires::keyed(item, 0),
         .key = item.key,
         .lowest = families_[i].lowest,
         .highest = families_[i].highest,
         .first = families_[i].first + place * families_[i].points()});
  }
  return uses;
}

void PooledAnswers::learnQuestions() {
  const auto known = static_cast<std::int64_t>(uses_.size()) - 1;
  for (const auto& question : storage::CodedAnswers(study_.database()).questionsAfter(known)) {
    uses_.resize(static_cast<std::size_t>(question.id));  // a number that is nobody's has no use
    uses_.push_back(usesOf(question));
  }
}

std::optional<std::size_t> PooledAnswers::cohortNamed(const std::string& cohort) const {
  const auto& cohorts = loaded_->protocol.cohorts;
  const auto found =
      std::find_if(cohorts.begin(), cohorts.end(), [&](const auto& c) { return c.id == cohort; });
  if (found == cohorts.end()) return std::nullopt;
  return static_cast<std::size_t>(found - cohorts.begin());
}

void PooledAnswers::addPlaces(
    const storage::CodedAnswer& answer, std::size_t cohort, std::vector<Place>& to) const {
  const auto question = static_cast<std::size_t>(answer.question);
  if (question >= uses_.size()) return;  // asked after everything else was read: refresh() knows it
  for (const auto& use : uses_[question]) {
    const auto score = use.offset + use.key * answer.point;
    // An answer that was given on the scale of an earlier version of the protocol is missing.
    if (score < use.lowest || score > use.highest) continue;
    const auto point = static_cast<std::size_t>(score - use.lowest);
    to.push_back(static_cast<Place>(cohort * placesOfACohort_ + use.first + point));
  }
}

void PooledAnswers::keep(SessionId session, const std::vector<Place>& places, Part& part) {
  if (places.empty()) return;
  part.sessions.put(session, places);
  for (const auto place : places) ++part.counts[place];
}

void PooledAnswers::countAll() {
  layOut();
  // First of all: what is written while the rest is read is counted anew by refresh().
  lastEvent_ = study_.events().last();
  learnQuestions();
  const storage::CodedAnswers answers(study_.database());
  const auto withMore = answers.sessionsWithMore();
  const auto last = static_cast<std::int64_t>(answers.lastSession());
  const bool isLarge = last >= worthAThread_;
  secondFrom_ = isLarge ? SessionId{last / 2} : storage::SessionRange{}.end;
  std::future<Part> second;
  if (isLarge) {
    second = std::async(std::launch::async, [this, &withMore] {
      auto reader = study_.openReader();
      return counted(reader, {.first = secondFrom_}, withMore);
    });
  }
  parts_[0] = counted(study_.database(), {.end = secondFrom_}, withMore);
  parts_[1] =
      isLarge ? second.get() : Part{std::vector<std::uint64_t>(parts_[0].counts.size()), {}};
  for (const auto left : withMore) countAnew(left);
}

PooledAnswers::Part PooledAnswers::counted(
    storage::Database& database,
    const storage::SessionRange& range,
    const std::vector<SessionId>& withMore) const {
  Part part;
  part.counts.assign(placesOfACohort_ * loaded_->protocol.cohorts.size(), 0);
  storage::CompletedSessions completed(database, mode_, range.first);
  SessionId session{};
  std::optional<std::size_t> cohort;
  std::vector<Place> places;
  const auto add = [&](const storage::CodedAnswer& answer) {
    if (answer.session != session) {
      keep(session, places, part);
      places.clear();
      session = answer.session;
      const bool counts = completed.isThere(session) &&
                          !std::binary_search(withMore.begin(), withMore.end(), session);
      cohort = counts ? cohortNamed(completed.cohort()) : std::nullopt;
    }
    if (cohort) addPlaces(answer, *cohort, places);
  };
  storage::CodedAnswers(database).visitAll(add, range);
  keep(session, places, part);
  return part;
}

void PooledAnswers::countAnew(SessionId session) {
  auto& part = partOf(session);
  for (const auto place : part.sessions.take(session)) --part.counts[place];
  const auto row = study_.sessions().load(session);
  const auto cohort = cohortNamed(row.cohort);
  if (row.runMode != mode_ || row.state != SessionState::Completed || !cohort) return;
  std::vector<Place> places;
  storage::CodedAnswers(study_.database()).visitFinished(session, [&](const auto& answer) {
    addPlaces(answer, *cohort, places);
  });
  keep(session, places, part);
}

bool PooledAnswers::refresh() {
  auto events = study_.events();
  const auto last = events.last();
  if (last == lastEvent_) return false;
  const auto touched = events.touchedAfter(lastEvent_);
  if (touched.isStudy) {  // another protocol, perhaps
    countAll();
    return true;
  }
  learnQuestions();
  for (const auto session : touched.sessions) countAnew(session);
  lastEvent_ = last;
  return true;
}

std::vector<analysis::NamedCounts> PooledAnswers::of(std::size_t family, std::size_t cohort) const {
  const auto& layout = families_.at(family);
  const auto points = layout.points();
  std::vector<analysis::NamedCounts> conditions;
  std::vector<std::uint64_t> sums(points);
  for (std::size_t i = 0; i < layout.conditions.size(); ++i) {
    const auto first = cohort * placesOfACohort_ + layout.first + i * points;
    for (std::size_t k = 0; k < points; ++k) {
      sums[k] = parts_[0].counts[first + k] + parts_[1].counts[first + k];
    }
    conditions.push_back({layout.conditions[i], analysis::LikertCounts(layout.lowest, sums)});
  }
  return conditions;
}

}  // namespace study
