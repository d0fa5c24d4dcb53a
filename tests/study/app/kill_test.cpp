// The program is killed at any moment: no acknowledged answer is lost, and the session can be
// resumed.
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "study/session/verification.h"
#include "tests/study/app/simulation.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/long_form.h"

namespace study {
namespace kill_test {

namespace fs = std::filesystem;

const int kPoints = tests::inLongForm(120, 24);
constexpr int kParticipants = 4;

class KillTest : public testing::Test {
 protected:
  void SetUp() override {
    study_.close();
    const auto folder = copy("undisturbed");
    for (tests::ChildProcess child(tests::simulation(folder, kParticipants));
         child.readLine(line_);) {
      if (line_.rfind("saved ", 0) == 0) all_.push_back(line_);
    }
    SimulatedClock clock;
    auto study = Study::open(folder, clock);
    undisturbed_ = tests::answersIn(study);
  }

  std::string copy(const std::string& name) {
    const std::string folder = study_.scratch() / name;
    fs::remove_all(folder);
    tests::forgetWhatWasSigned();
    fs::copy(study_.folder(), folder, fs::copy_options::recursive);
    return folder;
  }

  /// Kills the program @p pause microseconds after line @p count; returns everything it
  /// acknowledged.
  std::vector<std::string> killedAfter(const std::string& folder, std::size_t count, int pause) {
    tests::ChildProcess child(tests::simulation(folder, kParticipants));
    std::vector<std::string> acknowledged;
    while (acknowledged.size() < count && child.readLine(line_)) acknowledged.push_back(line_);
    usleep(static_cast<useconds_t>(pause));
    child.kill(SIGKILL);
    while (child.readLine(line_)) acknowledged.push_back(line_);
    return acknowledged;
  }

  void expectKept(const std::string& folder, const std::vector<std::string>& acknowledged) {
    EXPECT_EQ(tests::whatIsLost(folder, acknowledged), "");
    EXPECT_LE(tests::keptBeyond(folder, acknowledged), 1U);
  }

  /// Starts the program again.
  void expectToGoOn(const std::string& folder) {
    const auto finished = tests::run(tests::simulation(folder, kParticipants));
    ASSERT_EQ(finished.status, 0) << finished.error;
    SimulatedClock clock;
    auto study = Study::open(folder, clock);
    EXPECT_EQ(tests::answersIn(study), undisturbed_);
    EXPECT_TRUE(verify(study).isSound());
    for (const auto& row : study.sessions().all()) EXPECT_TRUE(isOver(row.state));
  }

  tests::MadeStudy study_{tests::protocolFrom(tests::shortProtocol()), 2026};
  std::vector<std::string> all_;  ///< all acknowledgements of an undisturbed run
  std::map<std::string, questionnaires::Response> undisturbed_;
  std::string line_;
};

TEST_F(KillTest, LosesNoAcknowledgedAnswerWheneverItIsKilled) {
  ASSERT_GE(all_.size(), 40U);
  std::mt19937 random(20261121);
  std::set<std::size_t> stoppedAt;
  for (int point = 0; point < kPoints; ++point) {
    const auto folder = copy("killed");
    const std::size_t count =
        static_cast<std::size_t>(point) * all_.size() / static_cast<std::size_t>(kPoints);
    const int pause = point % 3 == 0 ? 0 : static_cast<int>(random() % 3000);
    SCOPED_TRACE(
        "killed " + std::to_string(pause) + " us after " + std::to_string(count) + " lines");
    const auto acknowledged = killedAfter(folder, count, pause);
    stoppedAt.insert(acknowledged.size());
    expectKept(folder, acknowledged);
    if (point % 4 == 0) expectToGoOn(folder);
    if (HasFailure()) return;
  }
  EXPECT_GE(stoppedAt.size(), static_cast<std::size_t>(kPoints / 3))
      << "the points were not different ones";
  RecordProperty("points", kPoints);
}

TEST_F(KillTest, DetectsALostAnswer) {
  // The control: an acknowledgement of something that was never saved is found.
  const auto folder = copy("killed");
  auto acknowledged = killedAfter(folder, 20, 0);
  ASSERT_EQ(tests::whatIsLost(folder, acknowledged), "");
  acknowledged.push_back("saved P001 felt/kalman nothing-of-this-name");
  EXPECT_EQ(tests::whatIsLost(folder, acknowledged), "lost: " + acknowledged.back() + "\n");
}

}  // namespace kill_test
}  // namespace study
