#include "study/storage/keys/wrapped_key.h"

#include <algorithm>
#include <stdexcept>

#include <sodium.h>

#include "study/model/storage_error.h"

namespace study::storage {
namespace {

constexpr std::string_view kAssociatedData = "a key behind a passphrase";
static_assert(WrappedKey::kSaltBytes == crypto_pwhash_SALTBYTES);

// Upper limits of PassphraseCost, because a file from another person must not keep the program busy
// or take all memory.
constexpr std::uint64_t kMostOperations = 16;
constexpr std::uint64_t kMostMemory = 1024ULL * 1024 * 1024;  // [bytes]

SealingKey keyFrom(std::string_view passphrase, const WrappedKey& wrapped) {
  SealingKey::Bytes bytes{};
  const int code = crypto_pwhash(
      bytes.data(),
      bytes.size(),
      passphrase.data(),
      passphrase.size(),
      wrapped.salt.data(),
      wrapped.cost.operations,
      static_cast<std::size_t>(wrapped.cost.memory),
      crypto_pwhash_ALG_ARGON2ID13);
  if (code != 0) {
    throw StorageError(
        "There is not enough memory to check a passphrase (" +
        std::to_string(wrapped.cost.memory / (1024 * 1024)) +
        " MiB). Close other programs and try again.");
  }
  return SealingKey(bytes);
}

}  // namespace

WrappedKey WrappedKey::make(
    const SealingKey::Bytes& key, std::string_view passphrase, const PassphraseCost& cost) {
  if (passphrase.empty()) throw std::invalid_argument("an empty passphrase");
  WrappedKey wrapped{.cost = cost, .sealed = {}};
  randombytes_buf(wrapped.salt.data(), wrapped.salt.size());
  const std::string_view bytes(reinterpret_cast<const char*>(key.data()), key.size());
  wrapped.sealed = keyFrom(passphrase, wrapped).seal(bytes, kAssociatedData);
  return wrapped;
}

std::optional<SealingKey::Bytes> WrappedKey::opened(std::string_view passphrase) const {
  const bool isKnown = cost.operations >= crypto_pwhash_OPSLIMIT_MIN &&
                       cost.operations <= kMostOperations &&
                       cost.memory >= crypto_pwhash_MEMLIMIT_MIN && cost.memory <= kMostMemory;
  if (!isKnown) {
    throw StorageError(
        "What a passphrase opens is damaged, or of a later version of palpate.",
        StorageError::Kind::Damaged);
  }
  const auto text = keyFrom(passphrase, *this).open(sealed, kAssociatedData);
  SealingKey::Bytes bytes{};
  if (!text || text->size() != bytes.size()) return std::nullopt;
  std::copy(text->begin(), text->end(), bytes.begin());
  return bytes;
}

}  // namespace study::storage
