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

/// All that a computer needs to become a station of a study: its protocols, its place, and what its
/// own orders are drawn from. It travels sealed for that computer.
struct StationEnrolment {
  std::string study;  ///< uuid
  std::string title;
  std::uint64_t seed = 0;
  storage::BlindingSecret secret;  ///< of this station alone
  Station station;
  std::string server;  ///< where it pushes to, as libpq reads it
  std::string role;
  std::string bundleKey;  ///< for which bundles are sealed (bundleKeyOf())
  std::string expiresUtc;
  struct Protocol {
    std::string text;
    std::vector<protocols::SourceFile> files;
  };
  std::vector<Protocol> protocols;  ///< all versions, the oldest first: the study is named by it
  std::string mark = {};            ///< of whoever signed the file (markOf()), once it was read
};

/// What tells one study's signature from all others, to be read out on the telephone: the first 80
/// bits of a hash of the key with which its enrolments are signed, "1a2b 3c4d 5e6f 7081 92a3".
/// @param secret  of the study, from which that key is derived
std::string markOf(const storage::BlindingSecret& secret);

/// Sealed for the station, and signed for the study.
/// @param publicKey  of the station ('palpate collect key'). @param secret  of the study
/// @throws UserError  if it is no key
std::string asText(
    const StationEnrolment& enrolment,
    const std::string& publicKey,
    const storage::BlindingSecret& secret);

/// @throws UserError  in words, if it is none, for another station, or not as it was signed.
StationEnrolment enrolmentIn(const std::string& text, const storage::StationStore& station);

/// Where a study's station pushes to: collect.json in its folder. Nothing in it is secret.
struct HomeServer {
  std::string server;
  std::string role;
  std::string bundleKey;
};
void write(const HomeServer& home, const std::filesystem::path& folder);
/// @throws UserError  if the study was not made by join().
HomeServer homeServerOf(const std::filesystem::path& folder);

/// Makes the study's folder at a station that was enrolled by the file @p enrolment. A file is used
/// once. Anybody can seal a file for a station: that it comes from the study tells its mark, which
/// the account remembers.
/// @param mark  that the study's administrator read out; empty: nobody compared it
/// @throws UserError  if it is for another computer, was used, is too old, or has another mark than
///     @p mark or than an earlier enrolment of the study.
/// @throws storage::StorageError
StationEnrolment join(
    const std::filesystem::path& enrolment,
    const std::filesystem::path& folder,
    Clock& clock,
    const std::string& mark = {});

}  // namespace study::collect
