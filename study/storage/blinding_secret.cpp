#include "study/storage/blinding_secret.h"

#include <algorithm>
#include <utility>

#include <sodium.h>

#include "study/storage/hasher.h"

namespace study::storage {

BlindingSecret BlindingSecret::drawn() {
  Bytes bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return BlindingSecret(bytes);
}

BlindingSecret BlindingSecret::of(std::string_view station) const {
  return BlindingSecret(digestOf("station/" + std::string(station)));
}

BlindingSecret::Bytes BlindingSecret::digestOf(std::string_view text) const {
  static_assert(std::tuple_size_v<Bytes> == crypto_generichash_BYTES);
  Bytes digest{};
  crypto_generichash(
      digest.data(),
      digest.size(),
      reinterpret_cast<const unsigned char*>(text.data()),
      text.size(),
      bytes_.data(),
      bytes_.size());
  return digest;
}

std::string BlindingSecret::hashOf(std::string_view text) const {
  return inHexadecimal(digestOf(text));
}

std::string BlindingSecret::commitment() const {
  return hashOf("commitment");
}

std::string BlindingSecret::studyUuid(std::uint64_t seed, const std::string& protocolHash) const {
  constexpr std::size_t kDigits = 32;
  return hashOf("study/" + std::to_string(seed) + "/" + protocolHash).substr(0, kDigits);
}

BlindingSecret BlindingSecret::forFingerprints() const {
  return BlindingSecret(digestOf("secret of fingerprints"));
}

std::string BlindingSecret::fingerprint(std::string_view row) const {
  return hashOf("row of identity.db/" + std::string(row));
}

void BlindingSecret::arrange(std::vector<std::string>& ids, std::string_view purpose) const {
  std::vector<std::pair<std::string, std::string>> hashed;
  for (const auto& id : ids) hashed.emplace_back(hashOf(std::string(purpose) + "/" + id), id);
  std::ranges::sort(hashed);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = std::move(hashed[i].second);
}

}  // namespace study::storage
