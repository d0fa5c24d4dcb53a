#include "study/storage/evidence/station_heads.h"

#include <algorithm>
#include <span>
#include <system_error>
#include <utility>

#include "study/storage/hasher.h"

namespace study::storage {
namespace {

/// The name of a study's list. A uuid comes from a file that other people may have written, so it
/// must not be a path out of the station's folder.
std::string listOf(const std::string& study) {
  constexpr std::size_t kLongest = 64;
  const bool isSound = !study.empty() && study.size() <= kLongest &&
                       study.find_first_not_of("0123456789abcdef-") == std::string::npos;
  return "heads-" + (isSound ? study : inHexadecimal(hashOf(std::as_bytes(std::span(study)))));
}

std::string onOneLine(const std::filesystem::path& folder) {
  std::error_code ignored;
  const auto whole = std::filesystem::absolute(folder, ignored);
  std::string text = whole.empty() ? folder.string() : whole.lexically_normal().string();
  std::ranges::replace(text, '\n', '?');
  return text;
}

}  // namespace

void recordHead(
    const StationStore& station, const SignedHead& head, const std::filesystem::path& folder) {
  station.append(listOf(head.study), head.asLine() + " " + onOneLine(folder));
}

RecordedHeads readRecordedHeads(const StationStore& station, const std::string& study) {
  RecordedHeads noted;
  for (const auto& line : station.lines(listOf(study))) {
    std::string folder;
    auto head = headIn(line, &folder);
    if (head && head->key == station.publicKey() && head->isSigned()) {
      noted.heads.push_back({std::move(*head), std::move(folder)});
    } else {
      ++noted.unsoundLines;
    }
  }
  return noted;
}

}  // namespace study::storage
