// The n-th disk operation or memory allocation fails. The long form tries all of both (many
// minutes); the short one the first 12, and then a sample.
#include <iostream>

#include <gtest/gtest.h>

#include "study/storage/database.h"
#include "study/storage/study_schema.h"
#include "tests/study/storage/faults.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/scripted_session.h"
#include "tests/support/long_form.h"
#include "tests/support/scratch_folder.h"

namespace study {
namespace fault_test {

using tests::Arm;
using tests::Fault;

/// A way of failing.
struct Kind {
  const char* name;
  void (*arm)(const Fault&);
  std::int64_t (*disarm)();
  bool (*hasFired)();
  Arm when;
  bool isPersistent;
  int error;
  std::int64_t stride;  ///< step between the points that are tried after the first ones
  std::size_t fewest;   ///< points that the long form must reach; the short one an eighth
};

constexpr int kIoError = 5;    // EIO
constexpr int kNoRoom = 28;    // ENOSPC
constexpr int kNoQuota = 122;  // EDQUOT

class FaultTest : public testing::TestWithParam<Kind> {
 protected:
  static void SetUpTestSuite() { tests::memory_faults::install(); }
  void TearDown() override { GetParam().disarm(); }

  static std::int64_t stride() { return tests::isLong() ? 1 : GetParam().stride; }
  static std::size_t fewest() {
    return tests::isLong() ? GetParam().fewest : GetParam().fewest / 8;
  }
};

TEST_P(FaultTest, LosesNoAcknowledgedAnswerAndGivesAMessage) {
  const Kind kind = GetParam();
  tests::ScriptedStudy study;
  std::size_t points = 0;
  std::size_t complete = 0;
  for (std::int64_t n = 1;; n += n <= 12 ? 1 : stride()) {
    const auto folder = study.copy();
    const auto arm = [&] {
      kind.arm({.first = n, .isPersistent = kind.isPersistent, .error = kind.error});
    };
    const auto outcome = tests::runScript(folder, kind.when, arm);
    kind.disarm();
    const bool hasFired = kind.hasFired();
    const auto wrong = tests::whatIsWrongAfter(study, folder, outcome, points % 5 == 0);
    ASSERT_EQ(wrong, "") << kind.name << ", call " << n;
    if (!hasFired) {
      ASSERT_TRUE(outcome.isComplete);
      break;
    }
    ++points;
    complete += outcome.isComplete ? 1 : 0;
  }
  std::cout << kind.name << ": " << points << " points, " << complete << " of them overcome\n";
  RecordProperty("points", static_cast<int>(points));
  EXPECT_GE(points, fewest());
}

constexpr auto kDisk = [](const char* name, Arm when, bool isPersistent, int error) {
  return Kind{
      name,
      tests::io_faults::arm,
      tests::io_faults::disarm,
      tests::io_faults::hasFired,
      when,
      isPersistent,
      error,
      29,
      100};
};

constexpr auto kMemory = [](const char* name, Arm when, bool isPersistent) {
  return Kind{
      name,
      tests::memory_faults::arm,
      tests::memory_faults::disarm,
      tests::memory_faults::hasFired,
      when,
      isPersistent,
      0,
      1009,
      140};
};

INSTANTIATE_TEST_SUITE_P(
    Of,
    FaultTest,
    testing::Values(
        kDisk("ADiskThatFailsOnce", Arm::BeforeTheFirstCall, false, kIoError),
        kDisk("ADiskThatGoesOnFailing", Arm::BeforeTheFirstCall, true, kIoError),
        kDisk("ADiskThatIsFullForAMoment", Arm::BeforeTheFirstCall, false, kNoRoom),
        kDisk("ADiskThatStaysFull", Arm::BeforeTheFirstCall, true, kNoRoom),
        kDisk("ADiskThatFailsOnceFromTheStart", Arm::BeforeOpening, false, kIoError),
        kDisk("ADiskThatGoesOnFailingFromTheStart", Arm::BeforeOpening, true, kIoError),
        kMemory("MemoryThatIsShortOnce", Arm::BeforeTheFirstCall, false),
        kMemory("MemoryThatStaysShort", Arm::BeforeTheFirstCall, true),
        kMemory("MemoryThatIsShortOnceFromTheStart", Arm::BeforeOpening, false)),
    [](const auto& kind) { return kind.param.name; });

TEST(Faults, AreAFullDiskWhereTheAccountsQuotaIsUsedUp) {
  const tests::ScratchFolder folder;
  auto database = storage::Database::create(folder / "study.db", storage::studySchema());
  database.execute("CREATE TABLE note (words TEXT) STRICT");
  for (const int error : {kNoRoom, kNoQuota}) {
    for (std::int64_t n = 1;; ++n) {
      tests::io_faults::arm({.first = n, .isPersistent = true, .error = error});
      const auto refusal =
          tests::refusalOf([&] { database.execute("INSERT INTO note VALUES ('a note')"); });
      tests::io_faults::disarm();
      if (!tests::io_faults::hasFired()) {
        EXPECT_GT(n, 3) << "the control: something was written";
        break;
      }
      EXPECT_EQ(refusal.kind, storage::StorageError::Kind::DiskFull) << n << ": " << refusal.words;
      EXPECT_EQ(refusal.words.find("quota") != std::string::npos, error == kNoQuota);
    }
  }
}

TEST(Faults, AreNotReportedWithoutAFault) {
  tests::ScriptedStudy study;
  const auto folder = study.copy();
  const auto outcome = tests::runScript(folder, Arm::BeforeOpening, [] {});
  EXPECT_TRUE(outcome.isComplete) << outcome.error;
  EXPECT_EQ(tests::whatIsWrongAfter(study, folder, outcome, true), "");
}

TEST(Faults, AreDetectedByThisTestIfDataAreLost) {
  // The positive control: one acknowledgement too many is found as a loss.
  tests::ScriptedStudy study;
  const auto folder = study.copy();
  auto outcome = tests::runScript(folder, Arm::BeforeTheFirstCall, [] {
    tests::io_faults::arm({.first = 20, .isPersistent = true});
  });
  tests::io_faults::disarm();
  ASSERT_FALSE(outcome.isComplete);
  outcome.acknowledged += 2;
  EXPECT_NE(tests::whatIsWrongAfter(study, folder, outcome, false), "");
}

}  // namespace fault_test
}  // namespace study
