// Creates studies.
#include <utility>

#include <sodium.h>

#include "base/random.h"
#include "study/model/new_file.h"
#include "study/model/study_files.h"
#include "study/model/user_error.h"
#include "study/session/drawn_plan.h"
#include "study/session/study.h"
#include "study/storage/evidence/trail_signer.h"
#include "study/storage/map/study_keys.h"
#include "study/storage/statement.h"
#include "study/storage/study_schema.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using storage::Database;
using storage::StorageError;

constexpr std::uintmax_t kLeastFreeSpace = 64 * 1024 * 1024;  // [bytes]: enough for a first session

void makeFolder(const fs::path& folder) {
  if (folder.empty()) throw UserError("The folder of the study has no name. Name one.");
  std::error_code error;
  if (fs::exists(folder, error)) {
    throw StorageError(
        folder.string() + " is there already. Nothing is ever overwritten: choose another folder.");
  }
  const auto parent = fs::absolute(folder).parent_path();
  fs::create_directories(parent, error);
  if (error || !fs::create_directory(folder, error)) {
    throw StorageError(
        folder.string() + " cannot be made (" + error.message() +
        "). Choose a folder on a disk of this computer that may be written.");
  }
  fs::permissions(folder, fs::perms::owner_all, error);
  const auto space = fs::space(folder, error);
  if (!error && space.available < kLeastFreeSpace) {
    fs::remove(folder, error);
    throw StorageError(
        "There is too little room for a study in " + parent.string() + ": " +
        std::to_string(space.available / (1024 * 1024)) +
        " MiB are free, 64 are needed. Free some space.");
  }
  fs::create_directory(folder / "exports", error);
}

/// Creates the databases of a new study and writes their first rows.
void createDatabases(
    const fs::path& folder,
    const protocols::LoadedProtocol& protocol,
    Clock& clock,
    std::uint64_t seed,
    const storage::BlindingSecret& secret,
    const Station& station,
    const std::string& uuid) {
  const StudyFiles files{folder};
  Database::create(files.study(), storage::studySchema());
  Database::create(files.traces(), storage::traceSchema());
  storage::IdentityStore identities(Database::create(files.identity(), storage::identitySchema()));
  // Without blinding, the secret may be in the study's folder. With blinding, the station stores it
  // before the study is created.
  if (protocol.protocol.isOpenLabel) {
    identities.put(secret);
  } else {
    storage::storeStudyKey(secret, folder);
    identities.storeFingerprintSecret(secret.forFingerprints());
  }
  fs::permissions(files.identity(), fs::perms::owner_read | fs::perms::owner_write);
  // The row of table study is committed last. Study::open() refuses a folder without it as
  // unfinished.
  Database database =
      Database::open(files.study(), storage::studySchema(), Database::Access::ReadWrite);
  storage::Transaction transaction(database);
  const Moment now = clock.now();
  storage::ProtocolRepository(database).add(protocol, "the study was made", asUtc(now.wall));
  storage::Statement insert(
      database,
      "INSERT INTO study (id, uuid, seed, random_version, app_version, created_utc) "
      "VALUES (1, ?, ?, ?, ?, ?)");
  insert.bindAll(uuid, std::to_string(seed), base::kRandomVersion, appVersion(), asUtc(now.wall));
  insert.run();
  base::NamedArguments made{{"study", protocol.protocol.study.id}, {"secret", secret.commitment()}};
  if (!station.isNone()) {
    made.emplace_back("site", station.site);
    made.emplace_back("station", station.label);
    made.emplace_back("station_uuid", station.uuid);
    made.emplace_back(kOrdersOfStation, std::string("of its secret"));
  }
  storage::EventLog(database).append(
      {.when = now, .kind = EventKind::MadeStudy, .values = std::move(made)});
  transaction.commit();
  flushFolder(folder);
  storage::recordNewStudy(database, folder, now);
}

}  // namespace

std::uint64_t randomSeed() {
  constexpr std::uint64_t kExactInJson = (std::uint64_t{1} << 53) - 1;
  std::uint64_t seed = 0;
  randombytes_buf(&seed, sizeof seed);
  return seed & kExactInJson;
}

Study Study::create(
    const fs::path& folder,
    const protocols::LoadedProtocol& protocol,
    Clock& clock,
    std::optional<std::uint64_t> seed,
    const std::optional<storage::BlindingSecret>& secret,
    const Station& station,
    const std::string& uuid) {
  if (sodium_init() < 0) throw std::logic_error("libsodium does not start");
  makeFolder(folder);
  const auto usedSeed = seed ? *seed : protocol.protocol.seed.value_or(randomSeed());
  const auto usedSecret = secret ? *secret : storage::BlindingSecret::drawn();
  const auto hash = storage::sha256(protocol.text, protocol.files);
  try {
    createDatabases(
        folder,
        protocol,
        clock,
        usedSeed,
        usedSecret,
        station,
        uuid.empty() ? usedSecret.studyUuid(usedSeed, hash) : uuid);
  } catch (const StorageError&) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);  // the study was not complete yet, so no data are lost
    throw;
  }
  return open(folder, clock);
}

}  // namespace study
