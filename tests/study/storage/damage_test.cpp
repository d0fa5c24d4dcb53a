// A flipped bit, a page of zeros, a truncated file: damage is detected, or changes no stored value.
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include <gtest/gtest.h>

#include "study/cohort/simulated_participant.h"
#include "study/session/verification.h"
#include "study/storage/statement.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"
#include "tests/support/long_form.h"

namespace study {
namespace damage_test {

namespace fs = std::filesystem;

constexpr std::uint64_t kPage = 4096;  // [bytes]
constexpr const char* kName = "Zaphod Beeblebrox";

class DamageTest : public testing::Test {
 protected:
  void SetUp() override {
    simulateCohorts(*study_, study_.clock, 1, 7, [](const auto&) {});
    {
      auto session = Session::enrol(*study_, {.cohort = "surgeons"});
      auto signature = tests::answerTo(session, session.items().back());
      signature.response = std::string(kName);
      session.record(signature);
    }
    whole_ = everythingIn(*study_);
    study_.close();
    for (const auto* file : {"study.db", "traces.db", "identity.db"}) {
      tests::Sql(study_.file(file)).run("PRAGMA wal_checkpoint(TRUNCATE)");
    }
  }

  /// Every value of every table, with its type.
  static std::string everythingIn(Study& study) {
    std::string all;
    for (auto* database :
         {&study.database(), &study.traces().database(), &study.identities().database()}) {
      storage::Statement tables(
          *database, "SELECT name FROM sqlite_master WHERE type = 'table' ORDER BY name");
      while (tables.step()) {
        all += tables.text(0) + "\n";
        const auto name = tables.text(0);
        const bool isNarrow = name == "blinding_secret" || name == "fingerprint_key";
        storage::Statement rows(
            *database,
            "SELECT * FROM " + tables.text(0) + " ORDER BY " + (isNarrow ? "1" : "1, 2, 3"));
        while (rows.step()) {
          for (int column = 0; column < rows.columnCount(); ++column) {
            const auto bytes = rows.exactBytes(column);
            all.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
          }
        }
      }
    }
    return all;
  }

  /// The bytes of the sealed name.
  std::string sealedName() const {
    const auto digits =
        tests::Sql(study_.file("identity.db"))
            .text("SELECT hex(sealed) FROM identifying_answer WHERE sealed IS NOT NULL");
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2) {
      bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    }
    return bytes;
  }

  std::string copy() {
    std::string folder = study_.scratch() / "damaged";
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

  bool hasOnlyZerosAfter(const std::string& name, std::uint64_t place) const {
    const auto rest = tests::contentOf(study_.file(name)).substr(place);
    return rest.find_first_not_of('\0') == std::string::npos;
  }

  static void blank(const std::string& file, std::uint64_t page) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(page * kPage));
    stream << std::string(kPage, '\0');
  }

  /// The number of damaged copies by outcome.
  struct Outcome {
    int refused = 0;   ///< not opened, with a message for the operator
    int reported = 0;  ///< found by the verification
    int harmless = 0;  ///< every value of every table is unchanged
    int missed = 0;
    int found() const { return refused + reported; }
  };

  /// Damages the file @p name of a fresh copy, and counts the outcome.
  void lookAfter(
      const std::string& name, const std::function<void(const std::string& file)>& damage) {
    const auto folder = copy();
    damage(folder + ("/" + name));
    SimulatedClock clock;
    try {
      auto study = Study::open(folder, clock, storage::Database::Access::ReadOnly);
      if (!verify(study).isSound()) {
        ++outcome_.reported;
      } else {
        ++(everythingIn(study) == whole_ ? outcome_.harmless : outcome_.missed);
      }
    } catch (const storage::StorageError& error) {
      ++(std::string(error.what()).size() > 40 ? outcome_.refused : outcome_.missed);
    }
    EXPECT_EQ(outcome_.missed, 0);
  }

  void report(const char* what) const {
    std::cout << what << ": " << outcome_.refused << " refused, " << outcome_.reported
              << " reported, " << outcome_.harmless << " harmless, " << outcome_.missed
              << " missed\n";
  }

  std::uint64_t sizeOf(const std::string& name) const { return fs::file_size(study_.file(name)); }

  tests::MadeStudy study_;
  std::string whole_;
  Outcome outcome_;
};

TEST_F(DamageTest, OfASingleBitIsDetectedOrChangesNoValue) {
  const int flips = tests::inLongForm(3000, 100);
  const std::array<std::string, 4> names{"study.db", "study.db", "traces.db", "identity.db"};
  std::mt19937_64 random(20261121);
  for (int i = 0; i < flips; ++i) {
    const auto& name = names[static_cast<std::size_t>(i) % names.size()];
    const std::uint64_t bit = random() % (sizeOf(name) * 8);
    SCOPED_TRACE("bit " + std::to_string(bit) + " of " + name);
    lookAfter(name, [&](const std::string& file) { flip(file, bit); });
  }
  report("bits");
  EXPECT_GE(outcome_.found(), flips / 10);
}

TEST_F(DamageTest, OfANameIsAlwaysDetected) {
  const auto sealed = sealedName();
  const auto where = tests::contentOf(study_.file("identity.db")).find(sealed);
  ASSERT_NE(where, std::string::npos);
  const std::uint64_t bits = sealed.size() * 8;
  const auto stride = static_cast<std::uint64_t>(tests::inLongForm(1, 7));  // a bit of each byte
  for (std::uint64_t bit = 0; bit < bits; bit += stride) {
    SCOPED_TRACE("bit " + std::to_string(bit));
    lookAfter("identity.db", [&](const std::string& file) { flip(file, where * 8 + bit); });
  }
  report("bits of a name");
  EXPECT_EQ(outcome_.found(), static_cast<int>((bits + stride - 1) / stride));
}

TEST_F(DamageTest, OfAWholePageIsDetectedOrChangesNoValue) {
  for (const std::string name : {"study.db", "traces.db"}) {
    const std::uint64_t pages = sizeOf(name) / kPage;
    for (std::uint64_t page = 0; page < pages; page += page < 40 ? 1 : 7) {
      SCOPED_TRACE("page " + std::to_string(page) + " of " + name);
      lookAfter(name, [&](const std::string& file) { blank(file, page); });
    }
  }
  report("pages");
  EXPECT_GE(outcome_.found(), 60);
  EXPECT_LE(outcome_.harmless, 5);  // pages that contain free space only
}

TEST_F(DamageTest, ByTruncationIsAlwaysDetected) {
  for (const std::string name : {"study.db", "traces.db", "identity.db"}) {
    const std::uint64_t size = sizeOf(name);
    for (std::uint64_t part = 0; part < size; part += kPage * (1 + size / kPage / 20)) {
      SCOPED_TRACE(name + " of " + std::to_string(part) + " bytes");
      lookAfter(name, [&](const std::string& file) { fs::resize_file(file, part); });
      // The end of a table without rows is zeros, which SQLite reads where a page is cut short.
      if (hasOnlyZerosAfter(name, part + 777)) continue;
      lookAfter(name, [&](const std::string& file) { fs::resize_file(file, part + 777); });
    }
  }
  report("cut off");
  EXPECT_GE(outcome_.found(), 40);
  EXPECT_EQ(outcome_.harmless, 0);
}

TEST_F(DamageTest, IsNotReportedForAnIntactCopy) {
  lookAfter("study.db", [](const auto&) {});
  EXPECT_EQ(outcome_.harmless, 1);
}

TEST_F(DamageTest, IsSeenByThisTestInARowThatTheProgramDoesNotCheck) {
  // The control: a row that no check reads makes the copy different.
  const std::string lease =
      "INSERT INTO lease (session_id, station, pid, taken_utc, process) VALUES (1, 'x', 1, '', '')";
  const auto folder = copy();
  tests::Sql(folder + "/study.db").run(lease);
  SimulatedClock clock;
  auto study = Study::open(folder, clock);
  EXPECT_TRUE(verify(study).isSound());  // leases are not part of a study's results
  EXPECT_NE(everythingIn(study), whole_);
}

}  // namespace damage_test
}  // namespace study
