#include "study/storage/keys/sealed_condition.h"

#include "study/model/storage_error.h"

namespace study::storage {
namespace {

// Plain text is padded with zeros to a multiple of these sizes [bytes].
constexpr std::size_t kSizeOfCondition = 64;  // ids have at most 64 characters; 64 give 128 bytes
constexpr std::size_t kSizeOfMeasurements = 8192;

std::string placeOf(SessionId session, int step) {
  return "allocation/" + std::to_string(static_cast<std::int64_t>(session)) + "/" +
         std::to_string(step);
}

std::string placeOf(const VisitKey& trial) {
  return "trial/" + std::to_string(static_cast<std::int64_t>(trial.session)) + "/" +
         std::to_string(trial.step) + "/" + std::to_string(trial.attempt);
}

std::vector<std::byte> sealed(
    const SealingKey& key, std::string_view text, std::size_t size, const std::string& place) {
  std::string padded(text);
  padded.resize((text.size() / size + 1) * size, '\0');
  return key.sealDeterministically(padded, place);
}

std::string opened(
    const SealingKey& key, const std::vector<std::byte>& bytes, const std::string& place) {
  const auto padded = key.open(bytes, place);
  if (!padded) {
    throw StorageError(
        "Which condition an alternative was, or what was measured, cannot be read: it was changed "
        "since it was written. Do not go on with this study; 'palpate study verify' says more.",
        StorageError::Kind::Damaged);
  }
  return padded->substr(0, padded->find('\0'));
}

}  // namespace

std::vector<std::byte> sealCondition(
    const SealingKey& key, SessionId session, int step, std::string_view condition) {
  return sealed(key, condition, kSizeOfCondition, placeOf(session, step));
}

std::string openCondition(
    const SealingKey& key, SessionId session, int step, const std::vector<std::byte>& bytes) {
  return opened(key, bytes, placeOf(session, step));
}

std::vector<std::byte> sealMeasurements(
    const SealingKey& key, const VisitKey& trial, std::string_view text) {
  return sealed(key, text, kSizeOfMeasurements, placeOf(trial));
}

std::string openMeasurements(
    const SealingKey& key, const VisitKey& trial, const std::vector<std::byte>& bytes) {
  return opened(key, bytes, placeOf(trial));
}

std::string adviceOnMissingKey(const std::string& study, bool hasPassphrase) {
  return "This account does not have the key of the study " + study +
         ". Without it no session can go on, and nobody can say which condition an alternative "
         "was. On the account that has it: palpate study key export " +
         study + " --out key.txt --reason \"…\". Here: palpate study key import " + study +
         " key.txt" +
         (hasPassphrase ? ", or without a file: the study has a passphrase, which is asked for."
                        : ".");
}

}  // namespace study::storage
