// Samples of a trial are read back unchanged; missing ones are detected.
#include "study/storage/trace_store.h"

#include <cstring>
#include <random>

#include <gtest/gtest.h>

#include "study/session/trial_setup.h"
#include "study/session/verification.h"
#include "study/storage/records.h"
#include "study/storage/study_schema.h"
#include "study/trial/device_set.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"
#include "tests/support/scratch_folder.h"

namespace study::storage {
namespace trace_store_test {

using Samples = std::vector<TraceSample>;

/// Samples with random bits: not-a-number, infinities, −0.
Samples anySamples(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint32_t> words(count * sizeof(TraceSample) / sizeof(std::uint32_t));
  for (auto& word : words) word = static_cast<std::uint32_t>(random());
  Samples samples(count);
  std::memcpy(static_cast<void*>(samples.data()), words.data(), count * sizeof(TraceSample));
  return samples;
}

bool areSameBits(const Samples& a, const Samples& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), a.size() * sizeof(TraceSample)) == 0;
}

Samples joined(const std::vector<Samples>& chunks) {
  Samples all;
  for (const auto& chunk : chunks) all.insert(all.end(), chunk.begin(), chunk.end());
  return all;
}

constexpr VisitKey kVisit{SessionId{1}, 2, 1};

TEST(TraceStore, ReadsEveryBitBack) {
  TraceStore store(Database::inMemory(traceSchema()));
  const std::vector<Samples> chunks{anySamples(1000, 1), anySamples(1000, 2), anySamples(1, 3)};
  for (std::size_t i = 0; i < chunks.size(); ++i) {
    store.add(kVisit, static_cast<int>(i), chunks[i]);
  }
  EXPECT_TRUE(areSameBits(store.read(kVisit), joined(chunks)));
  EXPECT_EQ(store.sampleCount(kVisit), 2001);
  EXPECT_FALSE(areSameBits(store.read(kVisit), anySamples(2001, 1)));  // the control
}

/// Samples as release 0.1 kept them: without a torque.
Samples samplesWithoutTorque(std::size_t count) {
  auto samples = anySamples(count, 4);
  for (auto& sample : samples) sample.desiredTorque = sample.torque = 0.0F;
  return samples;
}

TEST(TraceStore, KeepsSamplesWithoutTorqueIn28BytesAsRelease01Did) {
  const tests::ScratchFolder folder;
  const std::string file = folder / "traces.db";
  const auto without = samplesWithoutTorque(1000);
  auto with = without;
  with.back().torque = 0.25F;
  {
    TraceStore store(Database::create(file, traceSchema()));
    store.add(kVisit, 0, without);
    store.add(kVisit, 1, with);
    EXPECT_TRUE(areSameBits(store.read(kVisit), joined({without, with})));
  }
  tests::Sql traces(file);
  EXPECT_EQ(traces.number("SELECT layout FROM chunk WHERE number = 0"), 1);
  EXPECT_EQ(traces.number("SELECT length(data) FROM chunk WHERE number = 0"), 28'000);
  EXPECT_EQ(traces.number("SELECT layout FROM chunk WHERE number = 1"), 2);
  EXPECT_EQ(traces.number("SELECT length(data) FROM chunk WHERE number = 1"), 36'000);
}

TEST(TraceStore, RefusesALayoutThatItDoesNotKnow) {
  const tests::ScratchFolder folder;
  const std::string file = folder / "traces.db";
  TraceStore store(Database::create(file, traceSchema()));
  store.add(kVisit, 0, samplesWithoutTorque(10));
  tests::Sql(file).run("UPDATE chunk SET layout = 3");
  EXPECT_THROW(store.read(kVisit), StorageError);
}

TEST(TraceStore, SeparatesTheAttemptsOfAStep) {
  TraceStore store(Database::inMemory(traceSchema()));
  const VisitKey again{kVisit.session, kVisit.step, 2};
  store.add(kVisit, 0, anySamples(10, 1));
  store.add(again, 0, anySamples(20, 2));
  EXPECT_EQ(store.read(kVisit).size(), 10U);
  EXPECT_EQ(store.read(again).size(), 20U);
  EXPECT_EQ(store.visits(), (std::vector<VisitKey>{kVisit, again}));
  EXPECT_TRUE(store.read({kVisit.session, 7, 1}).empty());
  EXPECT_NE(store.digest(kVisit), store.digest(again));
}

TEST(TraceStore, RefusesATraceInWhichASecondIsMissing) {
  TraceStore store(Database::inMemory(traceSchema()));
  store.add(kVisit, 0, anySamples(10, 1));
  store.add(kVisit, 2, anySamples(10, 2));
  EXPECT_THROW(store.read(kVisit), StorageError);
  EXPECT_THROW(store.intactSampleCount(kVisit), StorageError);
}

TEST(TraceStore, NeverOverwritesAChunk) {
  TraceStore store(Database::inMemory(traceSchema()));
  const auto first = anySamples(10, 1);
  store.add(kVisit, 0, first);
  store.add(kVisit, 0, first);  // written already, by a commit of unknown outcome
  EXPECT_THROW(store.add(kVisit, 0, anySamples(10, 2)), StorageError);
  EXPECT_TRUE(areSameBits(store.read(kVisit), first));
}

/// A session with a trial of several seconds, made by a simulated hand and stored.
class KeptTrialTest : public testing::Test {
 protected:
  explicit KeptTrialTest(
      const std::string& protocol = tests::shortProtocol({.labels = "position", .minimumCuts = 3}))
      : study_(tests::protocolFrom(protocol)) {}

  void SetUp() override {
    tests::walkTo(session_, StepKind::Trial);
    visit_ = session_.visit();
    Trial trial(device(), setup());
    session_.beginTrial();
    const auto record = runOffline(trial, 3, 60.0);
    ticks_ = record.ticks;
    session_.finishTrial(record);
  }

  haptics::devices::Device& device() { return deviceSet_.device(deviceFor(session_)); }

  /// As if the simulated device were a real one.
  Trial::Setup setup() {
    auto setup = setupFor(session_, study_->traces());
    setup.needsDevice = false;
    return setup;
  }

  /// The verification's findings on traces after the statement @p mischief.
  std::string problemsAfter(const std::string& mischief) {
    tests::Sql(study_.file("traces.db")).run(mischief);
    const auto traces = verify(*study_).checks.back();
    std::string problems;
    for (const auto& problem : traces.problems) problems += problem;
    return problems;
  }

  tests::MadeStudy study_;
  Session session_ = Session::enrol(*study_, {.cohort = "surgeons"});
  SimulatedDeviceSet deviceSet_{[](const protocols::DeviceRequirement& need) {
    return simulatedHandFor(need, 7, "surgeons", 0);
  }};
  VisitKey visit_;
  std::int64_t ticks_ = 0;
};

TEST_F(KeptTrialTest, IsStoredInChunksOfOneSecond) {
  tests::Sql traces(study_.file("traces.db"));
  EXPECT_EQ(traces.number("SELECT sum(samples) FROM chunk"), ticks_);
  EXPECT_EQ(traces.number("SELECT count(*) FROM chunk"), (ticks_ + 999) / 1000);
  EXPECT_EQ(
      traces.number("SELECT count(*) FROM chunk WHERE samples <> 1000"), ticks_ % 1000 ? 1 : 0);
  const auto samples = study_->traces().read(visit_);
  for (std::size_t i = 0; i < samples.size(); ++i) ASSERT_EQ(samples[i].tick, i);
  EXPECT_TRUE(verify(*study_).isSound());
}

TEST_F(KeptTrialTest, IsReportedIfAChunkInTheMiddleIsMissing) {
  EXPECT_NE(
      problemsAfter("DELETE FROM chunk WHERE number = 1").find("second 2"), std::string::npos);
}

/// The same where nothing is sealed, so that the samples of one second are sound in another's
/// place.
class OpenTrialTest : public KeptTrialTest {
 protected:
  static std::string protocol() {
    auto text = tests::shortProtocol({.labels = "position", .minimumCuts = 3});
    return text.insert(text.find(R"("languages")"), R"("blinding": "open", )");
  }
  OpenTrialTest() : KeptTrialTest(protocol()) {}
};

TEST_F(OpenTrialTest, IsReportedIfASecondTookThePlaceOfAnother) {
  const auto problems = problemsAfter(
      "UPDATE chunk SET data = (SELECT data FROM chunk WHERE number = 0), "
      "hash = (SELECT hash FROM chunk WHERE number = 0) WHERE number = 1");
  EXPECT_NE(problems.find("not the one that was recorded"), std::string::npos) << problems;
}

TEST_F(KeptTrialTest, IsReportedIfItsLastChunkIsMissing) {
  const auto problems =
      problemsAfter("DELETE FROM chunk WHERE number = (SELECT max(number) FROM chunk)");
  EXPECT_NE(problems.find(" of " + std::to_string(ticks_) + " samples"), std::string::npos)
      << problems;
}

TEST_F(KeptTrialTest, IsReportedIfAllChunksAreMissing) {
  EXPECT_NE(problemsAfter("DELETE FROM chunk").find("0 of "), std::string::npos);
}

TEST_F(KeptTrialTest, IsReportedIfItBelongsToAnotherTrial) {
  const auto problems = problemsAfter("UPDATE chunk SET attempt = 2");
  EXPECT_NE(problems.find("a trace without a trial"), std::string::npos) << problems;
}

TEST_F(KeptTrialTest, IsReportedIfChunksAreExchanged) {
  EXPECT_NE(
      problemsAfter("UPDATE chunk SET number = number + 100 WHERE number < 2;"
                    "UPDATE chunk SET number = 101 - number WHERE number >= 100"),
      "");
}

TEST(Trial, OfALiveSessionFailsOnASimulatedDevice) {
  tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol()));
  for (const auto& [mode, verdict] :
       {std::pair{RunMode::Live, Verdict::Fail},
        {RunMode::Pilot, Verdict::Pass},
        {RunMode::Simulated, Verdict::Pass}}) {
    auto session = Session::enrol(*study, {.cohort = "surgeons", .runMode = mode});
    tests::walkTo(session, StepKind::Trial);
    SimulatedDeviceSet devices([](const protocols::DeviceRequirement& need) {
      return simulatedHandFor(need, 7, "surgeons", 1);
    });
    Trial trial(devices.device(deviceFor(session)), setupFor(session, study->traces()));
    const auto judgement = runOffline(trial, 1, 60.0).judgement();
    EXPECT_EQ(judgement.verdict, verdict) << nameOf(mode);
    EXPECT_EQ(judgement.reasons.size(), verdict == Verdict::Fail ? 1U : 0U) << nameOf(mode);
  }
}

TEST_F(KeptTrialTest, IsRepeatedAfterADeviceFailure) {
  tests::walkTo(session_, StepKind::Trial);
  const auto first = session_.visit();
  Trial trial(device(), setup());
  session_.beginTrial();
  for (int i = 0; i < 1500; ++i) trial.keep(trial.step(1e-3));
  deviceSet_.unplug(deviceFor(session_).id);
  const auto record = runOffline(trial, 3, 60.0);
  EXPECT_EQ(record.ending, TrialEnding::DeviceGone);
  EXPECT_EQ(record.ticks, 1501);  // found in the first tick
  EXPECT_EQ(study_->traces().read(first).size(), 1501U);
  session_.abortTrial(record);

  EXPECT_FALSE(session_.allows(SessionEvent::BeganTrial));  // only the operator can continue
  EXPECT_TRUE(session_.allows(SessionEvent::RepeatedStep));
  deviceSet_.plugIn(deviceFor(session_).id);
  session_.repeatStep("the plug is in again");
  Trial again(device(), setup());
  session_.beginTrial();
  session_.finishTrial(runOffline(again, 3, 60.0));
  const auto trials = Records(study_->database()).trials();
  ASSERT_EQ(trials.size(), 3U);
  EXPECT_EQ(trials[1].ending, TrialEnding::DeviceGone);
  EXPECT_EQ(trials[1].verdict, Verdict::Fail);
  EXPECT_EQ(trials[2].ending, TrialEnding::Finished);
  EXPECT_EQ(trials[2].verdict, Verdict::Pass);
  EXPECT_EQ(trials[2].step.visit, (VisitKey{first.session, first.step, 2}));
  EXPECT_TRUE(verify(*study_).isSound());
}

}  // namespace trace_store_test
}  // namespace study::storage
