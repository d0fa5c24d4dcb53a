#include "study/session/study.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <sodium.h>

#include "base/random.h"
#include "base/text_table.h"
#include "protocols/load_protocol.h"
#include "questionnaires/json/document.h"
#include "study/model/new_file.h"
#include "study/model/study_files.h"
#include "study/model/user_error.h"
#include "study/session/erasure.h"
#include "study/storage/keys/sealed_condition.h"
#include "study/storage/local_disk.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"
#include "study/storage/study_schema.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using storage::Database;
using storage::StorageError;

void requireFinished(const Database& database) {
  storage::Statement select(database, "SELECT 1 FROM study WHERE id = 1");
  if (select.step()) return;
  throw StorageError(
      database.path() +
          " was not finished when it was made. Remove the folder and make the study again.",
      StorageError::Kind::Damaged);
}

bool isErasureOpenIn(const StudyFiles& files) {
  auto database = Database::open(files.study(), storage::studySchema(), Database::Access::ReadOnly);
  return hasPendingErasures(database);
}

}  // namespace

std::string_view appVersion() noexcept {
  return PALPATE_VERSION;
}

Study::Study(fs::path folder, Clock& clock, Database database, Database traces, Database identities)
    : folder_(folder),
      clock_(&clock),
      database_(std::move(database)),
      traces_(std::move(traces)),
      identities_(std::move(identities)),
      signer_(std::move(folder)) {}

Study Study::open(const fs::path& folder, Database::Access access) {
  static SystemClock clock;
  return open(folder, clock, access);
}

Study Study::open(const fs::path& folder, Clock& clock, Database::Access access) {
  if (sodium_init() < 0) throw std::logic_error("libsodium does not start");
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    if (error == std::errc::permission_denied) {
      throw StorageError(
          folder.string() + " cannot be read (" + error.message() +
          "). Check who may read it and the folder that it is in.");
    }
    throw StorageError(
        "There is no study in " + folder.string() +
        ". Make one with 'palpate study create', or check the folder's name.");
  }
  const StudyFiles files{folder};
  if (access == Database::Access::ReadWrite) storage::requireLocalDisk(files.study());
  if (access == Database::Access::ReadOnly && isErasureOpenIn(files)) {
    open(folder, clock, Database::Access::ReadWrite);
  }
  auto database = Database::open(files.study(), storage::studySchema(), access);
  requireFinished(database);
  auto traces = Database::open(files.traces(), storage::traceSchema(), access);
  auto identities = Database::open(files.identity(), storage::identitySchema(), access);
  Study study(folder, clock, std::move(database), std::move(traces), std::move(identities));
  study.readStudyRow();
  study.isWritable_ = access == Database::Access::ReadWrite;
  study.findKey();
  if (study.isWritable_) {
    storage::ReservedSpace(folder).take();
    finishPendingErasures(study);
    study.copyForms();
  }
  return study;
}

void Study::readStudyRow() {
  storage::Statement select(
      database_, "SELECT uuid, seed, random_version, created_utc FROM study WHERE id = 1");
  if (!select.step() || select.number(2) != base::kRandomVersion) {
    throw StorageError(
        database_.path() +
            " draws its orders in a way that this version of palpate does not know. "
            "Install the version that made it.",
        StorageError::Kind::Newer);
  }
  uuid_ = select.text(0);
  const auto seed = base::numberFrom<std::uint64_t>(select.text(1));
  if (!seed) {
    throw StorageError(
        database_.path() + " is damaged: the seed of its orders is '" + select.text(1) +
            "', which is no whole number. Restore it from a copy; do not go on with it.",
        StorageError::Kind::Damaged);
  }
  seed_ = *seed;
  createdUtc_ = select.text(3);
  const auto made = events().valuesOfMadeStudy();
  station_ = {
      .site = storage::storedText(made, "site"),
      .label = storage::storedText(made, "station"),
      .uuid = storage::storedText(made, "station_uuid")};
  storage::Statement first(database_, "SELECT kind FROM event WHERE seq = 1");
  isCollected_ = first.step() && first.text(0) == nameOf(EventKind::CollectedStudy);
}

void Study::readSecret() {
  const auto committed = events().commitment();
  auto found = identities_.blindingSecret();
  isSealed_ = !committed.empty() && !found;
  if (isSealed_) found = storage::findStudyKey(committed);
  if (isSealed_ && !found) {
    throw StorageError(storage::adviceOnMissingKey(folder_.string(), hasPassphrase()));
  }
  const bool isSound = committed.empty() || found->commitment() == committed;
  if (!isSound) {
    throw StorageError(
        identities_.database().path() +
            " has not the secret of this study's codes and orders. Restore it from a copy; do not "
            "go on with it.",
        StorageError::Kind::Damaged);
  }
  if (!committed.empty()) secret_ = found;
  if (isSealed_) setKey();
  isSecretRead_ = true;
}

void Study::findKey() noexcept {
  try {
    const auto wrapped = storage::wrappedKeyIn(identities_.database());
    const auto held = wrapped ? storage::cachedNamesKey(*wrapped) : std::nullopt;
    if (held) identities_.database().setKey(*held);
    readSecret();
  } catch (const std::exception&) {
    return;  // most functions need no key; secretFor() reports the error when the key is needed
  }
}

const storage::BlindingSecret* Study::secretFor(RunMode mode) {
  if (mode == RunMode::Simulated) return nullptr;
  if (!isSecretRead_) readSecret();
  return secret_ ? &*secret_ : nullptr;
}

void Study::useKey(const storage::BlindingSecret& key) {
  if (key.commitment() != events().commitment()) {
    throw UserError(
        "This is the key of another study, or digits of it were changed. Take the one that was "
        "exported from " +
        folder_.string() + " or from a copy of it.");
  }
  secret_ = key;
  setKey();
  isSecretRead_ = true;
}

void Study::setKey() {
  const storage::SealingKey key(secret_->bytes());
  database_.setKey(key);
  traces_.database().setKey(key);
}

bool Study::unlock(const std::string& passphrase) {
  const auto wrapped = storage::wrappedKeyIn(database_);
  const auto bytes = wrapped ? wrapped->opened(passphrase) : std::nullopt;
  if (bytes) {
    useKey(storage::BlindingSecret(*bytes));
    storage::cacheStudyKey(*secret_);
  }
  return bytes.has_value();
}

bool Study::unlockNames(const std::string& passphrase) {
  const auto wrapped = storage::wrappedKeyIn(identities_.database());
  const auto bytes = wrapped ? wrapped->opened(passphrase) : std::nullopt;
  if (bytes) {
    storage::cacheNamesKey(*wrapped, *bytes);
    identities_.database().setKey(storage::SealingKey(*bytes));
  }
  return bytes.has_value();
}

std::optional<storage::BlindingSecret> Study::fingerprintSecret() {
  if (auto secret = identities_.fingerprintSecret()) return secret;
  const auto* secret = secretFor(RunMode::Live);
  if (secret == nullptr) return std::nullopt;
  return isSealed_ ? secret->forFingerprints() : *secret;
}

const protocols::LoadedProtocol& Study::protocol() {
  return protocol(protocols().current().id);
}

const protocols::LoadedProtocol& Study::protocol(ProtocolId id) {
  auto& loaded = loaded_[id];
  if (loaded) return *loaded;
  const auto stored = protocols().load(id);
  questionnaires::Problems problems;
  auto protocol = protocols::loadProtocol(stored.text, stored.files, problems, stored.defaults);
  if (!protocol) {
    throw StorageError(
        "The protocol in " + database_.path() + " cannot be read by this version of palpate:\n" +
            questionnaires::describe(problems.all()),
        StorageError::Kind::Damaged);
  }
  loaded = std::make_unique<protocols::LoadedProtocol>(std::move(*protocol));
  return *loaded;
}

void Study::copyForms() {
  if (protocols().withoutForms().empty()) return;
  transact([&] {
    int copied = 0;
    for (const auto id : protocols().withoutForms()) {
      try {
        copied += protocols().addForms(id, protocol(id).files);
      } catch (const StorageError& error) {
        // This program's library lacks a form, or this release cannot read the protocol; a later
        // release may.
        if (error.kind() != StorageError::Kind::Damaged) throw;
      }
    }
    if (copied == 0) return;
    events().append(
        {.when = clock_->now(),
         .kind = EventKind::CopiedForms,
         .values = {{"forms", std::int64_t{copied}}}});
  });
}

void Study::amend(const protocols::LoadedProtocol& protocol, const std::string& reason) {
  const auto& study = this->protocol().protocol.study.id;
  if (protocol.protocol.study.id != study) {
    throw UserError(
        "This study has the protocol '" + study + "', and that is '" + protocol.protocol.study.id +
        "': not another version of it. Make a folder of its own for another study, or give the "
        "version the id '" +
        study + "'.");
  }
  transact([&] {
    if (protocols().isAnyFrozen() && base::isBlank(reason)) {
      throw StorageError(
          "A participant has begun. A change is a new version and needs a reason: add --reason "
          "\"…\".");
    }
    const Moment now = clock_->now();
    const auto id = protocols().add(
        protocol, base::isBlank(reason) ? "before the first participant" : reason, asUtc(now.wall));
    events().append(
        {.when = now,
         .actor = storage::Actor::Operator,
         .kind = EventKind::AmendedProtocol,
         .values = {{"version", static_cast<std::int64_t>(id)}, {"reason", reason}}});
    signTrail(nameOf(EventKind::AmendedProtocol));
  });
}

void saveProtocol(const protocols::LoadedProtocol& protocol, const std::string& path) {
  const auto isThere = [](const fs::path& file, const std::string& text) {
    return fs::is_regular_file(file) && fs::file_size(file) == text.size() &&
           questionnaires::readTextFile(file.string(), text.size()) == text;
  };
  requireNewFile(path);
  const auto folder = fs::path(path).parent_path();
  std::vector<std::pair<fs::path, const std::string*>> files;
  for (const auto& [name, text] : protocol.files) {
    if (name.starts_with(protocols::kLibraryCopyPrefix)) continue;
    const auto file = folder / name;
    if (isThere(file, text)) continue;
    if (file.has_parent_path()) fs::create_directories(file.parent_path());
    requireNewFile(file.string());
    files.emplace_back(file, &text);
  }
  for (const auto& [file, text] : files) writeNewFile(file.string(), *text);
  writeNewFile(path, protocol.text);
}

storage::TraceStore Study::openTraces() const {
  auto database = Database::open(
      StudyFiles{folder_}.traces(), storage::traceSchema(), Database::Access::ReadWrite);
  if (const auto* key = database_.key()) database.setKey(*key);
  return storage::TraceStore(std::move(database));
}

void Study::retryWithReservedSpace(const std::function<void()>& action) {
  try {
    action();
  } catch (const StorageError& error) {
    const bool mayHelp = error.kind() == StorageError::Kind::DiskFull;
    if (!mayHelp || !storage::ReservedSpace(folder_).release()) throw;
    action();
  }
}

bool Study::isEventStored(const std::vector<std::byte>& head) {
  try {
    return !head.empty() && events().holds(head);
  } catch (const StorageError& error) {
    throw StorageError(
        std::string("Whether the last step was kept cannot be found out just now. ") + error.what(),
        StorageError::Kind::Unknown);
  }
}

void Study::transact(const std::function<void()>& action) {
  retryWithReservedSpace([&] {
    std::vector<std::byte> head;
    try {
      signer_.forget();
      storage::Transaction transaction(database_);
      action();
      // After a commit that seemed to fail, the hash of the last event shows whether it was
      // written.
      head = events().head();
      transaction.commit();
    } catch (const StorageError&) {
      if (!isEventStored(head)) throw;
    }
  });
  // If the head cannot be noted now, the next one covers its events. verify() reports how many
  // heads the list lacks.
  signer_.recordSignedHead();
}

void Study::signTrail(std::string_view purpose) {
  signer_.sign(database_, purpose, clock_->now());
}

void Study::note(EventKind kind, const std::string& words) {
  note({.actor = storage::Actor::Operator, .kind = kind, .detail = words});
}

void Study::note(storage::Event event) {
  transact([&] {
    event.when = clock_->now();
    events().append(event);
    signTrail(event.name());
  });
}

}  // namespace study
