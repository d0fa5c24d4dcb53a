#include "study/bench/synthetic_study.h"

#include <array>

#include <fmt/format.h>

#include "base/random.h"
#include "protocols/orders/schedule.h"
#include "study/app/command_options.h"
#include "study/model/session_plan.h"
#include "study/session/session.h"
#include "study/session/study.h"
#include "study/storage/statement.h"

namespace study::bench {
namespace {

constexpr const char* kProtocol = "punch-face-validity";
constexpr std::uint64_t kSeed = 20'261'121;
constexpr std::int64_t kSessionsPerTransaction = 10'000;  // sessions in one transaction

/// An item that every session of a cohort contains.
struct AskedItem {
  int step = 0;
  int order = 0;
  const Step* plannedStep = nullptr;
  const questionnaires::Item* item = nullptr;
};

struct Cohort {
  std::string id;
  std::vector<Step> plan;
  std::vector<AskedItem> asked;
};

/// Writes sessions one after another.
class Writer {
 public:
  explicit Writer(Study& study) : study_(study), loaded_(study.protocol()), random_(kSeed) {
    for (const auto& cohort : loaded_.protocol.cohorts)
      cohorts_.push_back(cohortWithPlan(cohort.id));
  }

  /// @return the number of written answers, at most @p most
  std::int64_t add(std::int64_t session, std::int64_t most) {
    const auto& cohort = cohorts_[static_cast<std::size_t>(session) % cohorts_.size()];
    addPerson(session, cohort);
    std::int64_t written = 0;
    int step = -1;
    for (const auto& asked : cohort.asked) {
      if (written == most) break;
      if (asked.step != step) addStep(session, *asked.plannedStep, step = asked.step);
      addAnswer(session, asked);
      ++written;
    }
    return written;
  }

 private:
  Cohort cohortWithPlan(const std::string& id) {
    Cohort cohort{.id = id, .plan = {}, .asked = {}};
    cohort.plan = sessionPlan(
        loaded_.protocol, protocols::scheduleFor(loaded_.protocol, study_.seed(), id, 0));
    for (std::size_t i = 0; i < cohort.plan.size(); ++i) {
      const auto& step = cohort.plan[i];
      if (step.kind != StepKind::Questionnaire) continue;
      const auto* instrument = loaded_.instrument(step.instrument);
      int order = 0;
      for (const auto& item : instrument->itemsOf(step.itemSet)) {
        cohort.asked.push_back({static_cast<int>(i), ++order, &step, instrument->item(item.id)});
      }
    }
    return cohort;
  }

  void addPerson(std::int64_t session, const Cohort& cohort) {
    participant_.bindAll(session, fmt::format("SIM-{:07d}", session), cohort.id);
    participant_.run();
    session_.bindAll(session, session, cohort.id, session);
    session_.run();
  }

  void addStep(std::int64_t session, const Step& step, int number) {
    step_.bindAll(
        session,
        number,
        nameOf(step.kind),
        step.phase,
        step.instrument,
        step.itemSet,
        step.position,
        step.label);
    step_.run();
    allocation_.bindAll(session, number, step.condition);
    allocation_.run();
    visit_.bindAll(session, number);
    visit_.run();
  }

  void addAnswer(std::int64_t session, const AskedItem& asked) {
    answer_.bindAll(
        session, asked.step, asked.item->id, asked.order, drawAnswer(asked.plannedStep->condition));
    answer_.run();
  }

  /// A random point of the scale. The probabilities of the five points are fixed, with small
  /// differences between conditions.
  std::int64_t drawAnswer(const std::string& condition) {
    constexpr std::array<int, 5> kUpToOfFirst{8, 20, 45, 78, 100};
    constexpr std::array<int, 5> kUpToOfOthers{12, 27, 54, 83, 100};
    const auto& upTo =
        condition == loaded_.protocol.conditions.front().id ? kUpToOfFirst : kUpToOfOthers;
    const auto percent = static_cast<int>(random_.bits() % 100);
    std::int64_t point = 1;
    while (percent >= upTo[static_cast<std::size_t>(point - 1)]) ++point;
    return point;
  }

  storage::Statement prepare(const std::string& sql) { return {study_.database(), sql}; }

  Study& study_;
  const protocols::LoadedProtocol& loaded_;
  base::SplitMix64 random_;
  std::vector<Cohort> cohorts_;
  storage::Statement participant_ = prepare(
      "INSERT INTO participant (id, code, cohort, run_mode, created_utc) VALUES "
      "(?, ?, ?, 'simulated', '2000-01-01T10:00:00.000Z')");
  storage::Statement session_ = prepare(
      "INSERT INTO session (id, participant_id, number, protocol_id, run_mode, cohort, language, "
      "slot, slot_state, state, step, attempt, app_version, started_utc, ended_utc, end_reason) "
      "VALUES (?, ?, 1, 1, 'simulated', ?, 'en', ?, 'consumed', 'completed', 0, 1, 'bench', "
      "'2000-01-01T10:00:00.000Z', '2000-01-01T10:20:00.000Z', '')");
  storage::Statement step_ = prepare(
      "INSERT INTO step (session_id, step, kind, phase, instrument, item_set, position, label) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
  storage::Statement allocation_ =
      prepare("INSERT INTO allocation (session_id, step, condition) VALUES (?, ?, ?)");
  storage::Statement visit_ = prepare(
      "INSERT INTO visit (session_id, step, attempt, status, began_utc) "
      "VALUES (?, ?, 1, 'finished', '2000-01-01T10:00:00.000Z')");
  storage::Statement answer_ = prepare(
      "INSERT INTO answer (session_id, step, attempt, item, item_order, kind, point, "
      "first_touch_s, response_s, changes, language, saved_utc) "
      "VALUES (?, ?, 1, ?, ?, 'point', ?, 1.5, 2.5, 0, 'en', '2000-01-01T10:00:00.000Z')");
};

std::int64_t writeSessions(Study& study, std::int64_t answers) {
  Writer writer(study);
  std::int64_t session = 0;
  for (std::int64_t left = answers; left > 0;) {
    storage::Transaction transaction(study.database());
    for (std::int64_t i = 0; i < kSessionsPerTransaction && left > 0; ++i)
      left -= writer.add(++session, left);
    transaction.commit();
  }
  return session;
}

}  // namespace

SyntheticStudy makeSyntheticStudy(const std::filesystem::path& parentFolder, std::int64_t answers) {
  const auto protocol = app::loadValidProtocol(kProtocol);
  SystemClock clock;
  SyntheticStudy made{.folder = parentFolder / "study"};
  auto study = Study::create(made.folder, protocol, clock, kSeed);
  made.sessions = writeSessions(study, answers);
  study.note(EventKind::Note, "SYNTHETIC: made by palpate bench stats; nobody took part");
  study.database().execute("PRAGMA wal_checkpoint(TRUNCATE)");
  return made;
}

}  // namespace study::bench
