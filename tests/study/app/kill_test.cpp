// The program is killed, at any moment: nothing that it has acknowledged is lost, and the session
// goes on. reliability.md, F1.
#include <signal.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "study/storage/records.h"
#include "study/storage/statement.h"
#include "study/verification.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"

namespace study {
namespace {

namespace fs = std::filesystem;

constexpr int kPoints = 120;
constexpr int kParticipants = 4;

/// "saved P001 felt/kalman presence" is an answer, "saved P001 felt done" a step.
bool isAnswer(const std::string& line) {
  return line.find('/') != std::string::npos;
}

std::vector<std::string> simulation(const std::string& folder) {
  return {
      PALPATE_PROGRAM,
      "study",
      "simulate",
      folder,
      "--participants",
      std::to_string(kParticipants),
      "--verbose"};
}

/// What is kept, as the program acknowledges it, and what was answered.
std::map<std::string, questionnaires::Response> answersIn(Study& study) {
  std::map<SessionId, std::string> names;
  for (const auto& row : study.sessions().all()) names[row.id] = row.participant;
  std::map<std::string, questionnaires::Response> answers;
  for (const auto& record : storage::Records(study.database()).answers()) {
    const auto& step = record.step;
    answers.emplace(
        "saved " + names[step.visit.session] + " " + step.phase + "/" + step.condition + " " +
            record.answer.item,
        record.answer.response);
  }
  // What names a person lies apart.
  storage::Statement named(
      study.identities().database(),
      "SELECT participant, item, text FROM identifying_answer WHERE step = 0");
  while (named.step()) {
    answers.emplace("saved " + named.text(0) + " consent/ " + named.text(1), named.text(2));
  }
  return answers;
}

class KillTest : public testing::Test {
 protected:
  void SetUp() override {
    study_.close();
    const auto folder = copy("undisturbed");
    for (tests::ChildProcess child(simulation(folder)); child.readLine(line_);) {
      if (line_.rfind("saved ", 0) == 0) all_.push_back(line_);
    }
    SimulatedClock clock;
    auto study = Study::open(folder, clock);
    undisturbed_ = answersIn(study);
  }

  std::string copy(const std::string& name) {
    const std::string folder = study_.scratch() / name;
    fs::remove_all(folder);
    fs::copy(study_.folder(), folder, fs::copy_options::recursive);
    return folder;
  }

  /// Kills it @p pause microseconds after line @p count; everything that it has acknowledged.
  std::vector<std::string> killedAfter(const std::string& folder, std::size_t count, int pause) {
    tests::ChildProcess child(simulation(folder));
    std::vector<std::string> acknowledged;
    while (acknowledged.size() < count && child.readLine(line_)) acknowledged.push_back(line_);
    usleep(static_cast<useconds_t>(pause));
    child.kill(SIGKILL);
    while (child.readLine(line_)) acknowledged.push_back(line_);
    return acknowledged;
  }

  void expectKept(const std::string& folder, const std::vector<std::string>& acknowledged) {
    SimulatedClock clock;
    auto study = Study::open(folder, clock);
    const auto kept = answersIn(study);
    std::size_t answers = 0;
    for (const auto& line : acknowledged) {
      if (!isAnswer(line)) continue;
      ++answers;
      EXPECT_EQ(kept.count(line), 1U) << "lost: " << line;
    }
    EXPECT_LE(kept.size(), answers + 1);  // one may be kept that nobody was told about
    for (const auto& check : verify(study).checks) {
      EXPECT_TRUE(check.problems.empty()) << check.what << ": " << check.problems.front();
    }
  }

  /// Somebody starts it again.
  void expectToGoOn(const std::string& folder) {
    const auto finished = tests::run(simulation(folder));
    ASSERT_EQ(finished.status, 0) << finished.error;
    SimulatedClock clock;
    auto study = Study::open(folder, clock);
    EXPECT_EQ(answersIn(study), undisturbed_);
    EXPECT_TRUE(verify(study).isSound());
    for (const auto& row : study.sessions().all()) EXPECT_TRUE(isOver(row.state));
  }

  tests::MadeStudy study_{tests::protocolFrom(tests::shortProtocol()), 2026};
  std::vector<std::string> all_;  ///< what is acknowledged when nothing happens
  std::map<std::string, questionnaires::Response> undisturbed_;
  std::string line_;
};

TEST_F(KillTest, LosesNothingThatWasAcknowledgedWheneverItIsKilled) {
  ASSERT_GE(all_.size(), 40U);
  std::mt19937 random(20261121);
  std::set<std::size_t> stoppedAt;
  for (int point = 0; point < kPoints; ++point) {
    const auto folder = copy("killed");
    const std::size_t count = static_cast<std::size_t>(point) * all_.size() / kPoints;
    const int pause = point % 3 == 0 ? 0 : static_cast<int>(random() % 3000);
    SCOPED_TRACE(
        "killed " + std::to_string(pause) + " us after " + std::to_string(count) + " lines");
    const auto acknowledged = killedAfter(folder, count, pause);
    stoppedAt.insert(acknowledged.size());
    expectKept(folder, acknowledged);
    if (point % 4 == 0) expectToGoOn(folder);
    if (HasFailure()) return;
  }
  EXPECT_GE(stoppedAt.size(), 40U) << "the points were not different ones";
  RecordProperty("points", kPoints);
}

TEST_F(KillTest, NoticesWhatIsLost) {
  // The control: an acknowledgement of what was never saved is a loss.
  const auto folder = copy("killed");
  auto acknowledged = killedAfter(folder, 20, 0);
  acknowledged.push_back("saved P001 felt/kalman nothing-of-this-name");
  SimulatedClock clock;
  auto study = Study::open(folder, clock);
  EXPECT_EQ(answersIn(study).count(acknowledged.back()), 0U);
}

}  // namespace
}  // namespace study
