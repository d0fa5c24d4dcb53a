#include "study/storage/keys/sealing_key.h"

#include <sodium.h>

namespace study::storage {
namespace {

constexpr std::size_t kNonce = crypto_aead_xchacha20poly1305_ietf_NPUBBYTES;
constexpr std::size_t kProof = crypto_aead_xchacha20poly1305_ietf_ABYTES;
static_assert(kNonce == 24 && kProof == 16, "as documented");
static_assert(std::tuple_size_v<SealingKey::Bytes> == crypto_kdf_KEYBYTES);
static_assert(std::tuple_size_v<SealingKey::Bytes> == crypto_aead_xchacha20poly1305_ietf_KEYBYTES);

// Purposes of derived keys. These numbers are part of the file format.
constexpr unsigned kPurposeSeal = 1;
constexpr unsigned kPurposeHash = 2;
constexpr unsigned kPurposeJoin = 3;
constexpr unsigned kPurposeDeterministic = 4;

const unsigned char* bytesIn(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());
}

}  // namespace

SealingKey SealingKey::drawn() {
  Bytes bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return SealingKey(bytes);
}

SealingKey::Bytes SealingKey::derived(unsigned purpose) const {
  static constexpr std::array<char, crypto_kdf_CONTEXTBYTES> kContext{
      'p', 'a', 'l', 'p', 'a', 't', 'e', '1'};
  Bytes key{};
  crypto_kdf_derive_from_key(key.data(), key.size(), purpose, kContext.data(), bytes_.data());
  return key;
}

std::vector<std::byte> SealingKey::seal(std::string_view text, std::string_view place) const {
  return sealed(text, place, [](unsigned char* nonce) { randombytes_buf(nonce, kNonce); });
}

std::vector<std::byte> SealingKey::sealDeterministically(
    std::string_view text, std::string_view place) const {
  return sealed(text, place, [&](unsigned char* nonce) {
    const auto key = derived(kPurposeDeterministic);
    crypto_generichash_state state{};
    crypto_generichash_init(&state, key.data(), key.size(), kNonce);
    const std::string where = std::to_string(place.size()) + ":" + std::string(place);
    crypto_generichash_update(&state, bytesIn(where), where.size());
    crypto_generichash_update(&state, bytesIn(text), text.size());
    crypto_generichash_final(&state, nonce, kNonce);
  });
}

std::vector<std::byte> SealingKey::sealed(
    std::string_view text,
    std::string_view place,
    const std::function<void(unsigned char*)>& writeNonce) const {
  const auto key = derived(kPurposeSeal);
  std::vector<std::byte> sealed(kNonce + text.size() + kProof);
  auto* bytes = reinterpret_cast<unsigned char*>(sealed.data());
  writeNonce(bytes);
  crypto_aead_xchacha20poly1305_ietf_encrypt(
      bytes + kNonce,
      nullptr,
      bytesIn(text),
      text.size(),
      bytesIn(place),
      place.size(),
      nullptr,
      bytes,
      key.data());
  return sealed;
}

std::optional<std::string> SealingKey::open(
    std::span<const std::byte> sealed, std::string_view place) const {
  if (sealed.size() < kNonce + kProof) return std::nullopt;
  const auto key = derived(kPurposeSeal);
  const auto* bytes = reinterpret_cast<const unsigned char*>(sealed.data());
  std::string text(sealed.size() - kNonce - kProof, '\0');
  const int code = crypto_aead_xchacha20poly1305_ietf_decrypt(
      reinterpret_cast<unsigned char*>(text.data()),
      nullptr,
      nullptr,
      bytes + kNonce,
      sealed.size() - kNonce,
      bytesIn(place),
      place.size(),
      bytes,
      key.data());
  return code == 0 ? std::optional(std::move(text)) : std::nullopt;
}

SealingKey SealingKey::joinedWith(const SealingKey& other) const {
  const auto key = derived(kPurposeJoin);
  Bytes joined{};
  crypto_generichash(
      joined.data(),
      joined.size(),
      other.bytes_.data(),
      other.bytes_.size(),
      key.data(),
      key.size());
  return SealingKey(joined);
}

SealingKey::Bytes SealingKey::hashingKey() const {
  return derived(kPurposeHash);
}

}  // namespace study::storage
