#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/model/clock.h"
#include "study/model/station.h"
#include "study/storage/blinding_secret.h"
#include "study/storage/station_store.h"

namespace study::collect {

/// All that a computer needs to become a station of a study: its protocol, its place, and what its
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
  std::string protocol;  ///< its text
  std::vector<protocols::SourceFile> files;
};

/// @param publicKey  of the station ('palpate collect key'). @throws UserError  if it is none
std::string asText(const StationEnrolment& enrolment, const std::string& publicKey);

/// @throws UserError  in words, if it is none, or for another station.
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
/// once. @throws UserError  if it is for another computer, was used, or is too old.
/// @throws storage::StorageError
StationEnrolment join(
    const std::filesystem::path& enrolment, const std::filesystem::path& folder, Clock& clock);

}  // namespace study::collect
