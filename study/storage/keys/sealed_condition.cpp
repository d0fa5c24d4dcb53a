#include "study/storage/keys/sealed_condition.h"

#include "study/model/storage_error.h"

namespace study::storage {
namespace {

/// [bytes]: ids of conditions are shorter; a longer one takes the next multiple.
constexpr std::size_t kSize = 64;

std::string placeOf(SessionId session, int step) {
  return "allocation/" + std::to_string(static_cast<std::int64_t>(session)) + "/" +
         std::to_string(step);
}

}  // namespace

std::vector<std::byte> sealedCondition(
    const SealingKey& key, SessionId session, int step, std::string_view condition) {
  std::string padded(condition);
  padded.resize((condition.size() / kSize + 1) * kSize, '\0');
  return key.seal(padded, placeOf(session, step));
}

std::string openedCondition(
    const SealingKey* key, SessionId session, int step, const std::vector<std::byte>& sealed) {
  if (key == nullptr) throw StorageError(howToGetTheKey("DIR", false));
  const auto padded = key->open(sealed, placeOf(session, step));
  if (!padded) {
    throw StorageError(
        "Which condition an alternative was cannot be read: it was changed since it was written. "
        "Do not go on with this study; 'palpate study verify' says more.",
        StorageError::Kind::Damaged);
  }
  return padded->substr(0, padded->find('\0'));
}

std::string howToGetTheKey(const std::string& study, bool hasPassphrase) {
  return "This account has not the key of the study " + study +
         ". Without it no session can go on, and nobody can say which condition an alternative "
         "was. On the account that has it: palpate study key export " +
         study + " --out key.txt --reason \"…\". Here: palpate study key import " + study +
         " key.txt" +
         (hasPassphrase ? ", or without a file: the study has a passphrase, which is asked for."
                        : ".");
}

}  // namespace study::storage
