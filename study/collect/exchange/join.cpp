// A computer becomes a station of a study.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/protocol_files.h"
#include "study/model/user_error.h"
#include "study/session/study.h"

namespace study::collect {
namespace {

constexpr const char* kUsed = "enrolments";  // list of the station

std::string contentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw UserError(path.string() + " cannot be read. Check its name and its rights.");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void requireUnused(const StationEnrolment& enrolment, const storage::StationStore& station) {
  const auto used = station.lines(kUsed);
  const bool isUsed = std::any_of(used.begin(), used.end(), [&](const std::string& line) {
    return line.starts_with(enrolment.station.uuid);
  });
  if (!isUsed) return;
  throw UserError(
      "This enrolment was used already: the study's folder is on this computer. A second one "
      "would have the same orders and codes. Ask for another enrolment.");
}

}  // namespace

StationEnrolment join(
    const std::filesystem::path& file, const std::filesystem::path& folder, Clock& clock) {
  const auto station = storage::StationStore::findOrMake(storage::StationStore::usualFolder());
  auto enrolment = enrolmentIn(contentOf(file), station);
  requireUnused(enrolment, station);
  if (enrolment.expiresUtc < asUtc(clock.now().wall)) {
    throw UserError(
        "This enrolment was to be used before " + enrolment.expiresUtc + ". Ask for another one.");
  }
  const auto protocol = protocolOf(enrolment.protocol, enrolment.files);
  const auto hash = storage::sha256(protocol.text, protocol.files);
  if (studyUuid(enrolment.seed, hash) != enrolment.study) {
    throw UserError(
        "This version of palpate reads the study's protocol in another way than the server did. "
        "Install the release of whoever runs the study.");
  }
  Study::create(folder, protocol, clock, enrolment.seed, enrolment.secret, enrolment.station);
  write(
      {.server = enrolment.server, .role = enrolment.role, .bundleKey = enrolment.bundleKey},
      folder);
  station.append(kUsed, enrolment.station.uuid + " " + enrolment.study + " " + folder.string());
  return enrolment;
}

}  // namespace study::collect
