#include "study/session/study_key.h"

#include <algorithm>

#include "study/model/user_error.h"
#include "study/storage/statement.h"

namespace study {
namespace {

constexpr std::size_t kShortestPassphrase = 12;  // [bytes]

void requireReason(const std::string& reason) {
  if (reason.empty()) {
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

bool wasEverExported(Study& study) {
  storage::Statement select(study.database(), "SELECT 1 FROM event WHERE kind = ?");
  return select.bind(1, nameOf(EventKind::ExportedKey)).step();
}

}  // namespace

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
  keepOpenedKey(study);
}

void keepOpenedKey(Study& study) {
  const auto& key = requireKey(study);
  const bool isNew = storage::keepKey(key, study.folder());
  if (isNew && study.isWritable()) study.note(EventKind::ImportedKey, "");
}

void setPassphrase(
    Study& study,
    const std::string& passphrase,
    const std::string& reason,
    const storage::PassphraseCost& cost) {
  requireReason(reason);
  if (passphrase.size() < kShortestPassphrase) {
    throw UserError(
        "A passphrase has at least 12 characters: a few words that nobody guesses, and that are "
        "written down at a safe place.");
  }
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

bool hasOnlyKey(Study& study) {
  return study.isSealed() && study.hasKey() && !study.hasPassphrase() && !wasEverExported(study);
}

std::string sealInWords(Study& study) {
  if (study.events().commitment().empty() || study.protocol().protocol.isBlindingOpen) return {};
  if (!study.isSealed()) return "open: a version of palpate made it that did not seal conditions";
  if (hasOnlyKey(study)) return "sealed; this account has the only key: save a copy of it";
  const std::string passphrase = study.hasPassphrase() ? ", or a passphrase opens it" : "";
  return study.hasKey() ? "sealed; this account has the key" + passphrase
                        : "sealed; this account has not the key" + passphrase;
}

}  // namespace study
