#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace study::storage {

/// The secret that keeps a study blinded: 256 random bits, drawn when the study is created
/// (docs/decisions/0038). The station that created the study stores it outside of the study's
/// folder (docs/decisions/0049). In studies of older releases and studies without blinding it is in
/// identity.db.
///
/// The codes of conditions and the assignment of conditions to the drawn orders depend on the
/// secret. Neither can be computed from the study's seed, name or protocol. Stored orders are
/// sealed with it.
class BlindingSecret {
 public:
  using Bytes = std::array<unsigned char, 32>;

  explicit BlindingSecret(const Bytes& bytes) noexcept : bytes_(bytes) {}

  /// Drawn from the random number generator of the operating system.
  static BlindingSecret drawn();

  /// Derives the secret of the station with the label @p station. From the derived secret neither
  /// this secret nor that of another station can be computed.
  BlindingSecret of(std::string_view station) const;

  const Bytes& bytes() const noexcept { return bytes_; }

  /// A keyed hash in hexadecimal that identifies the secret without revealing it.
  std::string commitment() const;

  /// The permanent name of a study: 128 bits of a keyed hash, from which the seed cannot be
  /// computed.
  /// @param protocolHash  storage::sha256() of the protocol with its files
  std::string studyUuid(std::uint64_t seed, const std::string& protocolHash) const;

  /// Derives the secret for fingerprint(), from which this secret cannot be computed.
  BlindingSecret forFingerprints() const;

  /// A keyed hash of a row of identity.db, for the audit trail.
  std::string fingerprint(std::string_view row) const;

  /// Sorts @p ids by their hash with the secret (BLAKE2b-256 of "purpose/id"). Without the secret,
  /// all orders are equally likely. Orders for different purposes are independent.
  /// @param ids  distinct; their order has no effect.
  void arrange(std::vector<std::string>& ids, std::string_view purpose) const;

 private:
  /// The keyed hash of @p text, as bytes and in hexadecimal.
  Bytes digestOf(std::string_view text) const;
  std::string hashOf(std::string_view text) const;

  Bytes bytes_;
};

}  // namespace study::storage
