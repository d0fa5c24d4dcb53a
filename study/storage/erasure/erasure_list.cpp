#include "study/storage/erasure/erasure_list.h"

#include <algorithm>
#include <sstream>

#include "study/storage/statement.h"
#include "study/storage/station_store.h"

namespace study::storage {
namespace {

constexpr const char* kListName = "erasures";
constexpr std::size_t kFieldCount = 5;

bool isEnrolled(const Database& database, const ListedErasure& erasure) {
  Statement select(database, "SELECT 1 FROM participant WHERE code = ? AND created_utc = ?");
  select.bindAll(erasure.participant, erasure.enrolledUtc);
  return select.step();
}

}  // namespace

std::string asLine(const ListedErasure& erasure) {
  return erasure.study + "\t" + erasure.participant + "\t" + erasure.enrolledUtc + "\t" +
         std::string(nameOf(erasure.level)) + "\t" + erasure.utc;
}

std::optional<ListedErasure> listedErasureIn(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  // A mail program or an editor may have put blanks in place of tabs; no field has blanks.
  for (std::string field; stream >> field;) fields.push_back(field);
  if (fields.size() != kFieldCount) return std::nullopt;
  const auto level = erasureLevelNamed(fields[3]);
  if (!level) return std::nullopt;
  return ListedErasure{
      .study = fields[0],
      .participant = fields[1],
      .enrolledUtc = fields[2],
      .level = *level,
      .utc = fields[4]};
}

std::vector<ListedErasure> listedErasures(const std::string& study) {
  std::vector<ListedErasure> listed;
  const auto station = StationStore::find(StationStore::defaultFolder());
  if (!station) return listed;
  for (const auto& line : station->lines(kListName)) {
    auto erasure = listedErasureIn(line);
    if (erasure && erasure->study == study) listed.push_back(std::move(*erasure));
  }
  return listed;
}

void addListedErasure(const ListedErasure& erasure) {
  const auto known = listedErasures(erasure.study);
  if (std::ranges::find(known, erasure) != known.end()) return;
  StationStore::openOrCreate(StationStore::defaultFolder()).append(kListName, asLine(erasure));
}

std::vector<ListedErasure> erasuresToRepeat(
    Database& database, const std::vector<ListedErasure>& listed) {
  std::vector<ListedErasure> open;
  const auto done = ErasureRepository(database).all();
  const auto isDone = [&](const ListedErasure& erasure, bool (*part)(ErasureLevel)) {
    return !part(erasure.level) || std::ranges::any_of(done, [&](const auto& other) {
      return other.participant == erasure.participant && part(other.level);
    });
  };
  for (const auto& erasure : listed) {
    const auto names = [](ErasureLevel level) { return erasesNames(level); };
    const auto answers = [](ErasureLevel level) { return erasesAnswers(level); };
    const bool isAllDone = isDone(erasure, names) && isDone(erasure, answers);
    if (!isAllDone && isEnrolled(database, erasure)) open.push_back(erasure);
  }
  return open;
}

}  // namespace study::storage
