// An answer is acknowledged only when it is on the disk: checked by the order of the program's
// system calls under strace.
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/study/app/simulation.h"
#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/long_form.h"

namespace study {
namespace acknowledgement_test {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

/// The leak sanitizer does not work under strace.
const Lines kEnvironment{"ASAN_OPTIONS=detect_leaks=0"};

/// The findings in a list of system calls.
struct Seen {
  std::size_t acknowledged = 0;
  Lines tooEarly;  ///< acknowledged with data not on the disk, or without new data
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
        "strace",
        "-y",
        "-s",
        "80",
        "-o",
        trace_,
        "-e",
        "trace=pwrite64,write,fdatasync,fsync,unlink,ftruncate"};
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

TEST_F(AcknowledgementTest, FollowsTheFlushOfAllWrittenData) {
  const auto finished = traced(study_.folder(), {});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto seen = lookThrough(calls());
  EXPECT_EQ(seen.acknowledged, tests::acknowledgedIn(finished.out).size());
  EXPECT_GE(seen.acknowledged, 30U);
  EXPECT_TRUE(seen.tooEarly.empty()) << seen.tooEarly.front();
  RecordProperty("acknowledgements", static_cast<int>(seen.acknowledged));
}

TEST_F(AcknowledgementTest, IsDetectedIfItComesTooEarly) {
  // The positive control: the same calls with the flushes removed, or each moved behind its line.
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

/// A failure of the n-th call of a kind.
struct InjectedFault {
  const char* name;
  const char* calls;
  const char* effect;  ///< in strace's syntax
  const char* when;    ///< "" for the n-th only, "+" for all from there on
  int stride;          ///< in the long form
  int fewest;          ///< endings that the long form must reach to pass
};

void PrintTo(const InjectedFault& fault, std::ostream* out) {
  *out << fault.effect;
}

class InjectedFaultTest : public AcknowledgementTest,
                          public testing::WithParamInterface<InjectedFault> {
 protected:
  static constexpr int kKilled = -9;
  static constexpr int kCoarser = 7;  ///< the short form tries every seventh of these calls

  std::string copy() {
    std::string folder = study_.scratch() / "copy";
    fs::remove_all(folder);
    tests::forgetWhatWasSigned();
    fs::copy(study_.folder(), folder, fs::copy_options::recursive);
    return folder;
  }
};

TEST_P(InjectedFaultTest, LosesNoAcknowledgedAnswer) {
  const InjectedFault fault = GetParam();
  const int coarser = tests::inLongForm(1, kCoarser);
  int ended = 0;
  bool hasFired = true;
  for (int n = 1; hasFired; n += fault.stride * coarser) {
    const std::string what = std::string(fault.calls) + fault.effect + std::to_string(n);
    SCOPED_TRACE(what);
    const auto folder = copy();
    const auto finished = traced(folder, {"-e", "inject=" + what + fault.when});
    hasFired = finished.status == kKilled ||
               tests::contentOf(trace_).find("(INJECTED)") != std::string::npos;
    ended += finished.status != 0 ? 1 : 0;
    if (finished.status > 0) {
      EXPECT_NE(finished.error.find("the disk reports an error"), std::string::npos)
          << finished.error;
    }
    const auto acknowledged = tests::acknowledgedIn(finished.out);
    EXPECT_EQ(tests::whatIsLost(folder, acknowledged), "");
    EXPECT_LE(tests::keptBeyond(folder, acknowledged), 1U);
    ASSERT_EQ(tests::run(tests::simulation(folder, 1)).status, 0);  // start the program again
    EXPECT_EQ(tests::whatIsLost(folder, acknowledged), "");
    if (HasFailure()) return;
  }
  EXPECT_GE(ended, std::max(1, fault.fewest / coarser));
  std::cout << fault.name << ": ended " << ended << " times\n";
}

INSTANTIATE_TEST_SUITE_P(
    Of,
    InjectedFaultTest,
    testing::Values(
        InjectedFault{"AFlushThatFails", "fdatasync", ":error=EIO:when=", "", 1, 30},
        InjectedFault{"FlushesThatFailFromThenOn", "fdatasync", ":error=EIO:when=", "+", 1, 30},
        InjectedFault{"AProgramKilledInAFlush", "fdatasync", ":signal=KILL:when=", "", 1, 40},
        InjectedFault{"AProgramKilledInAWrite", "pwrite64", ":signal=KILL:when=", "", 11, 40},
        InjectedFault{"AProgramKilledBeforeItSaysSo", "write", ":signal=KILL:when=", "", 1, 30},
        InjectedFault{
            "AProgramKilledTidyingUp", "unlink,ftruncate", ":signal=KILL:when=", "", 1, 3}),
    [](const auto& fault) { return fault.param.name; });

}  // namespace acknowledgement_test
}  // namespace study
