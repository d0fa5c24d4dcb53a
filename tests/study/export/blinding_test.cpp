// What a study's secret hides: codes of conditions, and which condition takes which part in the
// orders.
#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "protocols/orders/schedule.h"
#include "study/export/condition_codes.h"
#include "study/export/export.h"
#include "study/model/session_plan.h"
#include "study/model/user_error.h"
#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/refusals.h"
#include "tests/study/storage/sql.h"
#include "tests/study/walk.h"

namespace study {
namespace blinding_test {

namespace fs = std::filesystem;
using storage::BlindingSecret;
using Names = std::vector<std::string>;

BlindingSecret secretNumber(unsigned number) {
  BlindingSecret::Bytes bytes{};
  bytes[0] = static_cast<unsigned char>(number & 0xffU);
  bytes[1] = static_cast<unsigned char>(number >> 8U);
  return BlindingSecret(bytes);
}

// Python: sorted(ids, key=lambda i: hashlib.blake2b((purpose + "/" + i).encode(), digest_size=32,
// key=bytes(range(32))).hexdigest())
TEST(BlindingSecret, ArrangesByKeyedHashes) {
  const auto arranged = [](std::string_view purpose) {
    Names ids{"kalman", "interpolation", "finite-elements"};
    tests::knownSecret().arrange(ids, purpose);
    return ids;
  };
  EXPECT_EQ(arranged("codes/live"), (Names{"finite-elements", "interpolation", "kalman"}));
  EXPECT_EQ(arranged("codes/pilot"), (Names{"interpolation", "kalman", "finite-elements"}));
  EXPECT_EQ(arranged("orders/pilot"), (Names{"finite-elements", "kalman", "interpolation"}));
  EXPECT_EQ(
      tests::knownSecret().commitment(),
      "b99a81757331699d82e4f03281548a415c2b8e2c5b65e58e111b150b576f9014");
}

TEST(BlindingSecret, MakesAllOrdersEquallyLikely) {
  std::map<Names, int> times;
  for (unsigned number = 0; number < 6000; ++number) {
    Names ids{"a", "b", "c"};
    secretNumber(number).arrange(ids, "codes/live");
    ++times[ids];
  }
  ASSERT_EQ(times.size(), 6U);
  double chiSquare = 0.0;
  for (const auto& [order, count] : times) chiSquare += (count - 1000.0) * (count - 1000.0) / 1000;
  EXPECT_LT(chiSquare, 20.5);  // R: qchisq(0.999, 5)
}

/// Whether a person who knows protocol and seed names every condition of the first session, of
/// which a blinded export shows the code in each step.
bool isNamedByTheSeed(Study& study, RunMode mode) {
  auto session = Session::enrol(study, {.cohort = "surgeons", .runMode = mode});
  const auto& protocol = study.protocol().protocol;
  const auto computed = sessionPlan(
      protocol,
      protocols::scheduleFor(
          protocol, study.seed(), "surgeons", static_cast<std::uint64_t>(session.slot())));
  const auto codes = conditionCodes(study, mode);
  std::map<std::string, std::string> guesses;
  for (const auto& [step, condition] : storage::allocationOf(study.database(), session.id())) {
    guesses[codes.at(condition)] = computed.at(static_cast<std::size_t>(step)).condition;
  }
  return std::all_of(codes.begin(), codes.end(), [&](const auto& code) {
    return guesses.at(code.second) == code.first;
  });
}

int namedOf(int studies, RunMode mode) {
  int named = 0;
  for (int i = 0; i < studies; ++i) {
    const auto secret = secretNumber(static_cast<unsigned>(i));
    tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol()), 7, secret);
    named += isNamedByTheSeed(*study, mode) ? 1 : 0;
  }
  return named;
}

TEST(Blinding, TellsNothingToWhoeverKnowsTheSeed) {
  // One of six by chance. R: qbinom(0.999, 48, 1 / 6) = 17
  EXPECT_LE(namedOf(48, RunMode::Live), 17);
  EXPECT_LE(namedOf(48, RunMode::Pilot), 17);
  // The same attack finds the codes of sessions that have nothing to hide.
  EXPECT_EQ(namedOf(4, RunMode::Simulated), 4);
}

TEST(Blinding, KeepsTheOrdersOfAProtocolThatPromisesThem) {
  auto text = tests::shortProtocol();
  text.insert(text.find(R"("languages")"), R"("seed": 5, )");
  for (unsigned number = 0; number < 4; ++number) {
    tests::MadeStudy study(tests::protocolFrom(text), 5, secretNumber(number));
    const auto& protocol = study->protocol().protocol;
    const auto session = Session::enrol(*study, {.cohort = "surgeons"});
    const auto plan = sessionPlan(protocol, protocols::scheduleFor(protocol, 5, "surgeons", 0));
    for (const auto& [step, condition] : storage::allocationOf(study->database(), session.id())) {
      EXPECT_EQ(plan.at(static_cast<std::size_t>(step)).condition, condition);
    }
  }
}

TEST(Blinding, HasASecretOfItsOwnInEveryStudy) {
  const tests::ScratchFolder folder;
  SimulatedClock clock;
  const auto protocol = tests::protocolFrom(tests::shortProtocol());
  auto one = Study::create(folder / "one", protocol, clock, 7);
  auto other = Study::create(folder / "other", protocol, clock, 7);
  EXPECT_NE(one.uuid(), other.uuid()) << "who tries seeds finds none";
  EXPECT_NE(one.secretFor(RunMode::Live)->bytes(), other.secretFor(RunMode::Live)->bytes());
}

TEST(Blinding, GivesStudiesOfOneSeedOtherCodes) {
  const auto codes = [](unsigned number, RunMode mode) {
    tests::MadeStudy study(tests::protocolFrom(tests::shortProtocol()), 7, secretNumber(number));
    return conditionCodes(*study, mode);
  };
  EXPECT_NE(codes(1, RunMode::Live), codes(2, RunMode::Live));
  EXPECT_NE(codes(1, RunMode::Live), codes(1, RunMode::Pilot));
  EXPECT_EQ(codes(1, RunMode::Simulated), codes(2, RunMode::Simulated));
}

std::map<std::string, std::string> contentsOf(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    contents[fs::relative(entry.path(), folder).string()] = tests::contentOf(entry.path());
  }
  return contents;
}

std::string hexadecimal(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += kDigits[static_cast<unsigned char>(c) >> 4U];
    text += kDigits[static_cast<unsigned char>(c) & 15U];
  }
  return text;
}

class BlindedStudy : public testing::Test {
 protected:
  BlindedStudy() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
  }

  /// The files without the head of the audit trail, to which every export adds an event.
  std::map<std::string, std::string> exported(const std::string& name, ExportFormat format) {
    const auto folder = study_.scratch() / name;
    exportStudy(*study_, folder, {.format = format, .runMode = RunMode::Live});
    auto contents = contentsOf(folder);
    const auto head = study_->events().headAsText();
    for (auto& [file, content] : contents) {
      if (const auto at = content.find(head); at != std::string::npos) {
        content.erase(at, head.size());
      }
    }
    return contents;
  }

  tests::MadeStudy study_;
};

TEST_F(BlindedStudy, HasOtherCodesInEachExport) {
  std::set<std::map<std::string, std::string>> arrangements;
  std::set<std::string> sets;
  for (int number = 0; number < 12; ++number) {
    const auto name = "export-" + std::to_string(number);
    exported(name, ExportFormat::Csv);
    const auto set = codeSetOf(study_.scratch() / name);
    sets.insert(set);
    arrangements.insert(conditionCodes(*study_, RunMode::Live, set));
  }
  EXPECT_EQ(sets.size(), 12U);
  EXPECT_GE(arrangements.size(), 3U) << "12 draws of 6 arrangements";
}

TEST_F(BlindedStudy, HasTheCodesOfAnEarlierExportWhereTheyAreAskedFor) {
  for (const auto format :
       {ExportFormat::Csv, ExportFormat::Json, ExportFormat::PsychDs, ExportFormat::Bids}) {
    const auto name = "of-" + std::to_string(static_cast<int>(format));
    exported(name, format);
    const auto set = codeSetOf(study_.scratch() / name);
    const auto again = study_.scratch() / (name + "-again");
    study_.reopen();
    exportStudy(*study_, again, {.format = format, .runMode = RunMode::Live, .codes = set});
    EXPECT_EQ(codeSetOf(again), set);
    if (format != ExportFormat::Csv) continue;
    EXPECT_EQ(
        tests::contentOf(again + "/responses.csv"),
        tests::contentOf(study_.scratch() / (name + "/responses.csv")));
  }
  EXPECT_THROW(codeSetOf(study_.folder()), UserError);
}

TEST_F(BlindedStudy, NamesTheConditionsOfACodedExportWithItsCodes) {
  exported("blinded", ExportFormat::Csv);
  const auto set = codeSetOf(study_.scratch() / "blinded");
  const auto unblinded = study_.scratch() / "unblinded";
  exportStudy(
      *study_,
      unblinded,
      {.runMode = RunMode::Live, .isBlinded = false, .codes = set},
      "the analysis is done");
  const auto responses = tests::contentOf(unblinded + "/responses.csv");
  for (const auto& [condition, code] : conditionCodes(*study_, RunMode::Live, set)) {
    EXPECT_NE(responses.find("," + code + "," + condition + ","), std::string::npos) << code;
  }
  EXPECT_EQ(study_->events().read().rbegin()[3].value("codes") != nullptr, true);
}

TEST_F(BlindedStudy, DrawsNoCodesForSimulatedSessions) {
  const auto out = study_.scratch() / "simulated";
  exportStudy(*study_, out, {.runMode = RunMode::Simulated});
  EXPECT_THROW(codeSetOf(out), UserError);
  EXPECT_THROW(
      exportStudy(*study_, out + "-2", {.runMode = RunMode::Simulated, .codes = drawnCodeSet()}),
      storage::StorageError);
}

TEST_F(BlindedStudy, HasItsSecretInNoFile) {
  const auto bytes = study_->secretFor(RunMode::Live)->bytes();
  const std::string secret(bytes.begin(), bytes.end());
  const auto holds = [&](const std::string& content) {
    return content.find(secret) != std::string::npos ||
           content.find(hexadecimal(secret)) != std::string::npos;
  };
  for (const auto format :
       {ExportFormat::Csv, ExportFormat::Json, ExportFormat::PsychDs, ExportFormat::Bids}) {
    const auto name = "export-" + std::to_string(static_cast<int>(format));
    for (const auto& [file, content] : exported(name, format)) EXPECT_FALSE(holds(content)) << file;
  }
  study_.close();
  for (const auto& [file, content] : contentsOf(study_.folder()))
    EXPECT_FALSE(holds(content)) << file;
  // The control: the station has it.
  const auto station = storage::StationStore::defaultFolder();
  EXPECT_TRUE(holds(tests::contentOf(station / "study-keys")));
}

/// Nobody is kept blind in it: the secret lies in the folder.
class OpenStudy : public testing::Test {
 protected:
  static protocols::LoadedProtocol openProtocol() {
    auto text = tests::shortProtocol();
    text.insert(text.find(R"("languages")"), R"("blinding": "open", )");
    return tests::protocolFrom(text);
  }

  OpenStudy() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkToTheEnd(session);
  }

  tests::MadeStudy study_{openProtocol()};
};

TEST_F(OpenStudy, NoticesThatItsSecretIsAnother) {
  EXPECT_TRUE(verify(*study_).isSound());
  study_.close();
  tests::Sql identities(study_.file("identity.db"));
  EXPECT_TRUE(identities.refuses("UPDATE blinding_secret SET bytes = zeroblob(32)"));
  EXPECT_TRUE(identities.refuses("DELETE FROM blinding_secret"));
  identities.run(
      "DROP TRIGGER a_secret_is_never_changed; "
      "UPDATE blinding_secret SET bytes = zeroblob(32)");
  study_.reopen();
  EXPECT_FALSE(verify(*study_).isSound());
  const auto folder = study_.scratch() / "refused";
  tests::expectClear(
      tests::refusalOf([&] { exportStudy(*study_, folder, {.runMode = RunMode::Live}); }),
      "Restore it from a copy");
  EXPECT_FALSE(fs::exists(folder));
}

}  // namespace blinding_test
}  // namespace study
