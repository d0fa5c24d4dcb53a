#include "study/storage/station_store.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>

#include "study/model/storage_error.h"
#include "tests/support/scratch_folder.h"

namespace study::storage {
namespace station_store_test {

namespace fs = std::filesystem;

mode_t rightsOf(const fs::path& path) {
  struct stat facts {};
  return stat(path.c_str(), &facts) == 0 ? facts.st_mode & 0777U : 0U;
}

class StationStoreTest : public testing::Test {
 protected:
  tests::ScratchFolder scratch_;
  const fs::path folder_ = scratch_.path() / "data" / "station";
};

TEST_F(StationStoreTest, IsMadeOnFirstUseAndIsTheSameAfterwards) {
  EXPECT_FALSE(StationStore::find(folder_));
  EXPECT_FALSE(fs::exists(folder_)) << "looking makes nothing";
  const auto made = StationStore::openOrCreate(folder_);
  const auto found = StationStore::find(folder_);
  ASSERT_TRUE(found);
  EXPECT_EQ(made.uuid().size(), 32U);
  EXPECT_EQ(found->uuid(), made.uuid());
  EXPECT_EQ(found->publicKey(), made.publicKey());
  EXPECT_EQ(found->sign("a"), made.sign("a"));
}

TEST_F(StationStoreTest, IsForItsOwnerAlone) {
  const auto before = umask(0);
  StationStore::openOrCreate(folder_).append("list", "line");
  umask(before);
  EXPECT_EQ(rightsOf(folder_), 0700U);
  EXPECT_EQ(rightsOf(folder_ / "key"), 0600U);
  EXPECT_EQ(rightsOf(folder_ / "list"), 0600U);
  fs::permissions(folder_ / "key", fs::perms::group_read, fs::perm_options::add);
  EXPECT_THROW(StationStore::find(folder_), StorageError);
}

TEST_F(StationStoreTest, TellsItsSignatureFromThoseOfOthers) {
  const auto store = StationStore::openOrCreate(folder_);
  const auto other = StationStore::openOrCreate(scratch_.path() / "other");
  EXPECT_NE(other.publicKey(), store.publicKey());
  const auto signature = store.sign("812 events");
  EXPECT_TRUE(StationStore::isSigned("812 events", signature, store.publicKey()));
  EXPECT_FALSE(StationStore::isSigned("813 events", signature, store.publicKey()));
  EXPECT_FALSE(StationStore::isSigned("812 events", signature, other.publicKey()));
  EXPECT_FALSE(StationStore::isSigned("812 events", other.sign("812 events"), store.publicKey()));
  EXPECT_FALSE(StationStore::isSigned("812 events", "", store.publicKey()));
  EXPECT_FALSE(StationStore::isSigned("812 events", signature + "00", store.publicKey()));
  EXPECT_FALSE(StationStore::isSigned("812 events", signature, "no key"));
}

/// RFC 8032, section 7.1, test 2: the key, and its signature of the byte 0x72.
TEST_F(StationStoreTest, SignsAsTheStandardSays) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "key")
      << "palpate station 1\n00112233445566778899aabbccddeeff\n"
         "4ccd089b28ff96da9db6c346ec114e0f5b8a319f35aba624da8cf6ed4fb8a6fb\n";
  fs::permissions(folder_ / "key", fs::perms::owner_read | fs::perms::owner_write);
  const auto store = StationStore::find(folder_);
  ASSERT_TRUE(store);
  EXPECT_EQ(store->publicKey(), "3d4017c3e843895a92b70aa74d1b7ebc9c982ccf2ec4968cc0cd55f12af4660c");
  EXPECT_EQ(
      store->sign("\x72"),
      "92a009a9f0d4cab8720e820b5f642540a2b27b5416503f8fb3762223ebdb69da"
      "085ac1e43e15996e458f3613d0f11d8c387b2eaeb4302aeeb00d291612bb0c00");
}

TEST_F(StationStoreTest, HasOneKeyAlthoughSeveralProgramsMakeIt) {
  constexpr std::size_t kPrograms = 8;
  std::vector<std::string> keys(kPrograms);
  {
    std::vector<std::jthread> programs;
    for (auto& key : keys) {
      programs.emplace_back([&] { key = StationStore::openOrCreate(folder_).publicKey(); });
    }
  }
  EXPECT_EQ(keys, std::vector<std::string>(kPrograms, keys.front()));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
}

TEST_F(StationStoreTest, KeepsLists) {
  const auto store = StationStore::openOrCreate(folder_);
  EXPECT_TRUE(store.lines("heads-1").empty());
  store.append("heads-1", "1 a");
  store.append("heads-2", "1 b");
  StationStore::openOrCreate(folder_).append("heads-1", "2 c");
  EXPECT_EQ(store.lines("heads-1"), (std::vector<std::string>{"1 a", "2 c"}));
  EXPECT_EQ(store.lines("heads-2"), std::vector<std::string>{"1 b"});
}

TEST_F(StationStoreTest, LeavesNoPartOfALineThatItCannotWriteWhole) {
  const auto store = StationStore::openOrCreate(folder_);
  store.append("list", "first");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  auto* handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit full = before;
  full.rlim_cur = 10;  // "first" and its end take 6 bytes
  setrlimit(RLIMIT_FSIZE, &full);
  EXPECT_THROW(store.append("list", "second line"), StorageError);
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  store.append("list", "third");
  EXPECT_EQ(store.lines("list"), (std::vector<std::string>{"first", "third"}));
}

TEST_F(StationStoreTest, BeginsALineAfterAPartOfOne) {
  const auto store = StationStore::openOrCreate(folder_);
  std::ofstream(folder_ / "list") << "first\nsec";
  store.append("list", "third");
  EXPECT_EQ(store.lines("list"), (std::vector<std::string>{"first", "sec", "third"}));
}

TEST_F(StationStoreTest, SaysWhatCannotBeUsed) {
  scratch_.write("file", "");
  EXPECT_THROW(StationStore::openOrCreate(scratch_.path() / "file" / "station"), StorageError);
  EXPECT_THROW(StationStore::openOrCreate({}), StorageError);
  fs::create_directories(folder_);
  std::ofstream(folder_ / "key") << "palpate station 2\nx\ny\n";
  fs::permissions(folder_ / "key", fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_THROW(StationStore::openOrCreate(folder_), StorageError);
}

TEST_F(StationStoreTest, LiesInTheDataFolderOfTheAccount) {
  const char* set = std::getenv("PALPATE_STATION");  // NOLINT(concurrency-mt-unsafe): one thread
  const std::string before = set == nullptr ? "" : set;
  setenv("PALPATE_STATION", folder_.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  EXPECT_EQ(StationStore::defaultFolder(), folder_);
  unsetenv("PALPATE_STATION");                          // NOLINT(concurrency-mt-unsafe)
  setenv("XDG_DATA_HOME", scratch_.path().c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
  EXPECT_EQ(StationStore::defaultFolder(), scratch_.path() / "palpate" / "station");
  unsetenv("XDG_DATA_HOME");  // NOLINT(concurrency-mt-unsafe)
  EXPECT_TRUE(StationStore::defaultFolder().string().ends_with(".local/share/palpate/station"));
  if (set != nullptr) setenv("PALPATE_STATION", before.c_str(), 1);  // NOLINT
}

}  // namespace station_store_test
}  // namespace study::storage
