// An answer is acknowledged when it is on the disk, and not before: what the program asks of the
// system, in its order, as strace sees it. reliability.md, D1, D2 and F5.
#include <filesystem>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/study/app/simulation.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

/// The leak sanitizer cannot look at a program that strace looks at.
const Lines kEnvironment{"ASAN_OPTIONS=detect_leaks=0"};

/// What came of looking through a list of system calls.
struct Seen {
  std::size_t acknowledged = 0;
  Lines tooEarly;  ///< acknowledged with something not on the disk, or with nothing new on it
};

/// "study.db-wal" in "fdatasync(4</…/study.db-wal>) = 0".
std::string fileOf(const std::string& call) {
  const auto begin = call.find('<');
  const auto end = call.find('>', begin);
  if (begin == std::string::npos || end == std::string::npos) return {};
  return fs::path(call.substr(begin + 1, end - begin - 1)).filename().string();
}

bool isCall(const std::string& line, const std::string& name) {
  return line.rfind(name + "(", 0) == 0;
}

bool isFlush(const std::string& line) {
  const bool isOne = isCall(line, "fdatasync") || isCall(line, "fsync");
  return isOne && line.size() > 3 && line.substr(line.size() - 3) == "= 0";
}

Seen lookThrough(const Lines& calls) {
  Seen seen;
  std::set<std::string> unflushed;
  std::size_t flushed = 0;
  for (const auto& call : calls) {
    const auto file = fileOf(call);
    const bool isLog = file.find("-wal") != std::string::npos;
    if (isLog && isCall(call, "pwrite64")) unflushed.insert(file);
    if (isLog && isFlush(call)) flushed += unflushed.erase(file);
    if (call.rfind("write(1<", 0) != 0 || call.find("\"saved ") == std::string::npos) continue;
    ++seen.acknowledged;
    if (flushed == 0 || !unflushed.empty()) seen.tooEarly.push_back(call);
    flushed = 0;
  }
  return seen;
}

class AcknowledgementTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto tried = tests::run({"strace", "-o", study_.scratch() / "tried", "true"});
    if (tried.status != 0) GTEST_SKIP() << "strace is missing or not permitted: " << tried.error;
    study_.close();
  }

  /// Simulates one participant under strace.
  tests::Finished traced(const std::string& folder, const Lines& options) {
    Lines call{
        "strace", "-y", "-s", "80", "-o", trace_, "-e", "trace=pwrite64,write,fdatasync,fsync"};
    call.insert(call.end(), options.begin(), options.end());
    for (const auto& word : tests::simulation(folder, 1)) call.push_back(word);
    return tests::run(call, kEnvironment);
  }

  Lines calls() const {
    Lines lines;
    std::istringstream stream(tests::contentOf(trace_));
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  tests::MadeStudy study_{tests::protocolFrom(tests::shortProtocol()), 2026};
  std::string trace_ = study_.scratch() / "trace";
};

TEST_F(AcknowledgementTest, FollowsTheFlushOfEverythingThatWasWrittenForIt) {
  const auto finished = traced(study_.folder(), {});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto seen = lookThrough(calls());
  EXPECT_EQ(seen.acknowledged, tests::acknowledgedIn(finished.out).size());
  EXPECT_GE(seen.acknowledged, 30U);
  EXPECT_TRUE(seen.tooEarly.empty()) << seen.tooEarly.front();
  RecordProperty("acknowledgements", static_cast<int>(seen.acknowledged));
}

TEST_F(AcknowledgementTest, IsFoundByThisTestWhereItComesTooEarly) {
  // The positive control: the same calls, with the flushes left out, or each after its line.
  ASSERT_EQ(traced(study_.folder(), {}).status, 0);
  Lines without;
  Lines late;
  std::string flush;
  for (const auto& call : calls()) {
    if (isFlush(call)) {
      flush = call;
      continue;
    }
    without.push_back(call);
    late.push_back(call);
    if (call.rfind("write(1<", 0) == 0) late.push_back(flush);
  }
  EXPECT_EQ(lookThrough(without).tooEarly.size(), lookThrough(without).acknowledged);
  EXPECT_GE(lookThrough(late).tooEarly.size(), 30U);
}

class FlushFaultTest : public AcknowledgementTest,
                       public testing::WithParamInterface<const char*> {};

TEST_P(FlushFaultTest, IsAcknowledgedByNobodyAndLosesNothing) {
  int points = 0;
  int refused = 0;
  for (bool hasFired = true; hasFired; ++points) {
    const std::string when = std::to_string(points + 1) + GetParam();
    SCOPED_TRACE("flush " + when);
    const std::string folder = study_.scratch() / "copy";
    fs::remove_all(folder);
    fs::copy(study_.folder(), folder, fs::copy_options::recursive);
    const auto finished = traced(folder, {"-e", "inject=fdatasync:error=EIO:when=" + when});
    hasFired = tests::contentOf(trace_).find("(INJECTED)") != std::string::npos;
    if (finished.status != 0) {
      ++refused;
      EXPECT_NE(finished.error.find("the disk reports an error"), std::string::npos)
          << finished.error;
    }
    const auto acknowledged = tests::acknowledgedIn(finished.out);
    EXPECT_EQ(tests::whatIsLost(folder, acknowledged), "");
    EXPECT_LE(tests::keptBeyond(folder, acknowledged), 1U);
    ASSERT_EQ(tests::run(tests::simulation(folder, 1)).status, 0);  // when it is well again
    EXPECT_EQ(tests::whatIsLost(folder, acknowledged), "");
  }
  EXPECT_GE(refused, 30);
  RecordProperty("points", points);
}

INSTANTIATE_TEST_SUITE_P(OfOne, FlushFaultTest, testing::Values(""), [](const auto&) {
  return "Flush";
});
INSTANTIATE_TEST_SUITE_P(OfAll, FlushFaultTest, testing::Values("+"), [](const auto&) {
  return "FromThenOn";
});

}  // namespace
}  // namespace study
