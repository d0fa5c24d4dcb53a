// A computer becomes a station of a study.
#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "base/file.h"
#include "study/collect/exchange/enrolment.h"
#include "study/collect/exchange/protocol_files.h"
#include "study/model/user_error.h"
#include "study/session/study.h"

namespace study::collect {
namespace {

constexpr const char* kEnrolmentList = "enrolments";  // list of the station

std::string contentOf(const std::filesystem::path& path) {
  auto text = base::readFile(path);
  if (!text) throw UserError(path.string() + " cannot be read. Check its name and its rights.");
  return std::move(*text);
}

void requireUnused(const StationEnrolment& enrolment, const storage::StationStore& station) {
  const auto used = station.lines(kEnrolmentList);
  const bool isUsed = std::ranges::any_of(
      used, [&](const std::string& line) { return line.starts_with(enrolment.station.uuid); });
  if (!isUsed) return;
  throw UserError(
      "This enrolment was used already: the study's folder is on this computer. A second one "
      "would have the same orders and codes. Ask for another enrolment.");
}

std::string withoutSpaces(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// Checks the mark. The file says where the station sends its data, so a forged file could divert
/// them.
void requireMark(
    const StationEnrolment& enrolment,
    const std::string& mark,
    const storage::StationStore& station) {
  if (!mark.empty() && withoutSpaces(mark) != withoutSpaces(enrolment.mark)) {
    throw UserError(fmt::format(
        "This enrolment has the mark {}, and not {}: it does not come from the study's "
        "administrator, "
        "or from another study of theirs. Nothing was made. Ask there for the file and its mark.",
        enrolment.mark,
        mark));
  }
  for (const auto& line : station.lines(kEnrolmentList)) {
    std::istringstream words(line);
    std::string uuid;
    std::string study;
    std::string noted;
    words >> uuid >> study >> noted;
    if (study != enrolment.study || noted == withoutSpaces(enrolment.mark)) continue;
    throw UserError(fmt::format(
        "This enrolment has the mark {}, and an earlier one of the same study had another: one of "
        "them does not come from the study's administrator. Nothing was made. Ask there for the "
        "mark.",
        enrolment.mark));
  }
}

}  // namespace

StationEnrolment join(
    const std::filesystem::path& file,
    const std::filesystem::path& folder,
    Clock& clock,
    const std::string& mark) {
  const auto station = storage::StationStore::openOrCreate(storage::StationStore::defaultFolder());
  auto enrolment = enrolmentIn(contentOf(file), station);
  requireMark(enrolment, mark, station);
  requireUnused(enrolment, station);
  if (const auto now = asUtc(clock.now().wall); enrolment.expiresUtc < now) {
    throw UserError(fmt::format(
        "This enrolment was to be used before {}, and this computer's clock shows {}. If the clock "
        "is wrong, set it; otherwise ask for another enrolment.",
        enrolment.expiresUtc,
        now));
  }
  std::vector<protocols::LoadedProtocol> versions;
  for (const auto& version : enrolment.protocols) {
    versions.push_back(protocolOf(version.text, version.files));
  }
  {
    auto study = Study::create(
        folder,
        versions.at(0),
        clock,
        enrolment.seed,
        enrolment.secret,
        enrolment.station,
        enrolment.study);
    for (auto version = std::next(versions.begin()); version != versions.end(); ++version) {
      study.amend(*version, "as on the server");
    }
  }
  write(
      {.server = enrolment.server, .role = enrolment.role, .bundleKey = enrolment.bundleKey},
      folder);
  station.append(
      kEnrolmentList,
      fmt::format(
          "{} {} {} {}",
          enrolment.station.uuid,
          enrolment.study,
          withoutSpaces(enrolment.mark),
          folder.string()));
  return enrolment;
}

}  // namespace study::collect
