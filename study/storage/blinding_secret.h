#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

/// The key that keeps a study blinded: 256 random bits, drawn when the study is made
/// (docs/decisions/0038). The station that made the study keeps it, outside of the study's folder
/// (docs/decisions/0049). Studies of older releases and studies without blinding have it in
/// identity.db.
///
/// The codes of conditions and the assignment of conditions to the drawn orders depend on it.
/// Neither can be computed from the study's seed, its name or its protocol. Stored orders are
/// sealed with it.
class BlindingSecret {
 public:
  using Bytes = std::array<unsigned char, 32>;

  explicit BlindingSecret(const Bytes& bytes) noexcept : bytes_(bytes) {}

  /// From the operating system's random numbers.
  static BlindingSecret drawn();

  /// Derives the secret of the station with that label. It reveals neither this secret nor that of
  /// another station.
  BlindingSecret of(std::string_view station) const;

  const Bytes& bytes() const noexcept { return bytes_; }

  /// A keyed hash in hexadecimal that identifies the secret without revealing it.
  std::string commitment() const;

  /// The permanent name of a study: 128 bits of a keyed hash, from which the seed cannot be
  /// computed.
  /// @param protocolHash  storage::sha256() of the protocol with its files
  std::string studyUuid(std::uint64_t seed, const std::string& protocolHash) const;

  /// Derives the secret for fingerprint(). It does not reveal this secret.
  BlindingSecret forFingerprints() const;

  /// A keyed hash of a row of identity.db, for the audit trail.
  std::string fingerprint(std::string_view row) const;

  /// Sorts @p ids by their hash with the secret (BLAKE2b-256 of "purpose/id"): without the secret,
  /// all orders are equally likely. Purposes are independent of each other.
  /// @param ids  distinct; their order does not matter.
  void arrange(std::vector<std::string>& ids, std::string_view purpose) const;

 private:
  Bytes digestOf(std::string_view text) const;
  std::string hashOf(std::string_view text) const;

  Bytes bytes_;
};

}  // namespace study::storage
