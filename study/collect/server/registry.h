#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/collect/server/connection.h"
#include "study/model/ids.h"

namespace study::collect {

/// A study as the server keeps it. Only its owner and whoever pulls it see seed and secret.
struct StudyOnServer {
  std::string uuid;
  std::string name;  ///< short, unique on the server
  std::string title;
  std::string seed;
  std::vector<std::byte> secret;
};

/// A version of a study's protocol. @param files  a JSON object: name to text
struct ProtocolOnServer {
  std::string sha256;
  std::string text;
  std::string files;
};

/// What the owner of the schema does. All functions throw ServerError.

/// @throws UserError  if there is a study of that name.
void addStudy(Connection& server, const StudyOnServer& study);
/// Does nothing if the version is there.
void addProtocol(Connection& server, const std::string& study, const ProtocolOnServer& protocol);
/// A question that participants answer about themselves, as analysts may see what was said.
struct BackgroundItem {
  std::string phase;
  std::string item;
  std::optional<double> width;  ///< of the bands of a number, in its unit
  bool isWhole = false;         ///< "20 to 24", otherwise "20 to <25"
};
/// Replaces all that is stored about these questions.
void replaceBackground(
    Connection& server, const std::string& study, const std::vector<BackgroundItem>& items);
/// All versions, the oldest first.
std::vector<ProtocolOnServer> protocolsOf(Connection& server, const std::string& study);
/// By its name; the only one if @p name is empty.
/// @throws UserError  if there is none, or more than one.
StudyOnServer findStudy(Connection& server, const std::string& name);

struct NewStation {
  Station station;
  std::string key;  ///< the station's public key
  int days = 30;    ///< until when it has to push for the first time
};
/// Adds a station and its role, station_<label>, without a password.
/// @return  the role, and until when the enrolment may be used (ISO 8601)
/// @throws UserError  if the study has a station of that name.
struct AddedStation {
  std::string role;
  std::string expiresUtc;
};
AddedStation addStation(Connection& server, const std::string& study, const NewStation& station);

/// Nothing is taken from the station any more. What arrived stays.
/// @throws UserError  if there is no such station.
void revokeStation(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& reason);

/// Sets aside what is there of a station, because it is not what the station recorded: all of it
/// stays under another name, is pulled no more, and the station sends everything again.
/// @throws UserError  if there is no such station.
void setAsideStation(
    Connection& server,
    const std::string& study,
    const std::string& label,
    const std::string& reason);

/// What arrived from a station, for its owner, analysts and whoever pulls.
struct StationStatus {
  std::string site;
  std::string station;
  std::int64_t events = 0;
  std::int64_t sessions = 0;
  std::int64_t incidents = 0;
  std::string lastContact;  ///< empty: it never pushed
  bool isRevoked = false;
  bool isSetAside = false;
};
std::vector<StationStatus> stationsOf(Connection& server, const std::string& studyName);

/// Keeps that something of a station was refused before ingest() saw it. @param station  its uuid
void addIncident(
    Connection& server,
    const std::string& station,
    const std::string& what,
    const std::string& detail);

/// Something that was refused.
struct Incident {
  std::string at;
  std::string role;
  std::string station;  ///< label; empty: unknown
  std::string what;
  std::string detail;
};
/// The newest first.
std::vector<Incident> incidentsOf(Connection& server, int most);

}  // namespace study::collect
