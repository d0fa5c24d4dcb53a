#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

/// What keeps a study blinded, its key: 256 random bits, drawn when the study is made
/// (docs/decisions/0038). It is not in the study's folder, but with the station that made it
/// (docs/decisions/0049); studies of before, and those in which nobody is blind, have it in
/// identity.db.
///
/// Codes of conditions, and which condition takes which part in the orders, depend on it. Neither
/// can be computed from the study's seed, its name or its protocol. What is stored of the orders is
/// sealed with it.
class BlindingSecret {
 public:
  using Bytes = std::array<unsigned char, 32>;

  explicit BlindingSecret(const Bytes& bytes) noexcept : bytes_(bytes) {}

  /// From the operating system's random numbers.
  static BlindingSecret drawn();

  /// The secret of one station (its label), which tells nothing of this one or of another
  /// station's.
  BlindingSecret of(std::string_view station) const;

  const Bytes& bytes() const noexcept { return bytes_; }

  /// A keyed hash in hexadecimal, which tells the secret from any other and does not reveal it.
  std::string commitment() const;

  /// The permanent name of a study: 128 bits of a keyed hash, from which the seed cannot be
  /// computed.
  /// @param protocolHash  storage::sha256() of the protocol with its files
  std::string studyUuid(std::uint64_t seed, const std::string& protocolHash) const;

  /// A secret of its own for fingerprints, which says nothing of this one.
  BlindingSecret forFingerprints() const;

  /// A keyed hash of a row of identity.db, for the audit trail.
  std::string fingerprint(std::string_view row) const;

  /// Sorts @p ids by their hash with the secret (BLAKE2b-256 of "purpose/id"): to anyone who does
  /// not know it, all orders are equally likely. Purposes are independent of each other.
  /// @param ids  distinct; their order does not matter.
  void arrange(std::vector<std::string>& ids, std::string_view purpose) const;

 private:
  Bytes digestOf(std::string_view text) const;
  std::string hashOf(std::string_view text) const;

  Bytes bytes_;
};

}  // namespace study::storage
