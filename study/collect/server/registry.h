#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/collect/server/connection.h"
#include "study/model/ids.h"

namespace study::collect {

/// A study in the server's tables. Only the owner and roles that may pull can read seed and secret.
struct StudyOnServer {
  std::string uuid;
  std::string name;  ///< short, unique on the server
  std::string title;
  std::string seed;               ///< of the orders of conditions, at all stations
  std::vector<std::byte> secret;  ///< the study's storage::BlindingSecret
};

/// A version of a study's protocol.
struct ProtocolOnServer {
  std::string sha256;
  std::string text;
  std::string files;  ///< a JSON object: name to text
};

/// The functions below are for the owner of the schema. All throw ServerError.

/// @throws UserError  if there is a study of that name.
void addStudy(Connection& server, const StudyOnServer& study);
/// Adds a version of a protocol. A version that the server has already becomes the newest.
void addProtocol(Connection& server, const std::string& study, const ProtocolOnServer& protocol);
/// A question about the participant, and how coarse its answers are for analysts.
struct BackgroundItem {
  std::string phase;
  std::string item;
  std::optional<double> width;  ///< width of the bands of a number, in its unit
  bool isWhole = false;         ///< "20 to 24", otherwise "20 to <25"
};
/// Replaces the stored background questions of a study.
void replaceBackground(
    Connection& server, const std::string& study, const std::vector<BackgroundItem>& items);
/// All versions of a study's protocol, the oldest first.
std::vector<ProtocolOnServer> protocolsOf(Connection& server, const std::string& study);
/// The study with that name; the only one if @p name is empty.
/// @throws UserError  if there is none, or more than one.
StudyOnServer findStudy(Connection& server, const std::string& name);

struct NewStation {
  Station station;
  std::string key;  ///< the station's public key
  int days = 30;    ///< days in which it has to push for the first time
};
struct AddedStation {
  std::string role;        ///< role with which the station logs in
  std::string expiresUtc;  ///< until when its enrolment may be used (ISO 8601)
};
/// Adds a station and its role, station_<label>, without a password.
/// @throws UserError  if the study has a station of that name.
AddedStation addStation(Connection& server, const std::string& study, const NewStation& station);

/// Revokes a station: the server accepts nothing more from it. Its data stay.
/// @throws UserError  if there is no such station.
void revokeStation(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& reason);

/// Sets aside the data of a station that differ from what it recorded: the server keeps them under
/// another name and no longer pulls them; the station sends everything again.
/// @return  whether the station was revoked; it is admitted again
/// @throws UserError  if there is no such station.
bool setAsideStation(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& reason);

/// The state of a station's data on the server.
struct StationStatus {
  std::string site;
  std::string station;      ///< label
  std::int64_t events = 0;  ///< of its audit trail
  std::int64_t sessions = 0;
  std::int64_t incidents = 0;  ///< refused requests, see Incident
  std::string lastContact;     ///< empty: it never pushed
  bool isRevoked = false;
  bool isSetAside = false;
};
/// The stations of a study, or of all studies if @p studyName is empty.
std::vector<StationStatus> stationsOf(Connection& server, const std::string& studyName);

/// Stores an incident: data of a station that were refused before ingest() was called. @param
/// station  its uuid
void addIncident(
    Connection& server,
    const std::string& station,
    const std::string& what,
    const std::string& detail);

/// A refused request.
struct Incident {
  std::string at;       ///< UTC, ISO 8601
  std::string role;     ///< role that sent the request
  std::string station;  ///< label; empty: unknown
  std::string what;
  std::string detail;
};
/// The last @p most incidents, the newest first.
std::vector<Incident> incidentsOf(Connection& server, int most);

}  // namespace study::collect
