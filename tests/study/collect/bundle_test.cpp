// Files for hospitals without a network.
#include "study/collect/exchange/bundle.h"

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "study/collect/exchange/administration.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/server/registry.h"
#include "study/model/storage_error.h"
#include "study/model/user_error.h"
#include "study/storage/study_schema.h"
#include "tests/study/collect/collected_study_at.h"

namespace bundle_test {

class Bundles : public tests::CollectTest {
 protected:
  std::string bundleOf(const std::string& label, std::int64_t after, const std::string& name) {
    const auto account = accountOf(label);
    study::collect::Outbox outbox(folderOf(label), clock_);
    const auto station =
        study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
    const auto home = study::collect::serverSettingsOf(folderOf(label));
    last_ =
        study::collect::writeBundle(outbox, station, home.bundleKey, after, scratch_ / name).last;
    return scratch_ / name;
  }

  std::int64_t take(const std::string& file) {
    auto server = admin();
    return study::collect::ingestBundle(server, file).lastEvent;
  }

  void expectRefused(const std::string& file) {
    EXPECT_THROW(take(file), study::UserError) << file;
  }

  std::int64_t last_ = 0;
};

TEST_F(Bundles, BringEverythingAndMayComeTwice) {
  addStation("oslo");
  simulate("oslo", 2);
  runSession("oslo");
  const auto file = bundleOf("oslo", 0, "a.bundle");
  EXPECT_EQ(take(file), last_);
  EXPECT_EQ(take(file), last_);
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
  EXPECT_EQ(push("oslo").before, last_);
}

TEST_F(Bundles, ComeInTheirOrder) {
  addStation("oslo");
  runSession("oslo");
  const auto first = bundleOf("oslo", 0, "first.bundle");
  const auto end = last_;
  runSession("oslo");
  const auto second = bundleOf("oslo", end, "second.bundle");
  expectRefused(second);
  EXPECT_TRUE(contentOfServer().empty());
  EXPECT_EQ(take(first), end);
  EXPECT_EQ(take(second), last_);
  EXPECT_EQ(take(first), last_) << "an older one changes nothing";
  EXPECT_EQ(contentOfServer(), contentOf({folderOf("oslo")}));
}

TEST_F(Bundles, ThatWereChangedOrCutOffAreRefused) {
  addStation("oslo");
  runSession("oslo");
  const auto file = bundleOf("oslo", 0, "a.bundle");
  const auto whole = tests::contentOf(file);
  for (const std::size_t at : {std::size_t{20}, whole.size() / 2, whole.size() - 3}) {
    auto changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    expectRefused(scratch_.write("changed-" + std::to_string(at), changed));
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{10}, std::size_t{100}, whole.size() / 2, whole.size() - 1}) {
    expectRefused(scratch_.write("cut-" + std::to_string(size), whole.substr(0, size)));
  }
  expectRefused(scratch_ / "none");
  EXPECT_TRUE(contentOfServer().empty());
  EXPECT_EQ(take(file), last_) << "the control: unchanged it is taken";
}

TEST_F(Bundles, OfAnotherStationsKeyAreRefused) {
  addStation("oslo");
  runSession("oslo");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  const auto other = study::storage::StationStore::openOrCreate(scratch_ / "somebody else");
  const auto home = study::collect::serverSettingsOf(folderOf("oslo"));
  study::collect::writeBundle(outbox, other, home.bundleKey, 0, scratch_ / "forged");
  expectRefused(scratch_ / "forged");
}

TEST_F(Bundles, OfAStudyThatWasChangedOnItsStationAreRefused) {
  addStation("oslo");
  runSession("oslo");
  const auto file = bundleOf("oslo", 0, "sound.bundle");
  {
    auto database = study::storage::Database::open(
        folderOf("oslo") + "/study.db",
        study::storage::studySchema(),
        study::storage::Database::Access::ReadWrite);
    database.execute("UPDATE visit SET reason = 'another' WHERE step = 2");
  }
  expectRefused(bundleOf("oslo", 0, "changed.bundle"));
  EXPECT_TRUE(contentOfServer().empty());
  EXPECT_EQ(incidents(), std::vector<std::string>{"bundle"});
  EXPECT_EQ(take(file), last_) << "the control: as it was before it is taken";
}

TEST_F(Bundles, AreNotMadeAfterAnEventThatIsNotThere) {
  addStation("oslo");
  runSession("oslo");
  const auto reason = [&](std::int64_t after) -> std::string {
    try {
      bundleOf("oslo", after, "none.bundle");
    } catch (const study::UserError& error) {
      return error.what();
    }
    return {};
  };
  bundleOf("oslo", 0, "a.bundle");  // says which is the last
  EXPECT_NE(reason(last_ + 1).find("none of them"), std::string::npos) << reason(last_ + 1);
  EXPECT_NE(reason(last_).find("everything already"), std::string::npos) << reason(last_);
}

TEST_F(Bundles, ThatDoNotFitOnTheDiskAreRemoved) {
  addStation("oslo");
  runSession("oslo");
  const auto account = accountOf("oslo");
  study::collect::Outbox outbox(folderOf("oslo"), clock_);
  const auto home = study::collect::serverSettingsOf(folderOf("oslo"));
  const auto station =
      study::storage::StationStore::openOrCreate(study::storage::StationStore::defaultFolder());
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{.rlim_cur = 100, .rlim_max = before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  EXPECT_THROW(
      study::collect::writeBundle(outbox, station, home.bundleKey, 0, scratch_ / "full"),
      study::storage::StorageError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "full"));
}

TEST_F(Bundles, TellNothingToWhoeverFindsThem) {
  addStation("oslo");
  runSession("oslo");
  const auto content = tests::contentOf(bundleOf("oslo", 0, "a.bundle"));
  for (const auto* word : {"oslo_P001", "surgeons", "interpolation", "answered"}) {
    EXPECT_EQ(content.find(word), std::string::npos) << word;
  }
}

}  // namespace bundle_test
