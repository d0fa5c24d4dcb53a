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

enum class AddedToServer { Study, Version, Nothing };
/// Makes a study on the server. If the study exists, the protocol is added as its newest version.
/// @return  what was made; Nothing: the study has this version already
/// @throws UserError  if the name is not valid. @throws ServerError
AddedToServer addStudyOrVersion(
    Connection& server,
    const std::string& name,
    const protocols::LoadedProtocol& protocol,
    std::optional<std::uint64_t> seed);

/// Takes away what every role of a database may do and none of ours has to: make temporary tables
/// and large objects, with which a station can fill the server's disk.
/// @return  advice, with what a superuser enters, if this account may not take it away
/// @throws ServerError
std::optional<std::string> closeDatabase(Connection& server);

/// Advice for the administrator, with the settings to change, if the server's log does not show
/// whose requests were denied, and from where; std::nullopt if it does.
/// @throws ServerError
std::optional<std::string> logPrivacyProblem(Connection& server);

struct EnrolmentRequest {
  std::string study;  ///< name; empty: the only one
  std::string site;
  std::string label;    ///< empty: the site's name
  std::string key;      ///< public key of the station
  std::string address;  ///< the server's address for the station; empty: that of this connection
  int days = 30;        ///< validity of the enrolment [days]
};

/// A station that was enrolled.
struct EnrolledStation {
  std::string study;  ///< name
  std::string label;
  std::string role;
  std::string expiresUtc;
  std::string file;  ///< content of the enrolment, sealed for the station
  std::string mark;  ///< fingerprint to be read out to the station (keyFingerprintOf())
};

/// Adds a station to a study of the server. @throws UserError  if a name, the key or the address is
/// invalid (it must not contain a password), or there is a station of that name already.
EnrolledStation enrolStation(Connection& server, const EnrolmentRequest& request);

/// Erases a participant of a revoked station from the server: rows, samples and the key of what the
/// trail says. For a station that is lost; else it is erased there, and pushed. The erasure and its
/// reason are kept as an incident.
/// @param study  its uuid
/// @return  a receipt for each session
/// @throws UserError  if the station is not revoked, or the server has no such participant of it.
///     @throws ServerError
std::vector<ErasureReceipt> eraseParticipant(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& participant,
    const std::string& reason);

/// The result of ingestBundle().
struct IngestedBundle {
  std::string station;         ///< label
  std::int64_t before = 0;     ///< before, the server had all events up to this one
  std::int64_t lastEvent = 0;  ///< the server now has all events up to this one
  std::vector<ErasureReceipt> erased;
};

/// Stores the content of a bundle, the file of a station without a network. Can be repeated.
/// @throws UserError  if the bundle is damaged or was not signed by a station of this server (the
///     server records an incident), or if an earlier bundle is missing. @throws ServerError
IngestedBundle ingestBundle(Connection& server, const std::filesystem::path& file);

}  // namespace study::collect
