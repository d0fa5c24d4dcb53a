#include "study/session/study_key.h"

#include "base/text_table.h"
#include "study/model/user_error.h"
#include "study/session/identity_evidence.h"
#include "study/storage/erasure/erased_rows.h"
#include "study/storage/statement.h"

namespace study {
namespace {

constexpr std::size_t kShortestPassphrase = 12;  // [bytes]

void requireReason(const std::string& reason) {
  if (base::isBlank(reason)) {
    throw UserError("Say why: it goes into the audit trail (--reason \"…\").");
  }
}

const storage::BlindingSecret& requireKey(Study& study) {
  const auto* key = study.secretFor(RunMode::Live);
  if (key == nullptr || !study.isSealed()) {
    throw UserError(
        study.folder().string() +
        " has no key: its conditions are not sealed. Either its protocol keeps nobody blind, or an "
        "older version of palpate made it.");
  }
  return *key;
}

/// Tampered names must not be sealed, because verification would then accept them.
/// @throws storage::StorageError  (Damaged)
void requireSoundNames(Study& study) {
  auto& identities = study.identities();
  if (!identities.hasUnsealedNames()) return;
  if (identities.damaged().empty() && checkIdentities(study).problems.empty()) return;
  throw storage::StorageError(
      "Names are not put behind a passphrase, because some of them were changed behind the "
      "program's back: 'palpate study verify' says which. Nothing was changed.",
      storage::StorageError::Kind::Damaged);
}

/// Draws missing Identity keys and seals names that an older release stored unsealed. The audit
/// trail contains no names; it gets an event with the new fingerprints (NotedIdentities).
void sealNamesOfOlderReleases(Study& study) {
  auto& identities = study.identities();
  for (const auto& row : study.sessions().all()) {
    if (row.runMode == RunMode::Simulated || identities.hasDrawnKeys(row.participant)) continue;
    identities.drawMissingKey(storage::IdentityStore::Key::Identity, row.participant);
  }
  recordFingerprintsOfSealedRows(study);
  for (const auto& participant : identities.sealUnsealedNames()) {
    if (!study.fingerprintSecret()) continue;
    study.note(
        {.kind = EventKind::NotedIdentities,
         .values = {{"rows", fingerprintsOf(study, participant)}}});
  }
}

bool wasEverExported(Study& study) {
  storage::Statement select(study.database(), "SELECT 1 FROM event WHERE kind = ?");
  return select.bindAll(nameOf(EventKind::ExportedKey)).step();
}

}  // namespace

void requireLongPassphrase(const std::string& passphrase) {
  if (passphrase.size() < kShortestPassphrase) {
    throw UserError(
        "A passphrase has at least 12 characters: a few words that nobody guesses, and that are "
        "written down at a safe place.");
  }
}

void exportKey(Study& study, const std::string& file, const std::string& reason) {
  requireReason(reason);
  const auto& key = requireKey(study);
  std::error_code ignored;
  if (std::filesystem::exists(file, ignored)) {
    throw UserError(file + " is there already. Nothing is overwritten: choose another name.");
  }
  study.note(EventKind::ExportedKey, reason);
  storage::writeKeyFile(file, key, study.protocol().protocol.study.title);
}

void importKey(Study& study, const std::string& file) {
  study.useKey(storage::readKeyFile(file));
  storeOpenedKey(study);
}

void storeOpenedKey(Study& study) {
  const auto& key = requireKey(study);
  const bool isNew = storage::storeStudyKey(key, study.folder());
  if (isNew && study.isWritable()) study.note(EventKind::ImportedKey, "");
}

void setPassphrase(
    Study& study,
    const std::string& passphrase,
    const std::string& reason,
    const storage::PassphraseCost& cost) {
  requireReason(reason);
  requireLongPassphrase(passphrase);
  const auto wrapped = storage::WrappedKey::make(requireKey(study).bytes(), passphrase, cost);
  study.transact([&] {
    storage::storeWrapped(study.database(), wrapped);
    study.events().append(
        {.when = study.clock().now(),
         .actor = storage::Actor::Operator,
         .kind = EventKind::SetPassphrase,
         .detail = reason});
    study.signTrail(nameOf(EventKind::SetPassphrase));
  });
}

void setPassphraseOfNames(
    Study& study,
    const std::string& passphrase,
    const std::string& reason,
    const storage::PassphraseCost& cost) {
  requireReason(reason);
  requireLongPassphrase(passphrase);
  auto& identities = study.identities();
  auto& database = identities.database();
  if (identities.isLocked()) throw UserError("The passphrase for the names was not given.");
  requireSoundNames(study);
  const auto key = database.key() != nullptr ? *database.key() : storage::SealingKey::drawn();
  const auto wrapped = storage::WrappedKey::make(key.bytes(), passphrase, cost);
  study.note(EventKind::SealedNames, reason);
  study.retryWithReservedSpace([&] {
    // With this setting SQLite overwrites deleted content with zeros.
    database.execute("PRAGMA secure_delete = ON");
    sealNamesOfOlderReleases(study);
    storage::Transaction transaction(database);
    identities.sealKeysWith(key);
    storage::storeWrapped(database, wrapped);
    transaction.commit();
  });
  database.setKey(key);
  storage::cacheNamesKey(wrapped, key.bytes());
  storage::purge(database);
}

void dropKey(Study& study, const std::string& reason) {
  requireReason(reason);
  requireKey(study);
  if (!study.hasPassphrase() && !wasEverExported(study)) {
    throw UserError(
        "This would be the end of the only key: nobody could ever say which condition an "
        "alternative was. Export it first (palpate study key export), or set a passphrase (palpate "
        "study key passphrase).");
  }
  study.note(EventKind::DroppedKey, reason);
  storage::dropKey(study.events().commitment());
}

bool hasOnlyCopyOfKey(Study& study) {
  return study.isSealed() && study.hasKey() && !study.hasPassphrase() && !wasEverExported(study);
}

std::string keyStatusText(Study& study) {
  if (study.events().commitment().empty() || study.protocol().protocol.isOpenLabel) return {};
  if (!study.isSealed()) return "open: a version of palpate made it that did not seal conditions";
  if (hasOnlyCopyOfKey(study)) return "sealed; only this account has the key: save a copy of it";
  const bool hasPassphrase = study.hasPassphrase();
  if (study.hasKey()) {
    return hasPassphrase ? "sealed; this account has the key, and a passphrase opens it"
                         : "sealed; this account has the key";
  }
  return hasPassphrase ? "sealed; this account does not have the key; a passphrase opens it"
                       : "sealed; this account does not have the key";
}

}  // namespace study
