#include "study/study.h"

#include <array>
#include <charconv>
#include <utility>

#include <sodium.h>

#include "protocols/random_stream.h"
#include "study/storage/ballast.h"
#include "study/storage/statement.h"
#include "study/storage/study_schema.h"
#include "study/storage/transaction.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using storage::Database;
using storage::StorageError;

constexpr std::uintmax_t kLeastFreeSpace = 64 * 1024 * 1024;  // [bytes]: for a first session

std::uint64_t drawnSeed() {
  constexpr std::uint64_t kExactInJson = (std::uint64_t{1} << 53) - 1;
  std::uint64_t seed = 0;
  randombytes_buf(&seed, sizeof seed);
  return seed & kExactInJson;
}

/// Names a study for good. A study with a given seed and protocol always gets the same name, so
/// that a simulated one can be made again byte for byte; a drawn seed makes it unique.
std::string uuidFor(std::uint64_t seed, const std::string& protocolHash) {
  std::array<unsigned char, 16> bytes{};
  const std::string content = std::to_string(seed) + protocolHash;
  crypto_generichash(
      bytes.data(),
      bytes.size(),
      reinterpret_cast<const unsigned char*>(content.data()),
      content.size(),
      nullptr,
      0);
  std::array<char, 2 * bytes.size() + 1> text{};
  sodium_bin2hex(text.data(), text.size(), bytes.data(), bytes.size());
  return text.data();
}

void makeFolder(const fs::path& folder) {
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

std::string pathOf(const fs::path& folder, const char* file) {
  return (folder / file).string();
}

}  // namespace

std::string_view appVersion() noexcept {
  return PALPATE_VERSION;
}

Study::Study(fs::path folder, Clock& clock, Database database, Database traces, Database identities)
    : folder_(std::move(folder)),
      clock_(&clock),
      database_(std::move(database)),
      traces_(std::move(traces)),
      identities_(std::move(identities)) {}

Study Study::create(
    const fs::path& folder,
    const protocols::LoadedProtocol& protocol,
    Clock& clock,
    std::optional<std::uint64_t> seed) {
  makeFolder(folder);
  {
    Database::create(pathOf(folder, "study.db"), storage::studySchema());
    Database::create(pathOf(folder, "traces.db"), storage::traceSchema());
    Database::create(pathOf(folder, "identity.db"), storage::identitySchema());
    fs::permissions(folder / "identity.db", fs::perms::owner_read | fs::perms::owner_write);
  }
  Database database = Database::open(
      pathOf(folder, "study.db"), storage::studySchema(), Database::Access::ReadWrite);
  storage::Transaction transaction(database);
  const std::string utc = asUtc(clock.now().wall);
  storage::ProtocolRepository(database).add(protocol, "the study was made", utc);
  const std::uint64_t chosen = seed ? *seed : protocol.protocol.seed.value_or(drawnSeed());
  storage::Statement insert(
      database,
      "INSERT INTO study (id, uuid, seed, random_version, app_version, created_utc) "
      "VALUES (1, ?, ?, ?, ?, ?)");
  insert.bind(1, uuidFor(chosen, storage::sha256(protocol.text, protocol.files)))
      .bind(2, std::to_string(chosen))
      .bind(3, std::int64_t{protocols::kRandomVersion})
      .bind(4, appVersion())
      .bind(5, utc);
  insert.run();
  storage::EventLog(database).append(
      {.when = clock.now(), .kind = "made_study", .detail = protocol.protocol.study.id});
  transaction.commit();
  storage::Ballast(folder).take();
  return open(folder, clock);
}

Study Study::open(const fs::path& folder, Clock& clock, Database::Access access) {
  if (sodium_init() < 0) throw std::logic_error("libsodium does not start");
  if (!fs::is_directory(folder)) {
    throw StorageError(
        "There is no study in " + folder.string() +
        ". Make one with 'palpate study create', or check the folder's name.");
  }
  Study study(
      folder,
      clock,
      Database::open(pathOf(folder, "study.db"), storage::studySchema(), access),
      Database::open(pathOf(folder, "traces.db"), storage::traceSchema(), access),
      Database::open(pathOf(folder, "identity.db"), storage::identitySchema(), access));
  study.readHead();
  if (access == Database::Access::ReadWrite) storage::Ballast(folder).take();
  return study;
}

void Study::readHead() {
  storage::Statement select(
      database_, "SELECT uuid, seed, random_version, created_utc FROM study WHERE id = 1");
  if (!select.step()) {
    throw StorageError(
        database_.path() +
            " was not finished when it was made. Remove the folder and make the study again.",
        StorageError::Kind::Damaged);
  }
  if (select.number(2) != protocols::kRandomVersion) {
    throw StorageError(
        database_.path() +
            " draws its orders in a way that this version of palpate does not know. "
            "Install the version that made it.",
        StorageError::Kind::Newer);
  }
  uuid_ = select.text(0);
  const std::string seed = select.text(1);
  std::from_chars(seed.data(), seed.data() + seed.size(), seed_);
  createdUtc_ = select.text(3);
}

const protocols::LoadedProtocol& Study::protocol() {
  return protocol(protocols().current().id);
}

const protocols::LoadedProtocol& Study::protocol(ProtocolId id) {
  auto& loaded = loaded_[id];
  if (loaded) return *loaded;
  const auto stored = protocols().load(id);
  const auto find = [&](const std::string& name) -> std::optional<std::string> {
    for (const auto& file : stored.files) {
      if (file.name == name) return file.text;
    }
    return std::nullopt;
  };
  questionnaires::Problems problems;
  auto protocol = protocols::loadProtocol(stored.text, find, problems);
  if (!protocol) {
    throw StorageError(
        "The protocol in " + database_.path() + " cannot be read by this version of palpate:\n" +
            questionnaires::inWords(problems.all()),
        StorageError::Kind::Damaged);
  }
  loaded = std::make_unique<protocols::LoadedProtocol>(std::move(*protocol));
  return *loaded;
}

void Study::amend(const protocols::LoadedProtocol& protocol, const std::string& reason) {
  storage::Transaction transaction(database_);
  const bool isFrozen = protocols().current().frozenUtc.has_value();
  if (isFrozen && reason.empty()) {
    throw StorageError(
        "A participant has begun with the protocol as it is. A change is a new version and needs a "
        "reason: add --reason \"…\".");
  }
  const Moment now = clock_->now();
  const auto id = protocols().add(
      protocol, reason.empty() ? "before the first participant" : reason, asUtc(now.wall));
  events().append(
      {.when = now,
       .actor = storage::Actor::Operator,
       .kind = "amended_protocol",
       .detail = "version " + std::to_string(static_cast<std::int64_t>(id)) + ": " + reason});
  transaction.commit();
}

storage::TraceStore Study::openTraces() const {
  return storage::TraceStore(Database::open(
      pathOf(folder_, "traces.db"), storage::traceSchema(), Database::Access::ReadWrite));
}

void Study::withRoom(const std::function<void()>& action) {
  try {
    action();
  } catch (const StorageError& error) {
    const bool mayHelp = error.kind() == StorageError::Kind::DiskFull;
    if (!mayHelp || !storage::Ballast(folder_).release()) throw;
    action();
  }
}

void Study::note(const std::string& kind, const std::string& detail) {
  storage::Transaction transaction(database_);
  events().append(
      {.when = clock_->now(), .actor = storage::Actor::Operator, .kind = kind, .detail = detail});
  transaction.commit();
}

}  // namespace study
