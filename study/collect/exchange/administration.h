#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/collect/exchange/batch.h"
#include "study/collect/server/registry.h"

namespace study::collect {

/// Makes a study on the server; for one that is there the protocol becomes its newest version.
/// @return  whether it was made
/// @throws UserError  if the name is not sound. @throws ServerError
bool putStudy(
    Connection& server,
    const std::string& name,
    const protocols::LoadedProtocol& protocol,
    std::optional<std::uint64_t> seed);

/// What is missing in the server's settings for its log to tell who was denied what; std::nullopt:
/// nothing. @throws ServerError
std::optional<std::string> logProblem(Connection& server);

struct StationRequest {
  std::string study;  ///< name; empty: the only one
  std::string site;
  std::string label;    ///< empty: as the site
  std::string key;      ///< public key of the station
  std::string address;  ///< where the station finds the server; empty: as this connection does
  int days = 30;        ///< for how long the enrolment can be used
};

/// A station that was enrolled.
struct EnrolledStation {
  std::string study;  ///< name
  std::string label;
  std::string role;
  std::string expiresUtc;
  std::string file;  ///< content of the enrolment, sealed for the station
  std::string mark;  ///< to be read out to the station (markOf())
};

/// @throws UserError  if a name, the key or the address is not sound (it may hold no password), or
///     the station is there already.
EnrolledStation enrolStation(Connection& server, const StationRequest& request);

/// A bundle that was taken in.
struct TakenBundle {
  std::string station;    ///< label
  std::int64_t have = 0;  ///< the server has all events up to this one
  std::vector<ErasureReceipt> erased;
};

/// Takes in what a station without a network put into a file. Twice is the same as once.
/// @throws UserError  if it is not whole or not what a station of this server signed, which is kept
///     as an incident, or if an earlier one is missing. @throws ServerError
TakenBundle takeBundle(Connection& server, const std::filesystem::path& file);

}  // namespace study::collect
