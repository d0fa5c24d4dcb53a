#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/model/clock.h"
#include "study/model/ids.h"
#include "study/storage/blinding_secret.h"
#include "study/storage/station_store.h"

namespace study::collect {

/// Everything that a computer needs to become a station of a study: protocols, site and label, and
/// the secret and seed of its orders. The file is sealed for that computer.
struct StationEnrolment {
  std::string study;  ///< uuid
  std::string title;
  std::uint64_t seed = 0;
  storage::BlindingSecret secret;  ///< of this station alone
  Station station;
  std::string server;  ///< connection string (libpq) of the server that it pushes to
  std::string role;
  std::string bundleKey;  ///< public key for sealing bundles (bundleKeyOf())
  std::string expiresUtc;
  struct Protocol {
    std::string text;
    std::vector<protocols::SourceFile> files;
  };
  /// All versions, the oldest first, from which the study's uuid is computed.
  std::vector<Protocol> protocols;
  std::string mark = {};  ///< keyFingerprintOf() the key that signed the file; set by enrolmentIn()
};

/// A short fingerprint of the key that signs a study's enrolments, to be compared on the telephone:
/// the first 80 bits of its hash, "1a2b 3c4d 5e6f 7081 92a3".
/// @param secret  of the study, from which that key is derived
std::string keyFingerprintOf(const storage::BlindingSecret& secret);

/// The enrolment file: sealed for the station, and signed with the study's key.
/// @param publicKey  of the station ('palpate collect key'). @param secret  of the study
/// @throws UserError  if @p publicKey is no key
std::string asText(
    const StationEnrolment& enrolment,
    const std::string& publicKey,
    const storage::BlindingSecret& secret);

/// Opens an enrolment file. @throws UserError  if it is no enrolment, is for another station, or
/// has an invalid signature.
StationEnrolment enrolmentIn(const std::string& text, const storage::StationStore& station);

/// The server that a station of a study pushes to: collect.json in the study's folder. It has no
/// secrets.
struct ServerSettings {
  std::string server;
  std::string role;
  std::string bundleKey;
};
void write(const ServerSettings& settings, const std::filesystem::path& folder);
/// @throws UserError  if the study was not made by join().
ServerSettings serverSettingsOf(const std::filesystem::path& folder);

/// Makes the study's folder at a station from the file @p enrolment, which can be used once.
/// Anybody can seal a file for a station; only the mark shows that it comes from the study. The
/// account remembers the mark.
/// @param mark  as the study's administrator read it out; empty: not compared
/// @throws UserError  if the file is for another computer, was used, has expired, or has another
///     mark than @p mark or than an earlier enrolment of the study.
/// @throws storage::StorageError
StationEnrolment join(
    const std::filesystem::path& enrolment,
    const std::filesystem::path& folder,
    Clock& clock,
    const std::string& mark = {});

}  // namespace study::collect
