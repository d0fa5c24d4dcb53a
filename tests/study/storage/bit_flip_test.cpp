// A bit that turns over by itself is found, or changes nothing that anybody could read:
// reliability.md, F7.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "study/export.h"
#include "study/simulated_participant.h"
#include "study/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"

namespace study {
namespace {

namespace fs = std::filesystem;

constexpr int kFlips = 400;

class BitFlipTest : public testing::Test {
 protected:
  void SetUp() override {
    simulateCohorts(*study_, study_.clock, 1, 7, [](const std::string&) {});
    whole_ = everythingIn(*study_);
    study_.close();
    for (const auto* file : {"study.db", "traces.db"}) {
      tests::Sql(study_.file(file)).run("PRAGMA wal_checkpoint(TRUNCATE)");
    }
  }

  /// All that can be read out of a study, as text.
  static std::string everythingIn(Study& study) {
    std::string all = study.protocol().text;
    for (const auto& table : exportTables(study, {.isBlinded = false})) all += asCsv(table);
    for (const auto& visit : study.traces().visits()) {
      for (const auto& sample : study.traces().read(visit)) {
        all += std::to_string(sample.tick) + exactly(static_cast<double>(sample.force));
      }
    }
    return all;
  }

  std::string copy() {
    const std::string folder = study_.scratch() / "flipped";
    fs::remove_all(folder);
    fs::copy(study_.folder(), folder, fs::copy_options::recursive);
    return folder;
  }

  static void flip(const std::string& file, std::uint64_t bit) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekg(static_cast<std::streamoff>(bit / 8));
    const char byte = static_cast<char>(stream.get() ^ (1 << (bit % 8)));
    stream.seekp(static_cast<std::streamoff>(bit / 8));
    stream.put(byte);
  }

  enum class Found { Refused, Reported, Harmless, Missed };

  Found lookAt(const std::string& folder) {
    SimulatedClock clock;
    try {
      auto study = Study::open(folder, clock, storage::Database::Access::ReadOnly);
      if (!verify(study).isSound()) return Found::Reported;
      return everythingIn(study) == whole_ ? Found::Harmless : Found::Missed;
    } catch (const std::exception&) {
      return Found::Refused;
    }
  }

  tests::MadeStudy study_;
  std::string whole_;
};

TEST_F(BitFlipTest, IsFoundOrChangesNothing) {
  std::mt19937_64 random(20261121);
  std::map<Found, int> counts;
  for (int i = 0; i < kFlips; ++i) {
    const std::string name = i % 4 == 3 ? "traces.db" : "study.db";
    const auto folder = copy();
    const std::uint64_t bits = fs::file_size(folder + "/" + name) * 8;
    const std::uint64_t bit = random() % bits;
    flip(folder + "/" + name, bit);
    const auto found = lookAt(folder);
    ++counts[found];
    EXPECT_NE(found, Found::Missed) << "bit " << bit << " of " << name;
  }
  std::cout << kFlips << " flips: " << counts[Found::Refused] << " refused, "
            << counts[Found::Reported] << " reported, " << counts[Found::Harmless] << " harmless, "
            << counts[Found::Missed] << " missed\n";
  EXPECT_GE(counts[Found::Refused] + counts[Found::Reported], kFlips / 10);
}

TEST_F(BitFlipTest, IsNothingWhereNothingWasFlipped) {
  EXPECT_EQ(lookAt(copy()), Found::Harmless);
}

}  // namespace
}  // namespace study
